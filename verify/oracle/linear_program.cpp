#include "oracle/linear_program.hpp"

#include <cstddef>

namespace ecods::oracle {
namespace {

// Row i is solved for variable basis[i]; from `variables` on they are artificial, and have no column.
struct Tableau {
    std::vector<Equation> rows;
    std::vector<std::size_t> basis;
    Equation cost;  // what each variable adds to the goal, less what it takes away
    std::size_t variables;

    const mpq_class& right(std::size_t row) const { return rows[row].back(); }

    static void subtract(Equation& from, const mpq_class& factor, const Equation& row) {
        if (sgn(factor) == 0) return;
        for (std::size_t j = 0; j < row.size(); ++j) from[j] -= factor * row[j];
    }

    void enter(std::size_t row, std::size_t column) {
        const mpq_class pivot = rows[row][column];
        for (mpq_class& x : rows[row]) x /= pivot;
        for (std::size_t i = 0; i < rows.size(); ++i) {
            if (i != row) subtract(rows[i], mpq_class(rows[i][column]), rows[row]);
        }
        subtract(cost, mpq_class(cost[column]), rows[row]);
        basis[row] = column;
    }

    // The row that limits the variable first; of several that of the least variable.
    std::size_t leaving(std::size_t column) const {
        std::size_t best = rows.size();
        for (std::size_t i = 0; i < rows.size(); ++i) {
            if (rows[i][column] <= 0) continue;
            if (best < rows.size()) {
                const int order = cmp(right(i) * rows[best][column], right(best) * rows[i][column]);
                if (order > 0 || (order == 0 && basis[i] > basis[best])) continue;
            }
            best = i;
        }
        return best;
    }

    void minimise() {
        for (;;) {
            std::size_t column = 0;
            while (column < variables && cost[column] >= 0) ++column;
            if (column == variables) return;
            const std::size_t row = leaving(column);
            if (row == rows.size()) return;  // without end, which no goal here is
            enter(row, column);
        }
    }

    // Artificial variables that are left are zero: others take their place, or their equation says nothing.
    void drop_artificial() {
        for (std::size_t i = rows.size(); i-- > 0;) {
            if (basis[i] < variables) continue;
            std::size_t column = 0;
            while (column < variables && rows[i][column] == 0) ++column;
            if (column < variables) {
                enter(i, column);
            } else {
                rows.erase(rows.begin() + static_cast<std::ptrdiff_t>(i));
                basis.erase(basis.begin() + static_cast<std::ptrdiff_t>(i));
            }
        }
    }
};

}  // namespace

std::optional<mpq_class> least_first_variable(std::vector<Equation> equations) {
    const std::size_t variables = equations[0].size() - 1;
    Tableau t{std::move(equations), {}, Equation(variables + 1), variables};
    for (std::size_t i = 0; i < t.rows.size(); ++i) {
        if (t.right(i) < 0) {
            for (mpq_class& x : t.rows[i]) x = -x;
        }
        t.basis.push_back(variables + i);
        Tableau::subtract(t.cost, 1, t.rows[i]);
    }
    t.minimise();
    if (t.cost.back() != 0) return std::nullopt;
    t.drop_artificial();
    t.cost = Equation(variables + 1);
    t.cost[0] = 1;
    for (std::size_t i = 0; i < t.rows.size(); ++i) {
        if (t.basis[i] == 0) Tableau::subtract(t.cost, 1, t.rows[i]);
    }
    t.minimise();
    return mpq_class(-t.cost.back());
}

}  // namespace ecods::oracle
