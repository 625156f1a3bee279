#include "world/two_body_tests.hpp"

namespace ecods {

void TwoBodyTests::set(ShapeKind a, ShapeKind b, std::shared_ptr<const TwoBodyTest> test, Takes takes) {
    put({std::move(test), a, takes}, b);
}

void TwoBodyTests::set_with_signs(ShapeKind a, ShapeKind b, std::shared_ptr<const TwoBodyTest> test, Takes takes) {
    put({std::move(test), a, takes, true}, b);
}

void TwoBodyTests::put(Entry entry, ShapeKind second) {
    const ShapeKind first = entry.first;
    const TwoBodyTest* const test = entry.test.get();
    const bool has_signs = entry.has_signs;
    entries_.insert_or_assign(key(first, second), std::move(entry));
    if (first != ShapeKind::mesh() || second != ShapeKind::mesh()) return;
    mesh_mesh_ = test;
    mesh_mesh_has_signs_ = has_signs;
}

bool TwoBodyTests::has(ShapeKind a, ShapeKind b) const {
    return entries_.contains(key(a, b));
}

OrderedTest TwoBodyTests::find_in_map(ShapeKind a, ShapeKind b) const {
    const Entry& entry = entries_.at(key(a, b));
    return {entry.test.get(), entry.takes == Takes::first_kind_first && entry.first != a, entry.has_signs};
}

}  // namespace ecods
