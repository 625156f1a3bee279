// bvh/axes/line_axes.cpp includes this source once for each instruction set.

[[gnu::noinline]] inline void bind_line_axes(const MeshBvh& tree, const Mat3& R, LineBound& bound) noexcept {
    const Edges edges(tree.frame, R);
    const Matrix4 N = axes_of(edges.edges, edges.edges);
    const Matrix4 P = N * edges.edges;
    for (int k = 0; k < 3; ++k) {
        store(bound.N[k], N.column[k]);
        store(bound.P[k], P.column[k]);
    }
    store(bound.size, edges.size);
    store(bound.origin, edges.origin);
    store(bound.origin_size, edges.origin_size);
    bound.factor = edges.factor;
}
