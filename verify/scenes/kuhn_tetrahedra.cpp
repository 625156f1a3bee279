#include "scenes/kuhn_tetrahedra.hpp"

#include <algorithm>
#include <map>

namespace ecods::scenes {

Tetrahedra random_tetrahedra(int size, Random& random) {
    Tetrahedra set;
    const std::uint32_t share = 1 + random.below(5);
    for (int i = 0; i < size * size * size; ++i) {
        std::array<std::size_t, 3> axes{0, 1, 2};
        do {
            if (random.below(6) >= share) continue;
            Tetrahedron corners{LatticePoint{i % size, i / size % size, i / size / size}};
            for (std::size_t k = 0; k < 3; ++k) {
                corners[k + 1] = corners[k];
                ++corners[k + 1][axes[k]];
            }
            set.insert(corners);
        } while (std::ranges::next_permutation(axes).found);
    }
    if (set.empty()) set.insert(Tetrahedron{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 1, 1}}});
    return set;
}

LatticeMesh boundary(const Tetrahedra& set, const LatticePoint& scale, const LatticePoint& by) {
    std::map<std::array<LatticePoint, 3>, int> counts;
    for (const Tetrahedron& t : set) {
        for (std::size_t without = 0; without < 4; ++without) {
            std::array<LatticePoint, 3> face{};
            for (std::size_t c = 0, i = 0; c < 4; ++c) {
                if (c != without) face[i++] = t[c];
            }
            ++counts[face];
        }
    }
    LatticeMesh mesh;
    const auto image = [&](const LatticePoint& x) {
        return LatticePoint{x[0] * scale[0] + by[0], x[1] * scale[1] + by[1], x[2] * scale[2] + by[2]};
    };
    for (const auto& [face, count] : counts) {
        if (count % 2 != 0) mesh.add(image(face[0]), image(face[1]), image(face[2]));
    }
    return mesh;
}

Relation relation(const Tetrahedra& a, const Tetrahedra& b) {
    if (a == b) return Relation::equal;
    if (std::ranges::includes(b, a)) return Relation::inside;
    if (std::ranges::includes(a, b)) return Relation::contains;
    std::set<LatticePoint> corners;
    for (const Tetrahedron& t : a) corners.insert(t.begin(), t.end());
    bool touches = false;
    for (const Tetrahedron& t : b) {
        if (a.contains(t)) return Relation::overlapping;
        touches = touches || std::ranges::any_of(t, [&](const LatticePoint& c) { return corners.contains(c); });
    }
    return touches ? Relation::touching : Relation::apart;
}

}  // namespace ecods::scenes
