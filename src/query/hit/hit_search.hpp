// The hits of one line with any number of bodies, compared exactly and rounded at the end.
//
// A body has a key, which orders hits of different bodies at one real parameter: a world's has the order of the ids.
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

// A hit, and the body that has it.
struct KeyedHit {
    std::uint64_t key = 0;
    Hit hit;
};

struct HitMemory;

// The least hit in the order of the real parameters, then keys, then triangles.
class FirstHit {
  public:
    // The line is valid; line and memory must outlive the search, which may be the memory's only one at a time. If
    // `is_alone`, one body is asked once and nothing is offered: nothing need be known exactly then.
    FirstHit(const Line& line, QueryMemory& memory, bool is_alone = false);
    FirstHit(const FirstHit&) = delete;
    FirstHit& operator=(const FirstHit&) = delete;

    // Asks one more body, in any order of keys. Tries the witness's triangle `b` before others, and leaves the one that
    // the body is hit at if its hit has become the least one.
    void ask(const Posed<MeshShape>& body, std::uint64_t key, PairWitness& witness);
    void ask(const Posed<MeshShape>& body, std::uint64_t key);

    // Asks a body that the memory is bound to about these triangles alone: all that the line may hit.
    void ask_about(std::span<const std::uint32_t> triangles, const Posed<MeshShape>& body, std::uint64_t key,
                   PairWitness& witness);

    // A hit that somebody else found: its parameter is the real number that `hit.parameter` is.
    void offer(const Hit& hit, std::uint64_t key);

    // No point of the line beyond this parameter can be of the least hit: an upper bound, rounded upwards; infinity
    // where nothing is known. What boxes are beyond it need not be asked.
    double limit() const noexcept { return scaled_.unscaled_above(limit_); }

    bool found() const noexcept { return found_; }
    // The least hit, rounded once. Only if found().
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
    double limit_;  // of the scaled parameter
    bool found_ = false;
    bool is_rounded_ = false;  // by whoever offered it
    KeyedHit least_;
};

// All hits, in the same order.
class AllHits {
  public:
    AllHits(const Line& line, QueryMemory& memory);
    ~AllHits();
    AllHits(const AllHits&) = delete;
    AllHits& operator=(const AllHits&) = delete;

    void ask(const Posed<MeshShape>& body, std::uint64_t key);
    void offer(const Hit& hit, std::uint64_t key);

    // All of them, rounded once, with ranks.
    std::vector<KeyedHit> get();

  private:
    struct State;
    class Collector;
    std::unique_ptr<State> state_;
};

}  // namespace ecods
