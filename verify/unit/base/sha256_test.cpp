// SHA-256 beside the vectors that NIST published with FIPS 180-4, and beside another implementation at each length
// where the padding changes its form.
#include "base/sha256.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

namespace ecods {
namespace {

std::string digest_of(std::string_view text, std::size_t piece = std::string_view::npos) {
    Sha256 sha;
    for (; !text.empty(); text.remove_prefix(std::min(piece, text.size()))) sha(text.substr(0, piece));
    return hexadecimal(sha.finish());
}

TEST(Sha256, IsThatOfTheStandard) {
    EXPECT_EQ(digest_of(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    EXPECT_EQ(digest_of("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    EXPECT_EQ(digest_of("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
              "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
    EXPECT_EQ(
        digest_of("abcdefghbcdefghicdefghijdefghijkefghijklfghijklmghijklmnhijklmnoijklmnopjklmnopqklmnopqrlmnopqrs"
                  "mnopqrstnopqrstu"),
        "cf5b16a778af8380036ce59e7b0492370b249b11e8f07a51afac45037afee9d1");
    EXPECT_EQ(digest_of(std::string(1'000'000, 'a')),
              "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

// Python's hashlib says so of the n bytes 32 + (7 * i + n) % 95.
TEST(Sha256, PadsTextsOfEachLength) {
    static constexpr std::pair<int, const char*> known[] = {
        {1, "bb7208bc9b5d7c04f1236a82a0093a5e33f40423d5ba8d4266f7092c3ba43b62"},
        {55, "e1af2acbfdd5d6e19603c1dd98a7591ab89099ac32640351527adbeb9b1b3dc9"},
        {56, "033c3998b26d6a2041ce86a593699f3772cccb08061ede02eb6ebb8e7b8c0aa6"},
        {57, "5c1f635ebd4fee29f2055471d7ea401743fe93bacbb577c97055e3069ea324aa"},
        {63, "68fea72e686881c6a3d3ce8c81f1cf9d3836df21fa8b16af0c076626ff25774d"},
        {64, "aac1b010dc7329e4a035aec628be325087f64f4c3a53a994bd03e8aa901baa23"},
        {65, "0b901378e06e6ac0730cf4784b0020a16a6fd4f4cd4e017cfcef64e4f66e3541"},
        {111, "cadd5d191a1ce6981d6b23c7816c581a4d43d4c3b194f2147a28270f838c6f69"},
        {112, "cded4f36d17db03fd83d80ea54141005b60a9228838bc0b7719b627f90d70051"},
        {119, "3041b2b0d4c5cff18fcf0adf40e2adb034024f829546f4359c530b991d2d26b0"},
        {120, "9c45a3ab760467e09b5fb351df0b781811a8383ddffeb03c29e1944ce1725a61"},
        {127, "12b067660ab635d2b5ef6c86b44356ed4b797f9f70baa46cc0645bb2d5d20ba8"},
        {128, "b919ea34af577ebf08ab7d5a2c9f4bd9cfede042a643342f03508a6b4161bbbb"},
        {1000, "0762d4c56e68ad2dd62b721041c45796ef92613da982af309b044a63385b0037"}};
    for (const auto& [n, digest] : known) {
        std::string text;
        for (int i = 0; i < n; ++i) text.push_back(static_cast<char>(32 + (7 * i + n) % 95));
        EXPECT_EQ(digest_of(text), digest) << n;
    }
}

TEST(Sha256, IsTheSameHoweverTheTextIsCut) {
    std::string text;
    for (int i = 0; i < 400; ++i) text.push_back(static_cast<char>(i * i));
    const std::string whole = digest_of(text);
    for (std::size_t piece = 1; piece <= text.size(); ++piece) EXPECT_EQ(digest_of(text, piece), whole) << piece;
    Sha256 sha;
    sha("");
    sha(text);
    sha("");
    EXPECT_EQ(hexadecimal(sha.finish()), whole);
}

TEST(Sha256, DiffersWhereverAByteDoes) {
    const std::string text(130, 'a');
    for (std::size_t at = 0; at < text.size(); ++at) {
        std::string other = text;
        other[at] = 'b';
        EXPECT_NE(digest_of(other), digest_of(text)) << at;
    }
    EXPECT_NE(digest_of(text + '\0'), digest_of(text));
}

}  // namespace
}  // namespace ecods
