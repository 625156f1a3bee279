#include "base/sha256.hpp"

#include <algorithm>
#include <bit>
#include <cstring>

namespace ecods {
namespace {

// The constants are the fractional parts of the cube roots of the first 64 primes, 32 bits each (section 4.2.2 of FIPS
// 180-4).
constexpr std::array<std::uint32_t, 64> constants = {
    0x428a2f98, 0x71374491, 0xb5c0fbcf, 0xe9b5dba5, 0x3956c25b, 0x59f111f1, 0x923f82a4, 0xab1c5ed5,
    0xd807aa98, 0x12835b01, 0x243185be, 0x550c7dc3, 0x72be5d74, 0x80deb1fe, 0x9bdc06a7, 0xc19bf174,
    0xe49b69c1, 0xefbe4786, 0x0fc19dc6, 0x240ca1cc, 0x2de92c6f, 0x4a7484aa, 0x5cb0a9dc, 0x76f988da,
    0x983e5152, 0xa831c66d, 0xb00327c8, 0xbf597fc7, 0xc6e00bf3, 0xd5a79147, 0x06ca6351, 0x14292967,
    0x27b70a85, 0x2e1b2138, 0x4d2c6dfc, 0x53380d13, 0x650a7354, 0x766a0abb, 0x81c2c92e, 0x92722c85,
    0xa2bfe8a1, 0xa81a664b, 0xc24b8b70, 0xc76c51a3, 0xd192e819, 0xd6990624, 0xf40e3585, 0x106aa070,
    0x19a4c116, 0x1e376c08, 0x2748774c, 0x34b0bcb5, 0x391c0cb3, 0x4ed8aa4a, 0x5b9cca4f, 0x682e6ff3,
    0x748f82ee, 0x78a5636f, 0x84c87814, 0x8cc70208, 0x90befffa, 0xa4506ceb, 0xbef9a3f7, 0xc67178f2};

std::uint32_t big_endian(const unsigned char* bytes) noexcept {
    return std::uint32_t{bytes[0]} << 24 | std::uint32_t{bytes[1]} << 16 | std::uint32_t{bytes[2]} << 8 | bytes[3];
}

}  // namespace

// Adds one block of 64 bytes to the state. Follows sections 6.2.2 and 4.1.2 of FIPS 180-4, with their names.
void Sha256::compress(const unsigned char* block) noexcept {
    std::array<std::uint32_t, 64> w;
    for (std::size_t t = 0; t < 16; ++t) w[t] = big_endian(block + 4 * t);
    for (std::size_t t = 16; t < 64; ++t) {
        const std::uint32_t x = w[t - 15], y = w[t - 2];
        const std::uint32_t sigma_0 = std::rotr(x, 7) ^ std::rotr(x, 18) ^ x >> 3;
        const std::uint32_t sigma_1 = std::rotr(y, 17) ^ std::rotr(y, 19) ^ y >> 10;
        w[t] = sigma_1 + w[t - 7] + sigma_0 + w[t - 16];
    }
    auto [a, b, c, d, e, f, g, h] = state_;
    for (std::size_t t = 0; t < 64; ++t) {
        const std::uint32_t sum_0 = std::rotr(a, 2) ^ std::rotr(a, 13) ^ std::rotr(a, 22);
        const std::uint32_t sum_1 = std::rotr(e, 6) ^ std::rotr(e, 11) ^ std::rotr(e, 25);
        const std::uint32_t choice = (e & f) ^ (~e & g), majority = (a & b) ^ (a & c) ^ (b & c);
        const std::uint32_t t_1 = h + sum_1 + choice + constants[t] + w[t], t_2 = sum_0 + majority;
        h = g;
        g = f;
        f = e;
        e = d + t_1;
        d = c;
        c = b;
        b = a;
        a = t_1 + t_2;
    }
    const Digest working = {a, b, c, d, e, f, g, h};
    for (std::size_t i = 0; i < state_.size(); ++i) state_[i] += working[i];
}

void Sha256::operator()(std::string_view piece) noexcept {
    const std::size_t kept = byte_count_ % block_bytes;
    byte_count_ += piece.size();
    if (kept > 0) {
        const std::size_t taken = std::min(piece.size(), block_bytes - kept);
        std::memcpy(rest_.data() + kept, piece.data(), taken);
        piece.remove_prefix(taken);
        if (kept + taken < block_bytes) return;
        compress(rest_.data());
    }
    for (; piece.size() >= block_bytes; piece.remove_prefix(block_bytes)) {
        compress(reinterpret_cast<const unsigned char*>(piece.data()));
    }
    if (!piece.empty()) std::memcpy(rest_.data(), piece.data(), piece.size());
}

// Pads the text with a 1 bit, zero bits, and the length of the text in bits, a 64-bit number that ends the last block
// (section 5.1.1).
Sha256::Digest Sha256::finish() noexcept {
    constexpr std::size_t length_at = block_bytes - 8;
    const std::uint64_t bit_count = 8 * byte_count_;
    std::size_t kept = byte_count_ % block_bytes;
    rest_[kept++] = 0x80;
    if (kept > length_at) {
        std::fill(rest_.begin() + static_cast<std::ptrdiff_t>(kept), rest_.end(), 0);
        compress(rest_.data());
        kept = 0;
    }
    std::fill(rest_.begin() + static_cast<std::ptrdiff_t>(kept), rest_.end(), 0);
    for (std::size_t i = 0; i < 8; ++i) rest_[length_at + i] = static_cast<unsigned char>(bit_count >> (56 - 8 * i));
    compress(rest_.data());
    return state_;
}

std::string hexadecimal(const Sha256::Digest& digest) {
    std::string text;
    for (const std::uint32_t word : digest) {
        for (int shift = 28; shift >= 0; shift -= 4) text.push_back("0123456789abcdef"[word >> shift & 15]);
    }
    return text;
}

}  // namespace ecods
