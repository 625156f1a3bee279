// Finds the hits of one line with any number of bodies. Hits are compared exactly, and rounded at the end.
//
// Each body has a key, which orders the hits of different bodies at one real parameter. A world's keys have the order
// of the ids.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "ecods/hit.hpp"
#include "exact/measure/round/fraction.hpp"
#include "geometry/line.hpp"
#include "geometry/scaled_line.hpp"

namespace ecods {

// A KeyedHit is a hit and the key of its body.
struct KeyedHit {
    std::uint64_t key = 0;
    Hit hit;
};

struct HitMemory;

// Finds the least hit, in the order of the real parameters, then keys, then triangles.
class FirstHit {
  public:
    // The line must be valid. Line and memory must outlive the search, and the memory must serve one search at a time.
    // If `is_alone`, one body is asked once and nothing is offered; then no parameter need be known exactly.
    FirstHit(const Line& line, QueryMemory& memory, bool is_alone = false);
    FirstHit(const FirstHit&) = delete;
    FirstHit& operator=(const FirstHit&) = delete;

    // Asks one more body, in any order of keys. Tries the triangle `b` of the witness before others. If the hit of the
    // body becomes the least one, leaves its triangle in the witness.
    void ask(const Posed<MeshShape>& body, std::uint64_t key, PairWitness& witness);
    void ask(const Posed<MeshShape>& body, std::uint64_t key);

    // Asks a body that the memory is bound to about these triangles alone, which must be all that the line may hit.
    void ask_about(std::span<const std::uint32_t> triangles, const Posed<MeshShape>& body, std::uint64_t key,
                   PairWitness& witness);

    // Takes a hit that was found in another way. Its real parameter is exactly `hit.parameter`.
    void offer(const Hit& hit, std::uint64_t key);

    // Returns an upper bound of the parameter of the least hit, rounded upwards; infinity if nothing is known. A body
    // whose box the line meets only beyond it need not be asked.
    double limit() const noexcept { return scaled_.unscaled_above(limit_); }

    bool found() const noexcept { return found_; }
    // Returns the least hit, rounded once. Requires found().
    KeyedHit get() const;

  private:
    template <class Search>
    void take(Search& search, std::uint64_t key, PairWitness& witness);
    bool is_before_least(const exact::Fraction& at, std::uint64_t key, std::uint32_t triangle) const noexcept;

    const Line& line_;
    bool is_alone_;
    ScaledLine scaled_;
    HitMemory& memory_;
    QueryCounts& counts_;
    double limit_;  // upper bound of the scaled parameter
    bool found_ = false;
    bool is_rounded_ = false;  // true if the numbers of least_ are final
    KeyedHit least_;
};

// Finds all hits, in the order of FirstHit.
class AllHits {
  public:
    AllHits(const Line& line, QueryMemory& memory);
    ~AllHits();
    AllHits(const AllHits&) = delete;
    AllHits& operator=(const AllHits&) = delete;

    void ask(const Posed<MeshShape>& body, std::uint64_t key);
    void offer(const Hit& hit, std::uint64_t key);

    // Returns all hits, rounded once, with ranks.
    std::vector<KeyedHit> get();

  private:
    struct State;
    class Collector;
    std::unique_ptr<State> state_;
};

}  // namespace ecods
