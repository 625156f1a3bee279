// Sha256 is a digest that identifies a text: nobody can make a second text that has it.
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

    // Takes the next piece of the text; how the text is cut into pieces changes nothing.
    void operator()(std::string_view piece) noexcept;

    // Returns the digest of all pieces. No piece may follow.
    Digest finish() noexcept;

  private:
    static constexpr std::size_t block_bytes = 64;
    using Block = std::array<unsigned char, block_bytes>;

    void compress(const unsigned char* block) noexcept;

    // The fractional parts of the square roots of the first eight primes, 32 bits each (5.3.3).
    Digest state_ = {0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a, 0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
    Block rest_{};  // the end of the text, which does not fill a block yet
    std::uint64_t byte_count_ = 0;
};

// Returns 64 lower-case digits.
std::string hexadecimal(const Sha256::Digest& digest);

}  // namespace ecods
