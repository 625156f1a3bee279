// TwoBodyTests stores the two-body tests, by the two kinds of shapes that each test takes.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include "ecods/shape.hpp"

namespace ecods {

// An OrderedTest is the test of two kinds of shapes, and the order in which it takes the two shapes.
struct OrderedTest {
    const TwoBodyTest* test;
    bool swapped;    // true if the test takes the shape of the second kind first
    bool has_signs;  // true if signed distances of bodies of these kinds agree with the test

    // Calls the member function `question` of the test with a and b, in the order in which the test takes them, and
    // with `arguments`.
    template <class Question, class... Arguments>
    auto ask(const Posed<Shape>& a, const Posed<Shape>& b, Question question, Arguments&&... arguments) const {
        return swapped ? (test->*question)(b, a, arguments...) : (test->*question)(a, b, arguments...);
    }
};

// Returns the closest points with the two bodies exchanged.
inline ClosestPoints turned(ClosestPoints points) noexcept {
    std::swap(points.a, points.b);
    std::swap(points.point_a, points.point_b);
    return points;
}

// Returns the contact of two bodies in the order of the caller: exchanges a and b if the test took the bodies in the
// other order.
inline std::optional<FirstContact> in_order(const OrderedTest& test, std::optional<FirstContact> contact) noexcept {
    if (contact && test.swapped) std::swap(contact->a, contact->b);
    return contact;
}

class TwoBodyTests {
  public:
    // Says whether a test takes the shapes in the order of its kinds, or in either order.
    enum class Takes : std::uint8_t { first_kind_first, either_order };
    void set(ShapeKind a, ShapeKind b, std::shared_ptr<const TwoBodyTest> test, Takes takes = Takes::first_kind_first);

    // Stores `test`, a test of the library's own, for two kinds of shapes. Where signed_distance_of() returns a
    // distance, the test must agree with that distance.
    void set_with_signs(ShapeKind a, ShapeKind b, std::shared_ptr<const TwoBodyTest> test,
                        Takes takes = Takes::first_kind_first);
    bool has(ShapeKind a, ShapeKind b) const;

    // Returns the test of the two kinds. Call only if has(a, b).
    OrderedTest find(ShapeKind a, ShapeKind b) const {
        if (a == ShapeKind::mesh() && b == ShapeKind::mesh()) return {mesh_mesh_, false, mesh_mesh_has_signs_};
        return find_in_map(a, b);
    }

  private:
    struct Entry {
        std::shared_ptr<const TwoBodyTest> test;
        ShapeKind first;
        Takes takes;
        bool has_signs = false;
    };
    using Key = std::pair<ShapeKind, ShapeKind>;  // the lesser kind first
    static Key key(ShapeKind a, ShapeKind b) { return a < b ? Key{a, b} : Key{b, a}; }
    OrderedTest find_in_map(ShapeKind a, ShapeKind b) const;
    void put(Entry entry, ShapeKind second);

    std::map<Key, Entry> entries_;
    const TwoBodyTest* mesh_mesh_ = nullptr;  // the most frequent test, found without a search
    bool mesh_mesh_has_signs_ = false;
};

}  // namespace ecods
