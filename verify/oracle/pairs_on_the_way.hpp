// The first contact of two meshes of which one or both move, out of the contacts of their pairs of triangles.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "oracle/first_contact.hpp"
#include "oracle/pair_motion.hpp"

namespace ecods::oracle {

struct PairsOnTheWay {
    Soup a, b;                                                              // at time 0
    std::vector<TrianglePair> at_start;                                     // all that may share a point at time 0
    std::vector<TrianglePair> on_the_way;                                   // all that may share a point up to time 1
    std::function<bool(const TrianglePair& pair, double until)> are_apart;  // true if that is proven, up to a time
    std::function<std::unique_ptr<PairMotion>(const TrianglePair& pair)> motion;
};

std::optional<ExactContact> first_of(const PairsOnTheWay& pairs);

}  // namespace ecods::oracle
