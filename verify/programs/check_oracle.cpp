#include "check_oracle.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>

#include "check_print.hpp"
#include "judge/distance_truth.hpp"
#include "judge/solid_truth.hpp"
#include "judge/text.hpp"
#include "oracle/distance.hpp"
#include "oracle/oracle.hpp"
#include "oracle/solid.hpp"

namespace ecods::check {

struct OracleJudge::State {
    std::vector<std::optional<oracle::OracleMesh>> meshes;                    // by body
    std::vector<bool> has_moved;                                              // by body, in this frame
    std::map<std::pair<std::size_t, std::size_t>, oracle::Verdict> verdicts;  // of pairs whose certified boxes overlap

    const oracle::Verdict& verdict(std::size_t a, std::size_t b);
};

OracleJudge::OracleJudge(const scenes::Scene& scene) : scene_(scene), state_(std::make_unique<State>()) {}

OracleJudge::~OracleJudge() = default;

void OracleJudge::check_frame(SceneWorld& world, const FrameAnswer& answer) {
    pose_meshes(world);
    check_boxes(world, answer);
    for (std::size_t a = 0; a < scene_.bodies.size(); ++a) {
        for (std::size_t b = a + 1; b < scene_.bodies.size(); ++b) check_pair(world, answer, a, b);
    }
    for (const DistanceAnswer& pair : answer.distances) check_distance(distances(world, pair.a, pair.b), answer, pair);
    if (answer.clearance) check_close(world, answer);
    if (world.questions().has_moves) check_meetings(world, answer);
    if (world.questions().has_casts) check_casts(world, answer);
    check_hits(world, answer);
}

oracle::MeshDistances OracleJudge::distances(const SceneWorld& world, std::size_t a, std::size_t b) const {
    return {judge::soup(world.posed(a)), judge::soup(world.posed(b))};
}

void OracleJudge::check_distance(const oracle::MeshDistances& exact, const FrameAnswer& answer,
                                 const DistanceAnswer& pair) {
    ++report_.distances;
    const ClosestPoints closest = judge::to_closest_points(exact.closest());
    if (judge::is_same(pair.closest, closest)) return;
    differ(answer, scene_.bodies[pair.a].name + ", " + scene_.bodies[pair.b].name,
           fmt::format("distance {}, but exactly {}", judge::text(pair.closest), judge::text(closest)));
}

void OracleJudge::check_close(const SceneWorld& world, const FrameAnswer& answer) {
    for (std::size_t a = 0; a < scene_.bodies.size(); ++a) {
        for (std::size_t b = a + 1; b < scene_.bodies.size(); ++b) {
            ++report_.clearances;
            const oracle::MeshDistances exact = distances(world, a, b);
            const auto listed = std::find_if(answer.close.begin(), answer.close.end(),
                                             [&](const DistanceAnswer& pair) { return pair.a == a && pair.b == b; });
            const bool is_listed = listed != answer.close.end();
            if (is_listed) check_distance(exact, answer, *listed);
            if (is_listed == exact.within(*answer.clearance)) continue;
            differ(answer, scene_.bodies[a].name + ", " + scene_.bodies[b].name,
                   is_listed ? "listed as close, but is not" : "not listed as close, but is");
        }
    }
}

void OracleJudge::pose_meshes(SceneWorld& world) {
    state_->meshes.resize(scene_.bodies.size());
    state_->has_moved.assign(scene_.bodies.size(), false);
    for (const std::size_t body : world.moved()) {
        state_->meshes[body].emplace(scene_.meshes[scene_.bodies[body].mesh_index].mesh, world.pose(body));
        state_->has_moved[body] = true;
    }
}

void OracleJudge::check_boxes(const SceneWorld& world, const FrameAnswer& answer) {
    std::vector<Aabb> boxes;
    for (std::size_t body = 0; body < scene_.bodies.size(); ++body) boxes.push_back(world.box(body));
    for (const std::size_t body : world.moved()) {
        ++report_.boxes;
        if (!oracle::box_contains(boxes[body], *state_->meshes[body])) {
            differ(answer, scene_.bodies[body].name, "the stored box does not contain the body");
        }
    }
    if (oracle::overlapping_boxes(boxes) != answer.overlapping) {
        differ(answer, "all bodies", "the overlapping pairs are not those of all pairs of boxes");
    }
}

const oracle::Verdict& OracleJudge::State::verdict(std::size_t a, std::size_t b) {
    static const oracle::Verdict apart;
    const oracle::OracleMesh& mesh_a = *meshes[a];
    const oracle::OracleMesh& mesh_b = *meshes[b];
    if (!oracle::boxes_overlap(mesh_a.outer_box(), mesh_b.outer_box())) {
        verdicts.erase({a, b});
        return apart;
    }
    const auto [entry, is_new] = verdicts.try_emplace({a, b});
    if (is_new || has_moved[a] || has_moved[b]) entry->second = oracle::verdict(mesh_a, mesh_b);
    return entry->second;
}

namespace {

bool is_solid(const Posed<MeshShape>& body) {
    return body.what->form() != MeshForm::surface;
}

// The relation of two bodies of which one is a solid, or both.
Relation relation_of_sets(const Posed<MeshShape>& a, const Posed<MeshShape>& b) {
    if (!is_solid(a)) return oracle::surface_relation(judge::soup(a), judge::soup(b));
    if (!is_solid(b)) return judge::mirrored(oracle::surface_relation(judge::soup(b), judge::soup(a)));
    return oracle::solid_relation(judge::soup(a), judge::soup(b));
}

}  // namespace

void OracleJudge::check_pair(SceneWorld& world, const FrameAnswer& answer, std::size_t a, std::size_t b) {
    const Posed<MeshShape> body_a = world.posed(a), body_b = world.posed(b);
    const bool are_surfaces = !is_solid(body_a) && !is_solid(body_b);
    const oracle::Verdict* const surfaces = are_surfaces ? &state_->verdict(a, b) : nullptr;
    const Relation exact = are_surfaces ? surfaces->relation : relation_of_sets(body_a, body_b);
    ++report_.body_pairs;
    const auto listed = std::find_if(answer.colliding.begin(), answer.colliding.end(),
                                     [&](const PairAnswer& pair) { return pair.a == a && pair.b == b; });
    const bool is_listed = listed != answer.colliding.end();
    const std::string bodies = scene_.bodies[a].name + ", " + scene_.bodies[b].name;
    if (is_listed != (exact != Relation::apart)) {
        differ(answer, bodies,
               fmt::format("{} as colliding, but {}", is_listed ? "listed" : "not listed", name_of(exact)));
    }
    // Pairs that are not listed are asked about, too.
    const Relation relation = is_listed ? listed->relation : world.world().relation(world.id(a), world.id(b));
    if (relation != exact) {
        differ(answer, bodies, fmt::format("{}, but exactly {}", name_of(relation), name_of(exact)));
    }
    if (!are_surfaces) return;
    const std::vector<TrianglePair> triangles =
        is_listed ? listed->triangles : world.world().intersecting_triangles(world.id(a), world.id(b));
    check_triangles(answer, bodies, triangles, surfaces->triangles);
}

void OracleJudge::check_triangles(const FrameAnswer& answer, const std::string& bodies,
                                  const std::vector<TrianglePair>& triangles, const std::vector<TrianglePair>& exact) {
    report_.triangle_pairs += std::max(triangles.size(), exact.size());
    if (triangles == exact) return;
    differ(answer, bodies,
           fmt::format("{} triangle pairs, but exactly {} (or others)", triangles.size(), exact.size()));
}

void OracleJudge::differ(const FrameAnswer& answer, const std::string& bodies, const std::string& text) {
    report_.differences.push_back(fmt::format("frame {}: {}: {}", answer.frame, bodies, text));
}

bool oracle_agrees(const scenes::HardCase& hard, Relation relation, const std::vector<TrianglePair>& triangles) {
    const oracle::OracleMesh a(hard.a.mesh, hard.a.pose);
    const oracle::OracleMesh b(hard.b.mesh, hard.b.pose);
    if (oracle::relation(a, b) != relation || oracle::intersecting_triangles(a, b) != triangles) return false;
    if (!hard.solid_relation) return true;
    const auto soup = [](const scenes::HardCase::Body& body) {
        return oracle::Soup{body.mesh->vertices(), body.mesh->triangles(), body.pose};
    };
    return name_of(oracle::solid_relation(soup(hard.a), soup(hard.b))) == *hard.solid_relation;
}

}  // namespace ecods::check
