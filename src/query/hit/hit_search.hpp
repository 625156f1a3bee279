// FirstHit and AllHits find the hits of one line with any number of bodies. Hits are compared exactly, and are rounded
// only at the end.
//
// Each body has a key. If hits of different bodies have the same real parameter, the lesser key comes first. A world
// uses keys that are ordered like the ids of its bodies.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "ecods/hit.hpp"
#include "exact/measure/line/line_hit.hpp"
#include "exact/measure/round/fraction.hpp"
#include "geometry/line.hpp"
#include "geometry/scaled_line.hpp"

namespace ecods {

// A KeyedHit is a hit and the key of the body that is hit.
struct KeyedHit {
    std::uint64_t key = 0;
    Hit hit;
};

struct HitMemory;

// FirstHit finds the least hit, in the order of the real parameters, then of keys, then of triangles.
class FirstHit {
  public:
    // Begins a search for the first hit of `line`, which must be valid. The line and `memory` must outlive the search,
    // and no other search may use `memory` meanwhile. Set `is_alone` only if ask() is called once and offer() never;
    // then the parameter of the hit need not be computed exactly.
    FirstHit(const Line& line, QueryMemory& memory, bool is_alone = false);
    FirstHit(const FirstHit&) = delete;
    FirstHit& operator=(const FirstHit&) = delete;

    // Searches one more body for a lesser hit; keys may be in any order. Tests the triangle witness.b before others. If
    // the body has the least hit so far, sets witness.b to the triangle that is hit.
    void ask(const Posed<MeshShape>& body, std::uint64_t key, PairWitness& witness);
    void ask(const Posed<MeshShape>& body, std::uint64_t key);

    // Searches the given triangles of the body for a lesser hit. The given triangles must include all that the line may
    // hit. `memory` must already be bound to the body.
    void ask_about(std::span<const std::uint32_t> triangles, const Posed<MeshShape>& body, std::uint64_t key,
                   PairWitness& witness);

    // Offers a hit that the caller found in another way. Its real parameter must be exactly `hit.parameter`.
    void offer(const Hit& hit, std::uint64_t key);

    // Calls ask(), which may be another search in the same memory, and returns the result of ask(). That search may
    // overwrite the least hit in the memory, so the least hit is saved before and restored afterwards.
    template <class Function>
    auto beside(const Function& ask) {
        const Kept least = keep();
        auto result = ask();
        put_back(least);
        return result;
    }

    // Returns an upper bound of the parameter of the least hit; infinity if nothing is known. The caller need not
    // search bodies whose boxes the line meets only beyond this parameter.
    double limit() const noexcept { return scaled_.unscaled_above(limit_); }

    bool found() const noexcept { return found_; }
    // Returns the least hit, rounded once. Call it only if found().
    KeyedHit get() const;

  private:
    using Kept = std::shared_ptr<const exact::LineHit>;  // null if nothing was found
    Kept keep() const;
    void put_back(const Kept& least) noexcept;

    template <class Search>
    void take(Search& search, std::uint64_t key, PairWitness& witness);
    bool is_before_least(const exact::Fraction& at, std::uint64_t key, std::uint32_t triangle) const noexcept;

    const Line& line_;
    bool is_alone_;
    ScaledLine scaled_;
    HitMemory& memory_;
    QueryCounts& counts_;
    double limit_;  // upper bound of the scaled parameter of the least hit
    bool found_ = false;
    bool is_rounded_ = false;  // true if all numbers of least_ are already rounded
    KeyedHit least_;
};

// AllHits finds all hits, in the order of their real parameters, then of keys, then of triangles. Hits of one body that
// were passed to offer() stay in the order of the calls.
class AllHits {
  public:
    AllHits(const Line& line, QueryMemory& memory);
    ~AllHits();
    AllHits(const AllHits&) = delete;
    AllHits& operator=(const AllHits&) = delete;

    void ask(const Posed<MeshShape>& body, std::uint64_t key);
    void offer(const Hit& hit, std::uint64_t key);

    // Returns all hits, with their numbers rounded once and their ranks set.
    std::vector<KeyedHit> get();

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace ecods
