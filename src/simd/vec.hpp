// Vec is the vector vocabulary: some numbers of one type side by side, and operations on all of them at once.
//
// Vec<T, N> has the operators of numbers, lane by lane; comparisons give integers of the same width, all ones where
// they hold. A compiler keeps one vector in as many registers as its lanes need. It splits a vector of more lanes than
// a register of the instruction set has; g++ 12 splits it into single numbers if a register of the baseline has less
// than a quarter of it, so eight doubles are written as two vectors of four.
//
// The functions (simd/vec_text.hpp) exist once for each instruction set: code in the region of a set finds the
// functions of its namespace, and all other code finds the baseline's. They are always inlined, so code that dispatch()
// compiles for a set outside of a region may use the baseline's. No other file spells vector_size.
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
    // Vectors in memory lie in an array of T: InMemory is aligned as a vector, Anywhere only as a number.
    typedef T InMemory __attribute__((vector_size(sizeof(T) * N), may_alias));
    typedef T Anywhere __attribute__((vector_size(sizeof(T) * N), may_alias, aligned(alignof(T))));
};

template <class T, int N>
using Vec = typename VecTypes<T, N>::Value;

template <class V>
using LaneType = std::remove_cvref_t<decltype(std::declval<V&>()[0])>;

// True for types that can be subscripted and are neither a class nor a pointer nor an array.
template <class V>
concept IsVec = !std::is_class_v<V> && !std::is_pointer_v<V> && !std::is_array_v<V> && requires(V v) {
    v[0];
};

template <IsVec V>
inline constexpr int lane_count = static_cast<int>(sizeof(V) / sizeof(LaneType<V>));

// The integers that a comparison of two V gives.
template <IsVec V>
using MaskOf = decltype(std::declval<V>() < std::declval<V>());

}  // namespace ecods

// float_width is the number of floats in a register of each set.
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
