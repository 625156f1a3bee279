#include "query/solid/self_contacts.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <span>

#include "bvh/axes/separating_axes.hpp"
#include "bvh/walks/walk_self.hpp"
#include "exact/point/frame.hpp"
#include "exact/sign/filter_bound.hpp"
#include "exact/sign/frame_signs.hpp"
#include "exact/simplex/triangle_contact.hpp"
#include "exact/simplex/triangle_filter.hpp"

namespace ecods {
namespace {

using namespace exact;

const Pose identity;

bool is_one_edge(const Triangle& a, std::size_t i, const Triangle& b, std::size_t j) noexcept {
    const std::uint32_t p = a[i], q = a[(i + 1) % 3], r = b[j], s = b[(j + 1) % 3];
    return (p == r && q == s) || (p == s && q == r);
}

class SelfContacts {
  public:
    SelfContacts(const ProperMesh& proper, const MeshTree& tree) : proper_(proper), tree_(tree) {
        const BodyRef body{proper.mesh.get(), &tree.extent, &identity};
        frame_.bind({&body, 1});
        bounds_ = determinant_bounds(frame_, own_delta);
        frame_.find_arithmetic();
    }

    std::optional<TrianglePair> find_least(std::vector<EdgeOverlap>& overlaps) {
        std::optional<TrianglePair> least;
        visit_contacts([&](const TrianglePair& pair, const Contact& found) {
            if (found.is_crossing && (!least || pair < *least)) least = pair;
            for (std::uint32_t bits = found.overlaps; !least && bits != 0; bits &= bits - 1) {
                const auto bit = static_cast<std::uint32_t>(std::countr_zero(bits));
                overlaps.push_back({{pair.a, bit / 3}, {pair.b, bit % 3}});
            }
        });
        return least;
    }

    std::vector<TrianglePair> find_all() {
        std::vector<TrianglePair> pairs;
        visit_contacts([&](const TrianglePair& pair, const Contact& found) {
            if (found.is_crossing) pairs.push_back(pair);
        });
        std::ranges::sort(pairs);
        return pairs;
    }

  private:
    // A Pair is two triangles and their corners: the corners of a, then those of b.
    struct Pair {
        Triangle a, b;
        Points<6> points;
        std::array<int, 3> shared{-1, -1, -1};  // by corner of a: the position of the same corner in b, or -1
        int shared_count = 0;

        // Returns the position of the only common corner, in a and in b.
        std::array<std::size_t, 2> common_corner() const noexcept {
            const std::size_t i = shared[0] >= 0 ? 0 : shared[1] >= 0 ? 1 : 2;
            return {i, static_cast<std::size_t>(shared[i])};
        }
        // Returns the position of the first corner of b that is not a corner of a.
        std::size_t own_corner_of_b() const noexcept {
            std::size_t j = 0;
            while (std::ranges::find(a, b[j]) != a.end()) ++j;
            return j;
        }
    };
    // Bit 3 i + j of `overlaps` is set if side i of the first triangle and side j of the second share a segment but are
    // different edges.
    struct Contact {
        bool is_crossing = false;
        std::uint32_t overlaps = 0;
    };
    enum class Answer { harmless, crossing, open };

    Pair pair_of(std::uint32_t i, std::uint32_t j) const {
        const auto triangles = proper_.mesh->triangles();
        const auto vertices = proper_.mesh->vertices();
        Pair pair{triangles[i], triangles[j], {}};
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3 &p = vertices[pair.a[k]], &q = vertices[pair.b[k]];
            pair.points[k] = {p[0], p[1], p[2]};
            pair.points[3 + k] = {q[0], q[1], q[2]};
        }
        for (std::size_t k = 0; k < 3; ++k) {
            const auto at = std::ranges::find(pair.b, pair.a[k]);
            if (at == pair.b.end()) continue;
            pair.shared[k] = static_cast<int>(at - pair.b.begin());
            ++pair.shared_count;
        }
        return pair;
    }

    // Returns true if a side of one triangle separates the two triangles' projections along the axis on which the
    // normal of the first is largest. The triangles then share at most the corners that lie on this side. Only sides
    // that contain all common corners are tried; for two common corners, there is one such side.
    bool is_flat_apart(const Pair& pair) const {
        const auto& w = pair.points;
        const PlainNormal normal = plain_normal(w[0], w[1], w[2]);
        const std::array<double, 3> size{std::abs(normal[0]), std::abs(normal[1]), std::abs(normal[2])};
        const auto axis = static_cast<std::size_t>(std::ranges::max_element(size) - size.begin());
        const auto turn = [&](std::size_t p, std::size_t q, std::size_t r) {
            return certain_sign(plain_orient2d(w[p], w[q], w[r], static_cast<int>(axis)), bounds_.orient2d[axis]);
        };
        for (const std::size_t own : {0u, 3u}) {
            const Triangle &corners = own == 0 ? pair.a : pair.b, &others = own == 0 ? pair.b : pair.a;
            const int own_turn =
                own == 0 ? certain_sign(normal[axis], bounds_.orient2d[axis]) : turn(own, own + 1, own + 2);
            for (std::size_t side = 0; own_turn != 0 && side < 3; ++side) {
                const std::size_t p = side, q = (side + 1) % 3;
                const auto is_end = [&](std::uint32_t vertex) { return vertex == corners[p] || vertex == corners[q]; };
                if (std::ranges::count_if(others, is_end) != pair.shared_count) continue;
                bool are_beyond = true;
                for (std::size_t k = 0; are_beyond && k < 3; ++k)
                    are_beyond = is_end(others[k]) || turn(own + p, own + q, 3 - own + k) == -own_turn;
                if (are_beyond) return true;
                if (pair.shared_count == 2) return false;
            }
        }
        return false;
    }

    // Filters two triangles with a common edge: if they are not coplanar, they share only this edge.
    static Answer filter_neighbours(const Pair& pair, double bound) {
        const auto& w = pair.points;
        return certain_sign(plain_orient3d(w[0], w[1], w[2], w[3 + pair.own_corner_of_b()]), bound) != 0
                   ? Answer::harmless
                   : Answer::open;
    }

    // Filters two triangles with one common corner. This corner is in the other triangle's plane, so the corner's sign
    // is set to 0, independent of doubles. The comparison of two edges along the line of both planes has the sign 0 if
    // both edges end in the common corner.
    static Answer filter_across_vertex(const Pair& pair, double bound) {
        const auto [i, j] = pair.common_corner();
        const auto others_of = [bound](const PlaneSides& sides, std::size_t corner, Sides& signs) {
            signs = sides.certain_signs(bound);
            signs[corner] = 0;
            return signs[(corner + 1) % 3] * signs[(corner + 2) % 3];
        };
        Sides first, second;
        const int first_others = others_of(plane_sides(pair.points, 3, 0), i, first);
        if (first_others > 0) return Answer::harmless;
        const int second_others = others_of(plane_sides(pair.points, 0, 3), j, second);
        if (second_others > 0) return Answer::harmless;
        if (first_others == 0 || second_others == 0) return Answer::open;
        const EdgeComparison e = name_corners(first, second);
        const auto is_shared = [&](int p) { return p == static_cast<int>(i) || p == 3 + static_cast<int>(j); };
        if ((is_shared(e.q1) && is_shared(e.q2)) || (is_shared(e.r1) && is_shared(e.r2))) return Answer::harmless;
        return filter_edges(pair.points, first, second, bound) == FilterAnswer::crossing ? Answer::crossing
                                                                                         : Answer::open;
    }

    static Answer filter(const Pair& pair, double bound) {
        switch (pair.shared_count) {
            case 0: {
                FilterTrace trace;
                const FilterAnswer answer = exact::filter(pair.points, bound, trace);
                return answer == FilterAnswer::unknown    ? Answer::open
                       : answer == FilterAnswer::disjoint ? Answer::harmless
                                                          : Answer::crossing;
            }
            case 1:
                return filter_across_vertex(pair, bound);
            case 2:
                return filter_neighbours(pair, bound);
            default:
                return Answer::crossing;  // the same triangle twice
        }
    }

    Contact decide(const Pair& pair) {
        return with_signs(frame_, corners_of(pair.a, pair.b, 0), [&](auto& signs) {
            Contact result;
            const TriangleContact contact = triangle_contact(signs);
            if (contact.kind == ContactKind::segment) {
                result.is_crossing = contact.first == TriangleContact::face || contact.second == TriangleContact::face;
                if (result.is_crossing) return result;
                const auto i = static_cast<std::size_t>(contact.first), j = static_cast<std::size_t>(contact.second);
                if (!is_one_edge(pair.a, i, pair.b, j)) result.overlaps = 1u << (3 * i + j);
            } else if (contact.kind == ContactKind::coplanar) {
                result.is_crossing = coplanar_faces_overlap(signs, signs.normal_axis(0));
                // The two triangles have disjoint interiors, and share a convex set. If this set contains a common
                // edge, it is that edge.
                if (result.is_crossing || pair.shared_count == 2) return result;
                const int axis = signs.normal_axis(0);
                for (int i = 0; i < 3; ++i) {
                    // With one common corner and disjoint interiors, only sides that end in this corner can overlap.
                    if (pair.shared_count == 1 && pair.shared[static_cast<std::size_t>(i)] < 0 &&
                        pair.shared[static_cast<std::size_t>(i + 1) % 3] < 0) {
                        continue;
                    }
                    for (int j = 0; j < 3; ++j) {
                        if (!segments_lie_along(signs, i, (i + 1) % 3, 3 + j, 3 + (j + 1) % 3, axis)) continue;
                        result.overlaps |= 1u << (3 * i + j);
                    }
                }
            }
            return result;
        });
    }

    Contact contact(std::uint32_t i, std::uint32_t j) {
        const Pair pair = pair_of(i, j);
        if (pair.shared_count < 3 && is_flat_apart(pair)) return {};
        Answer answer = filter(pair, bounds_.orient3d);
        if (answer == Answer::open && frame_.arithmetic() < Arithmetic::differences) {
            answer = filter(pair, determinant_bounds(pair.points, own_delta).orient3d);
        }
        if (answer == Answer::open) return decide(pair);
        return {answer == Answer::crossing, 0};
    }

    template <class Take>
    void visit_contacts(Take&& take) {
        SeparatingAxes axes;
        const PosedTree posed{tree_.boxes, identity.R};
        axes.bind(posed, posed, Vec3::Zero());
        std::vector<NodePair> stack;
        const auto bound = [&](const auto& x, const auto& y) { return overlap_mask(axes.sets(), x, y); };
        walk_self(tree_.boxes, stack, bound, [&](std::uint32_t i, std::uint32_t j) {
            if (i > j) std::swap(i, j);
            if (proper_.is_proper(i) && proper_.is_proper(j)) take(TrianglePair{i, j}, contact(i, j));
            return true;
        });
    }

    const ProperMesh& proper_;
    const MeshTree& tree_;
    Frame frame_;
    DeterminantBounds bounds_{};
};

}  // namespace

std::optional<TrianglePair> least_self_contact(const ProperMesh& proper, const MeshTree& tree,
                                               std::vector<EdgeOverlap>& overlaps) {
    return SelfContacts(proper, tree).find_least(overlaps);
}

std::vector<TrianglePair> all_self_contacts(const ProperMesh& proper, const MeshTree& tree) {
    return SelfContacts(proper, tree).find_all();
}

}  // namespace ecods
