#include "query/solid/shells.hpp"

#include "base/assert.hpp"
#include "query/solid/fan.hpp"
#include "query/solid/ray_query.hpp"

namespace ecods {
namespace {

const Pose in_place;

class ShellFinder {
  public:
    ShellFinder(const ProperMesh& proper, const MeshEdges& edges, const MeshTree& tree)
        : proper_(proper), edges_(edges), tree_(tree), signs_(frame_) {
        const exact::BodyRef body{proper.mesh.get(), &tree.extent, &in_place};
        frame_.bind({&body, 1});
    }

    Shells find() {
        const std::size_t count = triangles().size();
        shells_.of_triangle.assign(count, no_shell);
        shells_.faces_in.assign(count, 0);
        std::vector<TreeRef> stack;
        QueryCounts counts;
        RayQuery rays(frame_, 0, tree_, stack, counts);
        for (std::uint32_t i = 0; i < count; ++i) {
            if (!proper_.is_proper(i) || shells_.of_triangle[i] != no_shell) continue;
            shells_.first.push_back(i);
            // The triangle's normal points to the region above the triangle. If that region is inside, the triangle
            // faces in.
            take(i, rays.is_inside_above(i));
            while (!open_.empty()) {
                const std::uint32_t next = open_.back();
                open_.pop_back();
                for (std::uint32_t corner = 0; corner < 3; ++corner) cross_edge({next, corner});
            }
        }
        return std::move(shells_);
    }

  private:
    std::span<const Triangle> triangles() const { return proper_.mesh->triangles(); }

    void take(std::uint32_t triangle, bool faces_in) {
        shells_.of_triangle[triangle] = static_cast<std::uint32_t>(shells_.first.size() - 1);
        shells_.faces_in[triangle] = faces_in;
        open_.push_back(triangle);
    }

    // Returns true if the sector just after the side's triangle is inside the solid, for a triangle whose corners turn
    // left seen from outside, so that its normal points out. A turn around the edge, seen from the lesser vertex to the
    // greater one, passes the sectors. If the side begins at the lesser vertex, the normal points in the direction of
    // the turn, so the sector after the triangle is outside.
    bool inside_after(const SideRef& side) const {
        const auto corners = corners_from(triangles(), side);
        return corners[0] > corners[1];
    }

    // Adds the other triangles of an edge to the shell. Around the edge the sectors are outside and inside in turn,
    // which determines for each triangle whether it faces in.
    void cross_edge(const SideRef& from) {
        const auto sides = edges_.sides(edges_.edge_of(from));
        const bool wanted = inside_after(from) != (shells_.faces_in[from.triangle] != 0);
        if (sides.size() == 2) {
            const SideRef& to = sides[sides[0] == from ? 1 : 0];
            reach(to, !wanted);
            return;
        }
        wings_.clear();
        for (const SideRef& side : sides) {
            wings_.push_back({{0, corners_from(triangles(), side)[2]}, side.triangle, inside_after(side)});
        }
        const auto corners = corners_from(triangles(), from);
        const auto [p, q] = std::minmax(corners[0], corners[1]);
        sort_fan(signs_, {0, p}, {0, q}, wings_);
        std::size_t own = 0;
        while (wings_[own].triangle != from.triangle) ++own;
        for (std::size_t i = 0; i < wings_.size(); ++i) {
            reach(wings_[i].triangle, wings_[i].inside_after, wanted != ((i + own) % 2 != 0));
        }
    }

    void reach(const SideRef& side, bool wanted) { reach(side.triangle, inside_after(side), wanted); }
    void reach(std::uint32_t triangle, bool after, bool wanted) {
        if (shells_.of_triangle[triangle] == no_shell) take(triangle, after != wanted);
        ECODS_ASSERT((after != (shells_.faces_in[triangle] != 0)) == wanted);
    }

    const ProperMesh& proper_;
    const MeshEdges& edges_;
    const MeshTree& tree_;
    exact::Frame frame_;
    PointSigns signs_;
    Shells shells_;
    std::vector<std::uint32_t> open_;
    std::vector<Wing> wings_;
};

}  // namespace

Shells find_shells(const ProperMesh& proper, const MeshEdges& edges, const MeshTree& tree) {
    return ShellFinder(proper, edges, tree).find();
}

Shells shells_of_star(const ProperMesh& proper, std::span<const std::uint8_t> faces_in) {
    Shells shells;
    shells.faces_in.assign(faces_in.begin(), faces_in.end());
    shells.of_triangle.assign(faces_in.size(), 0);
    for (std::uint32_t i = 0; i < faces_in.size(); ++i) {
        if (!proper.is_proper(i)) {
            shells.of_triangle[i] = no_shell;
        } else if (shells.first.empty()) {
            shells.first.push_back(i);
        }
    }
    return shells;
}

}  // namespace ecods
