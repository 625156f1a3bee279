// Certificates of many kinds, for what checks the checkers.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "ecods/certificate.hpp"
#include "ecods/shape.hpp"

namespace ecods::certificates {

// A certificate and the shapes that it is about; of a hit or a miss, one.
struct Sample {
    std::string name;  // of the family and the question
    std::shared_ptr<const MeshShape> a, b;
    Certificate certificate;
};

// Calls `take` with the certificates of `count` cases of each family of hard pairs, distances and hits: the relation,
// the distance, and whether that is within itself, its neighbours, half and twice itself; and the first hits of
// segments.
void make_samples(std::size_t count, std::uint32_t seed, const std::function<void(const Sample&)>& take);

}  // namespace ecods::certificates
