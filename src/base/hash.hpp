// Mixing 64-bit words into digests that are the same on every machine.
#pragma once

#include <bit>
#include <cstdint>

namespace ecods {

// A bijection of 64-bit words in which each input bit reaches each output bit.
// Source: the finaliser of SplitMix64 (Steele, Lea, Flood, Fast Splittable Pseudorandom Number Generators, 2014).
constexpr std::uint64_t mix(std::uint64_t x) noexcept {
    x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9u;
    x = (x ^ (x >> 27)) * 0x94D049BB133111EBu;
    return x ^ (x >> 31);
}

// The digest of a sequence, one word after the other; order matters.
constexpr std::uint64_t combine(std::uint64_t digest, std::uint64_t word) noexcept {
    return mix(digest + 0x9E3779B97F4A7C15u + mix(word));
}

// The bits of a coordinate, -0.0 counting as 0.0: they are the same point. (x == 0 would not do: it holds for
// subnormals where the processor is set to take them for zero.)
constexpr std::uint64_t coordinate_bits(double x) noexcept {
    const std::uint64_t bits = std::bit_cast<std::uint64_t>(x);
    return bits << 1 == 0 ? 0 : bits;
}

}  // namespace ecods
