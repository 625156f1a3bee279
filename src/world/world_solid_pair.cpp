// Answers the questions about two solids.
#include <optional>
#include <string>
#include <utility>

#include "base/double_key.hpp"
#include "ecods/solid.hpp"
#include "world/world_impl.hpp"

namespace ecods {
namespace {

// Returns the subject as a solid of class S. Throws NotSupported if its shape is not of this class.
template <class S>
Posed<S> as(const Subject& subject, const char* form) {
    const S* const solid = dynamic_cast<const S*>(subject.posed.what);
    if (solid == nullptr) {
        const std::string name =
            subject.proxy ? "slot " + std::to_string(*subject.proxy + 1) + ": its body" : "the shape";
        throw NotSupported(name + " is no " + form);
    }
    return {*solid, subject.posed.pose};
}

// Calls ask(a, b) with the two subjects as solids of class S. A SingularPose that it throws is changed: it then names
// the body, and counts the arguments in the caller's order.
template <class S, class Function>
auto ask_of(const Bodies& bodies, const SubjectPair& pair, const char* form, const Function& ask) {
    const Posed<S> a = as<S>(pair.a, form), b = as<S>(pair.b, form);
    try {
        return ask(a, b);
    } catch (const SingularPose& error) {
        const Subject& subject = error.argument == 0 ? pair.a : pair.b;
        throw SingularPose(pair.is_turned ? 1 - error.argument : error.argument,
                           subject.proxy ? bodies.id_of(*subject.proxy) : BodyId());
    }
}

constexpr const char* convex_form = "convex solid";

// Returns the negative of the vector, but with every zero as +0. Tests for zero by bits, because == may take a
// subnormal number for zero.
Vec3 opposite(const Vec3& direction) {
    Vec3 result;
    for (int axis = 0; axis < 3; ++axis) result[axis] = key_of(direction[axis]) == 0 ? 0.0 : -direction[axis];
    return result;
}

}  // namespace

std::optional<Depth> World::depth(const Asked& a, const Asked& b, const Ask& ask) const {
    const Impl& w = impl();
    const SubjectPair pair = w.pair_of(a, b, Impl::PairOrder::lesser_id_first);
    auto depth = ask_of<ConvexSolid>(w.bodies, pair, convex_form, [&](const auto& first, const auto& second) {
        return ecods::depth(first, second, ask);
    });
    if (depth && pair.is_turned) {
        std::swap(depth->a, depth->b);
        depth->direction = opposite(depth->direction);
    }
    return depth;
}

std::optional<DepthBounds> World::depth_bounds(const Asked& a, const Asked& b, const Ask& ask) const {
    const Impl& w = impl();
    return ask_of<Solid>(w.bodies, w.pair_of(a, b), "solid", [&](const auto& first, const auto& second) {
        return ecods::depth_bounds(first, second, ask);
    });
}

}  // namespace ecods
