#include "query/shape/coplanar_groups.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <optional>
#include <span>

#include "exact/sign/vertex_signs.hpp"

namespace ecods {
namespace {

using namespace exact;

// A PlaneKey is a triangle's plane, rounded coarsely: the direction of the normal in steps of 2^-10, and the distance
// from the mesh's center in steps of 2^-20 of the mesh's size. Triangles in one plane usually have equal steps; only
// triangles with equal steps are compared exactly.
struct PlaneKey {
    std::array<std::int32_t, 4> step;
    std::uint32_t triangle;

    bool is_of_one_plane_with(const PlaneKey& other) const noexcept { return step == other.step; }
    friend auto operator<=>(const PlaneKey&, const PlaneKey&) = default;
};

// Returns the key of a triangle; nullopt if the normal is zero or overflows, and then the triangle is in no group.
std::optional<PlaneKey> key_of(const Mesh& mesh, const MeshExtent& extent, std::uint32_t triangle) {
    const Triangle& t = mesh.triangles()[triangle];
    const Vec3& a = mesh.vertices()[t[0]];
    const Vec3 normal = (mesh.vertices()[t[1]] - a).cross(mesh.vertices()[t[2]] - a);
    const double length = std::sqrt(normal.squaredNorm()), size = extent.half.maxCoeff();
    if (!(length > 0 && length < 0x1p500 && size > 0)) return std::nullopt;
    const Vec3 n = normal / length;
    const double distance = n.dot((a - extent.center) / size);  // at most about sqrt(3)
    const auto steps = [](double x, double count) { return static_cast<std::int32_t>(std::lround(x * count)); };
    if (!(std::abs(distance) < 4)) return std::nullopt;
    return PlaneKey{{steps(n[0], 0x1p10), steps(n[1], 0x1p10), steps(n[2], 0x1p10), steps(distance, 0x1p20)}, triangle};
}

// Returns true if two triangles lie exactly in one plane and their normals point to the same side.
bool is_coplanar(const VertexSigns& signs, const Mesh& mesh, std::uint32_t a, std::uint32_t b) {
    const Triangle &s = mesh.triangles()[a], &t = mesh.triangles()[b];
    for (const std::uint32_t vertex : t) {
        if (signs.orient3d(s[0], s[1], s[2], vertex) != 0) return false;
    }
    for (int axis = 0; axis < 3; ++axis) {
        const int turn = signs.orient2d(s[0], s[1], s[2], axis);
        if (turn != 0) return turn == signs.orient2d(t[0], t[1], t[2], axis);
    }
    return false;
}

// Grouper groups triangles with equal keys by their planes. Only the first four planes of each key are stored, because
// a surface with more planes of one key hardly has a group.
class Grouper {
  public:
    explicit Grouper(const Mesh& mesh)
        : mesh_(mesh), signs_(mesh.vertices()), group_(mesh.triangles().size(), CoplanarGroups::none) {}

    void add(std::span<const PlaneKey> keys) {
        plane_count_ = 0;
        for (const PlaneKey& key : keys) add(key.triangle);
    }

    // Returns the closed side of the group's plane that contains all vertices, 1 or -1; 0 if there are vertices on both
    // sides. Tests each vertex once, since triangles have three to six times as many corners. A vertex that no triangle
    // uses may turn the result into 0, but never makes the result wrong.
    std::int8_t side_of_mesh(std::uint32_t group) {
        const Triangle& t = mesh_.triangles()[first_[group]];
        const auto count = static_cast<std::uint32_t>(mesh_.vertices().size());
        int side = 0;
        for (std::uint32_t v = 0; v < count; ++v) {
            const int s = signs_.orient3d(t[0], t[1], t[2], v);
            if (s * side < 0) return 0;
            if (s != 0) side = s;
        }
        return static_cast<std::int8_t>(side);
    }

    std::vector<std::uint32_t>& groups() noexcept { return group_; }
    std::vector<std::uint32_t>& first() noexcept { return first_; }

  private:
    void add(std::uint32_t triangle) {
        for (std::size_t i = 0; i < plane_count_; ++i) {
            const std::uint32_t known = planes_[i];
            if (!is_coplanar(signs_, mesh_, known, triangle)) continue;
            if (group_[known] == CoplanarGroups::none) {
                group_[known] = static_cast<std::uint32_t>(first_.size());
                first_.push_back(known);
            }
            group_[triangle] = group_[known];
            return;
        }
        if (plane_count_ < planes_.size()) planes_[plane_count_++] = triangle;
    }

    const Mesh& mesh_;
    VertexSigns signs_;
    std::vector<std::uint32_t> group_, first_;
    std::array<std::uint32_t, 4> planes_;
    std::size_t plane_count_ = 0;
};

// Returns the group to which the first `count` items all belong; CoplanarGroups::none if there is no such group.
template <class Items, class GroupOf>
std::uint32_t common_group(const Items& items, std::size_t count, const GroupOf& group_of) {
    const std::uint32_t group = group_of(items[0]);
    for (std::size_t i = 1; i < count; ++i) {
        if (group_of(items[i]) != group) return CoplanarGroups::none;
    }
    return group;
}

void find_groups_of_nodes(CoplanarGroups& groups, const MeshBvh& tree) {
    groups.of_leaf.resize(tree.leaves.size());
    groups.of_node.resize(tree.nodes.size());
    for (std::size_t i = 0; i < tree.leaves.size(); ++i) {
        const TreeLeaf& leaf = tree.leaves[i];
        groups.of_leaf[i] =
            common_group(leaf.triangle, leaf.count, [&](std::uint32_t t) { return groups.of_triangle[t]; });
    }
    // The loop goes backwards, because parents precede children in the array.
    for (std::size_t i = tree.nodes.size(); i-- > 0;) {
        const BvhNode& node = tree.nodes[i];
        groups.of_node[i] = common_group(node.child, node.count, [&](TreeRef child) {
            return child.is_leaf() ? groups.of_leaf[child.index()] : groups.of_node[child.index()];
        });
    }
}

}  // namespace

CoplanarGroups find_coplanar_groups(const Mesh& mesh, const MeshExtent& extent, const MeshBvh& tree) {
    std::vector<PlaneKey> keys;
    for (std::uint32_t i = 0; i < mesh.triangles().size(); ++i) {
        if (const auto key = key_of(mesh, extent, i)) keys.push_back(*key);
    }
    std::ranges::sort(keys);
    Grouper grouper(mesh);
    for (std::size_t begin = 0, end; begin < keys.size(); begin = end) {
        for (end = begin + 1; end < keys.size() && keys[end].is_of_one_plane_with(keys[begin]);) ++end;
        if (end - begin > 1) grouper.add(std::span(keys).subspan(begin, end - begin));
    }
    constexpr std::size_t side_count_max = 32;
    CoplanarGroups groups;
    groups.side.resize(grouper.first().size());
    for (std::uint32_t i = 0; i < std::min(groups.side.size(), side_count_max); ++i)
        groups.side[i] = grouper.side_of_mesh(i);
    if (grouper.first().empty()) return groups;
    groups.of_triangle = std::move(grouper.groups());
    groups.first = std::move(grouper.first());
    find_groups_of_nodes(groups, tree);
    return groups;
}

}  // namespace ecods
