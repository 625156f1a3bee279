// A Proof holds a list of axes, and the steps of a proof as one sequence of words.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "ecods/pose.hpp"
#include "query/certificate/axis_formula.hpp"

namespace ecods {

// A ProofAxis is an axis that steps refer to by its index. It is a vector of doubles with few digits (`given`), or a
// formula of one of the first three kinds, for triangles a and b.
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
    // Holds the steps of the proof, one after the other. An opening has these words: its kind, the number of axes, the
    // axes, the number of pairs left open, the open pairs. A pair of triangles has these words: the step's kind, the
    // formula's kind, and the formula's i and j.
    std::vector<Word> words;
    std::size_t step_count = 0;
    std::size_t opening = 0;  // index of the last opening's first word

    void clear() noexcept { *this = {}; }

    // Begins an opening. Afterwards name() adds the axes of the opening, and end_opening() the pairs that the axes
    // leave open.
    void begin_opening() {
        opening = words.size();
        words.insert(words.end(), {0, 0});
    }
    // Adds an axis to the current opening, unless the opening has it already. If `named` is no_axis, first appends the
    // axis to the proof's list and sets `named` to its index. Returns false, and changes nothing, if the list is full.
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
