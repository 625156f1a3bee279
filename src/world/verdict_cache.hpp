// Caches the verdicts of the candidate pairs: a verdict holds while neither body of its pair changes.
//
// The ECoDS report calls this the collision cache: a pair that did not move is not tested again. The cache holds
// exactly the pairs whose boxes overlap, filtered-out pairs included, since a change of filters must find them.
//
// Verdicts are stored in one array. Each verdict is in two doubly linked lists, one for each of its bodies; the verdict
// stores the links. So the pairs of a body that moved are found without hashing. A pair that ends is found by a hash
// table, by its two bodies. Memory: 44 bytes a verdict, 4 bytes a body, and 8 bytes for each place of the table; at
// least a quarter of the places are empty.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "ecods/broad_phase.hpp"
#include "ecods/ids.hpp"
#include "ecods/shape.hpp"

namespace ecods {

// A VerdictIndex is the index of a verdict in the array. The index stays valid until some verdict is removed.
using VerdictIndex = std::uint32_t;
inline constexpr VerdictIndex no_verdict = ~VerdictIndex{0};

// Holds the answer of the current update for a pair. It is `none` until the pair is tested.
enum class Answer : std::uint8_t { none, filtered_out, no, yes };

struct Verdict {
    BodyPair bodies;                     // ids of the bodies when the pair began
    std::array<VerdictIndex, 2> next{};  // links in the lists of bodies.a and of bodies.b
    std::array<VerdictIndex, 2> previous{};
    PairWitness witness{};         // left by the last test of the pair
    bool is_enabled = false;       // true if the last test was not filtered out; false before a test
    bool is_positive = false;      // true if the last answer was yes; false unless enabled
    Answer answer = Answer::none;  // set by the current update, if it processes the pair

    ProxyPair proxies() const noexcept { return {bodies.a.slot - 1, bodies.b.slot - 1}; }
};

class VerdictCache {
  public:
    // Reserves memory for `verdict_count` verdicts altogether, whose proxies are below `proxy_end`. Up to this number
    // of verdicts, add() does not throw. Capacity grows geometrically, even if callers reserve in small steps.
    void reserve(std::size_t verdict_count, std::size_t proxy_end);

    void add(const BodyPair& bodies) noexcept;  // the pair must not be cached yet; its memory must be reserved
    Verdict remove(ProxyPair pair) noexcept;    // the pair must be cached; indices of other verdicts may change

    VerdictIndex find(ProxyPair pair) const noexcept;  // no_verdict if the pair is not cached
    const Verdict& operator[](VerdictIndex index) const noexcept { return verdicts_[index]; }
    void set(VerdictIndex index, bool is_enabled, bool is_positive) noexcept;
    PairWitness& witness(VerdictIndex index) noexcept { return verdicts_[index].witness; }
    Answer& answer(VerdictIndex index) noexcept { return verdicts_[index].answer; }

    VerdictIndex size() const noexcept { return static_cast<VerdictIndex>(verdicts_.size()); }
    std::size_t enabled_count() const noexcept { return enabled_count_; }

    // Iterate over the verdicts of a body, in no promised order: begin with first(proxy), continue with next(index,
    // proxy), and end at no_verdict.
    VerdictIndex first(ProxyIndex proxy) const noexcept { return proxy < firsts_.size() ? firsts_[proxy] : no_verdict; }
    VerdictIndex next(VerdictIndex index, ProxyIndex proxy) const noexcept {
        return verdicts_[index].next[side_of(proxy, index)];
    }
    ProxyIndex proxy_end() const noexcept { return static_cast<ProxyIndex>(firsts_.size()); }

    std::size_t memory_bytes() const noexcept;

    // Throws BrokenInvariant if the table, the lists and the counts do not agree with the verdicts.
    void validate() const;

  private:
    struct Place {
        std::uint32_t hash = 0;
        VerdictIndex index = no_verdict;  // no_verdict if the place is empty
    };

    int side_of(ProxyIndex proxy, VerdictIndex index) const noexcept {
        return verdicts_[index].bodies.a.slot - 1 == proxy ? 0 : 1;
    }
    static std::uint32_t hash_of(ProxyPair pair) noexcept;
    std::size_t place_of(
        ProxyPair pair) const noexcept;  // the place of the pair, or the empty place where it would be stored
    void take_place(VerdictIndex index) noexcept;
    void free_place(std::size_t place) noexcept;
    void link(VerdictIndex index, int side) noexcept;
    void link_neighbours(const Verdict& verdict, int side, VerdictIndex back, VerdictIndex on) noexcept;
    void unlink(VerdictIndex index, int side) noexcept;
    void relocate(VerdictIndex from, VerdictIndex to) noexcept;

    std::vector<Verdict> verdicts_;
    std::vector<VerdictIndex> firsts_;  // by proxy: first verdict of its list
    std::vector<Place> places_;         // open addressing with linear probing; the size is a power of two
    std::size_t enabled_count_ = 0;
};

}  // namespace ecods
