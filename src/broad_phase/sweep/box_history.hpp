// Keeps each box as it is now and as it was at the last update.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "base/bytes_of.hpp"
#include "broad_phase/changes/proxy_table.hpp"
#include "geometry/key_box.hpp"

namespace ecods {

class BoxHistory {
  public:
    void reserve(std::size_t count) {
        now_.reserve(count);
        before_.reserve(count);
    }

    // Sets now() of these proxies to their boxes in the table.
    void advance(std::span<const ProxyIndex> proxies, const ProxyTable& table) {
        if (now_.size() < table.end()) {
            now_.resize(table.end());
            before_.resize(table.end());
        }
        for (const ProxyIndex proxy : proxies) now_[proxy] = key_box(table.boxes()[proxy]);
    }
    // Ends an update: sets before() of these proxies to now().
    void settle(std::span<const ProxyIndex> proxies) {
        for (const ProxyIndex proxy : proxies) before_[proxy] = now_[proxy];
    }

    const KeyBox& now(ProxyIndex proxy) const noexcept { return now_[proxy]; }
    const KeyBox& before(ProxyIndex proxy) const noexcept { return before_[proxy]; }
    std::size_t bytes() const noexcept { return bytes_of(now_, before_); }

  private:
    std::vector<KeyBox> now_;
    std::vector<KeyBox> before_;
};

}  // namespace ecods
