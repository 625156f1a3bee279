// A check asks inner bounds about one case at a time, with any guess, in any mode and with any set of instructions, and
// requires that the truth is inside.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "environment/float_mode.hpp"
#include "environment/instruction_sets.hpp"
#include "scenes/random.hpp"

namespace ecods::guesses {

struct Tally {
    std::uint64_t asked = 0;    // bounds that were asked
    std::uint64_t telling = 0;  // of these, those that say something: most may not be near the truth
};

// One case of a check: everything in it comes of its numbers.
class Case {
  public:
    Case(std::uint32_t seed, Tally& of_all) : random(seed), tally(of_all) {}

    // Keeps the first thing that does not hold.
    void require(bool holds, std::string_view what, std::string_view where = "") {
        ++tally.asked;
        if (holds || is_wrong()) return;
        wrong = what;
        if (!where.empty()) wrong += " (" + std::string(where) + ")";
    }
    bool is_wrong() const noexcept { return !wrong.empty(); }

    scenes::Random random;
    Tally& tally;
    std::string wrong;
};

struct Check {
    std::string_view name;
    void (*ask)(Case&);
    std::uint32_t cases;  // of the short run
    double telling_min;   // share of the bounds that say something, below which the check proves little
};
std::span<const Check> checks();

void ask_distance(Case& c);
void ask_contact(Case& c);
void ask_near(Case& c);
void ask_far(Case& c);
void ask_swept(Case& c);
void ask_meeting(Case& c);
void ask_moving(Case& c);
void ask_overlap(Case& c);
void ask_axis_ray(Case& c);
void ask_hits(Case& c);
void ask_line(Case& c);
void ask_convex(Case& c);
void ask_point(Case& c);

// Calls evaluate() in the mode; not inlined, so that no operation leaves it.
template <class Evaluate>
[[gnu::noinline]] auto in_mode(const environment::FloatMode& mode, Evaluate&& evaluate) {
    const environment::InFloatMode in(mode);
    return evaluate();
}

// Calls use(mode) for each of them.
template <class Use>
void for_each_mode(Use&& use) {
    for (const environment::FloatMode& mode : environment::float_modes) use(mode);
}
// The same with every set of instructions.
template <class Use>
void for_each_set_and_mode(Use&& use) {
    static const auto sets = environment::supported_instruction_sets();
    for (const InstructionSet set : sets) {
        const environment::InstructionSetLimit limit(set);
        for_each_mode([&](const environment::FloatMode& mode) {
            use(mode, std::string(environment::name(set)) + ", " + mode.name);
        });
    }
}
inline const environment::FloatMode& some_mode(scenes::Random& random) {
    return environment::float_modes[random.below(environment::float_modes.size())];
}

}  // namespace ecods::guesses
