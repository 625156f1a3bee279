// simd/vec.hpp includes this source once for each instruction set: operations on all lanes of vectors at once.

// Return a vector whose lane i is first[i]. load() needs `first` to be aligned as V; load_anywhere() does not.
template <IsVec V>
ECODS_ALWAYS_INLINE V load(const LaneType<V>* first) noexcept {
    return *reinterpret_cast<const typename VecTypes<LaneType<V>, lane_count<V>>::InMemory*>(first);
}
template <IsVec V>
ECODS_ALWAYS_INLINE V load_anywhere(const LaneType<V>* first) noexcept {
    return *reinterpret_cast<const typename VecTypes<LaneType<V>, lane_count<V>>::Anywhere*>(first);
}

// Store lane i in first[i]. store() needs `first` to be aligned as V; store_anywhere() does not.
template <IsVec V>
ECODS_ALWAYS_INLINE void store(LaneType<V>* first, V v) noexcept {
    *reinterpret_cast<typename VecTypes<LaneType<V>, lane_count<V>>::InMemory*>(first) = v;
}

template <IsVec V>
ECODS_ALWAYS_INLINE void store_anywhere(LaneType<V>* first, V v) noexcept {
    *reinterpret_cast<typename VecTypes<LaneType<V>, lane_count<V>>::Anywhere*>(first) = v;
}

// Returns x in each lane. The compiler drops the subtraction, since subtracting zero changes no number, not even -0.
// (Without optimization, in a mode that rounds down, 0 becomes -0.) An addition of zero would change -0, and cost an
// instruction.
template <IsVec V>
ECODS_ALWAYS_INLINE V broadcast(LaneType<V> x) noexcept {
    return x - V{};
}

// bits_as() reinterprets the bits of v as lanes of another type. convert() converts each number in the current rounding
// mode.
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

// Returns `yes` in lanes in which the mask is all ones, and `no` in lanes in which the mask is zero.
template <IsVec V>
ECODS_ALWAYS_INLINE V select(MaskOf<V> mask, V yes, V no) noexcept {
    return mask ? yes : no;
}

// Return the lesser, or the greater, number of each lane; b in lanes in which a or b is NaN.
template <IsVec V>
ECODS_ALWAYS_INLINE V min(V a, V b) noexcept {
    return a < b ? a : b;
}
template <IsVec V>
ECODS_ALWAYS_INLINE V max(V a, V b) noexcept {
    return a > b ? a : b;
}

// Returns |v| in each lane.
template <IsVec V>
ECODS_ALWAYS_INLINE V absolute(V v) noexcept {
    static_assert(std::is_floating_point_v<LaneType<V>>);
    using Bits = MaskOf<V>;
    constexpr LaneType<Bits> all_but_sign = std::numeric_limits<LaneType<Bits>>::max();
    return bits_as<V>(bits_as<Bits>(v) & all_but_sign);
}

// Return the lanes with the numbers in `index`. With two vectors, the numbers count the lanes of a first and then the
// lanes of b.
template <int... index, IsVec V>
ECODS_ALWAYS_INLINE V shuffle(V a, V b) noexcept {
    return __builtin_shufflevector(a, b, index...);
}
template <int... index, IsVec V>
ECODS_ALWAYS_INLINE V shuffle(V v) noexcept {
    return __builtin_shufflevector(v, v, index...);
}

// Returns v itself if it has 128 bits. If it has 256 bits, returns the bitwise or of the two halves of v.
template <IsVec V>
ECODS_ALWAYS_INLINE Vec<std::uint64_t, 2> join_halves(V v) noexcept {
    const auto words = bits_as<Vec<std::uint64_t, static_cast<int>(sizeof(V) / 8)>>(v);
    if constexpr (sizeof(V) == 32) {
        return __builtin_shufflevector(words, words, 0, 1) | __builtin_shufflevector(words, words, 2, 3);
    } else {
        return words;
    }
}

// Returns the bitwise or of all lanes. V has two or more lanes of 32 or 64 bits.
template <IsVec V>
ECODS_ALWAYS_INLINE LaneType<V> any_bits(V v) noexcept {
    static_assert(std::is_integral_v<LaneType<V>> && sizeof(LaneType<V>) >= 4);
    const auto words = join_halves(v);
    std::uint64_t bits = words[0] | words[1];
    if constexpr (sizeof(LaneType<V>) == 4) bits |= bits >> 32;
    return static_cast<LaneType<V>>(bits);
}

// any() is true if at least one lane of a mask is set, all() if every lane is set. Only the signs of lanes are read,
// since a lane is all ones or zero: the baseline has an instruction that reads the signs of four lanes at once.
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

// Returns a vector whose lane i is the integer 2^(first + i).
template <IsVec V>
ECODS_ALWAYS_INLINE V lane_bits(int first = 0) noexcept {
    V bits{};
    for (int i = 0; i < lane_count<V>; ++i) bits[i] = LaneType<V>{1} << (first + i);
    return bits;
}

// Returns the low byte of each lane, packed into a word: the byte of lane 0 is the lowest.
template <IsVec V>
ECODS_ALWAYS_INLINE std::uint64_t low_bytes(V v) noexcept {
    const auto bytes = convert<Vec<std::uint8_t, lane_count<V>>>(v);
    std::uint64_t word = 0;
    std::memcpy(&word, &bytes, sizeof bytes);
    return word;
}
