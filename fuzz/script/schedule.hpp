// With which instruction set each world of a scene works, and how it is asked: by counters, so that a script that is
// played again meets the same, and every combination comes equally often, however many sets the processor supports.
#pragma once

#include <cstddef>
#include <numeric>

namespace ecods::fuzz {

// The index of the instruction set that a world uses in a round, of set_count sets. In set_count rounds each world uses
// each set once, and neighbouring worlds, whose answers are compared, never use the same one if there are two.
constexpr std::size_t scheduled_set(std::size_t round, std::size_t world, std::size_t set_count) noexcept {
    return (round + world) % set_count;
}

// Who is asked in a check, in which environment; all are indices.
struct Turn {
    std::size_t world = 0;
    std::size_t set = 0;
    std::size_t mode = 0;  // of float_modes
    friend constexpr bool operator==(const Turn&, const Turn&) = default;
};

// The value, of `count`, that comes with the n-th of combinations that repeat after `period`. It goes on by one each
// time; where the period and the count have a common factor, it would meet only some combinations so, and skips one
// whenever both come back to where they began. After period * count times, all have met all once, and it begins again.
constexpr std::size_t skewed(std::size_t n, std::size_t period, std::size_t count) noexcept {
    return (n + n / std::lcm(period, count) % std::gcd(period, count)) % count;
}

// In world_count * set_count * mode_count checks each combination comes once; in world_count * set_count of them, each
// of world and set. After any number of checks the sets differ by one at most.
constexpr Turn scheduled_turn(std::size_t check, std::size_t world_count, std::size_t set_count,
                              std::size_t mode_count) noexcept {
    return {.world = check % world_count,
            .set = skewed(check, world_count, set_count),
            .mode = skewed(check, world_count * set_count, mode_count)};
}

}  // namespace ecods::fuzz
