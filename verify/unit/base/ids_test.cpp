#include "ecods/ids.hpp"

#include <gtest/gtest.h>

#include <iomanip>
#include <limits>
#include <locale>
#include <sstream>

namespace ecods {
namespace {

template <class T>
std::string printed(const T& value) {
    std::ostringstream out;
    out << value;
    return out.str();
}

TEST(Ids, Print) {
    constexpr std::uint32_t max = std::numeric_limits<std::uint32_t>::max();
    const BodyId a{.slot = 3, .generation = 1}, b{.slot = 12, .generation = 0};
    EXPECT_EQ(printed(BodyId{}), "0.0");
    EXPECT_EQ(printed(a), "3.1");
    EXPECT_EQ(printed(BodyPair{a, b}), "(3.1, 12.0)");
    EXPECT_EQ(printed(TrianglePair{7, max}), "(7, 4294967295)");
    EXPECT_EQ(printed(ShapeKind::mesh()), "mesh");
    EXPECT_EQ(printed(ShapeKind{.value = 7}), "kind 7");
}

struct Grouping : std::numpunct<char> {
    char do_thousands_sep() const override { return ','; }
    std::string do_grouping() const override { return "\3"; }
};

TEST(Ids, PrintTheSameWhateverTheStreamIsSetTo) {
    std::ostringstream out;
    out.imbue(std::locale(std::locale::classic(), new Grouping));
    out << std::hex << std::setfill('.') << std::setw(10) << BodyId{.slot = 123456, .generation = 10} << '|';
    EXPECT_EQ(out.str(), ".123456.10|");
}

}  // namespace
}  // namespace ecods
