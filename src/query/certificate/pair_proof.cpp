#include "query/certificate/pair_proof.hpp"

#include <algorithm>
#include <bit>
#include <type_traits>

#include "base/arithmetic.hpp"
#include "base/double_key.hpp"

namespace ecods {
namespace {

// Beside a node, a leaf is not opened: all of it must be apart along one axis.
template <class X, class Y>
inline constexpr bool is_leaf_beside_node = requires(X x) {
    x.vertices;
}
&&requires(Y y) {
    y.child;
};

template <class X, class Y>
std::size_t part_count(const X& x, const Y&) {
    return is_leaf_beside_node<X, Y> ? 1 : x.count;
}

// As many bits has the normal of a slab, and as many pairs of a step it must prove to be worth a line.
constexpr int slab_bits = 12;
constexpr int slab_min = 2;
// As many pairs of triangles of two leaves are worth an axis that is tried exactly.
constexpr int ties_min = 4;
// So much of the body's size, or less, is the distance of such a pair more than what is to be proven.
constexpr double tie_share = 0x1p-16;

// As many pairs of leaves that only doubles proved anything of say that gaps are too small for floats.
constexpr int fine_min = 4;

constexpr double unbounded = 0x1p1000;

// Bit j: of some i, bit 8 i + j is set.
std::uint32_t columns_of(std::uint64_t pairs) {
    pairs |= pairs >> 32;
    pairs |= pairs >> 16;
    return static_cast<std::uint32_t>((pairs | pairs >> 8) & 0xff);
}

std::uint64_t lanes_of(std::size_t rows, std::size_t columns) {
    std::uint64_t all = 0;
    for (std::size_t i = 0; i < rows; ++i) all |= ((std::uint64_t{1} << columns) - 1) << (tree_width * i);
    return all;
}

}  // namespace

PairProof::PairProof(const Posed<MeshShape>& a, const Posed<MeshShape>& b, double least, TriangleDistances& pair,
                     Proof& proof)
    : a_(a),
      b_(b),
      tree_a_(MeshShapeAccess::tree(*a.what)),
      tree_b_(MeshShapeAccess::tree(*b.what)),
      least_(least),
      pair_(pair),
      proof_(proof),
      frame_a_(tree_a_.boxes, a.pose.R, Vec3::Zero()),
      frame_b_(tree_b_.boxes, b.pose.R, b.pose.t - a.pose.t),
      normals_{box_normals(tree_a_.boxes.frame, a.pose.R), box_normals(tree_b_.boxes.frame, b.pose.R)} {}

PairProof::Axis PairProof::bind(const Vec3& n) const {
    Axis axis;
    axis.n = n;
    axis.a = put_on_axis(frame_a_, n);
    axis.b = put_on_axis(frame_b_, n);
    // Seven roundings of a product of positive numbers, and two of sums.
    axis.margin = (axis.a.error + axis.b.error) * (1 + 0x1p-20) + least_ * n.norm() * (1 + 0x1p-40);
    if (!axis.a.is_bounded || !axis.b.is_bounded || !(axis.margin < 0x1p600)) {
        axis.margin = unbounded;
    } else {
        axis.in_floats = pair_axis(axis.a, axis.b, least_ * n.norm() * (1 + 0x1p-40));
    }
    return axis;
}

PairProof::Word PairProof::name(Axis& axis) {
    if (axis.named == no_axis) {
        axis.named = static_cast<Word>(proof_.axes.size());
        proof_.axes.push_back({.is_given = true, .given = axis.n});
    }
    return axis.named;
}

template <class X, class Y>
bool PairProof::try_axis(Axis& axis, const X& x, const Y& y, const Trial& trial, std::uint64_t& left) {
    if (axis.margin == unbounded) return false;
    std::uint64_t mask = apart_mask(axis.in_floats, x, y, columns_of(left), trial.of_x, trial.of_y);
    if (trial.is_fine && (left & ~mask) != 0)
        mask |= apart_mask(axis.a, axis.b, axis.margin, x, y, columns_of(left & ~mask));
    // A new axis is a line of its own.
    const int least = axis.named == no_axis ? trial.least : 1;
    if (std::popcount(mask & left) < least || (axis.named == no_axis && proof_.axes.size() >= no_axis)) return false;
    const Word named = name(axis);
    if (std::ranges::find(of_step_, named) == of_step_.end()) of_step_.push_back(named);
    left &= ~mask;
    return true;
}

Vec3 PairProof::slab_normal(std::size_t body, const Slab& slab) const {
    return normals_[body] * Vec3(static_cast<double>(slab.normal[0]), static_cast<double>(slab.normal[1]),
                                 static_cast<double>(slab.normal[2]));
}

// Nodes come again, beside others.
template <class X>
PairProof::SlabAxis& PairProof::slab_axis(const MeshTree& tree, const X& x, std::size_t body) {
    std::size_t node;
    if constexpr (requires { x.child; }) {
        node = 4 * static_cast<std::size_t>(&x - tree.boxes.nodes.data()) + body;
    } else {
        node = 4 * static_cast<std::size_t>(&x - tree.boxes.leaves.data()) + 2 + body;
    }
    std::uint8_t& place = slab_places_[node % slab_places_.size()];
    if (place == 0) {
        slabs_.emplace_back();
        place = static_cast<std::uint8_t>(slabs_.size());
    }
    SlabAxis& kept = slabs_[place - 1u];
    if (kept.node == node) return kept;
    kept = {.node = node, .axis = bind(shortened(slab_normal(body, x.slab), slab_bits))};
    kept.ends = slab_ends(kept.axis.in_floats, body == 0 ? kept.axis.a : kept.axis.b, x.slab);
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
        SlabAxis& slab = body == 0 ? slab_axis(tree_a_, x, body) : slab_axis(tree_b_, y, body);
        Axis& axis = slab.at == SlabAxis::none ? slab.axis : axes_[slab.at];
        const Trial trial{slab_min, is_fine, body == 0 ? &slab.ends : nullptr, body == 0 ? nullptr : &slab.ends};
        if (!try_axis(axis, x, y, trial, left)) continue;
        if (slab.at == SlabAxis::none) {
            slab.at = axes_.size();
            axes_.push_back(slab.axis);
        }
        remember(slab.at);
    }
}

// The axis of the closest features of the first pair of triangles that is left, as a vector, and as a formula.
void PairProof::try_features(const TreeLeaf& x, const TreeLeaf& y, std::uint64_t& left) {
    if (left != 0) {
        const auto first = static_cast<std::size_t>(std::countr_zero(left));
        Axis axis = bind(direction_of(x.triangle[first / tree_width], y.triangle[first % tree_width]));
        if (try_axis(axis, x, y, {.least = contact_count_ == 0 ? 1 : 3, .is_fine = true}, left)) {
            axes_.push_back(axis);
            remember(axes_.size() - 1);
        }
        ++contact_count_;
    }
    if (std::popcount(left) >= ties_min) {
        const auto first = static_cast<std::size_t>(std::countr_zero(left));
        const std::uint32_t i = x.triangle[first / tree_width], j = y.triangle[first % tree_width];
        // Triangles that are well apart are left open by their boxes' axes alone.
        const bool is_tie = !(pair_.enclose(i, j).lower > least_ + tie_share * frame_a_.size.sum());
        if (const auto formula = formula_for(i, j); is_tie && formula && add_contact(*formula, i, j))
            try_contact(contacts_.back(), x, y, left);
    }
}

// Chooses the axes of a step, and returns the pairs that none of them proves.
template <class X, class Y>
std::uint64_t PairProof::open(const X& x, const Y& y, std::uint64_t all) {
    constexpr bool are_leaves = std::is_same_v<X, TreeLeaf> && std::is_same_v<Y, TreeLeaf>;
    std::uint64_t left = all;
    of_step_.clear();
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
    for (Contact& contact : contacts_) {
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

void PairProof::visit(const Parts& top) {
    const MeshBvh &a = tree_a_.boxes, &b = tree_b_.boxes;
    const bool opens_a = !top.a.is_leaf() || top.b.is_leaf(), opens_b = !top.b.is_leaf() || top.a.is_leaf();
    const auto with = [&](const auto& x, const auto& y) {
        const std::size_t columns = part_count(y, x);
        std::uint64_t left = open(x, y, lanes_of(part_count(x, y), columns));
        std::array<Word, tree_width * tree_width> parts;
        std::size_t count = 0;
        if (opens_a && opens_b) {
            for (std::uint64_t rest = left; rest != 0; rest &= rest - 1) {
                const auto bit = static_cast<std::size_t>(std::countr_zero(rest));
                parts[count++] = static_cast<Word>(bit / tree_width * columns + bit % tree_width);
            }
            proof_.add_opening(StepKind::open_both, of_step_, {parts.data(), count});
        } else {
            std::uint64_t lanes = 0;
            for (std::uint64_t rest = left; rest != 0; rest &= rest - 1) {
                const auto bit = static_cast<std::size_t>(std::countr_zero(rest));
                lanes |= std::uint64_t{1} << (opens_a ? bit / tree_width : bit % tree_width);
            }
            left = lanes;
            for (; lanes != 0; lanes &= lanes - 1) parts[count++] = static_cast<Word>(std::countr_zero(lanes));
            proof_.add_opening(opens_a ? StepKind::open_a : StepKind::open_b, of_step_, {parts.data(), count});
        }
        for (std::size_t k = count; k-- > 0;) {
            if constexpr (
                requires { x.child; } && requires { y.child; }) {
                stack_.push_back({x.child[parts[k] / columns], y.child[parts[k] % columns]});
            } else if constexpr (requires { x.child; }) {
                stack_.push_back({x.child[parts[k]], top.b});
            } else if constexpr (requires { y.child; }) {
                stack_.push_back({top.a, y.child[parts[k]]});
            }
        }
        if constexpr (
            !requires { x.child; } && !requires { y.child; }) {
            for (std::size_t k = 0; k < count; ++k) {
                if (!decide(x.triangle[parts[k] / columns], y.triangle[parts[k] % columns])) return;
            }
        }
    };
    if (top.a.is_leaf()) {
        const TreeLeaf& x = a.leaves[top.a.index()];
        top.b.is_leaf() ? with(x, b.leaves[top.b.index()]) : with(x, b.nodes[top.b.index()]);
    } else {
        const BvhNode& x = a.nodes[top.a.index()];
        top.b.is_leaf() ? with(x, b.leaves[top.b.index()]) : with(x, b.nodes[top.b.index()]);
    }
}

template <class X, class Y>
void PairProof::try_contact(Contact& contact, const X& x, const Y& y, std::uint64_t& left) {
    std::uint32_t rows = contact.axis.lanes_inside(0, x), columns = rows == 0 ? 0 : contact.axis.lanes_inside(1, y);
    if (is_leaf_beside_node<X, Y>) rows = rows == x.lanes();
    if (is_leaf_beside_node<Y, X>) columns = columns == y.lanes();
    std::uint64_t mask = 0;
    for (; rows != 0; rows &= rows - 1)
        mask |= std::uint64_t{columns} << (tree_width * static_cast<std::size_t>(std::countr_zero(rows)));
    if ((mask & left) == 0 || (contact.named == no_axis && proof_.axes.size() >= no_axis)) return;
    if (contact.named == no_axis) {
        contact.named = static_cast<Word>(proof_.axes.size());
        proof_.axes.push_back(contact.axis.named());
    }
    of_step_.push_back(contact.named);
    left &= ~mask;
}

std::optional<TrianglePair> PairProof::run(const std::optional<TrianglePair>& closest, EndsAt ends_at) {
    ends_at_ = ends_at;
    axes_.reserve(256);
    stack_.reserve(256);
    of_step_.reserve(32);
    proof_.axes.reserve(32);
    proof_.words.reserve(1024);
    for (const Mat3& normals : normals_) {
        for (int k = 0; k < 3; ++k) axes_.push_back(bind(shortened(normals.col(k))));
    }
    if (closest) {
        const auto formula = formula_for(closest->a, closest->b);
        if (!formula) return closest;
        add_contact(*formula, closest->a, closest->b);
        axes_.push_back(bind(direction_of(closest->a, closest->b)));
        if (axes_.back().n == Vec3::Zero()) {
            axes_.pop_back();
        } else {
            recent_[recent_count_++] = axes_.size() - 1;
        }
    }
    stack_.assign(1, {tree_a_.boxes.root, tree_b_.boxes.root});
    while (!stack_.empty() && !found_) {
        const Parts top = stack_.back();
        stack_.pop_back();
        visit(top);
    }
    return found_;
}

}  // namespace ecods
