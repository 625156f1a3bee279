// How answers are shown, to people and to machines.
#pragma once

#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>

#include "check_oracle.hpp"

namespace ecods::check {

const char* name_of(Relation relation) noexcept;  // "disjoint", "touching", "crossing"

// "1 body", "2 bodies"; the plural adds an s if none is given.
std::string counted(std::size_t count, const std::string& singular, const std::string& plural = {});

// One line a frame, and one a colliding pair.
void print_frame(std::FILE* out, const scenes::Scene& scene, const FrameAnswer& answer);

// Each difference, and how many answers were checked.
void print_report(std::FILE* out, const OracleReport& report);

// {"bodies": [...], "frames": [{"frame": 0, "overlapping": n, "colliding": [{"a", "b", "relation",
// "triangle_pairs"}]}], "oracle": {"body_pairs", "triangle_pairs", "boxes", "differing", "differences"}}; the last with
// --oracle only.
nlohmann::ordered_json to_json(const scenes::Scene& scene);
nlohmann::ordered_json to_json(const scenes::Scene& scene, const FrameAnswer& answer);
nlohmann::ordered_json to_json(const OracleReport& report);

}  // namespace ecods::check
