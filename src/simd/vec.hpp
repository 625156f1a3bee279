// Vec<T, N> is a SIMD vector of N numbers of type T, with operations on all lanes at once.
//
// Vec<T, N> has the operators of T, lane by lane. A comparison gives a vector of integers of the same width: all ones
// in lanes in which the comparison holds, otherwise zero. The compiler splits a vector that is wider than a register of
// the instruction set into several registers. g++ 12 splits it into single numbers if it is too wide for the
// baseline, so eight doubles are written as two vectors of four.
//
// The functions (simd/vec_text.hpp) are compiled once for each instruction set. Code in the region of a set finds the
// functions of that set's namespace, and all other code finds the baseline's. Since they are always inlined, code that
// dispatch() compiles for another set may use the baseline's functions. No other file spells vector_size.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>
#include <utility>

#include "simd/inline.hpp"
#include "simd/region.hpp"

namespace ecods {

template <class T, int N>
struct VecTypes {
    typedef T Value __attribute__((vector_size(sizeof(T) * N)));
    // Both types refer to a vector in an array of T: the array is aligned as a vector for InMemory, only as T for
    // Anywhere.
    typedef T InMemory __attribute__((vector_size(sizeof(T) * N), may_alias));
    typedef T Anywhere __attribute__((vector_size(sizeof(T) * N), may_alias, aligned(alignof(T))));
};

template <class T, int N>
using Vec = typename VecTypes<T, N>::Value;

template <class V>
using LaneType = std::remove_cvref_t<decltype(std::declval<V&>()[0])>;

// The concept holds if V is a vector type: it can be subscripted and is neither a class nor a pointer nor an array.
template <class V>
concept IsVec = !std::is_class_v<V> && !std::is_pointer_v<V> && !std::is_array_v<V> && requires(V v) {
    v[0];
};

template <IsVec V>
inline constexpr int lane_count = static_cast<int>(sizeof(V) / sizeof(LaneType<V>));

// MaskOf<V> is the vector of integers that a comparison of two V gives.
template <IsVec V>
using MaskOf = decltype(std::declval<V>() < std::declval<V>());

}  // namespace ecods

// float_width is the number of floats in a register of the instruction set.
namespace ecods::baseline {
inline constexpr std::size_t float_width = 4;
}
#if ECODS_CAN_DISPATCH
namespace ecods::avx2 {
inline constexpr std::size_t float_width = 8;
}
#endif

#define ECODS_TEXT "simd/vec_text.hpp"
#include "simd/each_set.hpp"
