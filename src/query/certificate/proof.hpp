// A proof as it is kept: axes, and steps as a row of numbers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "ecods/pose.hpp"

namespace ecods {

// A vector that two triangles give, one of a and one of b (verify/certificates/README.md, FORMULA).
struct AxisFormula {
    enum class Kind : std::uint8_t {
        normal_a,
        normal_b,
        edges,          // edge i of a's  x  edge j of b's
        edge_a,         // edge i of a's  x  coordinate axis j
        edge_b,         // edge i of b's  x  coordinate axis j
        coordinate,     // coordinate axis i
        vertices,       // corner j of b's - corner i of a's
        vertex_a_edge,  // from edge j of b's to corner i of a's, at right angles to the edge
        vertex_b_edge,  // from edge j of a's to corner i of b's
    };

    Kind kind = Kind::normal_a;
    std::uint8_t i = 0;
    std::uint8_t j = 0;

    friend bool operator==(const AxisFormula&, const AxisFormula&) = default;
};

// An axis that steps name: a vector of short doubles, or a formula of two triangles that is one of the first three.
struct ProofAxis {
    bool is_given = true;
    Vec3 given = Vec3::Zero();
    AxisFormula formula{};
    std::uint32_t a = 0, b = 0;
};

enum class StepKind : std::uint16_t { open_both, open_a, open_b, apart, triangles };

struct Proof {
    using Word = std::uint16_t;

    std::vector<ProofAxis> axes;
    // One step after the other. An opening: its kind, the number of axes, these, the number of pairs left open, these.
    // A pair that is apart: its kind and the axis. Two triangles: its kind, and the formula's kind, i and j.
    std::vector<Word> words;
    std::size_t step_count = 0;

    void clear() noexcept {
        axes.clear();
        words.clear();
        step_count = 0;
    }

    void add_opening(StepKind kind, std::span<const Word> of_axes, std::span<const Word> left) {
        words.push_back(static_cast<Word>(kind));
        words.push_back(static_cast<Word>(of_axes.size()));
        words.insert(words.end(), of_axes.begin(), of_axes.end());
        words.push_back(static_cast<Word>(left.size()));
        words.insert(words.end(), left.begin(), left.end());
        ++step_count;
    }
    void add_apart(Word axis) {
        words.insert(words.end(), {static_cast<Word>(StepKind::apart), axis});
        ++step_count;
    }
    void add_triangles(const AxisFormula& formula) {
        words.insert(words.end(), {static_cast<Word>(StepKind::triangles), static_cast<Word>(formula.kind),
                                   static_cast<Word>(formula.i), static_cast<Word>(formula.j)});
        ++step_count;
    }
};

}  // namespace ecods
