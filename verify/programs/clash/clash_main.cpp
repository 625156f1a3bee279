// ecods_clash: which parts of some files clash, how, and where.
#include "programs/clash/report.hpp"

int main() {
    return 0;
}
