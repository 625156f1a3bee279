// In place of write_bcf.cpp where there is no libzip or no pugixml.
#include <stdexcept>

#include "programs/clash/write.hpp"

namespace ecods::clash {

bool can_write_bcf() noexcept {
    return false;
}

void write_bcf(std::ostream&, const ClashReport&, std::span<const Picture>, const std::string&) {
    throw std::runtime_error("this ecods_clash was built without libzip or pugixml, which BCF needs");
}

}  // namespace ecods::clash
