// Implements Quickhull (Barber, Dobkin and Huhdanpaa, The quickhull algorithm for convex hulls, 1996) with exact signs.
//
// When a point is added, the triangles that it is strictly beyond are replaced by triangles that join their rim to the
// point. Triangles whose plane contains the point stay, so a face of many triangles grows triangle by triangle. No new
// triangle has zero area: a point on the line of a rim edge would be in the planes of both triangles of the edge, but
// the added point is strictly beyond one of them. Doubles choose the next point, which affects only the time.
#include "query/convex/hull_of_points.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>

#include "base/assert.hpp"
#include "ecods/primitives.hpp"
#include "query/solid/proper_mesh.hpp"

namespace ecods::convex {
namespace {

constexpr std::uint32_t nothing = ~std::uint32_t{0};

class QuickHull {
  public:
    explicit QuickHull(std::span<const Vec3> points)
        : points_(points), candidates_(distinct(points)), next_(points.size(), nothing) {}

    std::vector<Triangle> build() {
        const auto simplex = find_simplex();
        if (!simplex) return {};
        begin(*simplex);
        for (std::uint32_t i = 0; i < facets_.size(); ++i) {
            if (facets_[i].is_alive && facets_[i].first != nothing) add(take_furthest(i), i);
        }
        std::vector<Triangle> result;
        for (const Facet& facet : facets_) {
            if (facet.is_alive) result.push_back(facet.corners);
        }
        return result;
    }

  private:
    struct Facet {
        Triangle corners;                        // counterclockwise, seen from outside
        std::array<std::uint32_t, 3> neighbors;  // by side: the facet on the other side of it
        std::uint32_t first = nothing;           // first in the list of points that are beyond this facet
        bool is_alive = true;
        bool is_visible = false;
    };

    struct RimEdge {
        std::uint32_t from, to;
        std::uint32_t behind;  // the facet on the other side of this edge, which stays
    };

    const Vec3& at(std::uint32_t i) const noexcept { return points_[i]; }

    bool is_beyond(const Facet& facet, std::uint32_t point) const noexcept {
        const auto& [a, b, c] = facet.corners;
        return orient3d(at(a), at(b), at(c), at(point)) == Sign::positive;
    }

    // Returns the height of p above the plane of a, b, c, times twice the triangle's area, in doubles. If the
    // computation overflows, the result may be any number.
    static double height(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p) noexcept {
        return (b - a).cross(c - a).dot(p - a);
    }

    // Returns the candidate with the greatest measure if good() is true for it; otherwise the first candidate for which
    // good() is true; nullopt if there is none.
    template <class Measure, class Good>
    std::optional<std::uint32_t> find(Measure&& measure, Good&& good) const {
        if (candidates_.empty()) return std::nullopt;
        std::uint32_t best = candidates_[0];
        double most = -1;
        for (const std::uint32_t i : candidates_) {
            const double m = measure(i);
            if (m > most) {
                most = m;
                best = i;
            }
        }
        if (good(best)) return best;
        const auto first = std::ranges::find_if(candidates_, good);
        return first == candidates_.end() ? std::nullopt : std::optional(*first);
    }

    // Returns four candidates that are not in one plane; nullopt if there are none.
    std::optional<std::array<std::uint32_t, 4>> find_simplex() const {
        if (candidates_.size() < 4) return std::nullopt;
        const auto [low, high] = std::ranges::minmax_element(
            candidates_, [&](std::uint32_t i, std::uint32_t j) { return compare_points(at(i), at(j)) < 0; });
        const std::uint32_t a = *low, b = *high;
        const auto third = find([&](std::uint32_t i) { return (at(b) - at(a)).cross(at(i) - at(a)).norm(); },
                                [&](std::uint32_t i) { return have_area(at(a), at(b), at(i)); });
        if (!third) return std::nullopt;
        const std::uint32_t c = *third;
        const auto fourth = find([&](std::uint32_t i) { return std::abs(height(at(a), at(b), at(c), at(i))); },
                                 [&](std::uint32_t i) { return orient3d(at(a), at(b), at(c), at(i)) != Sign::zero; });
        if (!fourth) return std::nullopt;
        const std::uint32_t d = *fourth;
        if (orient3d(at(a), at(b), at(c), at(d)) == Sign::positive) return {{a, c, b, d}};
        return {{a, b, c, d}};
    }

    // Sets the hull to the four facets of the simplex `s`. Its triangle 0, 1, 2 must face outwards: corner 3 is not
    // beyond this triangle.
    void begin(const std::array<std::uint32_t, 4>& s) {
        facets_.push_back({{s[0], s[1], s[2]}, {1, 2, 3}});
        facets_.push_back({{s[1], s[0], s[3]}, {0, 3, 2}});
        facets_.push_back({{s[2], s[1], s[3]}, {0, 1, 3}});
        facets_.push_back({{s[0], s[2], s[3]}, {0, 2, 1}});
        for (const std::uint32_t i : candidates_) {
            if (std::ranges::find(s, i) == s.end()) assign(i, 0);
        }
    }

    // Puts the point into the list of the first facet, from `first_facet` on, that the point is beyond. If there is no
    // such facet, the point is in no list.
    void assign(std::uint32_t point, std::size_t first_facet) {
        for (std::size_t i = first_facet; i < facets_.size(); ++i) {
            if (!is_beyond(facets_[i], point)) continue;
            next_[point] = facets_[i].first;
            facets_[i].first = point;
            return;
        }
    }

    // Removes the furthest point from a facet's list, and returns it. Doubles decide which point is the furthest.
    std::uint32_t take_furthest(std::uint32_t of) {
        Facet& facet = facets_[of];
        const Vec3 &a = at(facet.corners[0]), &b = at(facet.corners[1]), &c = at(facet.corners[2]);
        std::uint32_t best = facet.first, before_best = nothing;
        double most = height(a, b, c, at(best));
        for (std::uint32_t before = facet.first, i = next_[before]; i != nothing; before = i, i = next_[i]) {
            const double h = height(a, b, c, at(i));
            if (h > most) {
                most = h;
                best = i;
                before_best = before;
            }
        }
        (before_best == nothing ? facet.first : next_[before_best]) = next_[best];
        return best;
    }

    // Adds a point that is beyond the facet `beyond`. Each point in the lists of removed facets is then beyond a new
    // facet, or inside the hull. Proof: let q be a point in the list of a removed facet, and outside the new hull. The
    // segment from an inner point of the facet to q is beyond the facet, so the segment leaves the new hull through a
    // new facet.
    void add(std::uint32_t point, std::uint32_t beyond) {
        find_visible(point, beyond);
        const std::size_t first_new = facets_.size();
        starts_.resize(points_.size(), nothing);
        for (const RimEdge& edge : rim_) {
            const auto index = static_cast<std::uint32_t>(facets_.size());
            starts_[edge.from] = index;
            facets_.push_back({{edge.from, edge.to, point}, {edge.behind, nothing, nothing}});
            Facet& behind = facets_[edge.behind];
            for (std::size_t k = 0; k < 3; ++k) {
                if (behind.corners[k] == edge.to && behind.corners[(k + 1) % 3] == edge.from)
                    behind.neighbors[k] = index;
            }
        }
        for (std::size_t i = first_new; i < facets_.size(); ++i) {
            const std::uint32_t next = starts_[facets_[i].corners[1]];
            ECODS_ASSERT(next >= first_new && next < facets_.size());
            facets_[i].neighbors[1] = next;
            facets_[next].neighbors[2] = static_cast<std::uint32_t>(i);
        }
        for (const std::uint32_t gone : visible_) {
            for (std::uint32_t i = facets_[gone].first; i != nothing;) {
                const std::uint32_t after = next_[i];
                assign(i, first_new);
                i = after;
            }
            facets_[gone].first = nothing;
            facets_[gone].is_alive = false;
        }
    }

    // Sets visible_ to the facets that the point is beyond, and rim_ to the rim of these facets. The facet `beyond`
    // must be one of them. They are connected over edges, and the rim is one cycle.
    void find_visible(std::uint32_t point, std::uint32_t beyond) {
        visible_.assign(1, beyond);
        rim_.clear();
        facets_[beyond].is_visible = true;
        for (std::size_t i = 0; i < visible_.size(); ++i) {
            const Facet& facet = facets_[visible_[i]];
            for (std::size_t k = 0; k < 3; ++k) {
                Facet& other = facets_[facet.neighbors[k]];
                if (other.is_visible) continue;
                if (is_beyond(other, point)) {
                    other.is_visible = true;
                    visible_.push_back(facet.neighbors[k]);
                } else {
                    rim_.push_back({facet.corners[k], facet.corners[(k + 1) % 3], facet.neighbors[k]});
                }
            }
        }
    }

    std::span<const Vec3> points_;
    std::vector<std::uint32_t> candidates_;  // points without repeated coordinates
    std::vector<std::uint32_t> next_;        // by point: next point in its list
    std::vector<Facet> facets_;
    std::vector<std::uint32_t> visible_;
    std::vector<RimEdge> rim_;
    std::vector<std::uint32_t> starts_;  // by point: newest facet whose first side begins there
};

}  // namespace

std::vector<Triangle> triangulate_hull(std::span<const Vec3> points) {
    return QuickHull(points).build();
}

}  // namespace ecods::convex
