// The float filter: doubles with a proven bound, asked before integers. It says only "surely apart", and which corners
// are surely no extremes; without it (--exact) the same proofs are accepted, only later. README.md, section 6.
#pragma once

#include <algorithm>
#include <memory>
#include <span>

#include "certificate.hpp"
#include "mesh.hpp"

namespace certificate_checker {

// Of at most 64 parts each.
using Pairs = std::array<std::uint64_t, parts_max>;

class Filter {
  public:
    // Parts are surely apart if their gap is greater than m |n|. So many axes stay as they are once steps begin.
    Filter(const PosedMesh& a, const PosedMesh& b, double m, std::size_t axis_count, Budget& budget);

    // Sets axis k, behind those set so far or in place of one: of parts of a and b that are triangles.
    void set_axis(std::size_t k, const AxisLine& source, const std::array<std::uint32_t, 2>& triangles);
    // Begins a step, with parts of a and b, along axes that are set. Of the pairs in `left`, of part i of a's with each
    // part j of b's whose bit j is set in left[i], those that are surely apart along one of these axes are taken out.
    void open(const std::array<Node, 2>& parts, std::span<const std::uint32_t> axes, Pairs& left);
    // Of this step: along which of its axes parts i and j seem to be furthest apart.
    std::size_t best_axis(std::uint32_t i, std::uint32_t j);
    // Corners of part i of a side, among them all that are least or greatest along the step's axis k.
    const std::vector<std::uint32_t>& extremes(std::size_t side, std::size_t k, std::uint32_t i);

  private:
    struct Range {
        double low, high;
    };
    // Of a node's parts along an axis: their low ends begin there in ends_, their high ends behind them; each are
    // followed by any numbers up to a multiple of eight. Bit i is set if the range of part i is that of its corners,
    // not of a box around them.
    struct Ranges {
        std::size_t begin;
        std::uint64_t best;
    };
    static constexpr std::size_t lanes = 8;
    static std::size_t padded(std::size_t count) { return (count + lanes - 1) / lanes * lanes; }
    // Along a vector n, vertex v of the mesh, posed, is at v.n + offset, but for at most `error`. So are the corners of
    // boxes.
    struct Direction {
        std::array<double, 3> n{};
        double offset = 0, error = 0;
    };
    struct Side {
        const Mesh* mesh;
        const Pose* pose;
        std::array<double, 3> offset{};     // t - a's t, rounded
        std::array<double, 3> magnitude{};  // the sum of absolute values of R's row times vertex, and of t - a's t
        bool is_moderate = true;            // no double can overflow
        Node parts{};                       // of the step
        std::vector<std::size_t> ranges{};  // of the step's axis k: where those of its parts are in ranges_
        std::vector<std::uint32_t> rows{};  // of a node: 1 + its row in places_, 0 if it has none yet
    };
    struct Axis {
        std::array<Direction, 2> along;  // of a and of b
        double need = 0;                 // a gap in doubles that is greater than this proves that parts are apart
    };

    static void measure_boxes(const Mesh& mesh, std::uint32_t first, std::size_t count, const Direction& d,
                              double* ends);
    static void measure_leaf(const Mesh& mesh, const Node& leaf, const Direction& d, double* ends);
    Range range(const Side& side, std::uint32_t part, const Direction& d);
    double* add_ends(std::size_t count);
    Ranges measure(const Side& side, const Node& parts, const Direction& d);
    std::size_t place_of_ranges(std::size_t side, std::uint32_t axis);
    bool take_out(std::size_t k, Pairs& left);
    template <class Use>
    void visit(const Side& side, std::uint32_t part, const Direction& d, const Range& inner, const Use& use);
    // Of the step's axis k.
    Ranges& ranges_of(std::size_t side, std::size_t k) { return ranges_[sides_[side].ranges[k]]; }
    const double* ends_of(std::size_t side, std::size_t k) { return &ends_[ranges_of(side, k).begin]; }
    Range range_of(std::size_t side, std::size_t k, std::uint32_t i) {
        const double* const ends = ends_of(side, k);
        return {ends[i], ends[padded(sides_[side].parts.count) + i]};
    }
    // By how much the gap of two ranges exceeds what it needs; so of parts i and j along axis k of the step.
    static double excess(const Range& a, const Range& b, double need) {
        return std::max(b.low - a.high, a.low - b.high) - need;
    }
    double excess(std::size_t k, std::uint32_t i, std::uint32_t j) {
        return excess(range_of(0, k, i), range_of(1, k, j), axes_[named_[k]].need);
    }
    bool are_apart_by_corners(std::uint32_t i, std::uint32_t j);

    std::array<Side, 2> sides_;
    double m_;
    Budget* budget_;
    std::vector<Axis> axes_;
    std::span<const std::uint32_t> named_;
    // Of the parts of each node that was opened, along each axis that was named then, and of the step.
    std::vector<Ranges> ranges_;
    std::unique_ptr<double[]> ends_;  // not set where it is not used yet
    std::size_t ends_used_ = 0;
    std::size_t ends_size_ = 0;
    std::vector<std::size_t> places_;  // rows: for each axis 1 + where the node's are in ranges_, 0 if they are not set
    std::size_t axis_count_;           // a row's length
    std::vector<std::uint32_t> extremes_;
};

}  // namespace certificate_checker
