#include <array>
#include <utility>

#include "oracle/pair_motion.hpp"
#include "oracle/triangle_distance.hpp"

namespace ecods::oracle {
namespace {

// The time of which the signs of numbers are asked.
struct Moment {
    Root* root = nullptr;
};

// A polynomial of the time, which has the sign that it has at the moment.
struct Number {
    Polynomial p;
    const Moment* moment = nullptr;

    Number() = default;
    explicit Number(int constant) : p(constant) {}
    Number(Polynomial polynomial, const Moment* at) : p(std::move(polynomial)), moment(at) {}

    int sign() const {
        if (p.is_constant()) return p.is_zero() ? 0 : sgn(p.coefficients()[0]);
        return moment->root->sign_of(p);
    }
    const Moment* of(const Number& other) const { return moment != nullptr ? moment : other.moment; }

    friend Number operator+(const Number& x, const Number& y) { return {x.p + y.p, x.of(y)}; }
    friend Number operator-(const Number& x, const Number& y) { return {x.p - y.p, x.of(y)}; }
    friend Number operator*(const Number& x, const Number& y) { return {x.p * y.p, x.of(y)}; }
};

Number square(const Number& x) {
    return x * x;
}
bool may_be_positive(const Number& x) {
    return x.sign() > 0;
}
bool is_positive(const Number& x) {
    return x.sign() > 0;
}

TriangleOf<Number> numbers_of(const PolynomialCorners& polynomials, const Moment& moment) {
    std::array<Vector<Number>, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t k = 0; k < 3; ++k) corners[i][k] = {polynomials[i][k], &moment};
    }
    return TriangleOf<Number>(corners);
}

PolynomialCorners polynomials_of(const MovingTriangle& triangle) {
    PolynomialCorners corners;
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            corners[i][k] = Polynomial({triangle.from[i][k], triangle.change[i][k]});
        }
    }
    return corners;
}

// The polynomial whose roots are those of all three.
Polynomial common(const Vector<Number>& v) {
    for (const Number& x : v) {
        if (has_one_sign(x.p)) return Polynomial(1);
    }
    return gcd(gcd(v[0].p, v[1].p), v[2].p);
}

// Where what two features span (points, lines, planes) shares a point, this polynomial is zero.
Polynomial condition(const FeaturePair& pair, const TriangleOf<Number>& a, const TriangleOf<Number>& b) {
    const bool vertex_is_of_a = pair.dimension_a == 0;
    const TriangleOf<Number>& s = vertex_is_of_a ? a : b;
    const TriangleOf<Number>& t = vertex_is_of_a ? b : a;
    const auto i = vertex_is_of_a ? pair.a : pair.b, j = vertex_is_of_a ? pair.b : pair.a;
    switch (pair.kind) {
        case Closeness::vertex_vertex:
            return common(b.corner[pair.b] - a.corner[pair.a]);
        case Closeness::vertex_edge:
            return common(cross(Vector<Number>(s.corner[i] - t.corner[j]), t.edge[j]));
        case Closeness::vertex_face:
            return dot(t.normal, Vector<Number>(s.corner[i] - t.corner[0])).p;
        default:
            return dot(cross(a.edge[pair.a], b.edge[pair.b]), Vector<Number>(b.corner[pair.b] - a.corner[pair.a])).p;
    }
}

class Motion final : public PairMotion {
  public:
    Motion(const PolynomialCorners& a, const PolynomialCorners& b, const Polynomial& factor)
        : a_(numbers_of(a, moment_)), b_(numbers_of(b, moment_)) {
        for (const FeaturePair& pair : feature_pairs()) {
            Polynomial zero_there = condition(pair, a_, b_);
            if (!zero_there.is_zero() && !factor.is_constant()) zero_there = without_factor(zero_there, factor);
            conditions_.push_back(std::move(zero_there));
        }
    }

    // What is true all the time begins where something else is true: a vertex is in the plane of a face, and enters
    // the face across an edge; it is on the line of an edge, and enters the edge at its end.
    std::optional<Root> first_time() override {
        std::optional<Root> first;
        for (std::size_t i = 0; i < conditions_.size(); ++i) {
            if (conditions_[i].is_constant()) continue;
            for (Root& root : roots_to_one(conditions_[i])) {
                if (first && root.compare(*first) >= 0) break;
                if (!is_inside(i, root)) continue;
                first = root;
                break;
            }
        }
        return first;
    }

    std::vector<std::size_t> features_at(Root& time) override {
        std::vector<std::size_t> found;
        for (std::size_t i = 0; i < conditions_.size(); ++i) {
            if (time.sign_of(conditions_[i]) == 0 && is_inside(i, time)) found.push_back(i);
        }
        return found;
    }

  private:
    // Of features whose condition is true.
    bool is_inside(std::size_t pair, Root& time) {
        moment_.root = &time;
        return feature_distance(feature_pairs()[pair], a_, b_).is_inside;
    }

    Moment moment_;
    TriangleOf<Number> a_, b_;
    std::vector<Polynomial> conditions_;
};

}  // namespace

std::unique_ptr<PairMotion> make_motion(const MovingTriangle& a, const MovingTriangle& b) {
    return make_motion(polynomials_of(a), polynomials_of(b), Polynomial(1));
}

std::unique_ptr<PairMotion> make_motion(const PolynomialCorners& a, const PolynomialCorners& b,
                                        const Polynomial& factor) {
    return std::make_unique<Motion>(a, b, factor);
}

}  // namespace ecods::oracle
