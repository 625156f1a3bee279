// Scratch memory of the questions about solids.
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

// A hash set of pairs of numbers.
class PairSet {
  public:
    // Empties the set in constant time, by a new epoch.
    void clear() noexcept {
        ++epoch_;
        count_ = 0;
    }

    // Adds a pair; true if it was not in the set.
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
        std::uint64_t epoch = 0;  // epoch in which the entry was written; any other than the current one means free
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
    std::array<std::vector<std::uint8_t>, 2> met;  // by solid and shell: not 0 if a segment of contact was found
    PairSet fans;
    std::vector<Wing> wings;
    // Used for a surface against a solid:
    std::vector<std::uint8_t> contacts;  // by triangle
    std::vector<std::uint32_t> parents;  // by vertex: union-find parent
    std::vector<std::uint8_t> placed;    // by root vertex of a piece: not 0 if its side is known

    static SolidMemory& of(QueryMemory& memory) {
        return QueryMemoryAccess::part<SolidMemory>(memory, &QueryMemoryAccess::State::solid);
    }
};

}  // namespace ecods
