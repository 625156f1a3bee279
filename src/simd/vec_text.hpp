// vec_text.hpp is the text of simd/vec.hpp: operations on all lanes of vectors at once, compiled for each instruction
// set.

// Load first[i] into lane i. `first` is aligned as V is; in load_anywhere, as a number is.
template <IsVec V>
ECODS_ALWAYS_INLINE V load(const LaneType<V>* first) noexcept {
    return *reinterpret_cast<const typename VecTypes<LaneType<V>, lane_count<V>>::InMemory*>(first);
}
template <IsVec V>
ECODS_ALWAYS_INLINE V load_anywhere(const LaneType<V>* first) noexcept {
    return *reinterpret_cast<const typename VecTypes<LaneType<V>, lane_count<V>>::Anywhere*>(first);
}

// Store lane i in first[i]. `first` is aligned as V is; in store_anywhere, as a number is.
template <IsVec V>
ECODS_ALWAYS_INLINE void store(LaneType<V>* first, V v) noexcept {
    *reinterpret_cast<typename VecTypes<LaneType<V>, lane_count<V>>::InMemory*>(first) = v;
}

template <IsVec V>
ECODS_ALWAYS_INLINE void store_anywhere(LaneType<V>* first, V v) noexcept {
    *reinterpret_cast<typename VecTypes<LaneType<V>, lane_count<V>>::Anywhere*>(first) = v;
}

// Returns x in each lane. Subtracting zero leaves every number as it is, -0 too, so the compiler drops it; adding zero
// would cost an instruction.
template <IsVec V>
ECODS_ALWAYS_INLINE V broadcast(LaneType<V> x) noexcept {
    return x - V{};
}

// bits_as reads the same bits as lanes of another type; convert converts the numbers, as the rounding mode says.
template <IsVec To, IsVec From>
ECODS_ALWAYS_INLINE To bits_as(From v) noexcept {
    static_assert(sizeof(To) == sizeof(From));
    return reinterpret_cast<To>(v);
}
template <IsVec To, IsVec From>
ECODS_ALWAYS_INLINE To convert(From v) noexcept {
    static_assert(lane_count<To> == lane_count<From>);
    return __builtin_convertvector(v, To);
}

// Returns, lane by lane, yes if the mask is all ones, and no if it is zero.
template <IsVec V>
ECODS_ALWAYS_INLINE V select(MaskOf<V> mask, V yes, V no) noexcept {
    return mask ? yes : no;
}

// Return b in lanes in which a or b is a NaN.
template <IsVec V>
ECODS_ALWAYS_INLINE V min(V a, V b) noexcept {
    return a < b ? a : b;
}
template <IsVec V>
ECODS_ALWAYS_INLINE V max(V a, V b) noexcept {
    return a > b ? a : b;
}

// Clears the sign bits.
template <IsVec V>
ECODS_ALWAYS_INLINE V absolute(V v) noexcept {
    static_assert(std::is_floating_point_v<LaneType<V>>);
    using Bits = MaskOf<V>;
    constexpr LaneType<Bits> all_but_sign = std::numeric_limits<LaneType<Bits>>::max();
    return bits_as<V>(bits_as<Bits>(v) & all_but_sign);
}

// Return the lanes with the numbers in `index`: lanes of a are 0, 1, ..., and lanes of b follow.
template <int... index, IsVec V>
ECODS_ALWAYS_INLINE V shuffle(V a, V b) noexcept {
    return __builtin_shufflevector(a, b, index...);
}
template <int... index, IsVec V>
ECODS_ALWAYS_INLINE V shuffle(V v) noexcept {
    return __builtin_shufflevector(v, v, index...);
}

// The bits that are set in either half of 256 bits; 128 bits as they are.
template <IsVec V>
ECODS_ALWAYS_INLINE Vec<std::uint64_t, 2> join_halves(V v) noexcept {
    const auto words = bits_as<Vec<std::uint64_t, static_cast<int>(sizeof(V) / 8)>>(v);
    if constexpr (sizeof(V) == 32) {
        return __builtin_shufflevector(words, words, 0, 1) | __builtin_shufflevector(words, words, 2, 3);
    } else {
        return words;
    }
}

// The bits that are set in any lane. Lanes are integers of 32 or 64 bits, two or more.
template <IsVec V>
ECODS_ALWAYS_INLINE LaneType<V> any_bits(V v) noexcept {
    static_assert(std::is_integral_v<LaneType<V>> && sizeof(LaneType<V>) >= 4);
    const auto words = join_halves(v);
    std::uint64_t bits = words[0] | words[1];
    if constexpr (sizeof(LaneType<V>) == 4) bits |= bits >> 32;
    return static_cast<LaneType<V>>(bits);
}

// any() is true if any lane of a mask is set, all() if all are. The baseline has an instruction for the signs of four
// lanes at once, and the signs suffice for a mask.
template <IsVec V>
ECODS_ALWAYS_INLINE bool any(V mask) noexcept {
#if defined(__SSE2__)
    return __builtin_ia32_movmskps(bits_as<Vec<float, 4>>(join_halves(mask))) != 0;
#else
    return any_bits(mask) != 0;
#endif
}
template <IsVec V>
ECODS_ALWAYS_INLINE bool all(V mask) noexcept {
    return !any(~mask);
}

// Returns bit first + i alone in lane i.
template <IsVec V>
ECODS_ALWAYS_INLINE V lane_bits(int first = 0) noexcept {
    V bits{};
    for (int i = 0; i < lane_count<V>; ++i) bits[i] = LaneType<V>{1} << (first + i);
    return bits;
}

// Returns the low byte of each lane, lane 0 in the lowest byte.
template <IsVec V>
ECODS_ALWAYS_INLINE std::uint64_t low_bytes(V v) noexcept {
    const auto bytes = convert<Vec<std::uint8_t, lane_count<V>>>(v);
    std::uint64_t word = 0;
    std::memcpy(&word, &bytes, sizeof bytes);
    return word;
}
