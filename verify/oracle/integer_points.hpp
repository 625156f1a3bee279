// The points of two posed meshes as integers in one unit, and intervals around them.
#pragma once

#include <gmpxx.h>

#include <array>
#include <span>
#include <vector>

#include "oracle/distance.hpp"
#include "oracle/features.hpp"

namespace ecods::oracle {

// The points of any number of posed meshes, [mesh][vertex]; of vertices that no triangle uses, zero. Coordinates are
// integers times 2^unit. Needs a FloatEnvironment.
struct CommonIntegers {
    std::vector<std::vector<Vector<mpz_class>>> points;
    long unit = 0;

    explicit CommonIntegers(std::span<const Soup> soups);
};

struct IntegerPoints {
    // [body][vertex]; of vertices that no triangle uses, zero. Coordinates are integers times 2^unit.
    std::array<std::vector<Vector<mpz_class>>, 2> exact;
    long unit = 0;
    // Around the same points less a common origin, times 2^-scale: none is larger than one. Needs a FloatEnvironment.
    std::array<std::vector<Vector<Interval>>, 2> around;
    long scale = 0;

    IntegerPoints(const Soup& a, const Soup& b);
};

// An interval around x * 2^shift, for numbers that are no larger than one or so. Needs a FloatEnvironment.
Interval interval_around(const mpz_class& x, long shift);

}  // namespace ecods::oracle
