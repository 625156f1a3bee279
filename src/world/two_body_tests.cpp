#include "world/two_body_tests.hpp"

namespace ecods {

void TwoBodyTests::set(ShapeKind a, ShapeKind b, std::shared_ptr<const TwoBodyTest> test) {
    entries_.insert_or_assign(key(a, b), Entry{std::move(test), a});
}

bool TwoBodyTests::has(ShapeKind a, ShapeKind b) const {
    return entries_.contains(key(a, b));
}

OrderedTest TwoBodyTests::find(ShapeKind a, ShapeKind b) const {
    const Entry& entry = entries_.at(key(a, b));
    return {entry.test.get(), entry.first != a};
}

}  // namespace ecods
