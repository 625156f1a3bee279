// Linear programs in rationals.
#pragma once

#include <gmpxx.h>

#include <optional>
#include <vector>

namespace ecods::oracle {

// An equation: coefficients of all variables, and the number that their sum is.
using Equation = std::vector<mpq_class>;

// The least value of the first variable of those solutions of the equations of which no variable is negative; nothing
// if there is none. The simplex method, with Bland's rule, which always ends.
std::optional<mpq_class> least_first_variable(std::vector<Equation> equations);

}  // namespace ecods::oracle
