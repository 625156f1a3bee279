#include "judge/mixed_bodies.hpp"

#include "ecods/rounded.hpp"
#include "ecods/solid.hpp"
#include "oracle/convex.hpp"
#include "oracle/distance.hpp"
#include "oracle/half_space.hpp"
#include "oracle/solid.hpp"

namespace ecods::judge {
namespace {

using oracle::FractionAndRoot;

const Rounded* as_rounded(const MixedBody& body) {
    return dynamic_cast<const Rounded*>(body.shape.get());
}

mpq_class square_of(const oracle::ExactRoot& root) {
    mpz_class num = root.num, den = root.den;
    const long exponent = 2 * root.unit;
    exponent >= 0 ? num <<= static_cast<unsigned long>(exponent) : den <<= static_cast<unsigned long>(-exponent);
    mpq_class square(num, den);
    square.canonicalize();
    return square;
}

mpq_class dot(const std::array<mpq_class, 3>& x, const std::array<mpq_class, 3>& y) {
    return x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
}

oracle::ExactHeights heights_of(const MixedBody& body) {
    const auto& half_space = dynamic_cast<const HalfSpace&>(*body.shape);
    return oracle::ExactHeights({half_space.normal(), half_space.offset(), body.pose});
}

// Two half spaces are apart only if their normals are opposed: then by the height of a point of b's plane above a's.
FractionAndRoot of_half_spaces(const MixedBody& a, const MixedBody& b) {
    const oracle::ExactHeights first = heights_of(a), second = heights_of(b);
    const auto &G = first.direction(), &H = second.direction();
    const mpq_class along = dot(G, H), square_g = dot(G, G), square_h = dot(H, H);
    if (along >= 0 || along * along != square_g * square_h) return {};
    const mpq_class share = -second.at(std::array<mpq_class, 3>{}) / square_h;
    const mpq_class height = first.at({H[0] * share, H[1] * share, H[2] * share});
    if (height <= 0) return {};
    return {0, 1, height * height / square_g};
}

FractionAndRoot of_half_space(const MixedBody& body, const MixedBody& other) {
    const oracle::ExactHeights heights = heights_of(other);
    const mpq_class height = oracle::lowest_corner(heights, body.core().mesh(), body.pose).height;
    return {-mpq_class(body.radius()), height < 0 ? -1 : 1,
            height * height / dot(heights.direction(), heights.direction())};
}

bool has_piece_of(const MixedBody& body, const MixedBody& other) {
    return body.core().form() != MeshForm::surface && oracle::has_piece_inside(other.soup(), body.soup());
}

FractionAndRoot number_of(const MixedBody& a, const MixedBody& b) {
    if (a.is_half_space()) return b.is_half_space() ? of_half_spaces(a, b) : of_half_space(b, a);
    if (b.is_half_space()) return of_half_space(a, b);
    if (a.is_convex() && b.is_convex()) {
        const oracle::ConvexPair pair(a.core().mesh(), a.pose, b.core().mesh(), b.pose);
        if (pair.share_a_point()) return {0, -1, square_of(pair.depth()->depth)};
        return {0, 1, square_of(pair.distance())};
    }
    const mpq_class radii = mpq_class(a.radius()) + mpq_class(b.radius());
    const bool is_inside = has_piece_of(a, b) || has_piece_of(b, a);
    const mpq_class square =
        is_inside ? mpq_class() : square_of(oracle::MeshDistances(a.soup(), b.soup()).closest().distance);
    const bool is_signed = (a.is_rounded() || b.is_rounded()) && a.has_depth() && b.has_depth();
    if (is_signed && square == 0) {
        const oracle::Points x = oracle::posed_points(a.core().mesh(), a.pose),
                             y = oracle::posed_points(b.core().mesh(), b.pose);
        return {-radii, -1, oracle::squared_depth(x, y)};
    }
    const FractionAndRoot number{-radii, 1, square};
    return is_signed || number.sign() > 0 ? number : FractionAndRoot();
}

}  // namespace

const MeshShape& MixedBody::core() const {
    const Rounded* const rounded = as_rounded(*this);
    return rounded != nullptr ? rounded->core() : dynamic_cast<const MeshShape&>(*shape);
}

bool MixedBody::is_rounded() const {
    return as_rounded(*this) != nullptr;
}

double MixedBody::radius() const {
    const Rounded* const rounded = as_rounded(*this);
    return rounded != nullptr ? rounded->radius() : 0;
}

MixedDistance::MixedDistance(const MixedBody& a, const MixedBody& b) : number_(number_of(a, b)) {}

double MixedDistance::nearest() const {
    const double rounded = oracle::nearest(number_);
    return rounded == 0 ? number_.sign() * 0x1p-1074 : rounded;
}

int MixedDistance::compare(double d) const {
    FractionAndRoot rest = number_;
    rest.fraction -= mpq_class(d);
    return rest.sign();
}

}  // namespace ecods::judge
