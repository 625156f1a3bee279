#include "check_print.hpp"

#include <fmt/format.h>

#include <array>
#include <numbers>

namespace ecods::check {

std::string counted(std::size_t count, const std::string& singular, const std::string& plural) {
    return fmt::format("{} {}", count, count == 1 ? singular : plural.empty() ? singular + "s" : plural);
}

namespace {

double in_degrees(double radians) {
    return radians / std::numbers::pi * 180;
}

nlohmann::ordered_json to_json(const Vec3& v) {
    return {v[0], v[1], v[2]};
}

// The feature's triangle; null for no feature, as of a point inside a solid.
nlohmann::ordered_json triangle_of(const Feature& feature) {
    return feature.kind == Feature::Kind::none ? nlohmann::ordered_json() : nlohmann::ordered_json(feature.triangle);
}

nlohmann::ordered_json to_json(const scenes::Scene& scene, const std::vector<DistanceAnswer>& pairs) {
    nlohmann::ordered_json json = nlohmann::ordered_json::array();
    for (const DistanceAnswer& pair : pairs) {
        const ClosestPoints& closest = pair.closest;
        json.push_back({{"a", scene.bodies[pair.a].name},
                        {"b", scene.bodies[pair.b].name},
                        {"distance", closest.distance},
                        {"kind", name_of(closest.kind)},
                        {"point_a", to_json(closest.point_a)},
                        {"point_b", to_json(closest.point_b)},
                        {"triangle_a", triangle_of(closest.a)},
                        {"triangle_b", triangle_of(closest.b)}});
    }
    return json;
}

nlohmann::ordered_json to_json(const scenes::Scene& scene, const std::vector<MeetingAnswer>& pairs) {
    nlohmann::ordered_json json = nlohmann::ordered_json::array();
    for (const MeetingAnswer& pair : pairs) {
        json.push_back({{"a", scene.bodies[pair.a].name},
                        {"b", scene.bodies[pair.b].name},
                        {"time", pair.contact.time},
                        {"kind", name_of(pair.contact.kind)},
                        {"triangle_a", triangle_of(pair.contact.a)},
                        {"triangle_b", triangle_of(pair.contact.b)}});
        if (pair.angle) json.back()["angle"] = *pair.angle;
        if (pair.angle) json.back()["degrees"] = in_degrees(*pair.angle);
    }
    return json;
}

nlohmann::ordered_json to_json(const scenes::Scene& scene, const std::vector<HitAnswer>& hits) {
    nlohmann::ordered_json json = nlohmann::ordered_json::array();
    for (const auto& [ray, body, hit] : hits) {
        json.push_back({{"ray", ray},
                        {"body", scene.bodies[body].name},
                        {"parameter", hit.parameter},
                        {"rank", hit.rank},
                        {"kind", name_of(hit.kind)},
                        {"triangle", triangle_of(hit.feature)},
                        {"point", to_json(hit.point)}});
        if (hit.kind != HitKind::along) continue;
        json.back()["leave_parameter"] = hit.leave_parameter;
        json.back()["leave_point"] = to_json(hit.leave_point);
    }
    return json;
}

std::string triangle_text(const Feature& feature) {
    return feature.kind == Feature::Kind::none ? "none" : std::to_string(feature.triangle);
}

void print_meetings(std::FILE* out, const scenes::Scene& scene, const char* what,
                    const std::vector<MeetingAnswer>& pairs) {
    for (const MeetingAnswer& pair : pairs) {
        fmt::print(out, "  {} at {}{}  {} | {}  ({}, triangles {} and {})\n", what, pair.contact.time,
                   pair.angle ? fmt::format(" after {:.6g} degrees", in_degrees(*pair.angle)) : "",
                   scene.bodies[pair.a].name, scene.bodies[pair.b].name, name_of(pair.contact.kind),
                   triangle_text(pair.contact.a), triangle_text(pair.contact.b));
    }
}

std::string to_text(const Vec3& v) {
    return fmt::format("({}, {}, {})", v[0], v[1], v[2]);
}

void print_hits(std::FILE* out, const scenes::Scene& scene, const std::vector<HitAnswer>& hits) {
    for (const auto& [ray, body, hit] : hits) {
        std::string points = to_text(hit.point);
        if (hit.kind == HitKind::along)
            points += fmt::format(" to {} at {}", to_text(hit.leave_point), hit.leave_parameter);
        fmt::print(out, "  ray {} hits at {}  {}  ({}, triangle {}: {})\n", ray, hit.parameter, scene.bodies[body].name,
                   name_of(hit.kind), triangle_text(hit.feature), points);
    }
}

std::string to_text(const Feature& feature) {
    constexpr std::array names = {"vertex", "edge", "face"};
    if (feature.kind == Feature::Kind::none) return "none";
    return fmt::format("{} {}:{}", names[static_cast<std::size_t>(feature.kind)], feature.triangle, feature.corner);
}

void print_depths(std::FILE* out, const scenes::Scene& scene, const FrameAnswer& answer) {
    for (const auto& [a, b, depth] : answer.depths) {
        fmt::print(out, "  depth {}  {} | {}  (along {}: {}, {})\n", depth.depth, scene.bodies[a].name,
                   scene.bodies[b].name, to_text(depth.direction), to_text(depth.a), to_text(depth.b));
    }
    for (const GapAnswer& pair : answer.gaps) {
        fmt::print(out, "  gap {}  {} | {}\n", pair.distance, scene.bodies[pair.a].name, scene.bodies[pair.b].name);
    }
}

void print_distances(std::FILE* out, const scenes::Scene& scene, const char* what,
                     const std::vector<DistanceAnswer>& pairs) {
    for (const DistanceAnswer& pair : pairs) {
        const ClosestPoints& closest = pair.closest;
        fmt::print(out, "  {} {}  {} | {}  ({}: {}, {})\n", what, closest.distance, scene.bodies[pair.a].name,
                   scene.bodies[pair.b].name, name_of(closest.kind), to_text(closest.point_a),
                   to_text(closest.point_b));
    }
}

}  // namespace

void print_solids(std::FILE* out, const scenes::Scene& scene, const SceneWorld& world) {
    for (std::size_t body = 0; body < scene.bodies.size(); ++body) {
        const std::string& why = world.no_solid_since(body);
        fmt::print(out, "{}  {}{}{}\n", why.empty() ? "solid" : "no solid", scene.bodies[body].name,
                   why.empty() ? "" : ": ", why);
    }
}

void print_frame(std::FILE* out, const scenes::Scene& scene, const FrameAnswer& answer) {
    fmt::print(out, "frame {}: {}, {} with overlapping boxes, {} colliding\n", answer.frame,
               counted(scene.bodies.size(), "body", "bodies"), counted(answer.overlapping.size(), "pair"),
               answer.colliding.size());
    for (const PairAnswer& pair : answer.colliding) {
        fmt::print(out, "  {}  {} | {}  ({})\n", name_of(pair.relation), scene.bodies[pair.a].name,
                   scene.bodies[pair.b].name, counted(pair.triangles.size(), "triangle pair"));
    }
    print_distances(out, scene, "distance", answer.distances);
    print_distances(out, scene, "close", answer.close);
    print_meetings(out, scene, "met", answer.meetings);
    print_meetings(out, scene, "cast meets", answer.casts);
    print_hits(out, scene, answer.hits);
    print_depths(out, scene, answer);
}

void print_report(std::FILE* out, const OracleReport& report) {
    for (const std::string& difference : report.differences) fmt::print(out, "DIFFERS  {}\n", difference);
    std::string distances = report.distances == 0 ? "" : ", " + counted(report.distances, "distance");
    if (report.clearances > 0) distances += ", " + counted(report.clearances, "clearance");
    if (report.moves > 0) distances += fmt::format(", {} moves and casts", report.moves);
    if (report.rays > 0) distances += ", " + counted(report.rays, "ray");
    fmt::print(out, "oracle: checked {}, {}, {}{}: {}\n", counted(report.body_pairs, "body pair"),
               counted(report.triangle_pairs, "touching triangle pair"), counted(report.boxes, "box", "boxes"),
               distances,
               report.differences.empty() ? "no difference" : counted(report.differences.size(), "difference"));
}

nlohmann::ordered_json to_json(const scenes::Scene& scene) {
    nlohmann::ordered_json names = nlohmann::ordered_json::array();
    for (const scenes::SceneBody& body : scene.bodies) names.push_back(body.name);
    nlohmann::ordered_json json{{"bodies", names}};
    for (const auto& [file, counts] : scene.polygons) {
        json["polygons"].push_back({{"file", file},
                                    {"polygons", counts.polygons},
                                    {"ears", counts.ears},
                                    {"crossing", counts.crossing},
                                    {"in_no_plane", counts.in_no_plane}});
        if (counts.crossing > 0) json["polygons"].back()["first_crossing"] = counts.first_crossing;
    }
    json["frames"] = nlohmann::ordered_json::array();
    return json;
}

nlohmann::ordered_json to_json(const scenes::Scene& scene, const FrameAnswer& answer) {
    nlohmann::ordered_json pairs = nlohmann::ordered_json::array();
    for (const PairAnswer& pair : answer.colliding) {
        pairs.push_back({{"a", scene.bodies[pair.a].name},
                         {"b", scene.bodies[pair.b].name},
                         {"relation", name_of(pair.relation)},
                         {"triangle_pairs", pair.triangles.size()}});
    }
    nlohmann::ordered_json frame{
        {"frame", answer.frame}, {"overlapping", answer.overlapping.size()}, {"colliding", pairs}};
    if (!answer.distances.empty()) frame["distances"] = to_json(scene, answer.distances);
    if (answer.clearance) frame["close"] = to_json(scene, answer.close);
    if (!answer.meetings.empty()) frame["met"] = to_json(scene, answer.meetings);
    if (!answer.casts.empty()) frame["casts"] = to_json(scene, answer.casts);
    if (!answer.hits.empty()) frame["hits"] = to_json(scene, answer.hits);
    for (const auto& [a, b, depth] : answer.depths) {
        frame["depths"].push_back({{"a", scene.bodies[a].name},
                                   {"b", scene.bodies[b].name},
                                   {"depth", depth.depth},
                                   {"direction", to_json(depth.direction)},
                                   {"feature_a", to_text(depth.a)},
                                   {"feature_b", to_text(depth.b)}});
    }
    for (const GapAnswer& pair : answer.gaps) {
        frame["gaps"].push_back(
            {{"a", scene.bodies[pair.a].name}, {"b", scene.bodies[pair.b].name}, {"distance", pair.distance}});
    }
    return frame;
}

nlohmann::ordered_json solids_to_json(const scenes::Scene& scene, const SceneWorld& world) {
    nlohmann::ordered_json json = nlohmann::ordered_json::array();
    for (std::size_t body = 0; body < scene.bodies.size(); ++body) {
        const std::string& why = world.no_solid_since(body);
        json.push_back({{"body", scene.bodies[body].name}, {"is_solid", why.empty()}});
        if (!why.empty()) json.back()["why"] = why;
    }
    return json;
}

nlohmann::ordered_json to_json(const OracleReport& report) {
    nlohmann::ordered_json json{
        {"body_pairs", report.body_pairs}, {"triangle_pairs", report.triangle_pairs}, {"boxes", report.boxes}};
    if (report.distances > 0) json["distances"] = report.distances;
    if (report.clearances > 0) json["clearances"] = report.clearances;
    if (report.moves > 0) json["moves_and_casts"] = report.moves;
    if (report.rays > 0) json["rays"] = report.rays;
    json["differing"] = report.differences.size();
    json["differences"] = report.differences;
    return json;
}

}  // namespace ecods::check
