// Three numbers of a template: integers, fractions, or intervals that enclose them.
#pragma once

#include <array>

namespace ecods::oracle {

template <class N>
using Vector = std::array<N, 3>;

template <class N>
Vector<N> operator-(const Vector<N>& a, const Vector<N>& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
template <class N>
N dot(const Vector<N>& a, const Vector<N>& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
template <class N>
Vector<N> cross(const Vector<N>& a, const Vector<N>& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

}  // namespace ecods::oracle
