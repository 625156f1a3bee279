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
#include "ecods/pose.hpp"
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

// A PairHint has the triangles at which two bodies were closest, and the direction between two convex solids then.
struct PairHint {
    PairWitness witness;
    Vec3 axis = Vec3::Zero();  // zero if it is not known
};

// Holds hints about pairs, and the last closest pairs. No answer depends on its content: pairs of different worlds may
// share an entry, and the later one overwrites the other.
class ClosestMemory final : public QueryMemoryPart {
  public:
    static ClosestMemory& of(QueryMemory& memory) {
        return QueryMemoryAccess::part<ClosestMemory>(memory, &QueryMemoryAccess::State::closest_pairs);
    }

    PairHint& hint(const BodyPair& bodies) noexcept {
        return hints_[combine(bodies.a.rank(), bodies.b.rank()) % hints_.size()];
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
    // These lists are scratch memory. A question moves the lists out of this object, and back at its end, because a
    // caller's two-body test may meanwhile ask another world in the same memory.
    Lists lists;

  private:
    std::array<PairHint, 1024> hints_;
    std::array<BodyPair, 16> last_;
};

}  // namespace ecods
