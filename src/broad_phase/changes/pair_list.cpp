#include "broad_phase/changes/pair_list.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <iterator>
#include <limits>

#include "base/bytes_of.hpp"
#include "base/make_room.hpp"

namespace ecods {
namespace {

// Returns the first pair of [first, last), which is sorted, that is not before `pair`; `last` if there is none. Uses
// galloping search, since changes of a list are close to each other.
const ProxyPair* find_from(const ProxyPair* first, const ProxyPair* last, const ProxyPair& pair) {
    std::ptrdiff_t step = 1;
    while (step < last - first && is_before(first[step], pair)) {
        first += step;
        step *= 2;
    }
    return std::lower_bound(first, first + std::min(step + 1, last - first), pair, is_before);
}

// Holds a part of a list without changes, [begin, end), and the place to which it moves.
struct Block {
    std::size_t begin, end, to;
};

// Appends to `blocks` the unchanged blocks of a list from which `gone` is removed and into which `come` is inserted,
// and to `places` the new place of each pair in `come`. Both are ascending; `gone` may have pairs that the list lacks.
// Returns the new size of the list.
std::size_t find_blocks(const ProxyPairs& list, const ProxyPairs& gone, const ProxyPairs& come,
                        std::vector<Block>& blocks, std::vector<std::size_t>& places) {
    const ProxyPair* const first = list.data();
    const ProxyPair* const read_end = first + list.size();
    const ProxyPair* read = first;
    auto next_gone = gone.begin();
    auto next_come = come.begin();
    std::size_t size = 0;
    const auto keep_until = [&](const ProxyPair* end) {
        blocks.push_back({static_cast<std::size_t>(read - first), static_cast<std::size_t>(end - first), size});
        size += static_cast<std::size_t>(end - read);
        read = end;
    };
    while (next_gone != gone.end() || next_come != come.end()) {
        const bool is_gone = next_come == come.end() || (next_gone != gone.end() && !is_before(*next_come, *next_gone));
        const ProxyPair pair = is_gone ? *next_gone++ : *next_come++;
        keep_until(find_from(read, read_end, pair));
        if (!is_gone) {
            places.push_back(size++);
        } else if (read != read_end && *read == pair) {
            ++read;
        }
    }
    keep_until(read_end);
    return size;
}

// Appends the differences of two ascending lists, in order: pairs only in the old list to `ended`, pairs only in the
// new list to `began`. Fast path: skips blocks of eight pairs that are equal in both lists. Otherwise compares pair by
// pair, and advances the list with the lesser pair, or both lists, without a branch.
void append_differences(const ProxyPairs& old_list, const ProxyPairs& new_list, ProxyPairs& ended, ProxyPairs& began) {
    constexpr std::size_t few = 8;
    const ProxyPair* gone = old_list.data();
    const ProxyPair* const gone_end = gone + old_list.size();
    const ProxyPair* come = new_list.data();
    const ProxyPair* const come_end = come + new_list.size();
    std::array<ProxyPair, few> only_gone, only_come;
    while (gone_end - gone >= std::ptrdiff_t{few} && come_end - come >= std::ptrdiff_t{few}) {
        if (std::memcmp(gone, come, sizeof(only_gone)) == 0) {
            gone += few;
            come += few;
            continue;
        }
        std::size_t gone_count = 0, come_count = 0;
        for (std::size_t i = 0; i < few; ++i) {
            const std::uint64_t a = rank_of(*gone), b = rank_of(*come);
            only_gone[gone_count] = *gone;
            only_come[come_count] = *come;
            gone_count += a < b ? 1 : 0;
            come_count += b < a ? 1 : 0;
            gone += a <= b ? 1 : 0;
            come += b <= a ? 1 : 0;
        }
        ended.insert(ended.end(), only_gone.data(), only_gone.data() + gone_count);
        began.insert(began.end(), only_come.data(), only_come.data() + come_count);
    }
    std::set_difference(gone, gone_end, come, come_end, std::back_inserter(ended), is_before);
    std::set_difference(come, come_end, gone, gone_end, std::back_inserter(began), is_before);
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
    // Applies the log when it has grown long: the pass over the list is amortized over a proportional number of events.
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
    // Avoids a branch, since the outcome of the test is unpredictable: writes every pair to `removed`, and overwrites
    // it with the next pair if neither of its boxes was removed.
    constexpr std::size_t some = 64;
    std::array<ProxyPair, some> removed;
    for (std::size_t begin = 0; begin < list_.size(); begin += some) {
        std::size_t count = 0;
        for (std::size_t i = begin; i < std::min(begin + some, list_.size()); ++i) {
            removed[count] = list_[i];
            count += static_cast<unsigned>(table.is_removed(list_[i].a)) | table.is_removed(list_[i].b);
        }
        ended.insert(ended.end(), removed.data(), removed.data() + count);
    }
}

void PairList::compare(const ProxyTable& table, const ProxyChanges& changes, ProxyPairs& found, PairEvents& events) {
    auto& [began, ended] = events;
    apply_log();
    events.clear();
    if (!changes.removed.empty()) append_removed(table, changes, ended);
    if (!ended.empty()) make_patched(ended, {});
    const ProxyPairs& kept = ended.empty() ? list_ : spare_;
    append_differences(kept, found, ended, began);
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

// Applies the logged events to the list. Only the last event of each pair counts.
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

// Removes `gone` from the list and inserts `come`; both are ascending. `gone` may have pairs that the list lacks.
void PairList::patch(const ProxyPairs& gone, const ProxyPairs& come) {
    if (gone.empty() && come.empty()) return;
    constexpr std::size_t long_block = 16;  // shorter blocks cost more to move than to copy
    if (long_block * (gone.size() + come.size()) < list_.size()) {
        patch_in_place(gone, come);
    } else {
        make_patched(gone, come);
        list_.swap(spare_);
    }
}

// Removes `gone` from the list and inserts `come`, as patch() does, but in place, without memory for a second list.
// Unchanged blocks move as a whole: first the blocks that move towards the front, from the first one on, then the
// blocks that move towards the back, from the last one on. So no block is overwritten before it has moved.
void PairList::patch_in_place(const ProxyPairs& gone, const ProxyPairs& come) {
    std::vector<Block> blocks;
    blocks.reserve(gone.size() + come.size() + 1);
    std::vector<std::size_t> places;  // places of the pairs in `come`
    places.reserve(come.size());
    const std::size_t size = find_blocks(list_, gone, come, blocks, places);
    if (size > list_.size()) grow_to(list_, size);
    // Nothing below throws.
    ProxyPair* const list = list_.data();
    for (const auto& [begin, end, to] : blocks) {
        if (to < begin) std::move(list + begin, list + end, list + to);
    }
    for (auto block = blocks.rbegin(); block != blocks.rend(); ++block) {
        const auto [begin, end, to] = *block;
        if (to > begin) std::move_backward(list + begin, list + end, list + to + (end - begin));
    }
    for (std::size_t i = 0; i < come.size(); ++i) list[places[i]] = come[i];
    list_.resize(size);
}

// Writes the patched list to spare_ by a merge without branches. The merge is faster than moving blocks of the list if
// changes are close to each other.
void PairList::make_patched(const ProxyPairs& gone, const ProxyPairs& come) {
    constexpr std::uint64_t none = std::numeric_limits<std::uint64_t>::max();
    spare_.resize(list_.size() + come.size());
    ProxyPair* write = spare_.data();
    const ProxyPair *next_gone = gone.data(), *next_come = come.data();
    const ProxyPair* const gone_end = next_gone + gone.size();
    const ProxyPair* const come_end = next_come + come.size();
    for (const ProxyPair *read = list_.data(), *const end = read + list_.size(); read != end;) {
        const std::uint64_t kept = rank_of(*read);
        const std::uint64_t goes = next_gone != gone_end ? rank_of(*next_gone) : none;
        const std::uint64_t comes = next_come != come_end ? rank_of(*next_come) : none;
        if (goes < kept) [[unlikely]] {  // the list lacks this pair
            ++next_gone;
            continue;
        }
        const bool is_new = comes <= kept, is_gone = !is_new && goes == kept;
        *write = *(is_new ? next_come : read);
        write += is_gone ? 0 : 1;
        next_come += is_new ? 1 : 0;
        next_gone += is_gone ? 1 : 0;
        read += is_new ? 0 : 1;
    }
    write = std::copy(next_come, come_end, write);
    spare_.resize(static_cast<std::size_t>(write - spare_.data()));
}

std::size_t PairList::bytes() const noexcept {
    return bytes_of(list_, spare_, log_);
}

}  // namespace ecods
