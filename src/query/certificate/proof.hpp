// A proof as it is kept: axes, and steps as a row of numbers.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "ecods/pose.hpp"
#include "query/certificate/axis_formula.hpp"

namespace ecods {

// An axis that steps name: a vector of short doubles, or a formula of two triangles that is one of the first three.
struct ProofAxis {
    bool is_given = true;
    Vec3 given = Vec3::Zero();
    AxisFormula formula{};
    std::uint32_t a = 0, b = 0;
};

enum class StepKind : std::uint16_t { open_both, open_a, open_b, triangles };

struct Proof {
    using Word = std::uint16_t;
    static constexpr Word no_axis = 0xffff;

    std::vector<ProofAxis> axes;
    // One step after the other. An opening: its kind, the number of axes, these, the number of pairs left open, these.
    // Two triangles: the step's kind, and the formula's kind, i and j.
    std::vector<Word> words;
    std::size_t step_count = 0;
    std::size_t opening = 0;  // where the last one begins

    void clear() noexcept { *this = {}; }

    // An opening begins, names axes, and ends with what these leave open.
    void begin_opening() {
        opening = words.size();
        words.insert(words.end(), {0, 0});
    }
    // Names an axis in the step, once, and in the proof where `named` is no_axis. Returns false, with nothing named,
    // where the list of axes is full.
    bool name(const ProofAxis& axis, Word& named) {
        if (named == no_axis) {
            if (axes.size() >= no_axis) return false;
            named = static_cast<Word>(axes.size());
            axes.push_back(axis);
        }
        if (std::find(words.begin() + (opening + 2), words.end(), named) == words.end()) {
            words.push_back(named);
            ++words[opening + 1];
        }
        return true;
    }
    void end_opening(StepKind kind, std::span<const Word> left) {
        words[opening] = static_cast<Word>(kind);
        words.push_back(static_cast<Word>(left.size()));
        words.insert(words.end(), left.begin(), left.end());
        ++step_count;
    }

    void add_triangles(const AxisFormula& formula) {
        words.insert(words.end(), {static_cast<Word>(StepKind::triangles), static_cast<Word>(formula.kind),
                                   static_cast<Word>(formula.i), static_cast<Word>(formula.j)});
        ++step_count;
    }
};

}  // namespace ecods
