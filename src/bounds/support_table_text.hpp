// bounds/support_table.cpp includes this source once for each instruction set.

// Sets reach[k] = max(reach[k], direction_k . point), where direction_k = (x[k], y[k], z[k]).
[[gnu::noinline]] inline void include(const Row& x, const Row& y, const Row& z, const std::array<float, 3>& point,
                                      Row& reach) noexcept {
    for (std::size_t k = 0; k < SupportTableGrid::direction_count; ++k) {
        const float at = (x[k] * point[0] + y[k] * point[1]) + z[k] * point[2];
        reach[k] = at > reach[k] ? at : reach[k];
    }
}

// Returns the box of a pose, from the table.
//
// Bound. The center is posed with the error of a point (exact/point/point.hpp), like any point of the mesh, whose
// coordinates are below |center| + 2 scale: so the bound's term for underflow covers the reach, too. The oriented box
// reaches |R axes| half from the center: both products are off by 3.01 u' sqrt(3) |R| 1, below 16 u' |R| 1 in units of
// the scale. The reach that is added to the center has three roundings, below 4 u', and the sum has one.
// Claim: verify/proofs/small_bounds.py
ECODS_ALWAYS_INLINE Aabb box_by_table(const TableView& table, const Matrix4& R, Double4 t, const Matrix4& size,
                                      double delta) noexcept {
    const Double4 center = R * load3(table.frame.center.data()) + t;  // the operations of pose_point
    const Double4 oriented =
        absolute(R * load3(table.frame.axes)) * load3(table.frame.half.data()) + 16 * double_u * row_sums(size);
    const Reaches<Double4> h = reaches<Double4>(table.support, R.column[0], R.column[1], R.column[2]);
    const auto outwards = [&](Double4 units) {
        return (smaller(units, oriented) * table.frame.scale + delta) * (1 + 4 * double_u);
    };
    const Double4 max = center + outwards(h.along), min = center - outwards(h.against);
    Aabb box;
    for (int k = 0; k < 3; ++k) {
        box.max[k] = next_up(max[k]);
        box.min[k] = next_down(min[k]);
    }
    return box;
}

// Sets `box` to the box of the pose and returns true. Returns false, and sets nothing, if the pose must be scaled for
// its box.
[[gnu::noinline]] inline bool find_box(const TableView& table, const Pose& pose, Aabb& box) noexcept {
    const Matrix4 R = load3(pose.R), size = absolute(R);
    const Double4 t = load3(pose.t.data());
    const double sum_max = largest(size * load3(table.v_max.data()) + absolute(t)), size_max = largest(size);
    const double factor_max = std::max(size_max, table.v_max_of_all);
    const double delta = exact::point_error_bound(sum_max, factor_max);
    if (!(sum_max < sum_limit && size_max < size_limit && delta > unscaled_min + unscaled_min * factor_max)) {
        return false;
    }
    box = box_by_table(table, R, t, size, delta);
    return true;
}

// Sets `boxes` to the boxes of four poses and returns true. Returns false, and sets nothing, if any of the poses must
// be scaled for its box.
[[gnu::noinline]] inline bool find_four_boxes(const TableView& table, const std::array<const Pose*, 4>& poses,
                                              const std::array<Aabb*, 4>& boxes) noexcept {
    Double4 ends[6];
    if (!find_ends(table, load_four(poses.data()), ends)) return false;
    store_four(ends, boxes.data());
    return true;
}
