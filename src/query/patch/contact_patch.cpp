#include <optional>
#include <string>
#include <type_traits>
#include <typeinfo>
#include <utility>

#include "base/double_key.hpp"
#include "base/limits.hpp"
#include "ecods/contact.hpp"
#include "ecods/error.hpp"
#include "ecods/rounded.hpp"
#include "ecods/solid.hpp"
#include "exact/simplex/common_pose.hpp"
#include "query/body/rounded_segments.hpp"
#include "query/convex/convex_core.hpp"
#include "query/intersection/asking.hpp"
#include "query/intersection/query_memory.hpp"
#include "query/patch/half_space_patch.hpp"
#include "query/patch/hulls_patch.hpp"

namespace ecods {
namespace {

void require_valid(const PatchLimits& limits) {
    const double cosine = limits.min_cos_squared, gap = limits.max_gap;
    if (key_of(cosine) <= 0 || key_of(cosine) > key_of(1.0)) {
        throw InvalidArgument("min_cos_squared must be above 0 and at most 1", Argument::size, "min_cos_squared",
                              cosine);
    }
    if (key_of(gap) > infinity_key || key_of(gap) <= -infinity_key) {
        throw InvalidArgument("max_gap must not be NaN or -infinity", Argument::distance, "max_gap", gap);
    }
}

// Returns the shape as an S, or null if the shape is not an S. S must be a final class: comparing typeid is then
// enough, and faster than dynamic_cast.
template <class S>
const S* as(const Shape& shape) noexcept {
    static_assert(std::is_final_v<S>);
    return typeid(shape) == typeid(S) ? static_cast<const S*>(&shape) : nullptr;
}
const HalfSpace* as_half_space(const Shape& shape) noexcept {
    return shape.kind() == ShapeKind::half_space() ? as<HalfSpace>(shape) : nullptr;
}
const Rounded* as_rounded(const Shape& shape) noexcept {
    const ShapeKind kind = shape.kind();
    return kind == ShapeKind::rounded() || kind == ShapeKind::rounded_convex() ? as<Rounded>(shape) : nullptr;
}

// Returns the shape if it is a ConvexSolid, or its core if it is a Rounded with a convex core; otherwise null.
const MeshShape* find_core(const Shape& shape) noexcept {
    if (const Rounded* const rounded = as_rounded(shape))
        return convex::is_convex_core(rounded->core()) ? &rounded->core() : nullptr;
    return as<ConvexSolid>(shape);
}

Posed<ConvexSolid> core_of(const Posed<Shape>& posed, int argument) {
    const Shape& shape = *posed.what;
    if (const MeshShape* const core = find_core(shape)) {
        return convex::convex_core(Posed<MeshShape>(*core, posed.pose));
    }
    throw NotSupported(std::string("a contact patch is of convex bodies and half spaces: the ") +
                       (argument == 0 ? "first" : "second") + " body is neither");
}

double radius_of(const Shape& shape) noexcept {
    const Rounded* const rounded = as_rounded(shape);
    return rounded != nullptr ? rounded->radius() : 0;
}

// Returns the patch of two spheres or capsules if it has one corner and fixed precision decides it; otherwise nullopt.
// Parallel segments, and limits that allow a tilt (min_cos_squared < 1), are left to patch_of_hulls().
std::optional<ContactPatch> find_fixed(const Posed<Shape>& a, const Posed<Shape>& b, const PatchLimits& limits) {
    const Rounded* const x = as_rounded(*a.what);
    const Rounded* const y = as_rounded(*b.what);
    if (x == nullptr || y == nullptr || key_of(limits.min_cos_squared) != key_of(1.0)) return std::nullopt;
    const auto segments = RoundedSegments::find(Posed<Rounded>(*x, a.pose), Posed<Rounded>(*y, b.pose));
    if (!segments || !segments->is_only()) return std::nullopt;
    const auto at = segments->signed_closest();
    const auto direction = segments->direction(), middle = segments->middle();
    if (!at || !direction || !middle || key_of(at->distance) >= key_of(limits.max_gap)) return std::nullopt;
    if (!exact::is_regular(a.pose.R) || !exact::is_regular(b.pose.R)) return std::nullopt;
    ContactPatch patch{at->distance, *direction, {}, 1};
    patch.corners.push_back({at->point_a, at->point_b, *middle, at->distance, at->a, at->b});
    return patch;
}

}  // namespace

patches::ConvexBody::ConvexBody(const Posed<Shape>& posed, int argument)
    : core(core_of(posed, argument)), radius(radius_of(*posed.what)) {}

bool patches::have_patch(const Shape& a, const Shape& b) noexcept {
    const auto is_plane = [](const Shape& shape) { return as_half_space(shape) != nullptr; };
    const auto is_convex = [](const Shape& shape) { return find_core(shape) != nullptr; };
    return is_plane(a) ? is_convex(b) : is_convex(a) && (is_plane(b) || is_convex(b));
}

ContactPatch contact_patch(const Posed<Shape>& a, const Posed<Shape>& b, const PatchLimits& limits, const Ask& ask) {
    require_valid(limits);
    const HalfSpace *const plane_a = as_half_space(*a.what), *const plane_b = as_half_space(*b.what);
    if (plane_a != nullptr && plane_b != nullptr) throw NotSupported("two half spaces have no contact patch");
    Asking asking(ask);
    QueryMemory& memory = asking.memory();
    ++QueryMemoryAccess::state(memory).counts.queries;
    if (plane_b != nullptr) {
        return patches::patch_on_plane(patches::ConvexBody(a, 0), {*plane_b, b.pose}, 1, limits);
    }
    if (plane_a != nullptr) return patches::patch_on_plane(patches::ConvexBody(b, 1), {*plane_a, a.pose}, 0, limits);
    if (auto patch = find_fixed(a, b, limits)) {
        asking.witness() = {0, 0};
        return *std::move(patch);
    }
    const patches::ConvexBody x(a, 0), y(b, 1);
    convex::PosedHulls hulls(x.core, y.core, memory);
    return patches::patch_of_hulls(hulls, {x.radius, y.radius}, limits, memory, asking.witness());
}

}  // namespace ecods
