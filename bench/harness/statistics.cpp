#include "harness/statistics.hpp"

#include <gsl/gsl_fit.h>
#include <gsl/gsl_sort.h>
#include <gsl/gsl_statistics_double.h>

#include <algorithm>
#include <cmath>

namespace ecods::bench {

double median(std::vector<double> values) {
    return values.empty() ? 0 : gsl_stats_median(values.data(), 1, values.size());
}

double quantile(std::vector<double> values, double share) {
    if (values.empty()) return 0;
    gsl_sort(values.data(), 1, values.size());
    return gsl_stats_quantile_from_sorted_data(values.data(), 1, values.size(), share);
}

double spread_in_percent(std::vector<double> values) {
    if (values.size() < 2) return 0;
    return 100 * (quantile(values, 0.75) - quantile(values, 0.25)) / quantile(values, 0.5);
}

std::string medians_of(std::size_t repetition_count) {
    if (repetition_count == 1) return "one repetition";
    return "medians of " + std::to_string(repetition_count) + " interleaved repetitions";
}

double times_as_fast(std::span<const double> times, std::span<const double> yardstick_times) {
    std::vector<double> ratios;
    for (std::size_t i = 0; i < std::min(times.size(), yardstick_times.size()); ++i)
        ratios.push_back(yardstick_times[i] / times[i]);
    return median(std::move(ratios));
}

PowerLaw fit_power_law(std::span<const double> x, std::span<const double> y) {
    std::vector<double> log_x, log_y;
    for (const double value : x) log_x.push_back(std::log(value));
    for (const double value : y) log_y.push_back(std::log(value));
    double intercept = 0, slope = 0, c00 = 0, c01 = 0, c11 = 0, squares = 0;
    gsl_fit_linear(log_x.data(), 1, log_y.data(), 1, log_x.size(), &intercept, &slope, &c00, &c01, &c11, &squares);
    return {std::exp(intercept), slope, std::sqrt(c11)};
}

}  // namespace ecods::bench
