// Everything that include/ecods/distance.hpp answers about two bodies, judged by the oracle.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ecods/distance.hpp"
#include "ecods/intersection.hpp"
#include "judge/wrong.hpp"
#include "oracle/distance.hpp"

namespace ecods::judge {

// As the library writes them.
Feature to_feature(const oracle::NamedFeature& feature);
ClosestPoints to_closest_points(const oracle::ExactClosest& exact);

// Whether all of it is the same, bit for bit.
bool is_same(const ClosestPoints& x, const ClosestPoints& y);

// The double that follows x >= 0, or the one before it (step -1), in any floating-point environment.
double neighbour(double x, int step);

// In hexadecimal floats.
std::string text(const ClosestPoints& closest);
std::string text(double x);

// Which questions are asked, beside distance, within and closest.
struct Questions {
    bool has_bounds = true;
    bool has_lists = true;  // close_triangles, close_features, intersections; their length grows with the meshes
};

// What is true of two posed meshes, known before the library is asked: it may be asked in any floating-point
// environment.
class DistanceTruth {
  public:
    DistanceTruth(const Posed<MeshShape>& a, const Posed<MeshShape>& b, const Questions& questions = {});

    const oracle::ExactRoot& exact() const { return exact_; }
    double distance() const { return closest_.distance; }
    const ClosestPoints& closest() const { return closest_; }

    // Asks all of it, in both orders, and with the witness, which may come from anywhere.
    std::optional<Wrong> ask(QueryMemory& memory, PairWitness& witness) const;

  private:
    struct Within {
        double d;
        bool is_within;
    };
    struct List {
        double d;
        std::vector<ClosestPoints> closest;
        std::vector<CloseFeatures> features;
    };
    std::optional<Wrong> ask_distance(QueryMemory& memory, PairWitness& witness) const;
    std::optional<Wrong> ask_counts(QueryMemory& memory) const;  // of Ask, beside those of the memory
    std::optional<Wrong> ask_closest(QueryMemory& memory, PairWitness& witness) const;
    std::optional<Wrong> ask_bounds(QueryMemory& memory, PairWitness& witness) const;
    std::optional<Wrong> ask_lists(QueryMemory& memory) const;
    // Nothing, or what is wrong with it.
    std::optional<std::string> defect(const DistanceBounds& bounds, const DistanceTolerance& tolerance) const;

    Posed<MeshShape> a_, b_;
    oracle::ExactRoot exact_;
    ClosestPoints closest_, mirrored_;  // mirrored: of b and a
    std::vector<Within> within_;
    std::vector<DistanceTolerance> tolerances_;
    std::vector<List> lists_;
    std::optional<std::vector<TriangleIntersection>> intersections_;
};

}  // namespace ecods::judge
