// Sha256 computes a digest that identifies a text: nobody knows how to make two texts with the same digest.
// Source: FIPS 180-4, Secure Hash Standard, 2015.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace ecods {

class Sha256 {
  public:
    using Digest = std::array<std::uint32_t, 8>;

    // Adds the next piece of the text to the digest. The digest does not depend on how the text is cut into pieces.
    void operator()(std::string_view piece) noexcept;

    // Returns the digest of all pieces. No piece may be added afterwards.
    Digest finish() noexcept;

  private:
    static constexpr std::size_t block_bytes = 64;
    using Block = std::array<unsigned char, block_bytes>;

    void compress(const unsigned char* block) noexcept;

    // The initial state is the fractional parts of the square roots of the first eight primes, 32 bits each (5.3.3).
    Digest state_ = {0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a, 0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
    Block rest_{};  // the last bytes of the text, less than one block
    std::uint64_t byte_count_ = 0;
};

// Returns the digest as 64 lower-case hexadecimal digits.
std::string hexadecimal(const Sha256::Digest& digest);

}  // namespace ecods
