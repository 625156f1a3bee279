// The order of hits of many bodies, which only fractions know.
#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <tuple>

#include "fuzz/base/failure.hpp"
#include "fuzz/base/user_shape.hpp"
#include "fuzz/checks/text.hpp"
#include "fuzz/checks/truth.hpp"
#include "fuzz/checks/way_questions.hpp"
#include "judge/hit_truth.hpp"
#include "oracle/solid.hpp"
#include "scenes/numbers_of.hpp"

namespace ecods::fuzz {
namespace {

// Triangles of all bodies together; the oracle judges some thousand of them in a millisecond.
constexpr std::size_t triangles_max = 4000;

struct TrueHit {
    BodyId body;
    mpq_class at;
    Hit hit;
};

std::string text_of(const BodyId& body, const Hit& hit) {
    return fmt::format("{} {} rank {}", text(body), judge::text(hit), hit.rank);
}

// The hit of a line that begins inside a solid.
std::optional<Hit> hit_from_inside(const std::variant<Segment, Ray>& line, const Boundary& boundary, const Pose& pose) {
    if (!boundary.has_inside) return std::nullopt;
    const Vec3 begin = line.index() == 0 ? std::get<Segment>(line).a : std::get<Ray>(line).origin;
    const oracle::Soup solid{boundary.mesh->vertices(), boundary.mesh->triangles(), pose};
    if (oracle::locate(begin, solid).side != oracle::PointSide::inside) return std::nullopt;
    Hit hit;
    hit.kind = HitKind::inside;
    hit.feature = no_feature;
    hit.point = hit.leave_point = begin;
    return hit;
}

}  // namespace

void check_hit_order(const World& world, const std::variant<Segment, Ray>& line, Counters& counters) {
    std::vector<TrueHit> expected;
    std::size_t triangle_count = 0;
    for (const BodyId body : world.bodies()) {
        const auto shape = world.shape(body);
        const Pose pose = world.pose(body);
        const Boundary boundary = boundary_of(*shape, mesh_of(*shape), pose);
        const MeshShape mesh(boundary.mesh);
        triangle_count += mesh.mesh().triangles().size();
        if (triangle_count > triangles_max) return;
        const auto exact = judge::exact_hits(line, {mesh, pose});
        auto hits = judge::to_hits(exact);
        for (Hit& hit : hits) hit.feature.triangle = boundary.name(hit.feature.triangle);
        if (const auto inside = hit_from_inside(line, boundary, pose)) expected.push_back({body, 0, *inside});
        // What a shape of the caller's own says counts as it is.
        const bool is_rounded = shape->kind() != ShapeKind::mesh();
        for (std::size_t i = 0; i < exact.size(); ++i) {
            if (is_rounded && hits[i].parameter > std::numeric_limits<double>::max()) return;
            expected.push_back({body, is_rounded ? mpq_class(hits[i].parameter) : exact[i].enter, hits[i]});
        }
    }
    std::ranges::stable_sort(expected, [](const TrueHit& a, const TrueHit& b) {
        const int order = cmp(a.at, b.at);
        return order != 0 ? order < 0 : std::tuple(a.body, a.hit.triangle()) < std::tuple(b.body, b.hit.triangle());
    });
    std::uint32_t rank = 0;
    for (std::size_t i = 0; i < expected.size(); ++i) {
        if (i > 0 && expected[i].at != expected[i - 1].at) ++rank;
        expected[i].hit.rank = rank;
    }
    QueryMemory memory;
    const auto got = std::visit([&](const auto& one) { return world.all_hits(one, {}, memory); }, line);
    if (got.size() != expected.size()) {
        throw CheckFailed("hits against the oracle", fmt::format("{}", expected.size()), fmt::format("{}", got.size()));
    }
    for (std::size_t i = 0; i < got.size(); ++i) {
        if (got[i].body == expected[i].body && judge::is_same(got[i].hit, expected[i].hit)) continue;
        throw CheckFailed("hits against the oracle", text_of(expected[i].body, expected[i].hit),
                          text_of(got[i].body, got[i].hit));
    }
    ++counters["checked: hits in worlds against the oracle"];
    counters["checked: ties of hits in worlds"] += expected.empty() ? 0 : expected.size() - rank - 1;
}

}  // namespace ecods::fuzz
