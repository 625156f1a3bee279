// A VertexCache has a fixed size and caches values of one mesh's vertices.
#pragma once

#include <cstdint>
#include <vector>

#include "simd/inline.hpp"

namespace ecods::exact {

// Direct-mapped: vertices with the same remainder modulo `size` share an entry, which holds the latest of them. The
// default size makes 32 KiB of rounded points: a level 1 cache.
template <class Value, std::size_t size = 1024>
class VertexCache {
  public:
    // Forgets all values, at the cost of a counter.
    void clear() noexcept {
        epoch_ += std::uint64_t{1} << 32;
        if (epoch_ == 0) {  // After 2^32 times the tags would repeat.
            for (Entry& entry : entries_) entry.tag = 0;
            epoch_ = std::uint64_t{1} << 32;
        }
    }

    // Returns the value of `vertex`, valid until the next call; make(value) fills it in if it is not cached.
    template <class Make>
    ECODS_ALWAYS_INLINE const Value& get(std::uint32_t vertex, Make&& make) {
        Entry& entry = entries_[vertex % size];
        const std::uint64_t tag = epoch_ | vertex;
        if (entry.tag != tag) [[unlikely]] {
            make(entry.value);
            entry.tag = tag;
        }
        return entry.value;
    }

  private:
    struct Entry {
        std::uint64_t tag = 0;
        Value value{};
    };
    std::vector<Entry> entries_ = std::vector<Entry>(size);
    std::uint64_t epoch_ = std::uint64_t{1} << 32;  // the upper half of tags, never 0
};

}  // namespace ecods::exact
