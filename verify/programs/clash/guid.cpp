#include "programs/clash/guid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

namespace ecods::clash {
namespace {

// Fowler, Noll and Vo's FNV-1a of 64 bits, and the finalizer of splitmix64 (Steele, Lea and Flood, 2014), which
// spreads the last bytes over all bits.
class Hash {
  public:
    explicit Hash(std::uint64_t seed) : state_(0xcbf29ce484222325U ^ seed) {}

    void add(unsigned char byte) { state_ = (state_ ^ byte) * 0x100000001b3U; }

    std::uint64_t value() const {
        std::uint64_t x = state_;
        x = (x ^ x >> 30) * 0xbf58476d1ce4e5b9U;
        x = (x ^ x >> 27) * 0x94d049bb133111ebU;
        return x ^ x >> 31;
    }

  private:
    std::uint64_t state_;
};

bool is_digit_of_ifc(char c) {
    return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_' || c == '$';
}

}  // namespace

std::string guid_of(std::initializer_list<std::string_view> texts) {
    std::uint64_t halves[2] = {};
    for (std::uint64_t i = 0; i < 2; ++i) {
        Hash hash(i * 0x9e3779b97f4a7c15U);
        for (const std::string_view text : texts) {
            for (std::uint64_t size = text.size(), k = 0; k < 8; ++k)
                hash.add(static_cast<unsigned char>(size >> 8 * k));
            for (const char c : text) hash.add(static_cast<unsigned char>(c));
        }
        halves[i] = hash.value();
    }
    halves[0] = (halves[0] & ~std::uint64_t{0xF000}) | 0x8000;                     // the version
    halves[1] = (halves[1] & ~(std::uint64_t{3} << 62)) | std::uint64_t{2} << 62;  // the variant
    return fmt::format("{:08x}-{:04x}-{:04x}-{:04x}-{:012x}", halves[0] >> 32, halves[0] >> 16 & 0xFFFF,
                       halves[0] & 0xFFFF, halves[1] >> 48, halves[1] & 0xFFFFFFFFFFFF);
}

std::string_view ifc_guid_in(std::string_view name) {
    constexpr std::size_t size = 22;
    if (name.size() < size) return {};
    const std::string_view last = name.substr(name.size() - size);
    const char before = name.size() == size ? ' ' : name[name.size() - size - 1];
    // '_' is a digit, and it also joins the pieces of Class_Name_GUID, as assimp names what it reads from IFC.
    const bool is_piece = !is_digit_of_ifc(before) || (before == '_' && name.starts_with("Ifc"));
    // 22 digits have 132 bits, of which the first four are 0.
    const bool is_guid = last[0] >= '0' && last[0] <= '3' && std::all_of(last.begin(), last.end(), is_digit_of_ifc);
    return is_piece && is_guid ? last : std::string_view{};
}

}  // namespace ecods::clash
