// Builders, out of memory at any point.
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <string>

#include "allocation/each_allocation.hpp"
#include "ecods/builders.hpp"

namespace ecods::allocation::builders_test {
namespace {

TEST(BuildersOutOfMemory, BuildersBuildTheNextTime) {
    Failures failures;
    const auto build = [](std::uint64_t& answer) {
        const std::array<double, 4> heights{0, 1, 0, 0};
        const auto hill = height_field(heights, 2, {1, 1}, -1);
        answer = cone(0.3, 1, 3).solid->digest() ^ ellipsoid({1, 2, 3}, 0).solid->digest() ^ hill->digest();
    };
    fail_each_allocation<std::uint64_t>(
        {.make = [] { return std::uint64_t{0}; },
         .call = build,
         .difference = [](std::uint64_t& expected,
                          std::uint64_t& got) { return expected == got ? std::string() : std::to_string(got); },
         .go_on = build},
        failures);
    EXPECT_EQ(failures.defects, 0u) << failures.first;
}

}  // namespace
}  // namespace ecods::allocation::builders_test
