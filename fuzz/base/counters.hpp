// What a campaign did, by name: calls, motions, errors, checks. That a hard thing happens is seen here.
#pragma once

#include <cstdint>
#include <map>
#include <string>

namespace ecods::fuzz {

using Counters = std::map<std::string, std::uint64_t>;

}  // namespace ecods::fuzz
