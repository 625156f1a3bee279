// A VertexCache is a cache of fixed size for values that belong to the vertices of one mesh.
#pragma once

#include <cstdint>
#include <vector>

#include "simd/inline.hpp"

namespace ecods::exact {

// A VertexCache is direct-mapped: vertices with the same remainder modulo `size` share an entry, which holds the value
// of the last one. With the default size, rounded points take 32 KiB, the size of a level 1 cache.
template <class Value, std::size_t size = 1024>
class VertexCache {
  public:
    // Removes all values in constant time, by changing a counter.
    void clear() noexcept {
        epoch_ += std::uint64_t{1} << 32;
        if (epoch_ == 0) {  // after 2^32 calls tags would repeat
            for (Entry& entry : entries_) entry.tag = 0;
            epoch_ = std::uint64_t{1} << 32;
        }
    }

    // Returns the value of `vertex`; if it is not cached, make(value) sets it first. The reference is valid until the
    // next call.
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
    std::uint64_t epoch_ = std::uint64_t{1} << 32;  // upper half of tags; never 0
};

}  // namespace ecods::exact
