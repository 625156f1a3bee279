#include "query/solid/mesh_edges.hpp"

#include <algorithm>
#include <limits>

#include "base/double_key.hpp"
#include "base/make_error.hpp"
#include "ecods/primitives.hpp"

namespace ecods {
namespace {

// An OpenSide is a side of a triangle, in the list of the lesser of its two vertices. `other` is the greater vertex, by
// which the list is sorted.
struct OpenSide {
    std::uint32_t other;
    SideRef side;

    friend constexpr auto operator<=>(const OpenSide&, const OpenSide&) = default;
};

// A LooseEnd is one end of an edge that an odd number of triangles share: the vertex `at`. `other` is the edge's other
// end.
struct LooseEnd {
    std::uint32_t at;
    std::uint32_t other;
    SideRef side;
};

// LineOrder orders the lines through a vertex `at` by direction. Each direction is negated if its first nonzero
// coordinate is negative. Then lines are ordered by the axis of that coordinate, and then by slope.
class LineOrder {
  public:
    explicit LineOrder(std::span<const Vec3> vertices) : vertices_(vertices) {}

    int compare(std::uint32_t at, std::uint32_t a, std::uint32_t b) const {
        const Vec3 &o = vertices_[at], &p = vertices_[a], &q = vertices_[b];
        const int axis_p = first_axis(o, p), axis_q = first_axis(o, q);
        if (axis_p != axis_q) return axis_p < axis_q ? -1 : 1;
        const int turned = (compare_points(o, p) < 0) == (compare_points(o, q) < 0) ? -1 : 1;
        for (int axis = axis_p + 1; axis < 3; ++axis) {
            const auto flat = [&](const Vec3& v) { return Vec2(v[axis_p], v[axis]); };
            const auto turn = static_cast<int>(orient2d(flat(o), flat(p), flat(q)));
            if (turn != 0) return turn * turned;
        }
        return 0;
    }

  private:
    static int first_axis(const Vec3& o, const Vec3& p) noexcept {
        return key_of(o[0]) != key_of(p[0]) ? 0 : key_of(o[1]) != key_of(p[1]) ? 1 : 2;
    }

    std::span<const Vec3> vertices_;
};

}  // namespace

MeshEdges::MeshEdges(const ProperMesh& proper) {
    const auto triangles = proper.mesh->triangles();
    const std::size_t vertex_count = proper.mesh->vertices().size();
    if (triangles.size() > std::numeric_limits<std::uint32_t>::max() / 3) {
        throw mesh_too_large(vertex_count, triangles.size());
    }
    const auto for_sides = [&](auto&& visit) {
        for (std::uint32_t i = 0; i < triangles.size(); ++i) {
            if (!proper.is_proper(i)) continue;
            for (std::uint32_t corner = 0; corner < 3; ++corner) {
                const auto [a, b] = std::minmax(triangles[i][corner], triangles[i][(corner + 1) % 3]);
                visit(std::uint32_t{a}, OpenSide{b, {i, corner}});
            }
        }
    };
    // Sorts the sides by their lesser vertex, then by the greater one.
    std::vector<std::uint32_t> begin(vertex_count + 1, 0);
    for_sides([&](std::uint32_t vertex, const OpenSide&) { ++begin[vertex + 1]; });
    for (std::size_t i = 0; i < vertex_count; ++i) begin[i + 1] += begin[i];
    std::vector<OpenSide> open(begin.back());
    std::vector<std::uint32_t> end(begin.begin(), begin.end() - 1);
    for_sides([&](std::uint32_t vertex, const OpenSide& side) { open[end[vertex]++] = side; });

    edge_of_.resize(triangles.size());
    sides_.reserve(open.size());
    first_.reserve(open.size() / 2 + 1);
    for (std::size_t vertex = 0; vertex < vertex_count; ++vertex) {
        std::sort(open.begin() + begin[vertex], open.begin() + begin[vertex + 1]);
        for (std::uint32_t k = begin[vertex]; k < begin[vertex + 1]; ++k) {
            if (k == begin[vertex] || open[k].other != open[k - 1].other) first_.push_back(k);
            edge_of_[open[k].side.triangle][open[k].side.corner] = static_cast<std::uint32_t>(first_.size() - 1);
            sides_.push_back(open[k].side);
        }
    }
    first_.push_back(static_cast<std::uint32_t>(open.size()));
}

void check_closed(const Mesh& given, const ProperMesh& proper, const MeshEdges& edges) {
    const auto triangles = proper.mesh->triangles();
    std::vector<LooseEnd> loose;
    for (std::size_t edge = 0; edge < edges.count(); ++edge) {
        if (edges.sides(edge).size() % 2 == 0) continue;
        const SideRef side = edges.sides(edge)[0];
        const auto [a, b, opposite] = corners_from(triangles, side);
        loose.push_back({a, b, side});
        loose.push_back({b, a, side});
    }
    if (loose.empty()) return;
    const LineOrder lines(proper.mesh->vertices());
    std::sort(loose.begin(), loose.end(), [&](const LooseEnd& x, const LooseEnd& y) {
        if (x.at != y.at) return x.at < y.at;
        const int order = lines.compare(x.at, x.other, y.other);
        return order != 0 ? order < 0 : x.side < y.side;
    });
    const LooseEnd* least = nullptr;
    for (std::size_t i = 0, next = 0; i < loose.size(); i = next) {
        while (next < loose.size() && loose[next].at == loose[i].at &&
               lines.compare(loose[i].at, loose[i].other, loose[next].other) == 0) {
            ++next;
        }
        if ((next - i) % 2 != 0 && (least == nullptr || loose[i].side < least->side)) least = &loose[i];
    }
    if (least == nullptr) return;
    const SideRef side = least->side;
    const auto corners = corners_from(given.triangles(), side);
    const std::array<std::size_t, 2> ends{corners[0], corners[1]};
    const auto coordinates = [&](std::size_t vertex) -> NotSolid::Coordinates {
        const Vec3& v = given.vertices()[vertex];
        return {v[0], v[1], v[2]};
    };
    throw open_edge({side.triangle, static_cast<int>(side.corner), ends}, {coordinates(ends[0]), coordinates(ends[1])});
}

}  // namespace ecods
