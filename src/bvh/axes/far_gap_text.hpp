// bvh/axes/far_gap.cpp includes this source once for each instruction set.

[[gnu::noinline]] inline FarRow row_along(const PosedTree& a, const PosedTree& b, const Vec3& difference,
                                          double unit) noexcept {
    const Edges edges_a(a.tree.frame, a.R), edges_b(b.tree.frame, b.R);
    const Double4 d = load3(difference.data());
    const Double4 between = (edges_b.origin - edges_a.origin) + d;
    const double size = largest(absolute(between));
    const Double4 n = between * (1 / size);
    const Double4 row = n * (1 / unit);
    const Matrix4 N = transpose({{row, Double4{}, Double4{}}});
    const DoubleAxes exact(N, edges_a, edges_b, d, Own::a);
    FarRow result;
    result.length = std::sqrt(dot(n, n));
    for (std::size_t k = 0; k < 3; ++k) {
        result.a[k] = exact.a().column[k][0];
        result.b[k] = exact.b().column[k][0];
    }
    result.sum = (row_sums(absolute(exact.a())) + row_sums(absolute(exact.b())))[0];
    result.gap = exact.offset[0];
    result.margin = exact.margin[0];
    return result;
}
