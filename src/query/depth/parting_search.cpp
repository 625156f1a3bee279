// PartingSearch searches by heuristics for translations that part two solids. No computation here has to be right,
// because are_parted() confirms each result.
#include "query/depth/parting_search.hpp"

#include <algorithm>
#include <cmath>

#include "base/double_key.hpp"
#include "query/cast/cast_until.hpp"
#include "query/shape/mesh_tree.hpp"
#include "query/solid/relations.hpp"
#include "query/solid/solid_parts.hpp"

namespace ecods::depths {
namespace {

// The next two constants limit the number of directions that are tried, best ones first, and the number of contact
// normals that are followed from each direction.
constexpr std::size_t direction_count_max = 6;
constexpr int normal_count_max = 3;

// A translation is lengthened by these amounts, one after the other, until it parts the solids. The amounts are
// relative to the numbers whose difference the translation is.
constexpr std::array<double, 6> margins{0, 0x1p-52, 0x1p-50, 0x1p-46, 0x1p-38, 0x1p-26};

// short_part and unknown_part are lengths of the path after the contact, relative to the whole path. A contact's time
// is known to 2^-52 of the path, so to 2^-46 of a part as short as `short_part`. A part below `unknown_part` may be so
// short that its length does not show whether the path is worth following.
constexpr double short_part = 0x1p-6, unknown_part = 0x1p-20;

const exact::MeshExtent& extent_of(const Posed<Solid>& solid) {
    return MeshShapeAccess::tree(*solid.what).extent;
}

// Returns an upper bound of |v|. Three quotients, their squares, a root and a product together have a relative error of
// less than 2^-48.
double length_above(const Vec3& v) noexcept {
    const double most = v.cwiseAbs().maxCoeff();
    // Below 2^-900, rounding errors are no longer relative to the number.
    if (!(most >= 0x1p-900)) return std::isnan(most) ? std::numeric_limits<double>::infinity() : 0x1p-898;
    const Vec3 part = v / most;
    return most * (std::sqrt(part.dot(part)) * (1 + 0x1p-46));
}

}  // namespace

PartingSearch::PartingSearch(const Posed<Solid>& a, const Posed<Solid>& b, QueryMemory& memory)
    : a_(a), b_(b), memory_(memory) {
    const auto center = [](const Posed<Solid>& solid) -> Vec3 {
        return solid.pose.R * extent_of(solid).center + solid.pose.t;
    };
    centers_ = {center(a), center(b)};
    const auto size = [](const Posed<Solid>& solid) -> double {
        return (solid.pose.R.cwiseAbs() * extent_of(solid).half).maxCoeff();
    };
    way_min_ = 0x1p-48 * std::min(size(a), size(b));
}

double PartingSearch::reach_along(const Vec3& n) const {
    const auto half = [&](const Posed<Solid>& solid) {
        const Vec3 along = solid.pose.R.transpose() * n;
        return along.cwiseAbs().dot(extent_of(solid).half);
    };
    const double apart = n.dot(centers_[0] - centers_[1]) + half(a_) + half(b_);
    const double roundings = (centers_[0].cwiseAbs() + centers_[1].cwiseAbs()).sum() * 0x1p-48;
    return apart * (1 + 0x1p-20) + roundings;
}

void PartingSearch::add_direction(const Vec3& n) {
    const double length = n.norm();
    if (!(length > 0x1p-400 && length < 0x1p400)) return;
    const Vec3 unit = n / length;
    const bool is_known =
        std::ranges::any_of(directions_, [&](const Direction& d) { return d.n.dot(unit) > 1 - 0x1p-20; });
    if (is_known) return;
    const double reach = reach_along(unit);
    if (reach > 0 && reach <= std::numeric_limits<double>::max()) directions_.push_back({unit, reach});
}

bool PartingSearch::confirm(const Vec3& parted) {
    const double length = length_above(parted - b_.pose.t);
    if (!parted.allFinite() || !(length < best_.length)) return false;
    if (!are_parted({*b_.what, {b_.pose.R, parted}})) return false;
    best_ = {parted, length, {}};
    return true;
}

bool PartingSearch::are_parted(const Posed<Solid>& moved) const {
    if (has_inside(*a_.what) && has_inside(*b_.what)) return solid_relation(a_, moved, memory_) <= Relation::touching;
    const auto convex = [](const Posed<Solid>& solid) {
        return Posed<ConvexSolid>(static_cast<const ConvexSolid&>(*solid.what), solid.pose);
    };
    const auto deep = depth(convex(a_), convex(moved), memory_);
    return !deep || key_of(deep->depth) == 0;
}

void PartingSearch::try_length(const Vec3& direction, double length) {
    const double size = length + b_.pose.t.cwiseAbs().maxCoeff();
    for (const double margin : margins) {
        if (confirm(b_.pose.t + direction * (length + margin * size))) return;
    }
}

// Slides the second solid along a path from outside up to the first contact, and returns this contact. The time of a
// contact has a resolution of 2^-53 of the path, which is as long as the solids are large. If the path is the best so
// far, and the part after the contact is short, casts again along that part alone, lengthened by the roundings of the
// longer cast. The shorter casts are repeated until the part is no longer short, or is below a rounding error of the
// smaller solid's size. If the other solid is 2^k times as large, there are up to k / 48 + 2 more casts.
std::optional<FirstContact> PartingSearch::slide(const Direction& way) {
    double known = best_.length;
    std::optional<FirstContact> contact = slide_once(way);
    Direction rest = way;
    while (contact && rest.reach > way_min_) {
        const double part = 1 - contact->time;
        if (part > unknown_part && !(part < short_part && best_.length < known)) break;
        known = best_.length;
        rest.reach *= part + 0x1p-48;
        const std::optional<FirstContact> again = slide_once(rest);
        if (!again || !(again->time > 0)) break;  // otherwise the solids share a point along the whole part
        contact = again;
    }
    return contact;
}

std::optional<FirstContact> PartingSearch::slide_once(const Direction& way) {
    const Vec3 out = b_.pose.t + way.n * way.reach, motion = b_.pose.t - out;
    if (!out.allFinite() || !motion.allFinite()) return std::nullopt;
    const Posed<MeshShape> moved(*b_.what, {b_.pose.R, out});
    PairWitness witness;
    const std::optional<FirstContact> contact = cast_until(moved, motion, Posed<MeshShape>(a_), 1, memory_, witness);
    if (!contact) return std::nullopt;
    const double most = motion.norm();
    for (const double margin : margins) {
        const double time = std::max(0.0, contact->time - margin);
        if (most * (1 - time) * (1 - 0x1p-40) > best_.length) return contact;
        if (!confirm(out + motion * time)) continue;
        best_.middle = contact_point(*contact, best_.parted) - 0.5 * (best_.parted - b_.pose.t);
        return contact;
    }
    confirm(out);
    return contact;
}

// Returns corner i of the triangle of a contact feature, relative to its body's translation: of the second solid if
// `second`, otherwise of the first. The second solid is the moving one, so its feature is contact.a.
Vec3 PartingSearch::corner(bool second, const FirstContact& contact, std::uint32_t i) const {
    const Posed<Solid>& solid = second ? b_ : a_;
    const Feature& f = second ? contact.a : contact.b;
    const Mesh& mesh = solid.what->mesh();
    return solid.pose.R * mesh.vertices()[mesh.triangles()[f.triangle][(f.corner + i) % 3]];
}

// Returns the point where the solids touch while the second solid is at the translation `parted`.
Vec3 PartingSearch::contact_point(const FirstContact& contact, const Vec3& parted) const {
    if (contact.b.kind == Feature::Kind::vertex) return corner(false, contact, 0) + a_.pose.t;
    const Vec3 p = corner(true, contact, 0) + parted;
    if (contact.kind != ClosestKind::edge_edge) return p;
    // The result is the point of the second solid's edge that is nearest to the line of the first solid's edge.
    const Vec3 u = corner(true, contact, 1) - corner(true, contact, 0);
    const Vec3 v = corner(false, contact, 1) - corner(false, contact, 0), n = u.cross(v);
    const Vec3 w = corner(false, contact, 0) + a_.pose.t - p;
    return p + u * (w.cross(v).dot(n) / n.dot(n));
}

// Returns the normal of the features that touch, on the side to which the second solid leaves; nullopt if the features
// determine none.
std::optional<Vec3> PartingSearch::contact_normal(const FirstContact& contact, const Vec3& along) const {
    const auto edge = [&](bool second, std::uint32_t i) -> Vec3 {
        return corner(second, contact, i) - corner(second, contact, 0);
    };
    Vec3 n;
    if (contact.kind == ClosestKind::edge_edge) {
        n = edge(true, 1).cross(edge(false, 1));
    } else if (contact.kind == ClosestKind::vertex_face) {
        const bool second = contact.a.kind == Feature::Kind::face;
        n = edge(second, 1).cross(edge(second, 2));
    } else {
        return std::nullopt;
    }
    if (n.dot(along) < 0) n = -n;
    return n;
}

void PartingSearch::search() {
    add_direction(centers_[1] - centers_[0]);
    for (int axis = 0; axis < 3; ++axis) {
        for (const Vec3& n : {Vec3(Vec3::Unit(axis)), Vec3(a_.pose.R.col(axis)), Vec3(b_.pose.R.col(axis))}) {
            add_direction(n);
            add_direction(-n);
        }
    }
    std::ranges::sort(directions_, {}, &Direction::reach);
    const std::size_t count = std::min(direction_count_max, directions_.size());
    for (std::size_t i = 0; i < count; ++i) {
        Direction way = directions_[i];
        for (int normals = 0; normals <= normal_count_max; ++normals) {
            const double before = best_.length;
            const std::optional<FirstContact> contact = slide(way);
            if (!contact || (normals > 0 && !(best_.length < before))) break;
            const std::optional<Vec3> normal = contact_normal(*contact, way.n);
            if (!normal) break;
            const std::size_t known = directions_.size();
            add_direction(*normal);
            if (directions_.size() == known) break;
            way = directions_.back();
        }
    }
    // Tries the other directions until a parting along one of them is confirmed.
    for (std::size_t i = count; i < directions_.size() && !has_found(); ++i) {
        slide(Direction(directions_[i]));
    }
}

}  // namespace ecods::depths
