// The sides on which a line is of a solid that fills cells of the lattice: comparisons of fractions of integers.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "scenes/cells.hpp"

namespace ecods {

// The points (from + s step) / 2 for all real s; `step` is not zero.
class LatticeLine {
  public:
    // A fraction, den > 0.
    struct Number {
        std::int64_t num = 0, den = 1;

        friend bool operator<(const Number& x, const Number& y) { return x.num * y.den < y.num * x.den; }
        friend bool operator==(const Number& x, const Number& y) { return x.num * y.den == y.num * x.den; }
        double rounded() const { return static_cast<double>(num) / static_cast<double>(den); }
    };

    LatticeLine(const scenes::LatticePoint& from, const scenes::LatticePoint& step, const scenes::Cells& cells)
        : from_(from), step_(step), cells_(cells) {
        constexpr int lowest = -8, highest = 12;  // of planes of the lattice that cells may have
        for (std::size_t k = 0; k < 3; ++k) {
            for (int plane = lowest; step[k] != 0 && plane <= highest; ++plane) {
                const std::int64_t num = 2 * plane - from[k];
                breaks_.push_back(step[k] > 0 ? Number{num, step[k]} : Number{-num, -step[k]});
            }
        }
        std::sort(breaks_.begin(), breaks_.end());
        breaks_.erase(std::unique(breaks_.begin(), breaks_.end()), breaks_.end());
    }

    // The parameters at which the line meets a plane of the lattice: between them the side is constant.
    const std::vector<Number>& breaks() const { return breaks_; }

    Side side_at(const Number& s) const {
        scenes::LatticePoint doubled;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::int64_t num = from_[k] * s.den + step_[k] * s.num, den = 2 * s.den;  // the coordinate
            std::int64_t floor = num / den;
            if (floor * den > num) --floor;
            doubled[k] = static_cast<int>(2 * floor + (floor * den == num ? 0 : 1));
        }
        return scenes::side_of(doubled, cells_);
    }
    static Number between(const Number& x, const Number& y) {
        return {x.num * y.den + y.num * x.den, 2 * x.den * y.den};
    }
    // The side just before and just after a parameter.
    Side before(const Number& s) const {
        auto next = std::lower_bound(breaks_.begin(), breaks_.end(), s);
        return next == breaks_.begin() ? Side::outside : side_at(between(*std::prev(next), s));
    }
    Side after(const Number& s) const {
        auto next = std::upper_bound(breaks_.begin(), breaks_.end(), s);
        return next == breaks_.end() ? Side::outside : side_at(between(s, *next));
    }

  private:
    scenes::LatticePoint from_, step_;
    const scenes::Cells& cells_;
    std::vector<Number> breaks_;
};

}  // namespace ecods
