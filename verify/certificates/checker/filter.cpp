#include "filter.hpp"

#include <bit>
#if defined(__SSE2__)
#include <emmintrin.h>
#endif

#include "vectors.hpp"

namespace certificate_checker {
namespace {

constexpr double u = 0x1p-53;                           // half the distance from 1 to the next double
constexpr double underflow = 0x1p-1074;                 // at most this is lost where a result is subnormal
constexpr std::size_t kept_max = std::size_t{1} << 24;  // numbers: no certificate of use needs as many
constexpr double inflation = 1 + 0x1p-48;               // more than the roundings of the few sums of a bound

// The true number is within `error` of `value`. An operation adds what it rounds, u times its result, to what the
// operands are wrong by; the bound is inflated because it is rounded itself. Infinity and NaN are passed on, and no
// comparison that a proof needs holds for them.
struct Approximate {
    double value = 0, error = 0;
};
Approximate rounded(double value, double error) {
    return {value, (error + u * std::abs(value) + underflow) * inflation};
}
Approximate operator+(const Approximate& a, const Approximate& b) {
    return rounded(a.value + b.value, a.error + b.error);
}
Approximate& operator+=(Approximate& a, const Approximate& b) {
    return a = a + b;
}
Approximate operator-(const Approximate& a, const Approximate& b) {
    return rounded(a.value - b.value, a.error + b.error);
}
Approximate operator*(const Approximate& a, const Approximate& b) {
    return rounded(a.value * b.value, std::abs(a.value) * b.error + std::abs(b.value) * a.error + a.error * b.error);
}

// Bit j of eight: low[j] is greater than `above`, or high[j] less than `below`.
unsigned outside(const double* low, const double* high, double below, double above) {
    unsigned bits = 0;
#if defined(__SSE2__)
    const __m128d least = _mm_set1_pd(below), most = _mm_set1_pd(above);
    for (unsigned j = 0; j < 8; j += 2) {
        const __m128d is_above = _mm_cmpgt_pd(_mm_loadu_pd(low + j), most);
        const __m128d is_below = _mm_cmplt_pd(_mm_loadu_pd(high + j), least);
        bits |= static_cast<unsigned>(_mm_movemask_pd(_mm_or_pd(is_above, is_below))) << j;
    }
#else
    for (unsigned j = 0; j < 8; ++j) bits |= (low[j] > above || high[j] < below ? 1u : 0u) << j;
#endif
    return bits;
}

}  // namespace

// Vertices, R and t - origin up to 2^300 and n up to 2^24 let no product of them overflow; what underflows then amounts
// to less than 2^-400.
Filter::Filter(const PosedMesh& a, const PosedMesh& b, double m, std::size_t axis_count, Budget& budget)
    : sides_{Side{a.mesh, &a.pose}, Side{b.mesh, &b.pose}}, m_(m), budget_(&budget), axis_count_(axis_count) {
    ranges_.reserve(128);
    places_.reserve(1024);
    for (Side& side : sides_) {
        budget.spend(side.mesh->nodes.size() / 4);
        side.rows.resize(side.mesh->nodes.size());
        for (std::size_t i = 0; i < 3; ++i) {
            side.offset[i] = side.pose->t[i] - a.pose.t[i];
            side.magnitude[i] = std::abs(side.offset[i]);
            for (std::size_t l = 0; l < 3; ++l) {
                const double v = side.mesh->magnitude[l], r = std::abs(side.pose->R[i][l]);
                side.magnitude[i] += r * v;
                side.is_moderate = side.is_moderate && std::max({v, r, std::abs(side.offset[i])}) <= 0x1p300;
            }
        }
    }
}

// A corner: its error is as below, with n a coordinate axis. The vector is scaled to at most 1.
//
// Directions: let S = sum of |n_i| magnitude_i. R^T n takes 3 products and 2 sums, v.(R^T n) again, so each is wrong by
// 3u S; the offset, which takes a rounded difference, 3 products and 2 sums, by 4u S; the last sum by u S; a vertex
// that is itself rounded (mesh_of in mesh.cpp) by 2u S. With what comparing two such numbers takes this is 11u S (up
// to terms in u^2), and 16u covers these and the roundings of the bound itself.
void Filter::set_axis(std::size_t k, const AxisLine& source, const std::array<std::uint32_t, 2>& triangles) {
    budget_->spend(256);
    const auto corner = [&](std::size_t number, std::size_t corner_number) {
        const Side& side = sides_[number];
        const auto& v = side.mesh->vertices[side.mesh->corners(triangles[number])[corner_number % 3]];
        Vector<Approximate> x;
        for (std::size_t i = 0; i < 3; ++i) {
            x[i] = {dot(side.pose->R[i], v) + side.offset[i], 16 * u * side.magnitude[i] + 0x1p-400};
            if (!side.is_moderate) x[i].error = infinity;
        }
        return x;
    };
    const auto& g = source.given;
    Vector<Approximate> n = {{{g[0]}, {g[1]}, {g[2]}}};
    if (source.formula.kind != Kind::given) n = vector_of<Approximate>(source.formula, corner);
    const double size = std::max({std::abs(n[0].value), std::abs(n[1].value), std::abs(n[2].value)});
    // What this underflows is covered by the 2^-400 of directions.
    const double scale =
        size > 0 && size < infinity ? std::ldexp(1, std::clamp(-std::ilogb(size) - 1, -1000, 1000)) : 1;
    double square = 0;
    for (Approximate& x : n) {
        x = {x.value * scale, x.error * scale};
        square += (std::abs(x.value) + x.error) * (std::abs(x.value) + x.error);
    }
    axes_.resize(std::max(axes_.size(), k + 1));
    Axis& axis = axes_[k] = {};
    axis.need = m_ > 0 ? m_ * std::sqrt(square) * inflation : 0;
    for (std::size_t number = 0; number < 2; ++number) {
        const Side& side = sides_[number];
        Direction& d = axis.along[number];
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t l = 0; l < 3; ++l) d.n[l] += side.pose->R[i][l] * n[i].value;
            d.offset += n[i].value * side.offset[i];
            d.error += (16 * u * std::abs(n[i].value) + 2 * n[i].error) * side.magnitude[i];
        }
        d.error = side.is_moderate ? d.error + 0x1p-400 : infinity;
        axis.need += d.error;
    }
    axis.need *= inflation;
}

// Calls use(vertex, its place along d) for all corners of the part but such as are within `inner`, which may grow
// meanwhile. The depth of the recursion is that of the tree, which is limited.
template <class Use>
void Filter::visit(const Side& side, std::uint32_t part, const Direction& d, const Range& inner, const Use& use) {
    const auto contains = [&](double x) { return inner.low <= x && x <= inner.high; };
    if (side.mesh->is_triangle(part) || side.mesh->is_leaf(part)) {
        budget_->spend(side.mesh->all_corners(part).size());
        for (const std::uint32_t vertex : side.mesh->all_corners(part)) {
            const double x = dot(d.n, side.mesh->vertices[vertex]) + d.offset;
            if (!contains(x)) use(vertex, x);
        }
        return;
    }
    const Node& node = side.mesh->nodes[part];
    budget_->spend(8 * node.count);
    std::array<double, std::size_t{2} * parts_max> ends;
    measure_boxes(*side.mesh, node.first, node.count, d, ends.data());
    for (std::uint32_t i = 0; i < node.count; ++i) {
        if (!contains(ends[i]) || !contains(ends[padded(node.count) + i])) visit(side, node.first + i, d, inner, use);
    }
}

Filter::Range Filter::range(const Side& side, std::uint32_t part, const Direction& d) {
    Range found = {infinity, -infinity};
    visit(side, part, d, found, [&](std::uint32_t, double x) {
        found = {std::min(found.low, x), std::max(found.high, x)};
    });
    return found;
}

// The part reaches at least to high - error, and what is at most high - 4 error in doubles reaches at most to
// high - 3 error.
const std::vector<std::uint32_t>& Filter::extremes(std::size_t side, std::size_t k, std::uint32_t i) {
    const Direction& d = axes_[named_[k]].along[side];
    const std::uint32_t part = sides_[side].parts.first + i;
    Range inner = d.error < infinity ? range(sides_[side], part, d) : Range{infinity, -infinity};
    inner = {inner.low + 4 * d.error, inner.high - 4 * d.error};
    extremes_.clear();
    visit(sides_[side], part, d, inner, [&](std::uint32_t vertex, double) { extremes_.push_back(vertex); });
    return extremes_;
}

// The sums are as those of a vertex, so their errors are, too. Along -n, a box is least where it is greatest along n.
void Filter::measure_boxes(const Mesh& mesh, std::uint32_t first, std::size_t count, const Direction& d, double* ends) {
    const auto [x, y, z] = d.n;
    const std::size_t i = x < 0 ? 1 : 0, j = y < 0 ? 1 : 0, k = z < 0 ? 1 : 0;
    for (const std::size_t end : {0u, 1u}) {
        const double* const px = &mesh.boxes[i ^ end][0][first];
        const double* const py = &mesh.boxes[j ^ end][1][first];
        const double* const pz = &mesh.boxes[k ^ end][2][first];
        double* const of_end = ends + end * padded(count);
        for (std::size_t p = 0; p < count; ++p) of_end[p] = x * px[p] + y * py[p] + z * pz[p] + d.offset;
    }
}

void Filter::measure_leaf(const Mesh& mesh, const Node& leaf, const Direction& d, double* ends) {
    std::array<double, std::size_t{3} * parts_max> at;
    const auto [x, y, z] = d.n;
    const double* const px = &mesh.leaf_points[0][leaf.first_corner];
    const double* const py = &mesh.leaf_points[1][leaf.first_corner];
    const double* const pz = &mesh.leaf_points[2][leaf.first_corner];
    for (std::size_t c = 0; c < leaf.corner_count; ++c) at[c] = x * px[c] + y * py[c] + z * pz[c] + d.offset;
    const auto* const places = &mesh.leaf_places[leaf.first - mesh.nodes.size()];
    for (std::size_t i = 0; i < leaf.count; ++i) {
        const double p = at[places[i][0]], q = at[places[i][1]], r = at[places[i][2]];
        ends[i] = std::min(std::min(p, q), r);
        ends[padded(leaf.count) + i] = std::max(std::max(p, q), r);
    }
}

double* Filter::add_ends(std::size_t count) {
    const std::size_t begin = ends_used_;
    ends_used_ += count;
    if (ends_used_ > ends_size_) {
        ends_size_ = 2 * ends_used_ + 1024;
        auto larger = std::make_unique_for_overwrite<double[]>(ends_size_);
        std::copy_n(ends_.get(), begin, larger.get());
        ends_ = std::move(larger);
    }
    return &ends_[begin];
}

// Ranges of the parts of a node or a leaf, or of one part: by boxes, of triangles by corners.
Filter::Ranges Filter::measure(const Side& side, const Node& parts, const Direction& d) {
    const std::size_t begin = ends_used_;
    double* const ends = add_ends(2 * padded(parts.count));
    for (std::size_t i = parts.count; i < padded(parts.count); ++i) ends[i] = ends[padded(parts.count) + i] = 0;
    const bool is_triangle = parts.corner_count == 0 && side.mesh->is_triangle(parts.first);
    if (is_triangle) {
        const Range r = range(side, parts.first, d);
        ends[0] = r.low;
        ends[lanes] = r.high;
    } else if (parts.corner_count == 0) {
        measure_boxes(*side.mesh, parts.first, parts.count, d, ends);
    } else {
        measure_leaf(*side.mesh, parts, d, ends);
    }
    return {begin, is_triangle || parts.corner_count > 0 ? ~std::uint64_t{0} : 0};
}

// Of the step's parts along an axis. Each node that was opened has a row, but for the root, which is opened once or
// twice.
std::size_t Filter::place_of_ranges(std::size_t number, std::uint32_t axis) {
    Side& side = sides_[number];
    std::size_t* place = nullptr;
    if (side.parts.number != 0 && axis < axis_count_) {
        std::uint32_t& row = side.rows[side.parts.number];
        if (row == 0) {
            budget_->spend(axis_count_);
            places_.resize(places_.size() + axis_count_);
            row = static_cast<std::uint32_t>(places_.size() / axis_count_);
        }
        place = &places_[(row - 1) * axis_count_ + axis];
        if (*place != 0) return *place - 1;
    }
    ranges_.push_back(measure(side, side.parts, axes_[axis].along[number]));
    if (place != nullptr) *place = ranges_.size();
    return ranges_.size() - 1;
}

// Ranges are found again where they are asked for.
void Filter::forget() {
    ranges_.clear();
    places_.clear();
    ends_used_ = 0;
    for (Side& side : sides_) {
        budget_->spend(side.rows.size());
        side.rows.assign(side.rows.size(), 0);
    }
}

void Filter::open(const std::array<Node, 2>& parts, std::span<const std::uint32_t> axes, Pairs& left) {
    named_ = axes;
    if (ends_used_ + places_.size() > kept_max) forget();
    for (const std::size_t number : {0, 1}) {
        sides_[number].parts = parts[number];
        sides_[number].ranges.clear();
    }
    bool is_any_left = true;
    for (std::size_t k = 0; k < axes.size() && is_any_left; ++k) {
        for (const std::size_t number : {0, 1}) {
            sides_[number].ranges.push_back(place_of_ranges(number, axes[k]));
        }
        is_any_left = take_out(k, left);
    }
    for (std::uint32_t i = 0; i < parts[0].count && is_any_left; ++i) {
        for (std::uint64_t rest = left[i]; rest != 0; rest &= rest - 1) {
            const auto j = static_cast<std::uint32_t>(std::countr_zero(rest));
            if (are_apart_by_corners(i, j)) left[i] &= ~(std::uint64_t{1} << j);
        }
    }
}

// Takes out the pairs that are apart along the step's axis k by their ranges, as they are. Returns whether any is left.
bool Filter::take_out(std::size_t k, Pairs& left) {
    const std::size_t row_count = sides_[0].parts.count, rows = padded(row_count),
                      columns = padded(sides_[1].parts.count);
    const double *const a = ends_of(0, k), *const b = ends_of(1, k), need = axes_[named_[k]].need;
    for (std::size_t first = 0; first < columns; first += lanes) {
        const double *const low = b + first, *const high = low + columns;
        for (std::size_t i = 0; i < row_count; ++i) {
            const double above = a[rows + i] + need, below = a[i] - need;
            left[i] &= ~(std::uint64_t{outside(low, high, below, above)} << first);
        }
    }
    std::uint64_t any_left = 0;
    for (std::size_t i = 0; i < row_count; ++i) any_left |= left[i];
    return any_left != 0;
}

bool Filter::are_apart_by_corners(std::uint32_t i, std::uint32_t j) {
    for (std::size_t k = 0; k < named_.size(); ++k) {
        bool is_new = false;
        for (const std::size_t number : {0, 1}) {
            const Side& side = sides_[number];
            const std::uint32_t part = number == 0 ? i : j;
            Ranges& ranges = ranges_of(number, k);
            if ((ranges.best >> part & 1) != 0) continue;
            const Range found = range(side, side.parts.first + part, axes_[named_[k]].along[number]);
            ends_[ranges.begin + part] = found.low;
            ends_[ranges.begin + padded(side.parts.count) + part] = found.high;
            ranges.best |= std::uint64_t{1} << part;
            is_new = true;
        }
        if (is_new && excess(k, i, j) > 0) return true;
    }
    return false;
}

std::size_t Filter::best_axis(std::uint32_t i, std::uint32_t j) {
    std::size_t best = 0;
    double most = -infinity;
    for (std::size_t k = 0; k < named_.size(); ++k) {
        const double x = excess(k, i, j);
        if (x > most) best = k;
        most = std::max(most, x);
    }
    return best;
}

}  // namespace certificate_checker
