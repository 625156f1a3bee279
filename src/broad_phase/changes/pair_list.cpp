#include "broad_phase/changes/pair_list.hpp"

#include <algorithm>
#include <iterator>

#include "base/bytes_of.hpp"
#include "base/make_room.hpp"

namespace ecods {
namespace {

// The first in a sorted range that is not before `pair`. It is looked for near the beginning first: changes of a list
// follow each other closely.
const ProxyPair* find_from(const ProxyPair* first, const ProxyPair* last, const ProxyPair& pair) {
    std::ptrdiff_t step = 1;
    while (step < last - first && is_before(first[step], pair)) {
        first += step;
        step *= 2;
    }
    return std::lower_bound(first, first + std::min(step + 1, last - first), pair, is_before);
}

}  // namespace

void PairList::begin_update() {
    if (is_pending_ && !events_.empty()) log_events();
    is_pending_ = false;
}

void PairList::log_events() {
    make_room(log_, events_.ended.size() + events_.began.size());
    for (const ProxyPair& pair : events_.ended) log_.push_back({pair, order_});
    for (const ProxyPair& pair : events_.began) log_.push_back({pair, order_ + 1});
    order_ += 2;
    is_pending_ = false;
    // A pass over the list is paid for by a proportional number of events.
    constexpr std::size_t log_min = 1024;
    if (log_.size() > list_.size() / 4 + log_min) apply_log();
}

void PairList::end_update() noexcept {
    if (is_replaced_) list_.swap(spare_);
    is_pending_ = !is_replaced_;
    is_replaced_ = false;
}

void PairList::drop_update() noexcept {
    is_pending_ = is_replaced_ = false;
}

void PairList::append_removed(const ProxyTable& table, const ProxyChanges&, ProxyPairs& ended) {
    apply_log();
    for (const ProxyPair& pair : list_) {
        if (table.is_removed(pair.a) || table.is_removed(pair.b)) ended.push_back(pair);
    }
}

void PairList::compare(const ProxyTable& table, const ProxyChanges& changes, ProxyPairs& found, PairEvents& events) {
    auto& [began, ended] = events;
    apply_log();
    events.clear();
    if (!changes.removed.empty()) append_removed(table, changes, ended);
    if (!ended.empty()) make_patched(ended, {});
    const ProxyPairs& kept = ended.empty() ? list_ : spare_;
    std::set_difference(found.begin(), found.end(), kept.begin(), kept.end(), std::back_inserter(began), is_before);
    std::set_difference(kept.begin(), kept.end(), found.begin(), found.end(), std::back_inserter(ended), is_before);
    sort_pairs(ended);
    spare_.swap(found);
    is_replaced_ = true;
}

const ProxyPairs& PairList::sorted() {
    apply_log();
    if (is_pending_) patch(events_.ended, events_.began);
    is_pending_ = false;
    return list_;
}

// Of the events of one pair the last counts.
void PairList::apply_log() {
    if (log_.empty()) return;
    std::sort(log_.begin(), log_.end(), [](const Change& a, const Change& b) {
        return a.pair == b.pair ? a.order < b.order : is_before(a.pair, b.pair);
    });
    ProxyPairs gone, come;
    for (std::size_t i = 0; i < log_.size(); ++i) {
        if (i + 1 < log_.size() && log_[i + 1].pair == log_[i].pair) continue;
        gone.push_back(log_[i].pair);
        if (log_[i].order % 2 == 1) come.push_back(log_[i].pair);
    }
    patch(gone, come);
    log_.clear();
    order_ = 0;
}

// The list without `gone`, which need not all be in it, and with `come`; both are ascending. What lies between two
// changes is copied as a block.
void PairList::patch(const ProxyPairs& gone, const ProxyPairs& come) {
    if (gone.empty() && come.empty()) return;
    make_patched(gone, come);
    list_.swap(spare_);
}

void PairList::make_patched(const ProxyPairs& gone, const ProxyPairs& come) {
    spare_.resize(list_.size() + come.size());
    const ProxyPair* read = list_.data();
    const ProxyPair* const read_end = read + list_.size();
    ProxyPair* write = spare_.data();
    auto next_gone = gone.begin();
    auto next_come = come.begin();
    while (next_gone != gone.end() || next_come != come.end()) {
        const bool is_gone = next_come == come.end() || (next_gone != gone.end() && !is_before(*next_come, *next_gone));
        const ProxyPair pair = is_gone ? *next_gone : *next_come;
        const ProxyPair* next = find_from(read, read_end, pair);
        write = std::copy(read, next, write);
        read = next;
        if (is_gone) {
            if (read != read_end && *read == pair) ++read;
            ++next_gone;
        } else {
            *write++ = pair;
            ++next_come;
        }
    }
    write = std::copy(read, read_end, write);
    spare_.resize(static_cast<std::size_t>(write - spare_.data()));
}

std::size_t PairList::bytes() const noexcept {
    return bytes_of(list_, spare_, log_);
}

}  // namespace ecods
