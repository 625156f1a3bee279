#include "world/rounded_test.hpp"

#include "ecods/error.hpp"
#include "ecods/rounded.hpp"
#include "query/body/rounded_pair.hpp"
#include "world/bodies.hpp"

namespace ecods {
namespace {

// Answers questions about two shapes, each rounded or a mesh, in the order in which they are given, so that ties are
// broken by ids and not by kinds. With a core that is not convex, the test does not answer `relation`, since the
// relation may then be undecided (rounded.hpp).
class RoundedTest final : public TwoBodyTest {
  public:
    explicit RoundedTest(bool relates) : relates_(relates) {}

    bool answers(Question question) const noexcept override {
        switch (question) {
            case Question::distance:
            case Question::within:
            case Question::closest:
            case Question::cast:
            case Question::cast_moving:
                return true;
            case Question::relation:
                return relates_;
            default:
                return false;
        }
    }

    bool intersects(const Posed<Shape>& a, const Posed<Shape>& b, const Ask& ask) const override {
        return pair_of(a, b).intersects(ask);
    }
    Relation relation(const Posed<Shape>& a, const Posed<Shape>& b, const Ask& ask) const override {
        return pair_of(a, b).relation(ask);
    }
    double distance(const Posed<Shape>& a, const Posed<Shape>& b, const Ask& ask) const override {
        return pair_of(a, b).distance(ask);
    }
    bool within(const Posed<Shape>& a, const Posed<Shape>& b, double max_distance, const Ask& ask) const override {
        return pair_of(a, b).within(max_distance, ask);
    }
    ClosestPoints closest(const Posed<Shape>& a, const Posed<Shape>& b, const Ask& ask) const override {
        return pair_of(a, b).closest(ask);
    }
    std::optional<FirstContact> cast(const Posed<Shape>& a, const Vec3& motion, const Posed<Shape>& b, double max_time,
                                     const Ask& ask) const override {
        return pair_of(a, b).cast(motion, 0, max_time, ask);
    }
    std::optional<FirstContact> cast_moving(const Moving<Shape>& a, const Moving<Shape>& b, double max_time,
                                            const Ask& ask) const override {
        return pair_of({*a.what, a.from}, {*b.what, b.from}).cast_straight(a.to, b.to, max_time, ask);
    }

  private:
    static RoundedPair pair_of(const Posed<Shape>& a, const Posed<Shape>& b) {
        return {*core_and_radius(a), *core_and_radius(b)};
    }

    bool relates_;
};

}  // namespace

std::optional<CoreAndRadius> core_and_radius(const Posed<Shape>& posed) {
    const ShapeKind kind = posed.what->kind();
    if (kind == ShapeKind::mesh()) return Posed<MeshShape>(static_cast<const MeshShape&>(*posed.what), posed.pose);
    if (!is_rounded(kind)) return std::nullopt;
    return Posed<Rounded>(static_cast<const Rounded&>(*posed.what), posed.pose);
}

CoreAndRadius require_core(const Posed<Shape>& posed) {
    const auto core = core_and_radius(posed);
    if (!core) throw NotSupported(Question::cast, posed.what->kind(), ShapeKind::mesh());
    return *core;
}

void add_rounded_tests(TwoBodyTests& tests) {
    constexpr ShapeKind mesh = ShapeKind::mesh(), any = ShapeKind::rounded(), convex = ShapeKind::rounded_convex();
    const auto partial = std::make_shared<const RoundedTest>(false), full = std::make_shared<const RoundedTest>(true);
    constexpr auto either_order = TwoBodyTests::Takes::either_order;
    tests.set_with_signs(mesh, any, partial, either_order);
    tests.set_with_signs(any, any, partial, either_order);
    tests.set_with_signs(convex, any, partial, either_order);
    tests.set_with_signs(mesh, convex, full, either_order);
    tests.set_with_signs(convex, convex, full, either_order);
}

}  // namespace ecods
