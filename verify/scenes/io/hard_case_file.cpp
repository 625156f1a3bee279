#include "scenes/io/hard_case_file.hpp"

#include "scenes/io/json_file.hpp"
#include "scenes/io/json_place.hpp"

namespace ecods::scenes {
namespace {

HardCase::Body read_body(const JsonPlace& place, const char* name) {
    return {read_inline_mesh(place.at("shapes").at(name)), read_pose(place.at("transforms").at(name))};
}

}  // namespace

HardCases read_hard_cases(const std::filesystem::path& file) {
    const JsonDocument document = read_json(file);
    HardCases result;
    for (const JsonPlace& place : JsonPlace(file, *document).at("cases").elements()) {
        if (!place.at("shapes").find("A")) {
            ++result.skipped;
            continue;
        }
        const JsonPlace expected = place.at("expected_true_answer");
        const std::optional<JsonPlace> relation = expected.find("solid_relation_exact_affine");
        result.cases.push_back({.id = place.at("id").text(),
                                .a = read_body(place, "A"),
                                .b = read_body(place, "B"),
                                .intersects = expected.at("surfaces_intersect_exact_affine").boolean(),
                                .triangle_pair_count = expected.at("n_pairs_exact_affine").index(),
                                .solid_relation = relation ? std::optional(relation->text()) : std::nullopt});
    }
    return result;
}

}  // namespace ecods::scenes
