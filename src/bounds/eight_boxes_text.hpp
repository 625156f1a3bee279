// bounds/support_table.cpp includes this source for AVX-512.

// Sets `boxes` to the boxes of eight poses and returns true. Returns false, and sets nothing, if any of these poses
// must be scaled for its box. (find_four_boxes() does this for four poses.)
[[gnu::noinline]] inline bool find_eight_boxes(const TableView& table, const std::array<const Pose*, 8>& poses,
                                               const std::array<Aabb*, 8>& boxes) noexcept {
    const Rows<Double4> low = load_four(poses.data()), high = load_four(poses.data() + 4);
    Rows<Double8> rows;
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) rows.R[row][column] = join(low.R[row][column], high.R[row][column]);
        rows.t[row] = join(low.t[row], high.t[row]);
    }
    Double8 ends[6];
    if (!find_ends(table, rows, ends)) return false;
    Double4 first[6], second[6];
    for (int end = 0; end < 6; ++end) {
        first[end] = low_half(ends[end]);
        second[end] = high_half(ends[end]);
    }
    store_four(first, boxes.data());
    store_four(second, boxes.data() + 4);
    return true;
}
