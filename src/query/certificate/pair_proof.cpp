#include "query/certificate/pair_proof.hpp"

#include <algorithm>
#include <bit>
#include <limits>
#include <type_traits>

namespace ecods {
namespace {

// `is_leaf_beside_node` is true if x is a leaf and y a node. Then the leaf is not opened, but tested as one box with
// all its triangles.
template <class X, class Y>
inline constexpr bool is_leaf_beside_node = std::is_same_v<X, TreeLeaf>&& std::is_same_v<Y, BvhNode>;

template <class X, class Y>
std::size_t part_count(const X& x, const Y&) {
    return is_leaf_beside_node<X, Y> ? 1 : x.count;
}

// slab_bits is the number of bits of the coordinates of a slab's normal. A slab's axis is added to the proof only if it
// proves at least slab_min pairs in a step.
constexpr int slab_bits = 12;
constexpr int slab_min = 2;
// ties_min is the number of open pairs of triangles of two leaves from which on an axis is tried exactly.
constexpr int ties_min = 4;
// tie_share limits exact trials of axes: the triangles' distance must exceed the claimed distance by at most this share
// of the body's size.
constexpr double tie_share = 0x1p-16;

// fine_min is the number of pairs of leaves that only doubles proved apart after which doubles are always tried.
constexpr int fine_min = 4;

std::uint64_t lanes_of(std::size_t rows, std::size_t columns) {
    std::uint64_t all = 0;
    for (std::size_t i = 0; i < rows; ++i) all |= ((std::uint64_t{1} << columns) - 1) << (tree_width * i);
    return all;
}

}  // namespace

PairProof::PairProof(const Posed<MeshShape>& a, const Posed<MeshShape>& b, double least, TriangleDistances& pair,
                     Proof& proof)
    : least_(least),
      pair_(pair),
      proof_(proof),
      bodies_{BodyFrame(a, a.pose.t), BodyFrame(b, a.pose.t)},
      normals_{bodies_[0].normals(), bodies_[1].normals()} {}

template <class X, class Y>
bool PairProof::try_axis(PairAxis& axis, const X& x, const Y& y, const Trial& trial, std::uint64_t& left) {
    if (axis.margin == std::numeric_limits<double>::infinity()) return false;
    const std::uint64_t mask = apart_mask(axis, x, y, left, trial.is_fine, trial.of_x, trial.of_y);
    // An axis that is not in the proof yet costs a line of its own, so it must prove more pairs.
    const int least = axis.named == Proof::no_axis ? trial.least : 1;
    if (std::popcount(mask & left) < least || !proof_.name({.given = axis.n}, axis.named)) return false;
    left &= ~mask;
    return true;
}

// Returns the axis of a node's or leaf's slab. The axis is cached, because the same node is opened again with other
// nodes.
template <class X>
PairProof::SlabAxis& PairProof::slab_axis(const X& x, std::size_t body) {
    const MeshBvh& tree = bodies_[body].tree;
    std::size_t node;
    if constexpr (std::is_same_v<X, BvhNode>) {
        node = 4 * static_cast<std::size_t>(&x - tree.nodes.data()) + body;
    } else {
        node = 4 * static_cast<std::size_t>(&x - tree.leaves.data()) + 2 + body;
    }
    std::uint8_t& place = slab_places_[node % slab_places_.size()];
    if (place == 0) {
        slabs_.emplace_back();
        place = static_cast<std::uint8_t>(slabs_.size());
    }
    SlabAxis& kept = slabs_[place - 1u];
    if (kept.node == node) return kept;
    const auto& n = x.slab.normal;
    const Vec3 normal(static_cast<double>(n[0]), static_cast<double>(n[1]), static_cast<double>(n[2]));
    kept = {.node = node, .axis = bind(shortened(normals_[body] * normal, slab_bits))};
    kept.ends = slab_ends(kept.axis, body == 0 ? kept.axis.a : kept.axis.b, x.slab);
    return kept;
}

void PairProof::remember(std::size_t at) {
    const auto end = recent_.begin() + static_cast<std::ptrdiff_t>(recent_count_);
    auto found = std::find(recent_.begin(), end, at);
    if (found == end) {
        if (recent_count_ < recent_.size()) ++recent_count_;
        found = recent_.begin() + static_cast<std::ptrdiff_t>(recent_count_) - 1;
    }
    std::move_backward(recent_.begin(), found, found + 1);
    recent_[0] = at;
}

template <class X, class Y>
void PairProof::try_slabs(const X& x, const Y& y, bool is_fine, std::uint64_t& left) {
    for (const std::size_t body : {0u, 1u}) {
        if (left == 0) return;
        SlabAxis& slab = body == 0 ? slab_axis(x, body) : slab_axis(y, body);
        PairAxis& axis = slab.at == SlabAxis::none ? slab.axis : axes_[slab.at];
        const Trial trial{slab_min, is_fine, body == 0 ? &slab.ends : nullptr, body == 0 ? nullptr : &slab.ends};
        if (!try_axis(axis, x, y, trial, left)) continue;
        if (slab.at == SlabAxis::none) {
            slab.at = axes_.size();
            axes_.push_back(slab.axis);
        }
        remember(slab.at);
    }
}

// Tries the axis between the closest features of the first open pair of triangles, rounded to a vector. If many pairs
// stay open, tries the same axis exactly, as a formula. Removes from `left` the pairs that are proven apart.
void PairProof::try_features(const TreeLeaf& x, const TreeLeaf& y, std::uint64_t& left) {
    if (left != 0) {
        const auto first = static_cast<std::size_t>(std::countr_zero(left));
        PairAxis axis = bind(direction_of(x.triangle[first / tree_width], y.triangle[first % tree_width]));
        if (try_axis(axis, x, y, {.least = contact_count_ == 0 ? 1 : 3, .is_fine = true}, left)) {
            axes_.push_back(axis);
            remember(axes_.size() - 1);
        }
        ++contact_count_;
    }
    if (std::popcount(left) >= ties_min) {
        const auto first = static_cast<std::size_t>(std::countr_zero(left));
        const std::uint32_t i = x.triangle[first / tree_width], j = y.triangle[first % tree_width];
        // Two triangles whose distance clearly exceeds the claimed one are no tie: they are open only because too few
        // axes were tried.
        const bool is_tie = !(pair_.enclose(i, j).lower > least_ + tie_share * bodies_[0].size.sum());
        if (const auto formula = formula_for(i, j); is_tie && formula && add_contact(*formula, i, j))
            try_contact(contacts_.back(), x, y, left);
    }
}

// Tries the axes of a step for nodes or leaves x and y. Returns the pairs of `all` that no axis proves apart.
template <class X, class Y>
std::uint64_t PairProof::try_axes(const X& x, const Y& y, std::uint64_t all) {
    constexpr bool are_leaves = std::is_same_v<X, TreeLeaf> && std::is_same_v<Y, TreeLeaf>;
    std::uint64_t left = all;
    bool is_fine = fine_count_ == fine_min;
    const auto use = [&](std::size_t at) {
        if (try_axis(axes_[at], x, y, {.least = 1, .is_fine = is_fine}, left)) remember(at);
    };
    const std::array<std::size_t, 4> recent = recent_;
    const std::size_t recent_count = recent_count_;
    for (std::size_t k = 0; k < recent_count && left != 0; ++k) use(recent[k]);
    if (are_leaves && left != 0) {
        const std::uint64_t before = left;
        is_fine = true;
        for (std::size_t k = 0; k < recent_count && left != 0; ++k) use(recent[k]);
        if (left != before && fine_count_ < fine_min) ++fine_count_;
    }
    for (ContactAxis& contact : contacts_) {
        if (left != 0) try_contact(contact, x, y, left);
    }
    try_slabs(x, y, is_fine, left);
    const bool tries_boxes = 8 * std::popcount(left) > std::popcount(all);
    for (std::size_t k = 0; k < 6 && left != 0 && tries_boxes; ++k) {
        const auto end = recent.begin() + static_cast<std::ptrdiff_t>(recent_count);
        if (std::find(recent.begin(), end, k) == end) use(k);
    }
    if constexpr (are_leaves) try_features(x, y, left);
    return left;
}

template <class X, class Y>
void PairProof::try_contact(ContactAxis& contact, const X& x, const Y& y, std::uint64_t& left) {
    std::uint32_t rows = contact.lanes_inside(0, x), columns = rows == 0 ? 0 : contact.lanes_inside(1, y);
    if (is_leaf_beside_node<X, Y>) rows = rows == x.lanes();
    if (is_leaf_beside_node<Y, X>) columns = columns == y.lanes();
    std::uint64_t mask = 0;
    for (; rows != 0; rows &= rows - 1)
        mask |= std::uint64_t{columns} << (tree_width * static_cast<std::size_t>(std::countr_zero(rows)));
    if ((mask & left) != 0 && proof_.name(contact.axis, contact.named)) left &= ~mask;
}

// Adds the opening of x and y to the proof. Returns the pairs that the opening leaves open: bit 8 i + j stands for lane
// i of x and lane j of y.
template <class X, class Y>
std::uint64_t PairProof::open(const X& x, const Y& y) {
    const std::size_t columns = part_count(y, x);
    proof_.begin_opening();
    const std::uint64_t left = try_axes(x, y, lanes_of(part_count(x, y), columns));
    std::array<Proof::Word, tree_width * tree_width> parts;
    std::size_t count = 0;
    for (std::uint64_t rest = left; rest != 0; rest &= rest - 1) {
        const auto bit = static_cast<std::size_t>(std::countr_zero(rest));
        parts[count++] = static_cast<Proof::Word>(bit / tree_width * columns + bit % tree_width);
    }
    const StepKind kind = std::is_same_v<X, Y>         ? StepKind::open_both
                          : std::is_same_v<X, BvhNode> ? StepKind::open_a
                                                       : StepKind::open_b;
    proof_.end_opening(kind, {parts.data(), count});
    return left;
}

// Opens a pair from the stack: a node or leaf y of body 1 and x of body 0. (In this order, the bits of LanePairs are
// those of open().) Returns false if two triangles meet or cross, which ends the walk.
bool PairProof::visit(const NodePair& top) {
    return with_nodes(bodies_[1].tree, bodies_[0].tree, top, [&]<class Y, class X>(const Y& y, const X& x) {
        LanePairs left(open(x, y));
        if constexpr (are_leaves<Y, X>) {
            for (; left.more(); left.next()) {
                const std::uint32_t i = x.triangle[left.j()], j = y.triangle[left.i()];
                const auto formula = formula_for(i, j);
                if (!formula) found_ = TrianglePair{i, j};
                if (found_) return false;
                proof_.add_triangles(*formula);
            }
        } else {
            const auto before = static_cast<std::ptrdiff_t>(stack_.size());
            push_children(top, y, x, left, [&](const NodePair& children, const auto&) { stack_.push_back(children); });
            std::reverse(stack_.begin() + before, stack_.end());  // a proof opens the first next
        }
        return true;
    });
}

// Adds the axis between the two triangles `closest`, as a formula and as a rounded vector, to the axes that are tried
// first.
void PairProof::add_first_axes(const TrianglePair& closest, const AxisFormula& formula) {
    add_contact(formula, closest.a, closest.b);
    axes_.push_back(bind(direction_of(closest.a, closest.b)));
    if (axes_.back().n == Vec3::Zero()) {
        axes_.pop_back();
    } else {
        recent_[recent_count_++] = axes_.size() - 1;
    }
}

std::optional<TrianglePair> PairProof::run(const std::optional<TrianglePair>& closest, EndsAt ends_at) {
    ends_at_ = ends_at;
    axes_.reserve(256);
    stack_.reserve(256);
    proof_.axes.reserve(32);
    proof_.words.reserve(1024);
    for (const Mat3& normals : normals_) {
        for (int k = 0; k < 3; ++k) axes_.push_back(bind(shortened(normals.col(k))));
    }
    if (closest) {
        const auto formula = formula_for(closest->a, closest->b);
        if (!formula) return closest;
        add_first_axes(*closest, *formula);
    }
    stack_.assign(1, {bodies_[1].tree.root, bodies_[0].tree.root});
    while (!stack_.empty()) {
        const NodePair top = stack_.back();
        stack_.pop_back();
        if (!visit(top)) break;
    }
    return found_;
}

}  // namespace ecods
