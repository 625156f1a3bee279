// Signs of determinants against rational numbers.
#include "ecods/primitives.hpp"

#include <gmpxx.h>

#include "fuzz/targets/bytes.hpp"
#include "fuzz/targets/require.hpp"

namespace {

using namespace ecods;
using RationalPoint = std::array<mpq_class, 3>;

RationalPoint rational(const PosedPoint& p) {
    RationalPoint result;
    for (int row = 0; row < 3; ++row) {
        mpq_class& x = result[static_cast<std::size_t>(row)];
        x = mpq_class(p.pose.t[row]);
        for (int k = 0; k < 3; ++k) x += mpq_class(p.pose.R(row, k)) * mpq_class(p.v[k]);
    }
    return result;
}

Sign sign_of(const mpq_class& x) {
    return static_cast<Sign>(sgn(x));
}

// Along the third column.
mpq_class determinant(const RationalPoint& a, const RationalPoint& b, const RationalPoint& c, const RationalPoint& d) {
    RationalPoint u, v, w;
    for (std::size_t k = 0; k < 3; ++k) {
        u[k] = b[k] - a[k];
        v[k] = c[k] - a[k];
        w[k] = d[k] - a[k];
    }
    return u[2] * (v[0] * w[1] - v[1] * w[0]) - v[2] * (u[0] * w[1] - u[1] * w[0]) + w[2] * (u[0] * v[1] - u[1] * v[0]);
}

mpq_class minor(const RationalPoint& a, const RationalPoint& b, const RationalPoint& c, std::size_t i, std::size_t j) {
    return (b[i] - a[i]) * (c[j] - a[j]) - (b[j] - a[j]) * (c[i] - a[i]);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    ecods::fuzz::Bytes bytes(data, size);
    const std::array<Pose, 2> poses = {bytes.pose(), bytes.pose()};
    const auto posed = [&](const Vec3& v) { return PosedPoint{poses[bytes.below(2)], v}; };
    std::array<Vec3, 4> v;
    for (Vec3& x : v) x = bytes.point();
    const PosedPoint a = posed(v[0]), b = posed(v[1]), c = posed(v[2]), d = posed(v[3]);
    const RationalPoint p = rational(a), q = rational(b), r = rational(c), s = rational(d);

    using ecods::fuzz::require;
    require(orient3d(a, b, c, d) == sign_of(determinant(p, q, r, s)), "orient3d of posed points");
    require(orient3d(d, a, c, b) == sign_of(determinant(s, p, r, q)), "orient3d of posed points in another order");
    for (int axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<std::size_t>((axis + 1) % 3), j = static_cast<std::size_t>((axis + 2) % 3);
        require(orient2d(a, b, c, axis) == sign_of(minor(p, q, r, i, j)), "orient2d of posed points");
    }
    const Pose nowhere;
    const auto plain = [&](const Vec3& x) { return rational({nowhere, x}); };
    const RationalPoint e = plain(v[0]), f = plain(v[1]), g = plain(v[2]), h = plain(v[3]);
    require(orient3d(v[0], v[1], v[2], v[3]) == sign_of(determinant(e, f, g, h)), "orient3d");
    require(orient2d(v[0].head<2>(), v[1].head<2>(), v[2].head<2>()) == sign_of(minor(e, f, g, 0, 1)), "orient2d");
    return 0;
}
