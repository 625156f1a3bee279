// An Ask says how a question works: in which memory, from which witness it starts, and where its work is counted. All
// of these are optional, and no answer depends on them.
//
//     distance(a, b);                     in memory that the library keeps for the thread
//     distance(a, b, memory);             in the caller's memory
//     distance(a, b, {memory, witness});  starting from what decided the last question about the pair
//     distance(a, b, counts);             adding the work of this question to counts
//
// Example: verify/examples/how_do_i, again_with_a_witness().
#pragma once

#include <array>
#include <concepts>
#include <cstdint>
#include <memory>

#include "ecods/export.hpp"

namespace ecods {

// Counts the pairs of triangles that were decided, by the stage that decided them. Equal input gives equal counts.
struct StageCounts {
    std::uint64_t triangle_tests = 0;      // pairs of triangles
    std::uint64_t filter_passes = 0;       // decided in doubles, by one error bound for both bodies
    std::uint64_t semi_static_passes = 0;  // decided in doubles, by an error bound of the pair of triangles
    std::uint64_t local_passes = 0;  // decided in doubles, because both bodies have the same pose or short coordinates
    std::uint64_t plane_passes = 0;  // decided by known signs of one body's vertices against the other's planes
    std::uint64_t one_limb = 0;      // decided by integers of one limb (60 bits)
    std::uint64_t two_limbs = 0;     // decided by integers of two limbs (125 bits)
    std::uint64_t many_limbs = 0;    // decided by integers of more limbs

    ECODS_API StageCounts& operator+=(const StageCounts& other) noexcept;
    friend bool operator==(const StageCounts&, const StageCounts&) = default;
};

// A Stage holds the name of a stage in reports, and its count.
struct Stage {
    const char* name;
    std::uint64_t StageCounts::*count;
};

// Lists the stages that decide, from the cheapest to the dearest. Their counts add up to triangle_tests.
inline constexpr std::array<Stage, 7> stages{{
    {"filter", &StageCounts::filter_passes},
    {"semi-static", &StageCounts::semi_static_passes},
    {"local", &StageCounts::local_passes},
    {"planes", &StageCounts::plane_passes},
    {"one limb", &StageCounts::one_limb},
    {"two limbs", &StageCounts::two_limbs},
    {"many limbs", &StageCounts::many_limbs},
}};

// Counts the pairs of triangles that the questions of distance.hpp bounded, from the cheapest stage to the dearest.
struct DistanceCounts {
    std::uint64_t triangle_bounds = 0;  // bounded in floats
    std::uint64_t enclosures = 0;       // bounded in doubles, with proven bounds
    std::uint64_t exact = 0;            // rounded or compared exactly

    ECODS_API DistanceCounts& operator+=(const DistanceCounts& other) noexcept;
    friend bool operator==(const DistanceCounts&, const DistanceCounts&) = default;
};

// Counts the triangles that the questions of hit.hpp tested, from the cheapest stage to the dearest.
struct HitCounts {
    std::uint64_t triangle_tests = 0;  // tested in floats, eight at once
    std::uint64_t enclosures = 0;      // bounded in doubles, with proven bounds
    std::uint64_t exact = 0;           // decided, compared or rounded in integers

    ECODS_API HitCounts& operator+=(const HitCounts& other) noexcept;
    friend bool operator==(const HitCounts&, const HitCounts&) = default;
};

// Counts the pairs of triangles whose first contact the questions of cast.hpp computed, from the cheapest stage on.
struct CastCounts {
    std::uint64_t enclosures = 0;  // bounded in doubles, with proven bounds
    std::uint64_t exact = 0;       // computed in integers

    ECODS_API CastCounts& operator+=(const CastCounts& other) noexcept;
    friend bool operator==(const CastCounts&, const CastCounts&) = default;
};

// Counts the work of questions. Equal input gives equal counts.
struct QueryCounts {
    std::uint64_t queries = 0;       // two-body questions about meshes, and questions about a line and a mesh
    std::uint64_t witness_hits = 0;  // queries that the witness decided
    std::uint64_t box_tests = 0;     // tests of two tree nodes, each of up to eight boxes, or of a node and a line
    StageCounts stages;              // pairs of triangles that the trees did not exclude, by stage
    DistanceCounts distances;        // pairs of triangles that distance questions bounded
    HitCounts hits;                  // triangles that lines were tested against
    CastCounts casts;                // pairs of triangles whose first contact was computed

    ECODS_API QueryCounts& operator+=(const QueryCounts& other) noexcept;
    friend bool operator==(const QueryCounts&, const QueryCounts&) = default;
};

// A QueryMemory is scratch memory of questions: stacks, rounded vertices, exact vertices. It grows to the size that the
// largest question needed, and is then reused without allocation. It holds no answer: a question gives the same answer
// with a new memory. Only one question at a time may use it. A question that is asked while another one runs needs a
// memory of its own; the one exception is a two-body test, which passes on the memory that a World gives it
// (shape.hpp).
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

// A witness remembers what decided the last question about a pair of bodies: two triangles, or a separating axis. The
// next question tries the witness first, exactly, and then stores its own witness there. No answer depends on a
// witness, even if it is from another question or other bodies. A new witness is empty. (Bullet, Box3D: manifold or
// simplex cache.)
struct PairWitness {
    static constexpr std::uint32_t none = ~std::uint32_t{0};

    std::uint32_t a = none;
    std::uint32_t b = none;
};

// An Ask is the last argument of every question. It is made of a memory, a witness and counts: any of them, in any
// order. The memory, the witness and the counts must outlive it.
class Ask {
  public:
    Ask() = default;
    template <class... Given>
    requires(sizeof...(Given) > 0 && ((std::same_as<Given, QueryMemory> || std::same_as<Given, PairWitness> ||
                                       std::same_as<Given, QueryCounts>)&&...)) Ask(Given&... given)
    noexcept { (take(given), ...); }

    QueryMemory* memory = nullptr;   // null: memory that the library keeps for the calling thread
    PairWitness* witness = nullptr;  // null: the question starts without a witness
    QueryCounts* counts = nullptr;   // if not null, the work of the question is added here, even if it throws

  private:
    void take(QueryMemory& given) noexcept { memory = &given; }
    void take(PairWitness& given) noexcept { witness = &given; }
    void take(QueryCounts& given) noexcept { counts = &given; }
};

}  // namespace ecods
