// What the test suites of other libraries expect, asked of this one. Prints how many expectations each source has, and
// which the library's answers differ from.
//
// usage: foreign [SOURCE...]      the named sources, or all; then there must be 2,000 expectations at least
//        foreign --canary         one answer of each source is changed, which has to be the one that differs
#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "foreign/sources.hpp"

namespace ecods::foreign {

std::span<const Source> sources() {
    static constexpr Source all[] = {
        {"cgal", cgal::ask},
        {"cgal_orders", cgal_orders::ask},
        {"coal", coal::ask},
        {"embree", embree::ask},
        {"fcl_boxes", fcl_boxes::ask},
        {"fcl_projections", fcl_projections::ask},
        {"jolt_hulls", jolt_hulls::ask},
        {"jolt_points", jolt_points::ask},
        {"jolt_rays", jolt_rays::ask},
        {"libccd", libccd::ask},
        {"mujoco", mujoco::ask},
        {"parry", parry::ask},
        {"sample_queries", sample_queries::ask},
        {"shen", shen::ask},
        {"trimesh", trimesh::ask},
    };
    return all;
}

namespace {

constexpr std::size_t expectation_min = 2000;

int ask(const std::vector<std::string>& names) {
    std::size_t asked = 0, different = 0;
    for (const Source& source : sources()) {
        if (!names.empty() && std::ranges::find(names, source.name) == names.end()) continue;
        Expectations expect(source.name);
        source.ask(expect);
        std::printf("%-16s %7zu expectations, %zu differ\n", source.name.data(), expect.asked(), expect.different());
        asked += expect.asked();
        different += expect.different();
    }
    std::printf("%-16s %7zu expectations, %zu differ\n", "in all", asked, different);
    const bool is_enough = names.empty() ? asked >= expectation_min : asked > 0;
    if (!is_enough) std::printf("%zu expectations are too few\n", asked);
    return different == 0 && is_enough ? 0 : 1;
}

// The answer that is changed: no source has fewer.
constexpr std::size_t canary = 40;

int ask_canaries() {
    std::size_t seen = 0;
    for (const Source& source : sources()) {
        Expectations expect(source.name, canary);
        source.ask(expect);
        seen += expect.different() == 1;
    }
    std::printf("%zu of %zu changed answers are seen\n", seen, sources().size());
    return seen == sources().size() ? 0 : 1;
}

}  // namespace
}  // namespace ecods::foreign

int main(int argc, char** argv) {
    const std::vector<std::string> names(argv + 1, argv + argc);
    if (names == std::vector<std::string>{"--canary"}) return ecods::foreign::ask_canaries();
    return ecods::foreign::ask(names);
}
