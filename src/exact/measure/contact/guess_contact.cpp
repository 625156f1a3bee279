// guess_contact() projects the triangles along the motion. If the projections overlap, the first time belongs to a
// corner of the overlap: a vertex of one triangle in the other's face, or two edges that cross (contact_times.hpp). If
// they do not overlap, an edge of one triangle separates them.
#include "exact/measure/contact/guess_contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "exact/point/vectors.hpp"
#include "simd/inline.hpp"

namespace ecods::exact {
namespace {

using Index = std::size_t;

class Guess {
  public:
    Guess(const Points<6>& x, const Point& m) noexcept : x_(x), m_(m), edge_(edges_of(x)) {
        for (Index side = 0; side < 2; ++side) {
            for (Index i = 0; i < 3; ++i) {
                const Point c = cross(m, edge_[side][i]);
                square_[side][i] = dot(c, c);
                for (Index j = 0; j < 3; ++j) over_[side][i][j] = dot(c, minus(at(1 - side, j), at(side, i)));
                // own_ is the determinant for the triangle's own third corner. For each corner of the other triangle,
                // own_ equals the sum of over_ over the three edges.
                own_[side][i] = dot(c, minus(at(side, next_corner(next_corner(i))), at(side, i)));
            }
        }
    }

    ContactGuess find() noexcept {
        if (find_gap()) return best_;
        for (Index side = 0; side < 2; ++side) {
            for (Index j = 0; j < 3; ++j) try_face(side, j);
        }
        for (Index i = 0; i < 3; ++i) {
            for (Index j = 0; j < 3; ++j) try_edges(i, j);
        }
        best_.features = first_;
        if (greatest_ < 0) best_ = {ContactGuess::What::leaving, last_};
        return best_;
    }

  private:
    const Point& at(Index side, Index i) const noexcept { return x_[3 * side + i]; }

    // Sets best_ to the edge with the widest gap between the projections; returns false if no edge separates the
    // projections.
    ECODS_ALWAYS_INLINE bool find_gap() noexcept {
        double widest = 0;
        for (Index side = 0; side < 2; ++side) {
            for (Index i = 0; i < 3; ++i) {
                const auto& h = over_[side][i];
                const Index low = least_of(h[0], h[1], h[2]), high = greatest_of(h[0], h[1], h[2]);
                const double above = h[low] - std::max(own_[side][i], 0.0);
                const double below = std::min(own_[side][i], 0.0) - h[high];
                const double gap = std::max(above, below);
                if (!(gap > 0)) continue;
                const double ratio = gap * gap / square_[side][i];
                if (!(ratio > widest)) continue;
                widest = ratio;
                const Index other = above > below ? low : high;
                best_ = {ContactGuess::What::passing, vertex_and(FeatureKind::vertex_edge, side, i, other)};
            }
        }
        return widest > 0;
    }

    // Passes the time at which corner j of the other triangle meets the face of `side` to take(), if the corner is over
    // the face.
    ECODS_ALWAYS_INLINE void try_face(Index side, Index j) noexcept {
        const double s0 = over_[side][0][j], s1 = over_[side][1][j], s2 = over_[side][2][j];
        const bool is_inside = (s0 >= 0 && s1 >= 0 && s2 >= 0) || (s0 <= 0 && s1 <= 0 && s2 <= 0);
        if (!is_inside) return;
        const Point n = cross(edge_[side][0], edge_[side][1]);
        take(n, side == 0 ? minus(at(1, j), at(0, 0)) : minus(at(1, 0), at(0, j)),
             vertex_and(FeatureKind::vertex_face, 1 - side, j, 0));
    }

    ECODS_ALWAYS_INLINE void try_edges(Index i, Index j) noexcept {
        const double b = over_[0][i][j] * over_[0][i][next_corner(j)], a = over_[1][j][i] * over_[1][j][next_corner(i)];
        if (a > 0 || b > 0) return;
        take(cross(edge_[0][i], edge_[1][j]), minus(at(1, j), at(0, i)), pair_of(FeatureKind::edge_edge, 0, i, j));
    }

    ECODS_ALWAYS_INLINE void take(const Point& n, const Point& w, const FeaturePair& f) noexcept {
        const double time = dot(n, w) / dot(n, m_);
        if (time < least_) {
            least_ = time;
            first_ = f;
        }
        if (time > greatest_) {
            greatest_ = time;
            last_ = f;
        }
    }

    static constexpr double infinity = std::numeric_limits<double>::infinity();

    const Points<6>& x_;
    const Point& m_;
    TriangleEdges edge_;
    double over_[2][3][3];  // [side][edge][corner of the other]: determinant of m, edge and corner
    double own_[2][3];      // [side][edge]: the same for the triangle's third corner
    double square_[2][3];
    double least_ = infinity, greatest_ = -infinity;
    FeaturePair first_, last_;
    ContactGuess best_;
};

}  // namespace

ContactGuess guess_contact(const IntegerPair& pair, const ScaledVector& m) noexcept {
    return Guess(to_doubles(pair), m.x).find();
}

}  // namespace ecods::exact
