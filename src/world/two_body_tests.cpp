#include "world/two_body_tests.hpp"

namespace ecods {

void TwoBodyTests::set(ShapeKind a, ShapeKind b, std::shared_ptr<const TwoBodyTest> test, Takes takes) {
    const TwoBodyTest* const known = test.get();
    entries_.insert_or_assign(key(a, b), Entry{std::move(test), a, takes});
    if (a == ShapeKind::mesh() && b == ShapeKind::mesh()) mesh_mesh_ = known;
}

bool TwoBodyTests::has(ShapeKind a, ShapeKind b) const {
    return entries_.contains(key(a, b));
}

OrderedTest TwoBodyTests::find_in_map(ShapeKind a, ShapeKind b) const {
    const Entry& entry = entries_.at(key(a, b));
    return {entry.test.get(), entry.takes == Takes::first_kind_first && entry.first != a};
}

}  // namespace ecods
