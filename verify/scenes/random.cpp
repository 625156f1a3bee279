#include "scenes/random.hpp"

#include <gsl/gsl_rng.h>

#include <cmath>
#include <new>

#include "scenes/quaternion.hpp"

namespace ecods::scenes {

struct Random::Generator {
    struct Free {
        void operator()(gsl_rng* freed) const noexcept { gsl_rng_free(freed); }
    };
    std::unique_ptr<gsl_rng, Free> rng;
};

Random::Random(std::uint32_t seed) : generator_(new Generator{{gsl_rng_alloc(gsl_rng_mt19937), {}}}) {
    if (!generator_->rng) throw std::bad_alloc();
    gsl_rng_set(generator_->rng.get(), seed);
}

Random::~Random() = default;

double Random::uniform(double min, double max) {
    return min + (max - min) * gsl_rng_uniform(generator_->rng.get());
}

std::uint32_t Random::below(std::uint32_t count) {
    return static_cast<std::uint32_t>(gsl_rng_uniform_int(generator_->rng.get(), count));
}

// Both by rejection from the cube around the ball: no sine, cosine or logarithm, whose last bits differ between
// mathematical libraries. Points close to the centre are refused, too, since their direction has few bits.
Vec3 Random::direction() {
    while (true) {
        const double x = uniform(-1, 1), y = uniform(-1, 1), z = uniform(-1, 1);
        const double square = x * x + y * y + z * z;
        if (square <= 1 && square >= 0.0625) return Vec3(x, y, z) / std::sqrt(square);
    }
}

Eigen::Quaterniond Random::rotation() {
    while (true) {
        const double w = uniform(-1, 1), x = uniform(-1, 1), y = uniform(-1, 1), z = uniform(-1, 1);
        const double square = w * w + x * x + y * y + z * z;
        if (square <= 1 && square >= 0.0625) return unit(w, x, y, z);
    }
}

}  // namespace ecods::scenes
