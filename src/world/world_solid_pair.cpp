// Answers the questions about two solids.
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/double_key.hpp"
#include "ecods/contact.hpp"
#include "ecods/solid.hpp"
#include "query/patch/convex_body.hpp"
#include "world/signed_distance_of.hpp"
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

// Calls ask(), a question about the pair. If ask() throws SingularPose, throws another SingularPose that names the
// body, and whose argument is in the caller's order.
template <class Function>
auto naming_the_body(const Bodies& bodies, const SubjectPair& pair, const Function& ask) {
    try {
        return ask();
    } catch (const SingularPose& error) {
        const Subject& subject = error.argument == 0 ? pair.a : pair.b;
        throw SingularPose(pair.is_turned ? 1 - error.argument : error.argument,
                           subject.proxy ? bodies.id_of(*subject.proxy) : BodyId());
    }
}

// Calls ask(a, b) with the two subjects as solids of class S.
template <class S, class Function>
auto ask_of(const Bodies& bodies, const SubjectPair& pair, const char* form, const Function& ask) {
    const Posed<S> a = as<S>(pair.a, form), b = as<S>(pair.b, form);
    return naming_the_body(bodies, pair, [&] { return ask(a, b); });
}

constexpr const char* convex_form = "convex solid";

// Exchanges the features of a Depth, and turns its direction around.
void turn(Depth& depth) noexcept {
    std::swap(depth.a, depth.b);
    for (double& x : depth.direction) x = opposite(x);
}

}  // namespace

std::optional<Depth> World::depth(const Asked& a, const Asked& b, const Ask& ask) const {
    const Impl& w = impl();
    const SubjectPair pair = w.pair_of(a, b, Impl::PairOrder::lesser_id_first);
    std::optional<Depth> depth;
    if (const auto rounded = as_rounded_pair(pair.a.posed, pair.b.posed)) {
        depth = naming_the_body(w.bodies, pair, [&] { return rounded->depth(ask); });
    } else {
        depth = ask_of<ConvexSolid>(w.bodies, pair, convex_form, [&](const auto& first, const auto& second) {
            return ecods::depth(first, second, ask);
        });
    }
    if (depth && pair.is_turned) turn(*depth);
    return depth;
}

SignedDistance World::signed_distance(const Asked& a, const Asked& b, const Ask& ask) const {
    const Impl& w = impl();
    const SubjectPair pair = w.pair_of(a, b, Impl::PairOrder::lesser_id_first);
    auto found = naming_the_body(w.bodies, pair, [&] { return signed_distance_of(pair.a.posed, pair.b.posed, ask); });
    if (!found) {
        if (const auto rounded = as_rounded_pair(pair.a.posed, pair.b.posed)) {
            found = naming_the_body(w.bodies, pair, [&] { return rounded->signed_distance(ask); });
        }
    }
    if (!found) {
        found = ask_of<ConvexSolid>(w.bodies, pair, convex_form, [&](const auto& first, const auto& second) {
            return ecods::signed_distance(first, second, ask);
        });
    }
    if (pair.is_turned) turn(*found);
    return *found;
}

std::optional<DepthBounds> World::depth_bounds(const Asked& a, const Asked& b, const Ask& ask) const {
    const Impl& w = impl();
    return ask_of<Solid>(w.bodies, w.pair_of(a, b), "solid", [&](const auto& first, const auto& second) {
        return ecods::depth_bounds(first, second, ask);
    });
}

ContactPatch World::contact_patch(const Asked& a, const Asked& b, const PatchLimits& limits, const Ask& ask) const {
    const Impl& w = impl();
    const SubjectPair pair = w.pair_of(a, b);
    return naming_the_body(w.bodies, pair,
                           [&] { return ecods::contact_patch(pair.a.posed, pair.b.posed, limits, ask); });
}

std::vector<BodyPatch> World::contact_patches(const PatchLimits& limits, const Ask& ask) const {
    std::vector<BodyPatch> result;
    for (const BodyPair& bodies : colliding_pairs()) {
        if (!is_alive(bodies.a) || !is_alive(bodies.b)) continue;  // destroyed since the last update
        const SubjectPair pair = impl().pair_of(bodies.a, bodies.b);
        if (!patches::have_patch(*pair.a.posed.what, *pair.b.posed.what)) continue;
        result.push_back({bodies, contact_patch(bodies.a, bodies.b, limits, ask)});
    }
    return result;
}

}  // namespace ecods
