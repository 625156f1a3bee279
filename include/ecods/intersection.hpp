// Questions about two bodies. No World is needed.
//
// Each answer is exact for the real points R v + t, and depends on the bits of meshes and poses alone: swapping
// the bodies gives the same answer (and swapped triangle pairs). A pose must be finite (validate(Pose)); a query does
// not check it.
//
// Thread safety: shapes are immutable, so queries may run from many threads, each with a QueryMemory of its own.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "ecods/export.hpp"
#include "ecods/ids.hpp"
#include "ecods/posed.hpp"
#include "ecods/predicates.hpp"
#include "ecods/shape.hpp"

namespace ecods {

// How many pairs of triangles were decided, and by which stage. Counts are exact: the same input gives the same counts.
struct StageCounts {
    std::uint64_t triangle_tests = 0;      // pairs of triangles
    std::uint64_t filter_passes = 0;       // of these, decided by the bound of the body pair
    std::uint64_t semi_static_passes = 0;  // ... by the bound of the triangle pair
    std::uint64_t local_passes = 0;        // ... because both bodies have one pose or short coordinates
    std::uint64_t plane_passes = 0;        // ... by signs that were known of whole planes
    std::uint64_t one_limb = 0;            // ... by integers of one limb (60 bits)
    std::uint64_t two_limbs = 0;           // ... of two limbs (125 bits)
    std::uint64_t many_limbs = 0;          // ... of more

    ECODS_API StageCounts& operator+=(const StageCounts& other) noexcept;
    friend bool operator==(const StageCounts&, const StageCounts&) = default;
};

// A stage's name in reports, and its count.
struct Stage {
    const char* name;
    std::uint64_t StageCounts::*count;
};

// The stages that decide, from the cheapest to the dearest: their counts add up to triangle_tests.
inline constexpr std::array<Stage, 7> stages{{
    {"filter", &StageCounts::filter_passes},
    {"semi-static", &StageCounts::semi_static_passes},
    {"local", &StageCounts::local_passes},
    {"planes", &StageCounts::plane_passes},
    {"one limb", &StageCounts::one_limb},
    {"two limbs", &StageCounts::two_limbs},
    {"many limbs", &StageCounts::many_limbs},
}};

// How many pairs of triangles were bounded, from the cheapest stage to the dearest, by the questions of distance.hpp.
struct DistanceCounts {
    std::uint64_t triangle_bounds = 0;  // in floats
    std::uint64_t enclosures = 0;       // in doubles with proven bounds
    std::uint64_t exact = 0;            // rounded or compared exactly

    ECODS_API DistanceCounts& operator+=(const DistanceCounts& other) noexcept;
    friend bool operator==(const DistanceCounts&, const DistanceCounts&) = default;
};

// How many triangles were asked, from the cheapest stage to the dearest, by the questions of hit.hpp.
struct HitCounts {
    std::uint64_t triangle_tests = 0;  // in floats, eight at once
    std::uint64_t enclosures = 0;      // in doubles with proven bounds
    std::uint64_t exact = 0;           // decided, compared or rounded in integers

    ECODS_API HitCounts& operator+=(const HitCounts& other) noexcept;
    friend bool operator==(const HitCounts&, const HitCounts&) = default;
};

// How many pairs of triangles were asked when they first share a point, by the questions of cast.hpp, from the cheapest
// stage to the dearest.
struct CastCounts {
    std::uint64_t triangle_bounds = 0;  // in floats
    std::uint64_t enclosures = 0;       // in doubles with proven bounds
    std::uint64_t exact = 0;            // in integers

    ECODS_API CastCounts& operator+=(const CastCounts& other) noexcept;
    friend bool operator==(const CastCounts&, const CastCounts&) = default;
};

// The work of queries as exact counts.
struct QueryCounts {
    std::uint64_t queries = 0;       // two-body queries of meshes, and lines asked of one
    std::uint64_t witness_hits = 0;  // of these, decided by what decided last time
    std::uint64_t box_tests = 0;     // pairs of tree nodes, up to eight boxes against eight each, or nodes and lines
    StageCounts stages;              // of the pairs of triangles that the trees left over
    DistanceCounts distances;        // of these where distances are asked for
    HitCounts hits;                  // of the triangles that lines are asked of
    CastCounts casts;                // of these where times are asked for

    ECODS_API QueryCounts& operator+=(const QueryCounts& other) noexcept;
    friend bool operator==(const QueryCounts&, const QueryCounts&) = default;
};

// The memory that queries work in: stacks, rounded vertices, exact vertices. It grows to what the largest query
// needed and is then used again without allocation. It holds no answer: a query gives the same with a new one.
class ECODS_API QueryMemory {
  public:
    QueryMemory();
    ~QueryMemory();
    QueryMemory(QueryMemory&&) noexcept;
    QueryMemory& operator=(QueryMemory&&) noexcept;

    const QueryCounts& counts() const noexcept;
    void reset_counts() noexcept;

  private:
    friend struct QueryMemoryAccess;

    struct ECODS_HIDDEN State;
    std::unique_ptr<State> state_;
};

// Whether the bodies share a point; stops at the first one found.
ECODS_API bool intersects(const Posed<MeshShape>& a, const Posed<MeshShape>& b, QueryMemory& memory);

// The same, for a pair that was asked about before and has moved little: tries the witness first, and leaves a new one.
ECODS_API bool intersects(const Posed<MeshShape>& a, const Posed<MeshShape>& b, QueryMemory& memory,
                          PairWitness& witness);

// Disjoint, touching or crossing: the strongest relation of any two of their triangles. Stops at the first crossing.
ECODS_API Relation relation(const Posed<MeshShape>& a, const Posed<MeshShape>& b, QueryMemory& memory);

// Every pair of triangles that share a point, ascending.
ECODS_API std::vector<TrianglePair> intersecting_triangles(const Posed<MeshShape>& a, const Posed<MeshShape>& b,
                                                           QueryMemory& memory);

}  // namespace ecods
