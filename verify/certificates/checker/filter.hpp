// The float filter: doubles with a proven bound, asked before integers. It says only "surely apart", and which corners
// are surely no extremes; without it (--exact) the same proofs are accepted, only later. README.md, section 6.
#pragma once

#include <span>

#include "certificate.hpp"
#include "mesh.hpp"

namespace certificate_checker {

class Filter {
  public:
    // Parts are surely apart if their gap is greater than m |n|.
    Filter(const PosedMesh& a, const PosedMesh& b, double m, Budget& budget);

    // Sets axis k, behind those set so far or in place of one: of parts of a and b that are triangles.
    void set_axis(std::size_t k, const AxisLine& source, const std::array<std::uint32_t, 2>& triangles);
    // Begins a step, with parts of a and b, along axes that are set.
    void open(const std::array<Node, 2>& parts, std::span<const std::uint32_t> axes);
    // Of this step, parts i of a's and j of b's: whether they are surely apart along one of its axes.
    bool are_apart(std::uint32_t i, std::uint32_t j);
    // Corners of part i of a side, among them all that are least or greatest along the step's axis k.
    const std::vector<std::uint32_t>& extremes(std::size_t side, std::size_t k, std::uint32_t i);

  private:
    struct Range {
        double low, high;
    };
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
        // Of the step: part i, axis k at k * count of parts + i.
        Node parts{};
        std::vector<Range> ranges{};
        std::vector<std::uint8_t> is_best{};  // by corners, not by boxes
    };
    struct Axis {
        std::array<Direction, 2> along;  // of a and of b
        double need = 0;                 // a gap in doubles that is greater than this proves that parts are apart
    };

    static Range box_range(const Side& side, std::uint32_t node, const Direction& d);
    Range range(const Side& side, std::uint32_t part, const Direction& d);
    template <class Use>
    void visit(const Side& side, std::uint32_t part, const Direction& d, const Range& inner, const Use& use);
    void sharpen(std::size_t side, std::size_t k, std::uint32_t i);

    std::array<Side, 2> sides_;
    double m_;
    Budget* budget_;
    std::vector<Axis> axes_;
    std::span<const std::uint32_t> named_;
    std::vector<double> excess_;  // by how much the greatest gap of each pair exceeds what it needs
    std::vector<std::uint32_t> extremes_;
};

}  // namespace certificate_checker
