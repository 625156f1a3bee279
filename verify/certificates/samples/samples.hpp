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

// A square of 2 across^2 triangles, and the certificates of two of them that lie flush on each other or nearly so.
std::shared_ptr<const MeshShape> plate(std::uint32_t across);
void make_flush_samples(std::uint32_t across, std::uint32_t seed, const std::function<void(const Sample&)>& take);

// Of ships and of two tori, pairs that are 1e-4 radii apart: their relation, their distance, and that they are further
// apart than half of that. All certificates of one mesh are about the same shape.
void make_gap_samples(std::size_t count, std::uint32_t seed, const std::function<void(const Sample&)>& take);

// The certificates of worlds of a dozen bodies, some of them touching, crossing, filtered out or switched off: for each
// broad phase `count` worlds, each without and with clearances.
void make_worlds(std::size_t count, std::uint32_t seed, const std::function<void(const WorldCertificate&)>& take);

}  // namespace ecods::certificates
