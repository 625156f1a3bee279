// How the triangles of a proper mesh meet each other, in the mesh's own
// coordinates.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "ecods/ids.hpp"
#include "exact/point/frame.hpp"
#include "query/shape/mesh_tree.hpp"
#include "query/solid/mesh_edges.hpp"
#include "query/solid/proper_mesh.hpp"

namespace ecods {

// Two different edges that lie along each other, as sides of two triangles.
struct EdgeOverlap {
    SideRef a;
    SideRef b;
};

class SelfContacts {
  public:
    // `tree` is that of the mesh that `proper` was made of. Both must outlive the
    // questions.
    SelfContacts(const ProperMesh& proper, const MeshTree& tree);

    // The least pair of triangles that share a segment or more which is not a
    // side of both, if there is one. If there is none, `overlaps` are the sides
    // that lie along each other and are not one edge.
    std::optional<TrianglePair> find_least(std::vector<EdgeOverlap>& overlaps);

    // All such pairs, ascending.
    std::vector<TrianglePair> find_all();

  private:
    // The corners of two triangles, those of the first triangle first.
    struct Pair {
        Triangle a, b;
        exact::Points<6> points;
        int shared_count;
    };
    // By the bits 3 i + j: side i of the first triangle lies along side j of the
    // second, and they are different edges.
    struct Contact {
        bool is_crossing = false;
        std::uint32_t overlaps = 0;
    };
    enum class Answer { harmless, crossing, open };

    Pair pair_of(std::uint32_t i, std::uint32_t j) const;
    static Answer filter(const Pair& pair, double bound);
    static Answer filter_neighbours(const Pair& pair, double bound);
    static Answer filter_across_vertex(const Pair& pair, double bound);
    bool is_flat_apart(const Pair& pair) const;
    bool is_flat_across_edge(const Pair& pair) const;
    bool is_flat_across_vertex(const Pair& pair) const;
    Contact decide(const Pair& pair);
    Contact contact(std::uint32_t i, std::uint32_t j);
    template <class Take>
    void visit_contacts(Take&& take);

    const ProperMesh& proper_;
    const MeshTree& tree_;
    exact::Frame frame_;
    double bound_ = 0;  // for orient3d
    std::array<double, 3> bounds2d_{};
};

}  // namespace ecods
