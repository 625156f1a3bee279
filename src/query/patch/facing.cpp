#include "query/patch/facing.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "exact/point/posed_point.hpp"
#include "exact/point/vectors.hpp"

namespace ecods::patches {
namespace {

using exact::cross;
using exact::dot;
using exact::minus;
using Kind = Feature::Kind;

// Square is the square of a cosine or sine: num / (den n . n), with n the normal.
struct Square {
    ScaledInteger num, den;
};

class Facing {
  public:
    Facing(const HullInSpace& body, const ExactNormal& normal, bool is_against, double min_cos_squared)
        : body_(body), hull_(body.hull), normal_(normal), is_against_(is_against), limit_(min_cos_squared) {}

    // Returns, of the faces at `support`, the face whose normal has the least angle to the patch's normal (or its
    // opposite if is_against_), if the squared cosine is at least min_cos_squared; otherwise nullopt. If several faces
    // have equal angles, returns the face with the least index, which has the least name.
    std::optional<HullFeature> face_at(const HullFeature& support) const {
        std::optional<Square> best;
        HullFeature result{Kind::face, 0};
        for (const std::uint32_t face : faces_at(support)) {
            const std::optional<Square> cosine = cosine_of(face);
            if (!cosine || compare(cosine->num, limit_ * cosine->den * normal_.square) < 0) continue;
            if (best && compare(cosine->num * best->den, best->num * cosine->den) <= 0) continue;
            best = cosine;
            result.index = face;
        }
        return best ? std::optional(result) : std::nullopt;
    }

    // Returns, of the edges at a vertex, the edge with the least angle to the plane perpendicular to the normal, if the
    // squared sine is at most 1 - min_cos_squared; otherwise nullopt.
    std::optional<HullFeature> edge_at(std::uint32_t vertex) const {
        const ScaledInteger most = ScaledInteger(1.0) - limit_;
        std::optional<Square> best;
        HullFeature result{Kind::edge, 0};
        for (const std::uint32_t edge : edges_at(vertex)) {
            const auto& ends = hull_.edges[edge].ends;
            const ScaledLongVector way = minus(body_.point(ends[1]), body_.point(ends[0]));
            const ScaledInteger along = dot(way, normal_.n);
            Square sine{along * along, dot(way, way)};
            if (compare(sine.num, most * sine.den * normal_.square) > 0) continue;
            if (best && compare(sine.num * best->den, best->num * sine.den) >= 0) continue;
            best = std::move(sine);
            result.index = edge;
        }
        return best ? std::optional(result) : std::nullopt;
    }

  private:
    // Returns the square of the cosine of the angle between a face's outer normal and the patch's normal (or its
    // opposite if is_against_); nullopt if the cosine is not positive. A flat hull has outer normals on both sides.
    std::optional<Square> cosine_of(std::uint32_t face) const {
        const ScaledLongVector m = face_normal(body_, face);
        const ScaledInteger along = dot(m, normal_.n);
        const bool is_turned = hull_.is_flat() ? along.sign() < 0 : body_.is_mirrored != is_against_;
        if (along.sign() != (is_turned ? -1 : 1)) return std::nullopt;
        return Square{along * along, dot(m, m)};
    }

    static std::vector<std::uint32_t> sorted(std::vector<std::uint32_t> list) {
        std::ranges::sort(list);
        const auto rest = std::ranges::unique(list);
        list.erase(rest.begin(), rest.end());
        return list;
    }
    std::vector<std::uint32_t> edges_at(std::uint32_t vertex) const {
        std::vector<std::uint32_t> edges;
        for (const auto& neighbor : hull_.neighbors_of(vertex)) edges.push_back(neighbor.edge);
        return sorted(std::move(edges));
    }
    // Returns the faces that contain an edge or a vertex.
    std::vector<std::uint32_t> faces_at(const HullFeature& support) const {
        std::vector<std::uint32_t> faces;
        for (const std::uint32_t edge :
             support.kind == Kind::vertex ? edges_at(support.index) : std::vector<std::uint32_t>{support.index}) {
            for (const std::uint32_t face : hull_.edges[edge].faces) {
                if (face != convex::Hull::no_face) faces.push_back(face);
            }
        }
        return sorted(std::move(faces));
    }

    const HullInSpace& body_;
    const convex::Hull& hull_;
    const ExactNormal& normal_;
    bool is_against_;
    ScaledInteger limit_;
};

}  // namespace

ScaledLongVector HullInSpace::point(std::uint32_t v) const {
    return exact::posed_point(pose, vertex(v));
}

ScaledLongVector face_normal(const HullInSpace& body, std::uint32_t face) {
    const auto cycle = body.hull.cycle_of(face);
    const ScaledLongVector p = body.point(cycle[0].vertex);
    return cross(minus(body.point(cycle[1].vertex), p), minus(body.point(cycle[2].vertex), p));
}

Polygon polygon_of(const HullInSpace& body, const HullFeature& part, const ExactNormal& normal, bool is_against) {
    const bool is_two_sided = body.hull.is_flat() && part.kind == Kind::face;
    const bool is_clockwise =
        is_two_sided ? dot(face_normal(body, part.index), normal.n).sign() < 0 : body.is_mirrored != is_against;
    return {body.hull, part, is_clockwise};
}

HullFeature facing_feature(const HullInSpace& body, const HullFeature& support, const ExactNormal& normal,
                           bool is_against, double min_cos_squared) {
    if (support.kind == Kind::face) return support;
    const Facing facing(body, normal, is_against, min_cos_squared);
    if (const auto face = facing.face_at(support)) return *face;
    if (support.kind == Kind::edge) return support;
    return facing.edge_at(support.index).value_or(support);
}

}  // namespace ecods::patches
