// The verdicts of the candidate pairs, kept while neither body changes.
//
// The report's collision cache: a pair that did not move is not tested again. A pair is here exactly while its boxes
// overlap, whether it is filtered out or not: who stops filtering it must find it.
//
// Verdicts lie side by side. Each is in two lists, of the pairs of its two bodies, through links that it holds itself,
// so that a body that moved finds its pairs at their cost and without hashing; and in a table by its two bodies, for a
// pair that ends. Memory: 44 bytes a verdict, 4 bytes a body, and 8 bytes for each place of the table, which is a
// quarter empty at least.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "ecods/broad_phase.hpp"
#include "ecods/ids.hpp"
#include "ecods/shape.hpp"

namespace ecods {

// The place of a verdict, until one is removed.
using VerdictIndex = std::uint32_t;
inline constexpr VerdictIndex no_verdict = ~VerdictIndex{0};

// What an update found about a pair that it looks at.
enum class Answer : std::uint8_t { none, filtered_out, no, yes };

struct Verdict {
    BodyPair bodies;                     // with the generations that the pair began with
    std::array<VerdictIndex, 2> next{};  // in the list of bodies.a, and of bodies.b
    std::array<VerdictIndex, 2> previous{};
    PairWitness witness{};         // what decided it last
    bool is_enabled = false;       // not filtered out; false until the pair is tested
    bool is_positive = false;      // the answer; false unless enabled
    Answer answer = Answer::none;  // of the update under way, if that looks at the pair

    ProxyPair proxies() const noexcept { return {bodies.a.slot - 1, bodies.b.slot - 1}; }
};

class VerdictCache {
  public:
    // Reserves memory for so many verdicts, of proxies below `proxy_end`: add() does not throw until there are more.
    // Growth is geometric however small the steps.
    void reserve(std::size_t verdict_count, std::size_t proxy_end);

    void add(const BodyPair& bodies) noexcept;  // must not be here; memory must be reserved
    Verdict remove(ProxyPair pair) noexcept;    // must be here; indices of others may change

    VerdictIndex find(ProxyPair pair) const noexcept;  // no_verdict: not here
    const Verdict& operator[](VerdictIndex index) const noexcept { return verdicts_[index]; }
    void set(VerdictIndex index, bool is_enabled, bool is_positive) noexcept;
    PairWitness& witness(VerdictIndex index) noexcept { return verdicts_[index].witness; }
    Answer& answer(VerdictIndex index) noexcept { return verdicts_[index].answer; }

    VerdictIndex size() const noexcept { return static_cast<VerdictIndex>(verdicts_.size()); }
    std::size_t enabled_count() const noexcept { return enabled_count_; }

    // The list of the pairs of a body, in no order: first(proxy), then next(index, proxy), until no_verdict.
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
    std::size_t place_of(ProxyPair pair) const noexcept;  // where it is, or where it would be
    void take_place(VerdictIndex index) noexcept;
    void free_place(std::size_t place) noexcept;
    void link(VerdictIndex index, int side) noexcept;
    void link_neighbours(const Verdict& verdict, int side, VerdictIndex back, VerdictIndex on) noexcept;
    void unlink(VerdictIndex index, int side) noexcept;
    void relocate(VerdictIndex from, VerdictIndex to) noexcept;

    std::vector<Verdict> verdicts_;
    std::vector<VerdictIndex> firsts_;  // by proxy
    std::vector<Place> places_;         // open addressing, linear probing; a power of two
    std::size_t enabled_count_ = 0;
};

}  // namespace ecods
