#include "query/cast/way_time.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>

#include "base/double_key.hpp"
#include "exact/measure/round/long_rounding.hpp"

namespace ecods {
namespace {

exact::ScaledInteger whole_number(std::size_t number) {
    return {exact::Integer(static_cast<std::int64_t>(number)), 0};
}

}  // namespace

double time_on_way(std::size_t leg, double time_in_leg, std::size_t leg_count) {
    const exact::ScaledInteger sum = whole_number(leg) + exact::ScaledInteger(time_in_leg);
    const double time = exact::round_quotient(sum, whole_number(leg_count));
    return key_of(time) == 0 && sum.sign() != 0 ? std::numeric_limits<double>::denorm_min() : time;
}

std::size_t legs_begun(double time, std::size_t leg_count) {
    std::size_t begun = 1, end = leg_count;  // the first leg that begins later is in [begun, end]
    while (begun < end) {
        const std::size_t middle = begun + (end - begun) / 2;
        if (key_of(time_on_way(middle, 0, leg_count)) <= key_of(time)) {
            begun = middle + 1;
        } else {
            end = middle;
        }
    }
    return begun;
}

}  // namespace ecods
