// Defines the subjects of questions to a world, with their bodies already looked up.
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

// A SubjectPair holds the two subjects of a question, in the order in which the question gets them, and the test of
// their kinds.
struct SubjectPair {
    Subject a, b;
    OrderedTest test;
    bool is_turned = false;  // true if the caller gave the subjects in the other order

    // Calls the member function `question` of the test. If the test takes the two kinds in the other order, the
    // subjects are exchanged for it.
    template <class Question, class... Arguments>
    auto ask(Question question, const Arguments&... arguments) const {
        return test.ask(a.posed, b.posed, question, arguments...);
    }
};

}  // namespace ecods
