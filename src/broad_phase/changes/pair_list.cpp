#include "broad_phase/changes/pair_list.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include "base/bytes_of.hpp"
#include "base/make_room.hpp"

namespace ecods {
namespace {

// An object, so that algorithms do not call it through a pointer.
constexpr auto is_before = [](const ProxyPair& a, const ProxyPair& b) { return rank_of(a) < rank_of(b); };

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

// By digits, the last one first; digits that are the same in all pairs are left out. Comparing costs more when there
// are many, since a processor cannot foretell how a comparison ends.
void sort_pairs(ProxyPairs& pairs) {
    constexpr std::size_t few = 96;
    constexpr unsigned digit_bits = 8;
    constexpr std::size_t digit_count = std::size_t{1} << digit_bits;
    if (pairs.size() < few) {
        std::sort(pairs.begin(), pairs.end(), is_before);
        return;
    }
    std::uint64_t varying = 0;
    for (const ProxyPair& pair : pairs) varying |= rank_of(pair) ^ rank_of(pairs.front());
    ProxyPairs spare(pairs.size());
    for (unsigned shift = 0; shift < 64; shift += digit_bits) {
        if ((varying >> shift) % digit_count == 0) continue;
        std::array<std::size_t, digit_count> next{};  // where the next pair with this digit goes
        for (const ProxyPair& pair : pairs) ++next[(rank_of(pair) >> shift) % digit_count];
        std::size_t sum = 0;
        for (std::size_t& place : next) sum += std::exchange(place, sum);
        for (const ProxyPair& pair : pairs) spare[next[(rank_of(pair) >> shift) % digit_count]++] = pair;
        pairs.swap(spare);
    }
}

void normalise(ProxyPairs& pairs) {
    sort_pairs(pairs);
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
}

void PairList::begin_update() {
    if (has_pending_events()) log_events();
    is_pending_ = false;
    began.clear();
    ended.clear();
}

void PairList::log_events() {
    make_room(log_, ended.size() + began.size());
    for (const ProxyPair& pair : ended) log_.push_back({pair, order_});
    for (const ProxyPair& pair : began) log_.push_back({pair, order_ + 1});
    order_ += 2;
    is_pending_ = false;
    // A pass over the list is paid for by a proportional number of events.
    constexpr std::size_t log_min = 1024;
    if (log_.size() > list_.size() / 4 + log_min) apply_log();
}

void PairList::end_update() {
    if (is_replaced_) {
        list_.swap(spare_);
    } else {
        sort_pairs(began);
        sort_pairs(ended);
    }
    is_pending_ = !is_replaced_;
    is_replaced_ = false;
}

void PairList::drop_update() noexcept {
    began.clear();
    ended.clear();
    is_pending_ = is_replaced_ = false;
}

void PairList::replace(ProxyPairs& found) {
    sort_pairs(ended);
    apply_log();
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
    if (has_pending_events()) patch(ended, began);
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
    return bytes_of(list_, spare_, log_, began, ended);
}

}  // namespace ecods
