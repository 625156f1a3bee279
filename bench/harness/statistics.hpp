// What times and counts are boiled down to, by GSL.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace ecods::bench {

double median(std::vector<double> values);                  // 0 of nothing
double quantile(std::vector<double> values, double share);  // 0 of nothing
double spread_in_percent(std::vector<double> values);       // quartile distance over median; 0 of less than two

// What a table says of its times: "medians of 9 interleaved repetitions", or "one repetition".
std::string medians_of(std::size_t repetition_count);

// How many times as fast as the yardstick: the median of the ratios of one repetition each. 0 when there is none.
double times_as_fast(std::span<const double> times, std::span<const double> yardstick_times);

// y = factor * x^exponent, fitted by least squares to the logarithms. All values must be positive.
struct PowerLaw {
    double factor = 0;
    double exponent = 0;
    double exponent_error = 0;  // standard error
};
PowerLaw fit_power_law(std::span<const double> x, std::span<const double> y);

}  // namespace ecods::bench
