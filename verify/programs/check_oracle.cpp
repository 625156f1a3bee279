#include "check_oracle.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "check_print.hpp"

namespace ecods::check {

void OracleJudge::check_frame(SceneWorld& world, const FrameAnswer& answer) {
    pose_meshes(world);
    check_boxes(world, answer);
    for (std::size_t a = 0; a < scene_.bodies.size(); ++a) {
        for (std::size_t b = a + 1; b < scene_.bodies.size(); ++b) check_pair(world, answer, a, b);
    }
}

void OracleJudge::pose_meshes(SceneWorld& world) {
    meshes_.resize(scene_.bodies.size());
    has_moved_.assign(scene_.bodies.size(), false);
    for (const std::size_t body : world.moved()) {
        meshes_[body].emplace(scene_.meshes[scene_.bodies[body].mesh_index].mesh, world.pose(body));
        has_moved_[body] = true;
    }
}

void OracleJudge::check_boxes(const SceneWorld& world, const FrameAnswer& answer) {
    std::vector<Aabb> boxes;
    for (std::size_t body = 0; body < scene_.bodies.size(); ++body) boxes.push_back(world.box(body));
    for (const std::size_t body : world.moved()) {
        ++report_.boxes;
        if (!oracle::box_contains(boxes[body], *meshes_[body])) {
            differ(answer, scene_.bodies[body].name, "the stored box does not contain the body");
        }
    }
    if (oracle::overlapping_boxes(boxes) != answer.overlapping) {
        differ(answer, "all bodies", "the overlapping pairs are not those of all pairs of boxes");
    }
}

const oracle::Verdict& OracleJudge::verdict(std::size_t a, std::size_t b) {
    static const oracle::Verdict disjoint;
    const oracle::OracleMesh& mesh_a = *meshes_[a];
    const oracle::OracleMesh& mesh_b = *meshes_[b];
    if (!oracle::boxes_overlap(mesh_a.outer_box(), mesh_b.outer_box())) {
        verdicts_.erase({a, b});
        return disjoint;
    }
    const auto [entry, is_new] = verdicts_.try_emplace({a, b});
    if (is_new || has_moved_[a] || has_moved_[b]) entry->second = oracle::verdict(mesh_a, mesh_b);
    return entry->second;
}

void OracleJudge::check_pair(SceneWorld& world, const FrameAnswer& answer, std::size_t a, std::size_t b) {
    const oracle::Verdict& exact = verdict(a, b);
    ++report_.body_pairs;
    const auto listed = std::find_if(answer.colliding.begin(), answer.colliding.end(),
                                     [&](const PairAnswer& pair) { return pair.a == a && pair.b == b; });
    const bool is_listed = listed != answer.colliding.end();
    const std::string bodies = scene_.bodies[a].name + ", " + scene_.bodies[b].name;
    if (is_listed != (exact.relation != Relation::disjoint)) {
        differ(answer, bodies,
               fmt::format("{} as colliding, but {}", is_listed ? "listed" : "not listed", name_of(exact.relation)));
    }
    // Pairs that are not listed are asked about, too.
    const Relation relation = is_listed ? listed->relation : world.world().relation(world.id(a), world.id(b));
    const std::vector<TrianglePair> triangles =
        is_listed ? listed->triangles : world.world().intersecting_triangles(world.id(a), world.id(b));
    report_.triangle_pairs += std::max(triangles.size(), exact.triangles.size());
    if (relation != exact.relation) {
        differ(answer, bodies, fmt::format("{}, but exactly {}", name_of(relation), name_of(exact.relation)));
    }
    if (triangles != exact.triangles) {
        differ(answer, bodies,
               fmt::format("{} triangle pairs, but exactly {} (or others)", triangles.size(), exact.triangles.size()));
    }
}

void OracleJudge::differ(const FrameAnswer& answer, const std::string& bodies, const std::string& text) {
    report_.differences.push_back(fmt::format("frame {}: {}: {}", answer.frame, bodies, text));
}

}  // namespace ecods::check
