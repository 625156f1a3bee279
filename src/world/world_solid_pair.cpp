// Answers the questions about two solids.
#include <optional>
#include <string>
#include <utility>

#include "base/double_key.hpp"
#include "ecods/half_space.hpp"
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

// Calls ask(), a question about the pair. A SingularPose that it throws is changed: it then names the body, and counts
// the arguments in the caller's order.
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

// Exchanges the features of a Depth or a SignedDistance, and turns its direction around.
template <class Answer>
void exchange(Answer& answer) {
    std::swap(answer.a, answer.b);
    for (double& x : answer.direction) x = opposite(x);
}

}  // namespace

std::optional<Depth> World::depth(const Asked& a, const Asked& b, const Ask& ask) const {
    const Impl& w = impl();
    const SubjectPair pair = w.pair_of(a, b, Impl::PairOrder::lesser_id_first);
    auto depth = ask_of<ConvexSolid>(w.bodies, pair, convex_form, [&](const auto& first, const auto& second) {
        return ecods::depth(first, second, ask);
    });
    if (depth && pair.is_turned) exchange(*depth);
    return depth;
}

namespace {

void turn(SignedDistance& found) {
    exchange(found);
    std::swap(found.point_a, found.point_b);
}

// Returns the signed distance of a body and a half space, in the order of the pair; nullopt if not exactly one of the
// two is a half space.
std::optional<SignedDistance> ask_half_space(const SubjectPair& pair, const Ask& ask) {
    const auto* const first = dynamic_cast<const HalfSpace*>(pair.a.posed.what);
    const auto* const second = dynamic_cast<const HalfSpace*>(pair.b.posed.what);
    if ((first == nullptr) == (second == nullptr)) return std::nullopt;
    const Posed<Shape>&body = first == nullptr ? pair.a.posed : pair.b.posed,
          &other = first == nullptr ? pair.b.posed : pair.a.posed;
    const Posed<HalfSpace> half_space(first == nullptr ? *second : *first, other.pose);
    std::optional<SignedDistance> found;
    try {
        if (const auto* const mesh = dynamic_cast<const MeshShape*>(body.what)) {
            found = ecods::signed_distance(Posed<MeshShape>(*mesh, body.pose), half_space, ask);
        } else if (const auto* const rounded = dynamic_cast<const Rounded*>(body.what)) {
            found = ecods::signed_distance(Posed<Rounded>(*rounded, body.pose), half_space, ask);
        }
    } catch (const SingularPose&) {
        throw SingularPose(first == nullptr ? 1 : 0);  // the half space is the pair's first or second
    }
    if (found && first != nullptr) turn(*found);
    return found;
}

}  // namespace

SignedDistance World::signed_distance(const Asked& a, const Asked& b, const Ask& ask) const {
    const Impl& w = impl();
    const SubjectPair pair = w.pair_of(a, b, Impl::PairOrder::lesser_id_first);
    auto found = naming_the_body(w.bodies, pair, [&] { return ask_half_space(pair, ask); });
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

}  // namespace ecods
