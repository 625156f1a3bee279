// Holds the subjects of a world's questions, after they were looked up.
#pragma once

#include <optional>
#include <utility>

#include "ecods/world_options.hpp"
#include "world/two_body_tests.hpp"

namespace ecods {

// A subject is a body of the world, or a shape at a pose.
struct Subject {
    Posed<Shape> posed;
    std::optional<ProxyIndex> proxy = {};  // nothing for a shape at a pose
    std::optional<CollisionFilter> filter = {};

    ShapeKind kind() const noexcept { return posed.what->kind(); }
};

// Holds two subjects in the order in which they are asked about, and the test of their kinds.
struct SubjectPair {
    Subject a, b;
    OrderedTest test;
    bool is_turned = false;  // true if the caller named them in the other order

    // Asks a question of TwoBodyTest. If the test has the two kinds in the other order, the subjects are exchanged.
    template <class Question, class... Arguments>
    auto ask(Question question, const Arguments&... arguments) const {
        return test.ask(a.posed, b.posed, question, arguments...);
    }
};

}  // namespace ecods
