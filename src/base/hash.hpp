// 64-bit words are hashed to digests that are the same on every machine.
#pragma once

#include <bit>
#include <cstdint>

namespace ecods {

// Maps 64-bit words one to one; each input bit affects each output bit.
// Source: the finaliser of SplitMix64 (Steele, Lea, Flood, Fast Splittable Pseudorandom Number Generators, 2014).
constexpr std::uint64_t mix(std::uint64_t x) noexcept {
    x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9u;
    x = (x ^ (x >> 27)) * 0x94D049BB133111EBu;
    return x ^ (x >> 31);
}

// Returns the digest of a sequence with `word` appended to it. The digest depends on the order of words.
constexpr std::uint64_t combine(std::uint64_t digest, std::uint64_t word) noexcept {
    return mix(digest + 0x9E3779B97F4A7C15u + mix(word));
}

// Returns the bits of a coordinate. -0.0 gives the bits of 0.0, because they are the same point. Zero is recognised by
// its bits: x == 0 would also hold for subnormal numbers if the processor takes these for zero.
constexpr std::uint64_t coordinate_bits(double x) noexcept {
    const std::uint64_t bits = std::bit_cast<std::uint64_t>(x);
    return bits << 1 == 0 ? 0 : bits;
}

}  // namespace ecods
