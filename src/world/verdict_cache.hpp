// Keeps the verdicts of the candidate pairs while neither body changes.
//
// This is the collision cache of the ECoDS report: a pair that did not move is not tested again. A pair is here exactly
// while its boxes overlap, even while it is filtered out: it must be found when its filter changes.
//
// Verdicts are stored side by side. Each is in two linked lists, one of the pairs of each of its bodies; the links are
// stored in the verdict. So a body that moved finds its pairs without hashing. A hash table by the two bodies finds a
// pair that ends. Memory: 44 bytes a verdict, 4 bytes a body, and 8 bytes for each place of the table, of which at
// least a quarter is empty.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "ecods/broad_phase.hpp"
#include "ecods/ids.hpp"
#include "ecods/shape.hpp"

namespace ecods {

// A verdict keeps its index until a verdict is removed.
using VerdictIndex = std::uint32_t;
inline constexpr VerdictIndex no_verdict = ~VerdictIndex{0};

// An update gives each pair that it looks at an answer; `none` until the pair is tested.
enum class Answer : std::uint8_t { none, filtered_out, no, yes };

struct Verdict {
    BodyPair bodies;                     // with the generations of when the pair began
    std::array<VerdictIndex, 2> next{};  // in the lists of bodies.a and of bodies.b
    std::array<VerdictIndex, 2> previous{};
    PairWitness witness{};         // left by the last test of the pair
    bool is_enabled = false;       // true if not filtered out; false until the pair is tested
    bool is_positive = false;      // the last answer; false unless enabled
    Answer answer = Answer::none;  // of the current update, if it looks at the pair

    ProxyPair proxies() const noexcept { return {bodies.a.slot - 1, bodies.b.slot - 1}; }
};

class VerdictCache {
  public:
    // Reserves memory for this many verdicts in all, of proxies below `proxy_end`: add() does not throw until there are
    // more. Growth is geometric, however small the steps.
    void reserve(std::size_t verdict_count, std::size_t proxy_end);

    void add(const BodyPair& bodies) noexcept;  // the pair must not be here; memory must be reserved
    Verdict remove(ProxyPair pair) noexcept;    // the pair must be here; other indices may change

    VerdictIndex find(ProxyPair pair) const noexcept;  // no_verdict: not here
    const Verdict& operator[](VerdictIndex index) const noexcept { return verdicts_[index]; }
    void set(VerdictIndex index, bool is_enabled, bool is_positive) noexcept;
    PairWitness& witness(VerdictIndex index) noexcept { return verdicts_[index].witness; }
    Answer& answer(VerdictIndex index) noexcept { return verdicts_[index].answer; }

    VerdictIndex size() const noexcept { return static_cast<VerdictIndex>(verdicts_.size()); }
    std::size_t enabled_count() const noexcept { return enabled_count_; }

    // Iterate over the pairs of a body, in no order: first(proxy), then next(index, proxy), until no_verdict.
    VerdictIndex first(ProxyIndex proxy) const noexcept { return proxy < firsts_.size() ? firsts_[proxy] : no_verdict; }
    VerdictIndex next(VerdictIndex index, ProxyIndex proxy) const noexcept {
        return verdicts_[index].next[side_of(proxy, index)];
    }
    ProxyIndex proxy_end() const noexcept { return static_cast<ProxyIndex>(firsts_.size()); }

    std::size_t memory_bytes() const noexcept;

    // Throws BrokenInvariant.
    void validate() const;

  private:
    struct Place {
        std::uint32_t hash = 0;
        VerdictIndex index = no_verdict;  // no_verdict: empty
    };

    int side_of(ProxyIndex proxy, VerdictIndex index) const noexcept {
        return verdicts_[index].bodies.a.slot - 1 == proxy ? 0 : 1;
    }
    static std::uint32_t hash_of(ProxyPair pair) noexcept;
    std::size_t place_of(ProxyPair pair) const noexcept;  // where the pair is, or would be put
    void take_place(VerdictIndex index) noexcept;
    void free_place(std::size_t place) noexcept;
    void link(VerdictIndex index, int side) noexcept;
    void link_neighbours(const Verdict& verdict, int side, VerdictIndex back, VerdictIndex on) noexcept;
    void unlink(VerdictIndex index, int side) noexcept;
    void relocate(VerdictIndex from, VerdictIndex to) noexcept;

    std::vector<Verdict> verdicts_;
    std::vector<VerdictIndex> firsts_;  // by proxy: the first of its list
    std::vector<Place> places_;         // open addressing with linear probing; the size is a power of two
    std::size_t enabled_count_ = 0;
};

}  // namespace ecods
