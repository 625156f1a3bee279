// Places and normals of first contacts, by rational numbers on both sides of the time.
#include <algorithm>
#include <array>
#include <functional>
#include <utility>

#include "oracle/float_environment.hpp"
#include "oracle/integer_points.hpp"
#include "oracle/rational_rotation.hpp"
#include "oracle/way.hpp"

namespace ecods::oracle {
namespace {

using Fractions = Vector<mpq_class>;
using Triangles = std::array<std::array<Fractions, 3>, 2>;

mpq_class power_of_two(long exponent) {
    mpq_class x = 1;
    if (exponent >= 0) {
        mpq_mul_2exp(x.get_mpq_t(), x.get_mpq_t(), static_cast<mp_bitcnt_t>(exponent));
    } else {
        mpq_div_2exp(x.get_mpq_t(), x.get_mpq_t(), static_cast<mp_bitcnt_t>(-exponent));
    }
    return x;
}

// The least power of two that is larger, or twice that.
long exponent_of(const mpq_class& x) {
    return static_cast<long>(mpz_sizeinbase(x.get_num_mpz_t(), 2)) -
           static_cast<long>(mpz_sizeinbase(x.get_den_mpz_t(), 2)) + 1;
}

// How near times and numbers are taken, in bits: more where corners differ in size by hundreds of bits.
struct Precision {
    long time, zero, number, before;
};
constexpr Precision usual{1000, 600, 400, 500}, finest{5000, 2400, 1500, 2000};

// The short number that x is nearly, or x.
mpq_class snapped(const mpq_class& x, const mpq_class& size, const Precision& bits) {
    if (abs(x) <= size * power_of_two(-bits.zero)) return 0;
    const mpq_class unit = power_of_two(exponent_of(x) - 120);
    const mpq_class steps = x / unit + mpq_class(1, 2);
    mpz_class whole;
    mpz_fdiv_q(whole.get_mpz_t(), steps.get_num_mpz_t(), steps.get_den_mpz_t());
    const mpq_class near = whole * unit;
    return abs(x - near) <= abs(x) * power_of_two(-bits.number) ? near : x;
}

// A rational number just below the root, or the root.
mpq_class just_below(const Root& root, const Precision& bits) {
    if (root.is_exact()) return root.low();
    mpq_class low = 0, high = 1;
    while (high - low > low * power_of_two(-bits.time)) {
        const mpq_class middle = (low + high) / 2;
        (root.compare(middle) >= 0 ? low : high) = middle;
    }
    return low;
}

Fractions posed(const Pose& pose, const Vec3& v) {
    Fractions point;
    for (int k = 0; k < 3; ++k) {
        mpq_class& x = point[static_cast<std::size_t>(k)];
        x = exactly(pose.t[k]);
        for (int i = 0; i < 3; ++i) x += exactly(pose.R(k, i)) * exactly(v[i]);
    }
    return point;
}

std::array<Fractions, 3> posed(const Soup& soup, std::uint32_t triangle) {
    const Triangle& t = soup.triangles[triangle];
    return {posed(soup.pose, soup.vertices[t[0]]), posed(soup.pose, soup.vertices[t[1]]),
            posed(soup.pose, soup.vertices[t[2]])};
}

Fractions part(const Fractions& from, const Fractions& to, const mpq_class& time) {
    Fractions result;
    for (std::size_t k = 0; k < 3; ++k) result[k] = from[k] + time * (to[k] - from[k]);
    return result;
}

// The features at one time.
struct AtTime {
    const Triangles& at;
    const NamedFeature &a, &b;

    Fractions corner(std::size_t side, std::size_t i) const { return at[side][((side == 0 ? a : b).corner + i) % 3]; }
    Fractions edge(std::size_t side) const { return corner(side, 1) - corner(side, 0); }
    bool are_edges() const { return a.dimension == 1 && b.dimension == 1; }
    bool have_normal() const { return are_edges() || a.dimension == 2 || b.dimension == 2; }

    Fractions point() const {
        if (b.dimension == 0) return corner(1, 0);
        if (a.dimension == 0) return corner(0, 0);
        // The point of b's edge that is nearest to a's line.
        const Fractions u = edge(0), v = edge(1), n = cross(u, v), w = corner(0, 0) - corner(1, 0);
        const mpq_class t = dot(cross(w, u), cross(v, u)) / dot(n, n);
        return part(corner(1, 0), corner(1, 1), t);
    }
    // Returns a normal of any length.
    Fractions normal() const {
        if (are_edges()) return cross(edge(0), edge(1));
        const std::size_t side = a.dimension == 2 ? 0 : 1;
        return cross(edge(side), Fractions(corner(side, 2) - corner(side, 0)));
    }
};

mpq_class largest(const Fractions& v) {
    return std::max({mpq_class(abs(v[0])), mpq_class(abs(v[1])), mpq_class(abs(v[2]))});
}

// The usual one, if no corner at either end of time is far smaller or larger than another one.
Precision precision_for(const std::function<Triangles(const mpq_class&)>& triangles_at) {
    mpq_class least = 0, most = 0;
    for (const int time : {0, 1}) {
        for (const auto& corners : triangles_at(time)) {
            for (const Fractions& corner : corners) {
                for (const mpq_class& x : corner) {
                    const mpq_class size = abs(x);
                    if (sgn(size) != 0 && (sgn(least) == 0 || size < least)) least = size;
                    most = std::max(most, size);
                }
            }
        }
    }
    return least >= most * power_of_two(-150) ? usual : finest;
}

PlaceOfContact place_at(const Root& root, const std::function<Triangles(const mpq_class&)>& triangles_at,
                        const NamedFeature& of_a, const NamedFeature& of_b) {
    const Precision bits = precision_for(triangles_at);
    const mpq_class time = just_below(root, bits);
    const Triangles at = triangles_at(time), before = triangles_at(time * (1 - power_of_two(-bits.before)));
    const AtTime features{at, of_a, of_b}, features_before{before, of_a, of_b};
    mpq_class size = 0;
    for (const auto& corners : at) {
        for (const Fractions& corner : corners) size = std::max(size, largest(corner));
    }
    PlaceOfContact place;
    const Fractions point = features.point();
    for (std::size_t k = 0; k < 3; ++k) {
        place.point[static_cast<Eigen::Index>(k)] = nearest(FractionAndRoot{snapped(point[k], size, bits), 0, 0});
    }
    if (!features.have_normal()) return place;
    Fractions n = features.normal();
    const mpq_class longest = largest(n);
    for (mpq_class& x : n) x = snapped(mpq_class(x / longest), 1, bits);
    const int sign =
        sgn(dot(features_before.normal(), Fractions(features_before.corner(1, 0) - features_before.corner(0, 0))));
    const mpq_class square = dot(n, n);
    place.normal.emplace();
    for (std::size_t k = 0; k < 3; ++k) {
        const mpq_class factor = sign * n[k] / square;
        (*place.normal)[static_cast<Eigen::Index>(k)] = nearest(FractionAndRoot{0, factor, square});
    }
    return place;
}

}  // namespace

PlaceOfContact place_of_contact(const LegSoup& a, const Soup& b, const NamedFeature& of_a, const NamedFeature& of_b) {
    const auto root = motion_of_pair(a, b, {of_a.triangle, of_b.triangle})->first_time();
    const std::array<Fractions, 3> start = posed(a.start, of_a.triangle), still = posed(b, of_b.triangle);
    const Fractions pivot = posed(Pose(), a.pivot), from = posed(Pose(), a.pivot_from), to = posed(Pose(), a.pivot_to);
    return place_at(
        *root,
        [&](const mpq_class& time) -> Triangles {
            const RationalRotation rotation(a.from, a.to, time);
            const Fractions place = part(from, to, time);
            std::array<Fractions, 3> turned;
            for (std::size_t i = 0; i < 3; ++i) {
                const Fractions g = start[i] - pivot;
                for (std::size_t k = 0; k < 3; ++k) turned[i][k] = place[k] + dot(rotation.rows[k], g);
            }
            return {turned, still};
        },
        of_a, of_b);
}

PlaceOfContact place_of_contact(const MovingSoup& a, const MovingSoup& b, const NamedFeature& of_a,
                                const NamedFeature& of_b) {
    const FloatEnvironment environment;
    const auto ends = [](const MovingSoup& body, std::uint32_t triangle) {
        const Soup goal{body.from.vertices, body.from.triangles, body.to};
        return std::pair(posed(body.from, triangle), posed(goal, triangle));
    };
    const auto [from_a, to_a] = ends(a, of_a.triangle);
    const auto [from_b, to_b] = ends(b, of_b.triangle);
    mpz_class unit = 1;
    for (const auto* corners : {&from_a, &to_a, &from_b, &to_b}) {
        for (const Fractions& corner : *corners) {
            for (const mpq_class& x : corner) unit = lcm(unit, x.get_den());
        }
    }
    const auto moving = [&](const std::array<Fractions, 3>& from, const std::array<Fractions, 3>& to) {
        MovingTriangle result;
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t k = 0; k < 3; ++k) {
                result.from[i][k] = mpq_class(from[i][k] * unit).get_num();
                result.change[i][k] = mpq_class((to[i][k] - from[i][k]) * unit).get_num();
            }
        }
        return result;
    };
    const auto root = make_motion(moving(from_a, to_a), moving(from_b, to_b))->first_time();
    return place_at(
        *root,
        [&](const mpq_class& time) -> Triangles {
            Triangles at;
            for (std::size_t i = 0; i < 3; ++i) {
                at[0][i] = part(from_a[i], to_a[i], time);
                at[1][i] = part(from_b[i], to_b[i], time);
            }
            return at;
        },
        of_a, of_b);
}

}  // namespace ecods::oracle
