#include "programs/clash/report.hpp"

namespace ecods::clash {

std::string_view name_of(Kind kind) noexcept {
    constexpr std::array<std::string_view, kind_count> names{"equal",    "inside",   "overlapping",
                                                             "crossing", "touching", "clearance"};
    return names[static_cast<std::size_t>(kind)];
}

}  // namespace ecods::clash
