#include "oracle/hits.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "oracle/float_environment.hpp"
#include "oracle/integer_points.hpp"

namespace ecods::oracle {
namespace {

using Integers = Vector<mpz_class>;

bool is_zero(const Integers& v) {
    return sgn(v[0]) == 0 && sgn(v[1]) == 0 && sgn(v[2]) == 0;
}

// The line x + s d in common integers.
struct Line {
    Integers x, d;
    std::optional<mpq_class> end;  // the largest parameter
};

// The parameters that are left.
class Range {
  public:
    explicit Range(const std::optional<mpq_class>& end) : leave_(end) {}

    // Of those with a + b s = 0, or a + b s >= 0.
    void require_zero(const mpz_class& a, const mpz_class& b) {
        require_not_negative(a, b);
        require_not_negative(-a, -b);
    }
    void require_not_negative(const mpz_class& a, const mpz_class& b) {
        if (is_empty_) return;
        if (sgn(b) == 0) {
            is_empty_ = sgn(a) < 0;
            return;
        }
        mpq_class s(-a, b);
        s.canonicalize();
        if (sgn(b) > 0) {
            enter_ = std::max(enter_, s);
        } else if (!leave_ || *leave_ > s) {
            leave_ = s;
        }
        is_empty_ = leave_ && enter_ > *leave_;
    }

    bool is_empty() const { return is_empty_; }
    const mpq_class& enter() const { return enter_; }
    const mpq_class& leave() const { return *leave_; }  // of what is bounded

  private:
    mpq_class enter_ = 0;
    std::optional<mpq_class> leave_;
    bool is_empty_ = false;
};

using Corners = std::array<Integers, 3>;

struct Span {
    Corners corner;
    std::array<Integers, 3> edge;
    Integers normal;

    explicit Span(const Corners& corners) : corner(corners) {
        for (std::size_t i = 0; i < 3; ++i) edge[i] = corner[(i + 1) % 3] - corner[i];
        normal = cross(edge[0], edge[1]);
    }
};

void clip_to_face(Range& range, const Line& line, const Span& t) {
    range.require_zero(dot(t.normal, Integers(line.x - t.corner[0])), dot(t.normal, line.d));
    for (std::size_t i = 0; i < 3 && !range.is_empty(); ++i) {
        const Integers inward = cross(t.normal, t.edge[i]);
        range.require_not_negative(dot(inward, Integers(line.x - t.corner[i])), dot(inward, line.d));
    }
}

// A triangle without area is its longest edge, which may be a point.
void clip_to_edge(Range& range, const Line& line, const Span& t) {
    std::size_t longest = 0;
    for (std::size_t i = 1; i < 3; ++i) {
        if (square_of(t.edge[i]) > square_of(t.edge[longest])) longest = i;
    }
    const Integers& along = t.edge[longest];
    const Integers w = line.x - t.corner[longest];
    if (is_zero(along)) {
        for (std::size_t k = 0; k < 3; ++k) range.require_zero(w[k], line.d[k]);
        return;
    }
    const Integers beside = cross(w, along), beside_slope = cross(line.d, along);
    for (std::size_t k = 0; k < 3; ++k) range.require_zero(beside[k], beside_slope[k]);
    const mpz_class at = dot(w, along), slope = dot(line.d, along);
    range.require_not_negative(at, slope);
    range.require_not_negative(square_of(along) - at, -slope);
}

// A point of the line, in units of `den`.
struct PointOnLine {
    Integers num;
    mpz_class den;

    PointOnLine(const Line& line, const mpq_class& s) : den(s.get_den()) {
        for (std::size_t k = 0; k < 3; ++k) num[k] = line.x[k] * den + line.d[k] * s.get_num();
    }
    Integers from(const Integers& p) const { return {num[0] - p[0] * den, num[1] - p[1] * den, num[2] - p[2] * den}; }
    ExactPoint exact(long unit) const {
        ExactPoint point;
        for (std::size_t k = 0; k < 3; ++k) point.x[k] = {num[k], den, unit};
        return point;
    }
};

bool is_on_edge(const PointOnLine& p, const Span& t, std::size_t i) {
    const Integers w = p.from(t.corner[i]);
    const mpz_class along = dot(w, t.edge[i]);
    return is_zero(cross(w, t.edge[i])) && along >= 0 && along <= square_of(t.edge[i]) * p.den;
}

// The lowest feature that holds both points of a triangle, and what is between them.
NamedFeature feature_of(const PointOnLine& p, const PointOnLine& q, bool is_one_point, const Span& t,
                        std::uint32_t triangle) {
    for (std::uint32_t i = 0; i < 3 && is_one_point; ++i) {
        if (is_zero(p.from(t.corner[i]))) return {0, triangle, i};
    }
    for (std::uint32_t i = 0; i < 3; ++i) {
        if (!is_zero(t.edge[i]) && is_on_edge(p, t, i) && is_on_edge(q, t, i)) return {1, triangle, i};
    }
    return {2, triangle, 0};
}

HitWay way_of(int dimension, bool is_one_point, const Line& line, const Span& t) {
    if (!is_one_point) return HitWay::along;
    if (dimension == 0) return HitWay::vertex;
    if (dimension == 1) return HitWay::edge;
    const int side = sgn(dot(t.normal, line.d));
    return side == 0 ? HitWay::face : side < 0 ? HitWay::front : HitWay::back;
}

std::optional<ExactHit> hit_of(const Line& line, const Span& t, std::uint32_t triangle, long unit) {
    Range range(line.end);
    is_zero(t.normal) ? clip_to_edge(range, line, t) : clip_to_face(range, line, t);
    if (range.is_empty()) return std::nullopt;
    ExactHit hit;
    hit.enter = range.enter();
    hit.leave = range.leave();
    const bool is_one_point = hit.enter == hit.leave;
    const PointOnLine p(line, hit.enter), q(line, hit.leave);
    hit.feature = feature_of(p, q, is_one_point, t, triangle);
    hit.way = way_of(hit.feature.dimension, is_one_point, line, t);
    hit.point = p.exact(unit);
    hit.leave_point = q.exact(unit);
    return hit;
}

Line line_of(const ExactLine& given, const std::vector<Integers>& points) {
    Line line{points[0], given.is_ray ? points[1] : Integers(points[1] - points[0]), {}};
    if (!given.is_ray) {
        line.end = 1;
    } else if (!std::isinf(given.max_parameter)) {
        line.end = mpq_class(given.max_parameter);
    }
    if (is_zero(line.d)) line.end = 0;
    return line;
}

}  // namespace

std::vector<ExactHit> all_hits(const ExactLine& given, const Soup& soup) {
    const FloatEnvironment environment;
    const std::array<Vec3, 2> ends{given.from, given.to};
    constexpr std::array<Triangle, 1> both{{{0, 0, 1}}};
    const std::array<Soup, 2> soups{soup, Soup{ends, both, Pose()}};
    const CommonIntegers common(soups);
    const Line line = line_of(given, common.points[1]);
    std::vector<ExactHit> hits;
    for (std::uint32_t i = 0; i < soup.triangles.size(); ++i) {
        const Triangle& t = soup.triangles[i];
        const auto& points = common.points[0];
        if (auto hit = hit_of(line, Span({points[t[0]], points[t[1]], points[t[2]]}), i, common.unit)) {
            hits.push_back(std::move(*hit));
        }
    }
    std::ranges::stable_sort(hits, {}, &ExactHit::enter);
    for (std::size_t i = 1; i < hits.size(); ++i) {
        hits[i].rank = hits[i - 1].rank + (hits[i - 1].enter == hits[i].enter ? 0 : 1);
    }
    return hits;
}

double nearest_parameter(const mpq_class& parameter) {
    const ExactRoot square{parameter.get_num() * parameter.get_num(), parameter.get_den() * parameter.get_den(), 0};
    return nearest(square);
}

}  // namespace ecods::oracle
