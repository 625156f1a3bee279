#include "oracle/share_point.hpp"

#include <utility>
#include <vector>

#include "oracle/linear_program.hpp"

namespace ecods::oracle {

bool share_point(const Corners& a, const Corners& b) {
    std::vector<Equation> equations(5, Equation(7));
    equations[0] = {1, 1, 1, 0, 0, 0, 1};
    equations[1] = {0, 0, 0, 1, 1, 1, 1};
    for (std::size_t k = 0; k < 3; ++k) {
        for (std::size_t i = 0; i < 3; ++i) {
            equations[2 + k][i] = a[i][k] - b[0][k];
            equations[2 + k][3 + i] = b[0][k] - b[i][k];
        }
    }
    return least_first_variable(std::move(equations)).has_value();
}

}  // namespace ecods::oracle
