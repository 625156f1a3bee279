// SolidMemory is the scratch memory of relations of solids and surfaces.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "base/hash.hpp"
#include "bvh/tree/mesh_bvh.hpp"
#include "exact/point/frame.hpp"
#include "query/intersection/query_memory.hpp"
#include "query/solid/fan.hpp"

namespace ecods {

// PairSet is a hash set of pairs of numbers.
class PairSet {
  public:
    // Empties the set in constant time, by beginning a new epoch.
    void clear() noexcept {
        ++epoch_;
        count_ = 0;
    }

    // Adds a pair, and returns true if it was not in the set before.
    bool insert(std::uint64_t a, std::uint64_t b) {
        if (2 * count_ >= entries_.size()) grow();
        Entry& entry = find(entries_, a, b);
        if (entry.epoch == epoch_) return false;
        entry = {epoch_, a, b};
        ++count_;
        return true;
    }

  private:
    struct Entry {
        std::uint64_t epoch =
            0;  // epoch in which the entry was written; the entry is free unless it is the current one
        std::uint64_t a = 0, b = 0;
    };

    Entry& find(std::vector<Entry>& entries, std::uint64_t a, std::uint64_t b) const {
        const std::size_t mask = entries.size() - 1;
        std::size_t at = combine(a, b) & mask;
        while (entries[at].epoch == epoch_ && (entries[at].a != a || entries[at].b != b)) at = (at + 1) & mask;
        return entries[at];
    }
    void grow() {
        std::vector<Entry> larger(entries_.empty() ? 64 : 2 * entries_.size());
        for (const Entry& entry : entries_) {
            if (entry.epoch == epoch_) find(larger, entry.a, entry.b) = entry;
        }
        entries_ = std::move(larger);
    }

    std::vector<Entry> entries_;  // the size is a power of two
    std::uint64_t epoch_ = 1;
    std::size_t count_ = 0;
};

struct SolidMemory final : QueryMemoryPart {
    exact::Frame frame;
    std::vector<TreeRef> stack;
    std::array<std::vector<std::uint8_t>, 2> met;  // by solid and shell: not 0 if the shell has a segment of contact
    PairSet fans;
    std::vector<Wing> wings;
    // The following members are used for a surface and a solid.
    std::vector<std::uint8_t> contacts;  // by triangle: a SurfaceSearch::Contact
    std::vector<std::uint32_t> parents;  // by vertex: union-find parent
    std::vector<std::uint8_t> placed;    // by vertex that is a union-find root: not 0 if its piece's side is known

    static SolidMemory& of(QueryMemory& memory) {
        return QueryMemoryAccess::part<SolidMemory>(memory, &QueryMemoryAccess::State::solid);
    }
};

}  // namespace ecods
