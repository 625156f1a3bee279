// Implements the functions of distance.hpp and solid.hpp for points. If a face or an edge certainly contains the only
// closest point, that feature determines the side of a solid's surface on which the point is: the segment to the
// closest point meets the surface nowhere else. Otherwise a ray decides the side.
#include <optional>
#include <vector>

#include "base/double_key.hpp"
#include "base/make_error.hpp"
#include "ecods/distance.hpp"
#include "ecods/primitives.hpp"
#include "ecods/solid.hpp"
#include "exact/simplex/common_pose.hpp"
#include "query/body/posed_body.hpp"
#include "query/distance/point_search.hpp"
#include "query/intersection/asking.hpp"
#include "query/solid/solid_parts.hpp"

namespace ecods {
namespace {

void require_all_valid(std::span<const Vec3> points) {
    for (std::size_t i = 0; i < points.size(); ++i) {
        try {
            require_valid(points[i]);
        } catch (const InvalidArgument& error) {
            throw error.at({}, i);
        }
    }
}

// SolidSides finds sides of a posed solid's surface from features of its mesh.
class SolidSides {
  public:
    explicit SolidSides(const PosedBody& body) : body_(body) {
        if (!body.has_inside()) return;
        const Posed<Solid> posed = body.solid();
        solid_ = posed.what;
        is_mirror_ = exact::is_mirror(posed.pose.R);
    }

    bool has_inside() const noexcept { return solid_ != nullptr; }

    // Returns the side on which the point is, given the result of search.find(point).
    Side of(const Vec3& point, const PointSearch& search, QueryMemory& memory) const {
        if (std::optional<OnlyFeature> only = search.only(); only && can_name()) {
            body_.rename(only->feature);
            if (only->feature.kind == Feature::Kind::face) return of_face(*only);
            if (only->feature.kind == Feature::Kind::edge) {
                if (const auto side = of_edge(only->feature)) return *side;
            }
        }
        return as_part(memory, [&] { return locate(point, body_.solid(), memory).side; });
    }

  private:
    // Returns true if the triangles of the boundary are those of the proper mesh, because no edges were split.
    bool can_name() const noexcept { return SolidAccess::parts(*solid_).origins.empty(); }
    bool faces_in(std::uint32_t triangle) const { return SolidAccess::shells(*solid_).faces_in[triangle] != 0; }

    Side of_face(const OnlyFeature& only) const {
        const bool is_outer = (only.side > 0) != (faces_in(only.feature.triangle) != is_mirror_);
        return is_outer ? Side::outside : Side::inside;
    }

    // Returns the side of the point if the edge has two faces that are not in one plane; otherwise nullopt. A point
    // whose closest point is inside the edge is at a right angle or more to both faces: it is outside if the edge is
    // convex, inside if it is not. An affine bijection keeps an edge convex, so the mesh's own coordinates decide.
    std::optional<Side> of_edge(const Feature& edge) const {
        const SolidAccess::Parts& parts = SolidAccess::parts(*solid_);
        const auto triangles = parts.proper.mesh->triangles();
        const auto vertices = parts.proper.mesh->vertices();
        const auto sides = parts.edges.sides(parts.edges.edge_of({edge.triangle, edge.corner}));
        if (sides.size() != 2) return std::nullopt;
        const auto [p, q, r] = corners_from(triangles, sides[0]);
        const std::uint32_t beyond = corners_from(triangles, sides[1])[2];
        const Sign above = orient3d(vertices[p], vertices[q], vertices[r], vertices[beyond]);
        if (above == Sign::zero) return std::nullopt;
        const bool is_dent = (above == Sign::positive) != faces_in(sides[0].triangle);
        return is_dent ? Side::inside : Side::outside;
    }

    const PosedBody& body_;
    const Solid* solid_ = nullptr;
    bool is_mirror_ = false;
};

// AskedPoints answers questions about several points and one body.
class AskedPoints {
  public:
    AskedPoints(const Posed<MeshShape>& body, QueryMemory& memory)
        : body_(body), sides_(body_), search_(body_.boundary(), memory), memory_(memory) {}

    ClosestPoint closest(const Vec3& point) {
        search_.find(point);
        if (sides_.has_inside() && sides_.of(point, search_, memory_) == Side::inside) {
            ClosestPoint inside{0, no_feature, point};
            for (int axis = 0; axis < 3; ++axis) {
                if (key_of(point[axis]) == 0) inside.point[axis] = 0;
            }
            return inside;
        }
        const ClosestPoints points = search_.closest();
        ClosestPoint result{points.distance, points.b, points.point_b};
        body_.rename(result.feature);
        return result;
    }

    double signed_distance(const Vec3& point) {
        search_.find(point);
        const double distance = search_.distance();
        if (!sides_.has_inside() || key_of(distance) == 0) return distance;
        return sides_.of(point, search_, memory_) == Side::inside ? -distance : distance;
    }

  private:
    PosedBody body_;
    SolidSides sides_;
    PointSearch search_;
    QueryMemory& memory_;
};

// Returns ask_one(point, memory) for each point.
template <class Answer, class AskOne>
std::vector<Answer> for_each_point(std::span<const Vec3> points, const Ask& ask, AskOne&& ask_one) {
    require_all_valid(points);
    Asking asking(ask);
    std::vector<Answer> answers;
    answers.reserve(points.size());
    for (const Vec3& point : points) answers.push_back(ask_one(point, asking.memory()));
    return answers;
}

}  // namespace

ClosestPoint closest(const Eigen::Ref<const Vec3>& point, const Posed<MeshShape>& body, const Ask& ask) {
    const Vec3 at = point;
    require_valid(at);
    Asking asking(ask);
    return AskedPoints(body, asking.memory()).closest(at);
}

double signed_distance(const Eigen::Ref<const Vec3>& point, const Posed<MeshShape>& body, const Ask& ask) {
    const Vec3 at = point;
    require_valid(at);
    Asking asking(ask);
    return AskedPoints(body, asking.memory()).signed_distance(at);
}

std::vector<ClosestPoint> closest(std::span<const Vec3> points, const Posed<MeshShape>& body, const Ask& ask) {
    std::optional<AskedPoints> asked;
    return for_each_point<ClosestPoint>(points, ask, [&](const Vec3& point, QueryMemory& memory) {
        if (!asked) asked.emplace(body, memory);
        return asked->closest(point);
    });
}

std::vector<double> signed_distance(std::span<const Vec3> points, const Posed<MeshShape>& body, const Ask& ask) {
    std::optional<AskedPoints> asked;
    return for_each_point<double>(points, ask, [&](const Vec3& point, QueryMemory& memory) {
        if (!asked) asked.emplace(body, memory);
        return asked->signed_distance(point);
    });
}

std::vector<Location> locate(std::span<const Vec3> points, const Posed<Solid>& solid, const Ask& ask) {
    return for_each_point<Location>(
        points, ask, [&](const Vec3& point, QueryMemory& memory) { return locate(point, solid, memory); });
}

}  // namespace ecods
