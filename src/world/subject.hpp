// Defines what a question to a world is asked about: subjects, with their bodies already looked up.
#pragma once

#include <optional>
#include <utility>

#include "ecods/world_options.hpp"
#include "world/two_body_tests.hpp"

namespace ecods {

// A subject is a body of the world, or a shape at a pose.
struct Subject {
    Posed<Shape> posed;
    std::optional<ProxyIndex> proxy = {};  // empty for a shape at a pose
    std::optional<CollisionFilter> filter = {};

    ShapeKind kind() const noexcept { return posed.what->kind(); }
};

// Holds the two subjects of a question, in the order in which they are passed to it, and the test of their kinds.
struct SubjectPair {
    Subject a, b;
    OrderedTest test;
    bool is_turned = false;  // true if the caller gave them in the other order

    // Calls the member function `question` of the test. If the test takes the two kinds in the other order, it gets the
    // subjects exchanged.
    template <class Question, class... Arguments>
    auto ask(Question question, const Arguments&... arguments) const {
        return test.ask(a.posed, b.posed, question, arguments...);
    }
};

}  // namespace ecods
