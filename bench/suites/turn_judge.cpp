#include "suites/turn_judge.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "judge/cast_truth.hpp"
#include "oracle/first_contact.hpp"

namespace ecods::bench {

namespace {

using Corners = std::array<Vec3, 3>;

// Boxes are larger by this share of all sizes, which is far more than rounding to doubles.
constexpr double margin_share = 1e-9;
constexpr int piece_count = 256;

struct Box {
    Vec3 min, max;

    void include(const Vec3& p) {
        min = min.cwiseMin(p);
        max = max.cwiseMax(p);
    }
    void grow(double by) {
        min.array() -= by;
        max.array() += by;
    }
    bool overlaps(const Box& other) const {
        return (min.array() <= other.max.array()).all() && (other.min.array() <= max.array()).all();
    }
};

Box box_of(const Corners& corners) {
    Box box{corners[0], corners[0]};
    for (const Vec3& p : corners) box.include(p);
    return box;
}

std::vector<Corners> corners_of(const MeshShape& shape, const Pose& pose) {
    std::vector<Corners> triangles;
    for (const Triangle& t : shape.mesh().triangles()) {
        Corners corners;
        for (std::size_t i = 0; i < 3; ++i) corners[i] = pose.R * shape.mesh().vertices()[t[i]] + pose.t;
        triangles.push_back(corners);
    }
    return triangles;
}

// A turn in plain doubles.
class Arc {
  public:
    explicit Arc(const Turn& turn) : turn_(turn) {}

    Vec3 at(const Vec3& start, double time) const {
        const auto& [w, x, y, z] = turn_.q;
        const double a = 1 + time * (w - 1);
        const Vec3 b = time * Vec3(x, y, z), g = start - turn_.pivot_from, once = b.cross(g);
        const double norm = a * a + b.squaredNorm();
        return turn_.pivot_from + time * (turn_.pivot_to - turn_.pivot_from) + g +
               2 / norm * (a * once + b.cross(once));
    }
    // How far an arc of the point leaves its chord, which spans this angle: the pivot stays.
    double sagitta(const Vec3& start, double angle) const {
        return (start - turn_.pivot_from).norm() * angle * angle / 8;
    }
    double angle_at(double time) const {
        const auto& [w, x, y, z] = turn_.q;
        return 2 * std::atan2(time * Vec3(x, y, z).norm(), 1 + time * (w - 1));
    }

  private:
    Turn turn_;
};

Box swept(const Arc& arc, const Corners& start, double from, double to, double angle, double margin) {
    Box box = box_of({arc.at(start[0], from), arc.at(start[1], from), arc.at(start[2], from)});
    double most = 0;
    for (const Vec3& p : start) {
        box.include(arc.at(p, to));
        most = std::max(most, arc.sagitta(p, angle));
    }
    box.grow(most * (1 + margin_share) + margin);
    return box;
}

struct Bodies {
    const Turning<MeshShape>& turning;
    const Posed<MeshShape>& resting;
    std::vector<Corners> a, b;  // at the start
    std::vector<Box> boxes_b;
    Box all_b;
    double margin = 0;

    Bodies(const Turning<MeshShape>& turning_body, const Posed<MeshShape>& resting_body)
        : turning(turning_body),
          resting(resting_body),
          a(corners_of(*turning.what, turning.pose)),
          b(corners_of(*resting.what, resting.pose)),
          all_b(box_of(b[0])) {
        double size = turning.turn.pivot_from.norm();
        for (const auto* list : {&a, &b}) {
            for (const Corners& corners : *list) size = std::max(size, corners[0].norm());
        }
        margin = margin_share * size;
        for (const Corners& corners : b) {
            boxes_b.push_back(box_of(corners));
            for (const Vec3& p : corners) all_b.include(p);
        }
    }
};

// Pairs of triangles that may share a point from one time to another.
std::vector<TrianglePair> near_pairs(const Bodies& bodies, double from, double to) {
    const Arc arc(bodies.turning.turn);
    std::vector<TrianglePair> pairs;
    for (int piece = 0; piece < piece_count; ++piece) {
        const double step = (to - from) / piece_count, begin = from + piece * step, end = std::min(to, begin + step);
        const double angle = arc.angle_at(end) - arc.angle_at(begin);
        for (std::uint32_t i = 0; i < bodies.a.size(); ++i) {
            const Box box = swept(arc, bodies.a[i], begin, end, angle, bodies.margin);
            if (!box.overlaps(bodies.all_b)) continue;
            for (std::uint32_t j = 0; j < bodies.b.size(); ++j) {
                if (box.overlaps(bodies.boxes_b[j])) pairs.push_back({i, j});
            }
        }
    }
    std::ranges::sort(pairs);
    const auto repeated = std::ranges::unique(pairs);
    pairs.erase(repeated.begin(), repeated.end());
    return pairs;
}

// Some triangles of a mesh, each with corners of its own.
struct Part {
    std::vector<Vec3> vertices;
    std::vector<Triangle> triangles;
    std::vector<std::uint32_t> indices;  // in the mesh, ascending

    Part(const Mesh& mesh, std::vector<std::uint32_t> chosen) : indices(std::move(chosen)) {
        std::ranges::sort(indices);
        const auto repeated = std::ranges::unique(indices);
        indices.erase(repeated.begin(), repeated.end());
        for (const std::uint32_t index : indices) {
            const auto first = static_cast<std::uint32_t>(vertices.size());
            for (const std::uint32_t corner : mesh.triangles()[index]) vertices.push_back(mesh.vertices()[corner]);
            triangles.push_back({first, first + 1, first + 2});
        }
    }
    oracle::Soup soup(const Pose& pose) const { return {vertices, triangles, pose}; }
};

std::optional<FirstContact> contact_of(const Bodies& bodies, std::span<const TrianglePair> pairs) {
    std::vector<std::uint32_t> of_a, of_b;
    for (const TrianglePair& pair : pairs) {
        of_a.push_back(pair.a);
        of_b.push_back(pair.b);
    }
    const Part a(bodies.turning.what->mesh(), of_a), b(bodies.resting.what->mesh(), of_b);
    const auto& [w, x, y, z] = bodies.turning.turn.q;
    auto contact = judge::to_first_contact(oracle::first_contact(
        oracle::TurningSoup{
            a.soup(bodies.turning.pose), {w, x, y, z}, bodies.turning.turn.pivot_from, bodies.turning.turn.pivot_to},
        b.soup(bodies.resting.pose)));
    if (!contact) return std::nullopt;
    contact->a.triangle = a.indices[contact->a.triangle];
    contact->b.triangle = b.indices[contact->b.triangle];
    return contact;
}

// The pairs whose times round to the least one are asked about together: they tie.
std::optional<FirstContact> first_of(const Bodies& bodies, const std::vector<TrianglePair>& pairs) {
    std::vector<TrianglePair> tied;
    double least = 2;
    for (const TrianglePair& pair : pairs) {
        const auto contact = contact_of(bodies, std::span(&pair, 1));
        if (!contact || contact->time > least) continue;
        if (contact->time < least) tied.clear();
        tied.push_back(pair);
        least = contact->time;
    }
    return tied.empty() ? std::nullopt : contact_of(bodies, tied);
}

}  // namespace

std::optional<FirstContact> true_contact(const Turning<MeshShape>& a, const Posed<MeshShape>& b,
                                         std::optional<double> claimed) {
    const Bodies bodies(a, b);
    if (claimed && *claimed < 1) {
        if (const auto contact = first_of(bodies, near_pairs(bodies, 0, *claimed))) return contact;
    }
    return first_of(bodies, near_pairs(bodies, 0, 1));
}

}  // namespace ecods::bench
