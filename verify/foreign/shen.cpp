// Whether two triangles meet (Shen 2003), as doubles and as floats, in both orders.
#include <array>
#include <string_view>

#include "ecods/primitives.hpp"
#include "foreign/shen_pairs.hpp"
#include "foreign/sources.hpp"

namespace ecods::foreign::shen {
namespace {

using Corners = std::array<Vec3, 3>;

class Decimals {
  public:
    explicit Decimals(std::string_view text) : text_(text) {}

    // Skips to the next digit, if there is one.
    bool more() {
        while (at_ < text_.size() && (text_[at_] < '0' || text_[at_] > '9')) ++at_;
        return at_ < text_.size();
    }
    double next() {
        int number = 0;
        for (int digit = 0; digit < 6; ++digit) number = 10 * number + (text_[at_++] - '0');
        return number / 1e6;
    }

  private:
    std::string_view text_;
    std::size_t at_ = 0;
};

Corners rounded_to_floats(const Corners& t) {
    Corners result;
    for (std::size_t i = 0; i < 3; ++i) result[i] = t[i].cast<float>().cast<double>();
    return result;
}

void ask_pairs(Expectations& expect, std::string_view pairs, bool meet) {
    for (Decimals text(pairs); text.more();) {
        std::array<Corners, 2> t;
        for (Corners& corners : t) {
            for (Vec3& v : corners) {
                for (int k = 0; k < 3; ++k) v[k] = text.next();
            }
        }
        const Corners a = rounded_to_floats(t[0]), b = rounded_to_floats(t[1]);
        expect.is(triangle_triangle(t[0], t[1]) != Relation::apart, meet);
        expect.is(triangle_triangle(t[1], t[0]) != Relation::apart, meet);
        expect.is(triangle_triangle(a, b) != Relation::apart, meet);
        expect.is(triangle_triangle(b, a) != Relation::apart, meet);
    }
}

}  // namespace

void ask(Expectations& expect) {
    expect.from("intersected.txt");
    ask_pairs(expect, intersected_pairs, true);
    expect.from("separated.txt");
    ask_pairs(expect, separated_pairs, false);
}

}  // namespace ecods::foreign::shen
