// The vector vocabulary: some numbers of one type side by side, and what is done with all of them at once.
//
// Vec<T, N> has the operators of numbers, lane by lane; comparisons give integers of the same width, all ones where
// they hold. A compiler keeps one vector in as many registers as its lanes need. A vector of more lanes than a register
// of the instruction set has is split; by g++ 12 into single numbers where no register of the baseline has a quarter
// of it, so eight doubles are written as two vectors of four.
//
// The functions (simd/vec_text.hpp) are there once for each instruction set: code in a region of a set finds those of
// its namespace, and all other code those of the baseline. They are always inlined, so that code which dispatch()
// compiles for a set without being in a region may use the latter. No other file spells vector_size.
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
    // As it lies in memory: in an array of T, aligned as a vector or only as a number is.
    typedef T InMemory __attribute__((vector_size(sizeof(T) * N), may_alias));
    typedef T Anywhere __attribute__((vector_size(sizeof(T) * N), may_alias, aligned(alignof(T))));
};

template <class T, int N>
using Vec = typename VecTypes<T, N>::Value;

template <class V>
using LaneType = std::remove_cvref_t<decltype(std::declval<V&>()[0])>;

// What can be subscripted and is neither a class nor a pointer nor an array.
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

// Floats in a register of each set.
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
