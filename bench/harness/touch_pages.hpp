// Memory of a parent process, before it is used in timed work.
#pragma once

#include <cstddef>
#include <span>

namespace ecods::bench {

// Reads a byte of each page. A child process is given the pages of its parent one at a time, when it first looks at
// them; that costs as much as some engines need for all that is in a page, and is no work of theirs.
template <class T>
void touch_pages(std::span<const T> values) {
    constexpr std::size_t page_size = 4096;
    const auto bytes = std::as_bytes(values);
    for (std::size_t i = 0; i < bytes.size(); i += page_size) {
        [[maybe_unused]] const volatile std::byte seen = bytes[i];
    }
    if (!bytes.empty()) {
        [[maybe_unused]] const volatile std::byte seen = bytes.back();
    }
}

}  // namespace ecods::bench
