// Which test decides for which two kinds of shape.
#pragma once

#include <map>
#include <memory>
#include <utility>

#include "ecods/shape.hpp"

namespace ecods {

// A test with its arguments put in the order that it was registered for.
struct OrderedTest {
    const TwoBodyTest* test;
    bool swapped;  // whether the shape of the second kind asked for comes first

    // Asks a question of TwoBodyTest about the two in that order, with what comes after them.
    template <class Question, class... Arguments>
    auto ask(const Posed<Shape>& a, const Posed<Shape>& b, Question question, Arguments&&... arguments) const {
        return swapped ? (test->*question)(b, a, arguments...) : (test->*question)(a, b, arguments...);
    }
};

class TwoBodyTests {
  public:
    void set(ShapeKind a, ShapeKind b, std::shared_ptr<const TwoBodyTest> test);
    bool has(ShapeKind a, ShapeKind b) const;

    // has(a, b) must hold.
    OrderedTest find(ShapeKind a, ShapeKind b) const {
        if (a == ShapeKind::mesh() && b == ShapeKind::mesh()) return {mesh_mesh_, false};
        return find_in_map(a, b);
    }

  private:
    struct Entry {
        std::shared_ptr<const TwoBodyTest> test;
        ShapeKind first;
    };
    using Key = std::pair<ShapeKind, ShapeKind>;  // ascending
    static Key key(ShapeKind a, ShapeKind b) { return a < b ? Key{a, b} : Key{b, a}; }
    OrderedTest find_in_map(ShapeKind a, ShapeKind b) const;

    std::map<Key, Entry> entries_;
    const TwoBodyTest* mesh_mesh_ = nullptr;  // the most frequent, at hand
};

}  // namespace ecods
