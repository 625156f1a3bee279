// bounds/support_lanes.hpp includes this source once for each instruction set. V is Double4, or Double8 in the region
// for AVX-512 (simd/double8.hpp). The operations are in the same order for both, so each lane gets the same bits.

using namespace support;

// The functions of four numbers below have the names that the functions of eight have in simd/double8.hpp.

using Mask4 = Vec<std::int64_t, 4>;
using Int4 = Vec<std::int32_t, 4>;

ECODS_ALWAYS_INLINE Mask4 is_less(Double4 a, Double4 b) noexcept {
    return a < b;
}
ECODS_ALWAYS_INLINE Double4 either(Mask4 mask, Double4 yes, Double4 no) noexcept {
    return mask ? yes : no;
}
ECODS_ALWAYS_INLINE Double4 larger(Double4 a, Double4 b) noexcept {
    return a > b ? a : b;
}
ECODS_ALWAYS_INLINE Double4 smaller(Double4 a, Double4 b) noexcept {
    return a < b ? a : b;
}
ECODS_ALWAYS_INLINE Int4 truncated(Double4 v) noexcept {
    return convert<Int4>(v);
}
ECODS_ALWAYS_INLINE Double4 doubles_of(Int4 v) noexcept {
    return convert<Double4>(v);
}
ECODS_ALWAYS_INLINE Double4 negative(Double4 x) noexcept {
    using Bits = Vec<std::uint64_t, 4>;
    return bits_as<Double4>(bits_as<Bits>(x) ^ (std::uint64_t{1} << 63));
}
// Returns next_up(x) in each lane. x must be neither infinite nor NaN.
ECODS_ALWAYS_INLINE Double4 next_up_of_finite(Double4 x) noexcept {
    using Bits = Vec<std::uint64_t, 4>;
    const Bits bits = bits_as<Bits>(x), zero{}, one = zero + 1;
    const Bits next = bits_as<Mask4>(x) < 0 ? bits - 1 : bits + 1;
    return bits_as<Double4>(bits + bits == zero ? one : next);
}
ECODS_ALWAYS_INLINE Int4 either(Mask4 mask, Int4 yes, Int4 no) noexcept {
    return convert<Int4>(mask) ? yes : no;
}
ECODS_ALWAYS_INLINE Int4 places_of(Int4 numbers) noexcept {
    return numbers;
}
// Sets first[i] to table[2 places[i]] and second[i] to table[2 places[i] + 1].
ECODS_ALWAYS_INLINE void load_pairs(const float* table, Int4 places, Double4& first, Double4& second) noexcept {
    const auto two = [&](int i) -> Vec<float, 4> {
        double pairs[2];
        std::memcpy(&pairs[0], table + 2 * static_cast<std::ptrdiff_t>(places[i]), sizeof(double));
        std::memcpy(&pairs[1], table + 2 * static_cast<std::ptrdiff_t>(places[i + 1]), sizeof(double));
        return bits_as<Vec<float, 4>>(Double2{pairs[0], pairs[1]});
    };
    const Vec<float, 4> low = two(0), high = two(2);
    first = convert<Double4>(shuffle<0, 2, 4, 6>(low, high));
    second = convert<Double4>(shuffle<1, 3, 5, 7>(low, high));
}

// The functions down to reaches() compute the support function.

template <class V>
struct Reaches {
    V along, against;
};

// Returns the table's values h(p) and h(-p) of a grid corner p for each lane; the two are neighbours in the table.
template <class V, class Places>
ECODS_ALWAYS_INLINE Reaches<V> table_corner(const float* support, const Places& places) noexcept {
    Reaches<V> reaches;
    load_pairs(support, places, reaches.along, reaches.against);
    return reaches;
}

// Returns upper bounds of h(d) and h(-d), in units of the scale, for one direction d in each lane of (x, y, z).
//
// The directions are rows of a matrix R: the three rows of one R, or the same row of several matrices. -d is in the
// same cell of the grid as d, with the same barycentric coordinates ("shares"), and the table has h(-p) beside h(p).
//
// Bound. Let m = |d_axis| be the largest |coordinate| of d, l_k the shares, p_k the grid corners, and u' = 2^-52. The
// factor to cells is off by u', a place in the grid by 17 u' (of 8 cells, each a quarter of m wide), its remainder
// within a cell is exact, and the shares are off by 2 u'. So d and m sum l_k p_k differ by less than 8 u' m on each
// axis, which changes h by at most 8 u' m 3 sqrt(3) < 42 u' m. The errors of the shares and the roundings of the sum
// cost 8 u' m |h| < 24 u' m. 512 u' m covers all. For m below 2^-1000, the bound |h(d)| <= 3 m suffices.
// Claim: verify/proofs/small_bounds.py
template <class V>
ECODS_ALWAYS_INLINE Reaches<V> reaches(const Row& support, V x, V y, V z) noexcept {
    const V none{}, one = none + 1;
    const V size_x = absolute(x), size_y = absolute(y), size_z = absolute(z);
    const V size_xy = larger(size_y, size_x), m = larger(size_z, size_xy);
    const auto is_y = is_less(size_x, size_y), is_z = is_less(size_xy, size_z);
    // by_axis() selects a, b or c if x, y or z has the largest magnitude. d is that coordinate, or 1 if it is tiny;
    // `start` is where the face of that axis begins in the table.
    const auto by_axis = [&](V a, V b, V c) -> V { return either(is_z, c, either(is_y, b, a)); };
    const auto is_tiny = is_less(m, none + tiny);
    const V d = either(is_tiny, one, by_axis(x, y, z));
    using Int = decltype(truncated(x));
    constexpr int face = SupportTableGrid::face_size;
    const Int start = either(is_z, Int{} + 2 * face, either(is_y, Int{} + face, Int{}));

    const V to_cells = middle / d;
    const auto place = [&](V coordinate) -> V {
        return larger(smaller(coordinate * to_cells + middle, none + cell_count), none);
    };
    const auto cell = [&](V at) -> Int { return min(truncated(at), Int{} + (cell_count - 1)); };
    const V at_i = place(by_axis(y, z, x)), at_j = place(by_axis(z, x, y));
    const Int i = cell(at_i), j = cell(at_j);
    const V f = at_i - doubles_of(i), g = at_j - doubles_of(j);

    // Each cell is cut along its diagonal into two triangles; a, b and c are the corners of the triangle that d meets.
    const V low = smaller(f, g), high = larger(g, f);
    const V first_share = 1 - high, across_share = high - low;
    const Int first = (start + side_count * j) + i,
              across = first + either(is_less(f, g), Int{} + side_count, Int{} + 1);
    const auto at_first = places_of(first);
    const auto a = table_corner<V>(support.data(), at_first), b = table_corner<V>(support.data(), places_of(across)),
               c = table_corner<V>(support.data() + 2 * (side_count + 1), at_first);
    const V up = (first_share * a.along + across_share * b.along) + low * c.along;
    const V down = (first_share * a.against + across_share * b.against) + low * c.against;
    const auto is_negative = is_less(d, none);
    const V along = either(is_negative, down, up), against = either(is_negative, up, down);
    return {.along = either(is_tiny, 4 * m, m * (along + table_error)),
            .against = either(is_tiny, 4 * m, m * (against + table_error))};
}

// The functions below compute boxes.

// Holds the matrices and translations of several poses, one pose in each lane.
template <class V>
struct Rows {
    V R[3][3], t[3];
};

ECODS_ALWAYS_INLINE void transpose4(const double* const (&rows)[4], Double4 (&columns)[4]) noexcept {
    const Double4 a = load_anywhere<Double4>(rows[0]), b = load_anywhere<Double4>(rows[1]);
    const Double4 c = load_anywhere<Double4>(rows[2]), d = load_anywhere<Double4>(rows[3]);
    const Double4 ab_low = shuffle<0, 4, 2, 6>(a, b), ab_high = shuffle<1, 5, 3, 7>(a, b);
    const Double4 cd_low = shuffle<0, 4, 2, 6>(c, d), cd_high = shuffle<1, 5, 3, 7>(c, d);
    columns[0] = shuffle<0, 1, 4, 5>(ab_low, cd_low);
    columns[1] = shuffle<0, 1, 4, 5>(ab_high, cd_high);
    columns[2] = shuffle<2, 3, 6, 7>(ab_low, cd_low);
    columns[3] = shuffle<2, 3, 6, 7>(ab_high, cd_high);
}

ECODS_ALWAYS_INLINE Rows<Double4> load_four(const Pose* const* poses) noexcept {
    static_assert(sizeof(Pose) == 12 * sizeof(double), "R by columns, then t: three registers of four");
    Rows<Double4> rows;
    for (int part = 0; part < 3; ++part) {
        const double* numbers[4];
        for (std::size_t i = 0; i < 4; ++i) numbers[i] = poses[i]->R.data() + 4 * part;
        Double4 columns[4];
        transpose4(numbers, columns);
        for (int k = 0; k < 4; ++k) {
            const int at = 4 * part + k;
            (at < 9 ? rows.R[at % 3][at / 3] : rows.t[at - 9]) = columns[k];
        }
    }
    return rows;
}

// Stores four boxes. ends[0] to ends[2] are the minima on x, y and z, one box in each lane, and ends[3] to ends[5] the
// maxima.
ECODS_ALWAYS_INLINE void store_four(const Double4 (&ends)[6], Aabb* const* boxes) noexcept {
    static_assert(sizeof(Aabb) == 6 * sizeof(double), "the lower ends, then the upper ones");
    const Double4 xy_even = shuffle<0, 4, 2, 6>(ends[0], ends[1]), xy_odd = shuffle<1, 5, 3, 7>(ends[0], ends[1]);
    const Double4 zx_even = shuffle<0, 4, 2, 6>(ends[2], ends[3]), zx_odd = shuffle<1, 5, 3, 7>(ends[2], ends[3]);
    const Double4 yz_even = shuffle<0, 4, 2, 6>(ends[4], ends[5]), yz_odd = shuffle<1, 5, 3, 7>(ends[4], ends[5]);
    const Double4 first[4] = {shuffle<0, 1, 4, 5>(xy_even, zx_even), shuffle<0, 1, 4, 5>(xy_odd, zx_odd),
                              shuffle<2, 3, 6, 7>(xy_even, zx_even), shuffle<2, 3, 6, 7>(xy_odd, zx_odd)};
    const Double2 last[4] = {Double2{yz_even[0], yz_even[1]}, Double2{yz_odd[0], yz_odd[1]},
                             Double2{yz_even[2], yz_even[3]}, Double2{yz_odd[2], yz_odd[3]}};
    for (int i = 0; i < 4; ++i) {
        store_anywhere(boxes[i]->min.data(), first[i]);
        store_anywhere(boxes[i]->min.data() + 4, last[i]);
    }
}

// Sets `ends` to the minima on x, y and z and then the maxima, one box in each lane, and returns true. Returns false,
// and sets nothing, if any of the poses must be scaled for its box.
template <class V>
ECODS_ALWAYS_INLINE bool find_ends(const TableView& table, const Rows<V>& rows, V (&ends)[6]) noexcept {
    const LocalFrame& frame = table.frame;
    const V none{};
    V size[3][3], sum_max{}, size_max{};
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
            size[row][column] = absolute(rows.R[row][column]);
            size_max = larger(size_max, size[row][column]);
        }
        const V* const s = size[row];
        const V sum = (s[0] * table.v_max[0] + s[1] * table.v_max[1]) + s[2] * table.v_max[2];
        sum_max = larger(sum_max, sum + absolute(rows.t[row]));
    }
    const V factor_max = larger(size_max, none + table.v_max_of_all);
    constexpr double least = exact::underflow_of_points;  // as in exact::point_error_bound
    const V underflow =
        either(is_less(factor_max, none + exact::small_factor), none + least, least + least * factor_max);
    const V delta = exact::error_of_sum * sum_max + underflow;
    const auto is_low = is_less(sum_max, none + sum_limit) & is_less(size_max, none + size_limit);
    if (!all(is_low & is_less(unscaled_min + unscaled_min * factor_max, delta))) return false;
    for (int row = 0; row < 3; ++row) {
        const V* const r = rows.R[row];
        const auto times = [&](const Vec3& v) -> V { return (r[0] * v[0] + r[1] * v[1]) + r[2] * v[2]; };
        const V center = times(frame.center) + rows.t[row];
        const V x = absolute(times(frame.axes.col(0))), y = absolute(times(frame.axes.col(1))),
                z = absolute(times(frame.axes.col(2)));
        const V oriented = ((x * frame.half[0] + y * frame.half[1]) + z * frame.half[2]) +
                           16 * double_u * ((size[row][0] + size[row][1]) + size[row][2]);
        const Reaches<V> h = reaches<V>(table.support, r[0], r[1], r[2]);
        const auto outwards = [&](V units) -> V {
            return (smaller(units, oriented) * frame.scale + delta) * (1 + 4 * double_u);
        };
        ends[row] = negative(next_up_of_finite(negative(center - outwards(h.against))));
        ends[row + 3] = next_up_of_finite(center + outwards(h.along));
    }
    return true;
}
