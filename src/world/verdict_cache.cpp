#include "world/verdict_cache.hpp"

#include <algorithm>
#include <bit>

#include "base/hash.hpp"
#include "ecods/error.hpp"

namespace ecods {

void VerdictCache::reserve(std::size_t verdict_count, std::size_t proxy_end) {
    if (proxy_end > firsts_.size()) firsts_.resize(proxy_end, no_verdict);
    if (verdict_count > verdicts_.capacity()) verdicts_.reserve(std::max(verdict_count, 2 * verdicts_.capacity()));
    // Grows the table if more than three quarters of its places would be taken, so that probes stay short.
    if (verdict_count * 4 > places_.size() * 3) {
        std::vector<Place> places(std::bit_ceil(std::max<std::size_t>(16, verdict_count * 4 / 3 + 1)));
        places_.swap(places);
        for (VerdictIndex index = 0; index < size(); ++index) take_place(index);
    }
}

void VerdictCache::add(const BodyPair& bodies) noexcept {
    const VerdictIndex index = size();
    verdicts_.push_back({.bodies = bodies});
    take_place(index);
    link(index, 0);
    link(index, 1);
}

Verdict VerdictCache::remove(ProxyPair pair) noexcept {
    const std::size_t place = place_of(pair);
    const VerdictIndex index = places_[place].index;
    const Verdict verdict = verdicts_[index];
    free_place(place);
    unlink(index, 0);
    unlink(index, 1);
    if (index + 1 != size()) relocate(size() - 1, index);
    verdicts_.pop_back();
    enabled_count_ -= verdict.is_enabled;
    return verdict;
}

VerdictIndex VerdictCache::find(ProxyPair pair) const noexcept {
    return places_.empty() ? no_verdict : places_[place_of(pair)].index;
}

void VerdictCache::set(VerdictIndex index, bool is_enabled, bool is_positive) noexcept {
    Verdict& verdict = verdicts_[index];
    enabled_count_ += is_enabled;
    enabled_count_ -= verdict.is_enabled;
    verdict.is_enabled = is_enabled;
    verdict.is_positive = is_positive;
}

std::size_t VerdictCache::memory_bytes() const noexcept {
    return verdicts_.capacity() * sizeof(Verdict) + firsts_.capacity() * sizeof(VerdictIndex) +
           places_.capacity() * sizeof(Place);
}

// The functions down to free_place() find, add and remove entries of the hash table.

std::uint32_t VerdictCache::hash_of(ProxyPair pair) noexcept {
    return static_cast<std::uint32_t>(mix(std::uint64_t{pair.a} << 32 | pair.b));
}

std::size_t VerdictCache::place_of(ProxyPair pair) const noexcept {
    const std::uint32_t hash = hash_of(pair);
    const std::size_t mask = places_.size() - 1;
    std::size_t place = hash & mask;
    while (places_[place].index != no_verdict) {
        if (places_[place].hash == hash && verdicts_[places_[place].index].proxies() == pair) break;
        place = (place + 1) & mask;
    }
    return place;
}

void VerdictCache::take_place(VerdictIndex index) noexcept {
    const std::uint32_t hash = hash_of(verdicts_[index].proxies());
    const std::size_t mask = places_.size() - 1;
    std::size_t place = hash & mask;
    while (places_[place].index != no_verdict) place = (place + 1) & mask;
    places_[place] = {hash, index};
}

// Empties a place of the hash table. The gap is filled with a later entry, unless that entry would then stand before
// its home place; the gap that this entry leaves is filled in the same way (Knuth, volume 3, algorithm 6.4R). No mark
// of a removed entry remains, so probes do not get longer.
void VerdictCache::free_place(std::size_t place) noexcept {
    const std::size_t mask = places_.size() - 1;
    for (std::size_t other = (place + 1) & mask; places_[other].index != no_verdict; other = (other + 1) & mask) {
        const std::size_t home = places_[other].hash & mask;
        if (((other - home) & mask) < ((other - place) & mask)) continue;
        places_[place] = places_[other];
        place = other;
    }
    places_[place] = {};
}

// The functions down to relocate() change the linked lists of verdicts.

void VerdictCache::link(VerdictIndex index, int side) noexcept {
    Verdict& verdict = verdicts_[index];
    const ProxyIndex proxy = (side == 0 ? verdict.bodies.a : verdict.bodies.b).slot - 1;
    verdict.previous[side] = no_verdict;
    verdict.next[side] = firsts_[proxy];
    if (firsts_[proxy] != no_verdict) verdicts_[firsts_[proxy]].previous[side_of(proxy, firsts_[proxy])] = index;
    firsts_[proxy] = index;
}

// Changes the links that point to a verdict in the list of its body number `side`. The link back of the next verdict
// becomes `back`. The link forward of the previous verdict, or the first link of the list, becomes `on`.
void VerdictCache::link_neighbours(const Verdict& verdict, int side, VerdictIndex back, VerdictIndex on) noexcept {
    const ProxyIndex proxy = (side == 0 ? verdict.bodies.a : verdict.bodies.b).slot - 1;
    const VerdictIndex next = verdict.next[side], previous = verdict.previous[side];
    if (next != no_verdict) verdicts_[next].previous[side_of(proxy, next)] = back;
    (previous == no_verdict ? firsts_[proxy] : verdicts_[previous].next[side_of(proxy, previous)]) = on;
}

void VerdictCache::unlink(VerdictIndex index, int side) noexcept {
    const Verdict& verdict = verdicts_[index];
    link_neighbours(verdict, side, verdict.previous[side], verdict.next[side]);
}

// Moves the verdict at `from` to the index `to`. The verdict that is at `to` must already be unlinked from its lists.
void VerdictCache::relocate(VerdictIndex from, VerdictIndex to) noexcept {
    const Verdict& verdict = verdicts_[from];
    places_[place_of(verdict.proxies())].index = to;
    verdicts_[to] = verdict;
    for (const int side : {0, 1}) link_neighbours(verdict, side, to, to);
}

// The functions below check the cache.

namespace {

void require(bool holds, const char* what) {
    if (!holds) throw BrokenInvariant(what);
}

}  // namespace

void VerdictCache::validate() const {
    std::size_t enabled = 0;
    for (VerdictIndex index = 0; index < size(); ++index) {
        require(verdicts_[index].bodies.a < verdicts_[index].bodies.b, "a pair of the cache is not ascending");
        require(find(verdicts_[index].proxies()) == index, "a verdict is not where the cache looks for it");
        require(verdicts_[index].is_enabled || !verdicts_[index].is_positive,
                "a pair that is filtered out is positive");
        enabled += verdicts_[index].is_enabled;
    }
    require(enabled == enabled_count_, "enabled pairs are not counted right");
    const auto taken = std::ranges::count_if(places_, [](const Place& place) { return place.index != no_verdict; });
    require(static_cast<std::size_t>(taken) == verdicts_.size(), "the cache has places for other pairs");

    // Checks the lists: each must hold only pairs of its own body, with correct links back, and all lists together must
    // have two entries for each verdict.
    std::size_t visits = 0;
    for (ProxyIndex proxy = 0; proxy < proxy_end(); ++proxy) {
        VerdictIndex previous = no_verdict;
        for (VerdictIndex index = first(proxy); index != no_verdict; index = next(index, proxy)) {
            const ProxyPair pair = verdicts_[index].proxies();
            require(pair.a == proxy || pair.b == proxy, "a body's list holds a pair of other bodies");
            require(verdicts_[index].previous[side_of(proxy, index)] == previous, "a link back is wrong");
            require(++visits <= 2 * verdicts_.size(), "the lists of pairs are not lists");
            previous = index;
        }
    }
    require(visits == 2 * verdicts_.size(), "a pair is missing in the list of a body");
}

}  // namespace ecods
