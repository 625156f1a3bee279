#include <array>

#include "oracle/linear_program.hpp"
#include "oracle/pair_motion.hpp"
#include "oracle/triangle_distance.hpp"

namespace ecods::oracle {
namespace {

class Translation final : public PairMotion {
  public:
    Translation(const MovingTriangle& a, const MovingTriangle& b) : a_(a), b_(b) {}

    // Variables: the time, what is left of it, three weights of the corners of a and of b. The sum of a's corners by
    // weight, moved, is that of b's.
    std::optional<Root> first_time() override {
        std::vector<Equation> equations(6, Equation(9));
        equations[0] = {1, 1, 0, 0, 0, 0, 0, 0, 1};
        equations[1] = {0, 0, 1, 1, 1, 0, 0, 0, 1};
        equations[2] = {0, 0, 0, 0, 0, 1, 1, 1, 1};
        for (std::size_t k = 0; k < 3; ++k) {
            Equation& sum = equations[3 + k];
            sum[0] = a_.change[0][k];
            for (std::size_t i = 0; i < 3; ++i) {
                sum[2 + i] = a_.from[i][k] - b_.from[0][k];
                sum[5 + i] = b_.from[0][k] - b_.from[i][k];
            }
        }
        const auto least = least_first_variable(std::move(equations));
        if (!least) return std::nullopt;
        return Root(*least);
    }

    // In units of the time's denominator all are integers.
    std::vector<std::size_t> features_at(Root& time) override {
        const TriangleOf<mpz_class> a = at(a_, time.low()), b = at(b_, time.low());
        std::vector<std::size_t> found;
        for (std::size_t i = 0; i < feature_pairs().size(); ++i) {
            const FeatureDistance<mpz_class> d = feature_distance(feature_pairs()[i], a, b);
            if (d.is_inside && sgn(d.num) == 0) found.push_back(i);
        }
        return found;
    }

  private:
    static TriangleOf<mpz_class> at(const MovingTriangle& triangle, const mpq_class& time) {
        std::array<Vector<mpz_class>, 3> corners;
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t k = 0; k < 3; ++k) {
                corners[i][k] = triangle.from[i][k] * time.get_den() + triangle.change[i][k] * time.get_num();
            }
        }
        return TriangleOf<mpz_class>(corners);
    }

    MovingTriangle a_, b_;
};

}  // namespace

std::unique_ptr<PairMotion> make_translation(const MovingTriangle& a, const MovingTriangle& b) {
    return std::make_unique<Translation>(a, b);
}

}  // namespace ecods::oracle
