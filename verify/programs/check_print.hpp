// How answers are shown, to people and to machines.
#pragma once

#include <cstdio>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "check_oracle.hpp"

namespace ecods::check {

// "1 body", "2 bodies"; the plural adds an s if none is given.
std::string counted(std::size_t count, const std::string& singular, const std::string& plural = {});

// Returns the name of a relation, or of a kind of closest points or hits, as operator<< writes it: "vertex and vertex".
template <class Kind>
std::string name_of(Kind kind) {
    std::ostringstream out;
    out << kind;
    return out.str();
}

// One line for each body: whether its mesh bounds a solid, and why not.
void print_solids(std::FILE* out, const scenes::Scene& scene, const SceneWorld& world);

// One line a frame, one a colliding pair, and one a distance and a close pair, with the closest points in as many
// digits as name them.
void print_frame(std::FILE* out, const scenes::Scene& scene, const FrameAnswer& answer);

// Each difference, and how many answers were checked.
void print_report(std::FILE* out, const OracleReport& report);

// {"bodies": [...], "frames": [{"frame": 0, "overlapping": n, "colliding": [{"a", "b", "relation",
// "triangle_pairs"}], "distances": [{"a", "b", "distance", "kind", "point_a", "point_b", "triangle_a",
// "triangle_b"}], "close": [as distances]}], "oracle": {"body_pairs", "triangle_pairs", "boxes", "distances",
// "clearances", "differing", "differences"}}; distances with --distance only (null: above the largest double), close
// with --clearance only, the last with --oracle only. A triangle is null where a point is inside a solid. With --solids
// also "solids": [{"body", "is_solid", "why"}]. With --depth also "depths": [{"a", "b", "depth", "direction",
// "feature_a", "feature_b"}] and "gaps": [{"a", "b", "distance"}], where there are any.
nlohmann::ordered_json to_json(const scenes::Scene& scene);
nlohmann::ordered_json solids_to_json(const scenes::Scene& scene, const SceneWorld& world);
nlohmann::ordered_json to_json(const scenes::Scene& scene, const FrameAnswer& answer);
nlohmann::ordered_json to_json(const OracleReport& report);

}  // namespace ecods::check
