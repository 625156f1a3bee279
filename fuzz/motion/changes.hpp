// What happens to a scene beside single moves: lives, shapes, filters, many poses at once, bad input.
#pragma once

#include <cstdint>
#include <map>
#include <span>

#include "fuzz/motion/setting.hpp"
#include "fuzz/script/script.hpp"

namespace ecods::fuzz {

// A script under way, and all that its next call is drawn from.
struct Writing {
    const Setting& setting;
    scenes::Random& random;
    Counters& counters;
    Script script = {};
    Model model = {};
    std::map<Label, Pose> homes = {};  // where bodies were created

    void make(Call call);
    void create(const Part& part, const Pose& pose);
    Label any_body();  // there must be one
    const Part& any_part();
    Pose next_pose(Label body, std::uint32_t Weights::*group);
};

struct Change {
    const char* name;
    std::uint32_t Weights::*group;
    void (*make)(Writing&);
};
std::span<const Change> changes();

}  // namespace ecods::fuzz
