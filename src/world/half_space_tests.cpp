#include "world/half_space_tests.hpp"

#include "ecods/rounded.hpp"
#include "ecods/solid.hpp"

namespace ecods {
namespace {

template <class Thing>
Posed<Thing> as(const Posed<Shape>& posed) {
    return {static_cast<const Thing&>(*posed.what), posed.pose};
}
template <class Thing>
Moving<Thing> as(const Moving<Shape>& moving) {
    return {static_cast<const Thing&>(*moving.what), moving.from, moving.to};
}

// Answers the questions that meshes, rounded bodies and half spaces all have with a half space. `First` is the first
// shape.
template <class First>
class HalfSpaceTest : public TwoBodyTest {
  public:
    bool answers(Question question) const noexcept override {
        return question == Question::relation || question == Question::distance || question == Question::within ||
               question == Question::cast;
    }
    bool intersects(const Posed<Shape>& a, const Posed<Shape>& b, const Ask& ask) const override {
        return ecods::intersects(as<First>(a), as<HalfSpace>(b), ask);
    }
    Relation relation(const Posed<Shape>& a, const Posed<Shape>& b, const Ask& ask) const override {
        return ecods::relation(as<First>(a), as<HalfSpace>(b), ask);
    }
    double distance(const Posed<Shape>& a, const Posed<Shape>& b, const Ask& ask) const override {
        return ecods::distance(as<First>(a), as<HalfSpace>(b), ask);
    }
    bool within(const Posed<Shape>& a, const Posed<Shape>& b, double max_distance, const Ask& ask) const override {
        return ecods::within(as<First>(a), as<HalfSpace>(b), max_distance, ask);
    }
    std::optional<FirstContact> cast(const Posed<Shape>& a, const Vec3& motion, const Posed<Shape>& b, double max_time,
                                     const Ask& ask) const override {
        return ecods::cast(as<First>(a), motion, as<HalfSpace>(b), max_time, ask);
    }
};

// Answers `closest` besides the questions of HalfSpaceTest: meshes and rounded bodies have closest points with a half
// space.
template <class First>
class BodyHalfSpaceTest : public HalfSpaceTest<First> {
  public:
    bool answers(Question question) const noexcept override {
        return HalfSpaceTest<First>::answers(question) || question == Question::closest;
    }
    ClosestPoints closest(const Posed<Shape>& a, const Posed<Shape>& b, const Ask& ask) const override {
        return ecods::closest(as<First>(a), as<HalfSpace>(b), ask);
    }
};

// Answers casts of bodies that move between poses, besides the questions of Base.
template <class Base, class First>
class MovingHalfSpaceTest final : public Base {
  public:
    bool answers(Question question) const noexcept override {
        return Base::answers(question) || question == Question::cast_moving;
    }
    std::optional<FirstContact> cast_moving(const Moving<Shape>& a, const Moving<Shape>& b, double max_time,
                                            const Ask& ask) const override {
        return ecods::cast(as<First>(a), as<HalfSpace>(b), max_time, ask);
    }
};

using MeshHalfSpaceTest = MovingHalfSpaceTest<BodyHalfSpaceTest<MeshShape>, MeshShape>;
using RoundedHalfSpaceTest = MovingHalfSpaceTest<BodyHalfSpaceTest<Rounded>, Rounded>;
using TwoHalfSpacesTest = MovingHalfSpaceTest<HalfSpaceTest<HalfSpace>, HalfSpace>;

}  // namespace

void add_half_space_tests(TwoBodyTests& tests) {
    constexpr ShapeKind half_space = ShapeKind::half_space();
    const auto of_rounded = std::make_shared<const RoundedHalfSpaceTest>();
    tests.set_with_signs(ShapeKind::mesh(), half_space, std::make_shared<const MeshHalfSpaceTest>());
    tests.set_with_signs(ShapeKind::rounded(), half_space, of_rounded);
    tests.set_with_signs(ShapeKind::rounded_convex(), half_space, of_rounded);
    tests.set(half_space, half_space, std::make_shared<const TwoHalfSpacesTest>());
}

}  // namespace ecods
