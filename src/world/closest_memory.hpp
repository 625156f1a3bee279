// Keeps hints for World::closest_pair from one call to the next, in the caller's or the thread's QueryMemory.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/hash.hpp"
#include "ecods/ask.hpp"
#include "ecods/broad_phase.hpp"
#include "ecods/ids.hpp"
#include "query/intersection/query_memory.hpp"

namespace ecods {

// A GroupPair is the groups of the two bodies of a pair, in either order.
struct GroupPair {
    static constexpr std::uint64_t all = ~std::uint64_t{0};

    std::uint64_t a = all, b = all;

    bool are_all() const noexcept { return a == all && b == all; }
    bool hold(const CollisionFilter& x, const CollisionFilter& y) const noexcept {
        return ((x.groups & a) != 0 && (y.groups & b) != 0) || ((x.groups & b) != 0 && (y.groups & a) != 0);
    }
};

// Holds witnesses of pairs, and the last closest pairs. No answer depends on its content: pairs of different worlds may
// share an entry, and the later one overwrites the other.
class ClosestMemory final : public QueryMemoryPart {
  public:
    static ClosestMemory& of(QueryMemory& memory) {
        return QueryMemoryAccess::part<ClosestMemory>(memory, &QueryMemoryAccess::State::closest_pairs);
    }

    PairWitness& witness(const BodyPair& bodies) noexcept {
        return witnesses_[combine(bodies.a.rank(), bodies.b.rank()) % witnesses_.size()];
    }

    // Returns the entry for the pair that was the closest pair of these groups at the last call.
    BodyPair& last_of(const GroupPair& groups) noexcept { return last_[combine(groups.a, groups.b) % last_.size()]; }

    // A Candidate is two bodies, and a lower bound of their distance, from their boxes.
    struct Candidate {
        double lower;
        ProxyPair pair;
    };
    struct Lists {
        std::vector<ProxyIndex> members_a, members_b;  // the bodies of both groups
        std::vector<Candidate> candidates;
    };
    // Scratch lists. A question moves them out, and back at its end, because a caller's two-body test may meanwhile ask
    // another world in the same memory.
    Lists lists;

  private:
    std::array<PairWitness, 1024> witnesses_;
    std::array<BodyPair, 16> last_;
};

}  // namespace ecods
