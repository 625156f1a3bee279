#include <algorithm>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ecods/rounded.hpp"
#include "fuzz/base/failure.hpp"
#include "fuzz/checks/checks.hpp"
#include "fuzz/checks/text.hpp"
#include "oracle/distance.hpp"
#include "oracle/solid.hpp"
#include "oracle/solid_points.hpp"
#include "scenes/numbers_of.hpp"
#include "scenes/random.hpp"

namespace ecods::fuzz {
namespace {

using Pairs = std::vector<BodyPair>;

constexpr std::size_t judged_max = 12;  // pairs a frame
// Pairs of triangles; the oracle judges some thousand of them in a millisecond.
constexpr std::size_t triangle_pairs_max = 40000;

// Whether certified boxes leave it open, on each axis and with doubles: the gap is off by a unit in the last place.
bool may_be_close(const TrueBody& a, const TrueBody& b, double clearance) {
    const double d = clearance + a.radius + b.radius;
    const Aabb x = a.exact.outer_box(), y = b.exact.outer_box();
    for (int axis = 0; axis < 3; ++axis) {
        const double gap = std::max(x.min[axis] - y.max[axis], y.min[axis] - x.max[axis]);
        if (gap > d + d * 0x1p-40 + 0x1p-1000) return false;
    }
    return true;
}

// What is in the first list and not in the second.
void require_events(const char* what, const Pairs& got, const Pairs& first, const Pairs& second) {
    Pairs expected;
    std::ranges::set_difference(first, second, std::back_inserter(expected));
    if (!std::ranges::equal(got, expected)) throw CheckFailed(what, text(expected), text(got));
}

}  // namespace

void check_close_pairs(const World& world, const Pairs& before, const Truth& truth, std::uint32_t seed,
                       Counters& counters) {
    const Pairs now = numbers_of(world.close_pairs());
    require_events("close pairs that began", numbers_of(world.close_began()), now, before);
    require_events("close pairs that ended", numbers_of(world.close_ended()), before, now);
    const std::optional<double> clearance = world.clearance();
    if (!clearance) {
        if (!now.empty()) throw CheckFailed("close pairs without a clearance", "none", text(now));
        return;
    }
    for (const BodyPair& pair : numbers_of(world.colliding_pairs())) {
        if (!std::ranges::binary_search(now, pair)) throw CheckFailed("close pairs", "those that collide", text(now));
    }
    struct Judged {
        const TrueBody* a;
        const TrueBody* b;
    };
    std::vector<Judged> judged;
    const auto bodies = truth.bodies();
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        for (std::size_t j = i + 1; j < bodies.size(); ++j) {
            const BodyPair pair{bodies[i].id, bodies[j].id};
            const bool is_possible = may_be_close(bodies[i], bodies[j], *clearance) && may_meet(world, pair.a, pair.b);
            if (is_possible) judged.push_back({&bodies[i], &bodies[j]});
            if (!is_possible && std::ranges::binary_search(now, pair)) {
                throw CheckFailed("close pairs", "no pair that is filtered out or far apart", text(now));
            }
        }
    }
    scenes::Random random(seed);
    for (std::size_t count = 0; count < judged_max && !judged.empty(); ++count) {
        std::swap(judged[random.below(static_cast<std::uint32_t>(judged.size()))], judged.back());
        const auto [a, b] = judged.back();
        judged.pop_back();
        if (a->mesh->triangles().size() * b->mesh->triangles().size() > triangle_pairs_max) continue;
        const oracle::Soup of_a = a->soup(), of_b = b->soup();
        const bool has_radii = a->radius != 0 || b->radius != 0;
        const bool is_close = has_radii ? distance_of(*a, *b).compare(*clearance) <= 0
                                        : oracle::MeshDistances(of_a, of_b).within(*clearance) ||
                                              (b->boundary.has_inside && oracle::has_piece_inside(of_a, of_b)) ||
                                              (a->boundary.has_inside && oracle::has_piece_inside(of_b, of_a));
        if (std::ranges::binary_search(now, BodyPair{a->id, b->id}) != is_close) {
            throw CheckFailed("close pairs",
                              std::string(is_close ? "with " : "without ") + text(BodyPair{a->id, b->id}), text(now));
        }
        ++counters[is_close ? "checked: pairs within the clearance" : "checked: pairs beyond the clearance"];
    }
}

namespace {

// The least distance, and whose it is.
template <class Item>
void take_least(std::optional<Item>& least, const Item& item) {
    if (!least || item.distance < least->distance) least = item;
}

template <class Item>
void require_same(const char* what, const std::optional<Item>& got, const std::optional<Item>& expected) {
    if (got == expected) return;
    const auto text_of = [](const std::optional<Item>& item) {
        return item ? fmt::format("{:a}", item->distance) : std::string("none");
    };
    throw CheckFailed(what, text_of(expected), text_of(got));
}

// Signs has what decides, for ClosestPair, if the distances of a body have signs.
struct Signs {
    bool is_half_space, is_rounded = false, is_convex = false, is_triangle = false;

    Signs(const World& world, BodyId id) : is_half_space(world.shape(id)->kind() == ShapeKind::half_space()) {
        const std::shared_ptr<const Shape> shape = world.shape(id);
        const auto* const rounded = dynamic_cast<const Rounded*>(shape.get());
        const auto* const core = rounded != nullptr ? &rounded->core() : dynamic_cast<const MeshShape*>(shape.get());
        is_rounded = rounded != nullptr;
        if (core == nullptr) return;
        const bool is_regular = !oracle::is_singular(world.pose(id));
        is_convex = is_regular && core->form() == MeshForm::convex;
        is_triangle = is_regular && core->form() != MeshForm::convex && core->mesh().triangles().size() == 1;
    }
};

bool is_signed(const Signs& a, const Signs& b) {
    if (a.is_half_space || b.is_half_space) return !a.is_half_space || !b.is_half_space;
    if (!a.is_rounded && !b.is_rounded) return a.is_convex && b.is_convex;
    return (a.is_convex || a.is_triangle) && (b.is_convex || b.is_triangle);
}

// The distance that ClosestPair promises, from the questions about the pair.
double signed_distance_of(const World& world, BodyId a, BodyId b, QueryMemory& memory) {
    if (is_signed({world, a}, {world, b})) return world.signed_distance(a, b, memory).distance;
    return world.distance(a, b, memory);
}

// All pairs, and those of two groups that overlap: of bodies in odd or even slots, or divided by three.
void check_closest_pairs(const World& world, const std::vector<BodyId>& bodies, QueryMemory& memory) {
    std::vector<std::pair<double, BodyPair>> all;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        for (std::size_t j = i + 1; j < bodies.size(); ++j) {
            if (!may_meet(world, bodies[i], bodies[j])) continue;
            all.emplace_back(signed_distance_of(world, bodies[i], bodies[j], memory), BodyPair{bodies[i], bodies[j]});
        }
    }
    std::ranges::sort(all, {}, [](const auto& pair) { return pair; });
    std::vector<ClosestPair> expected;
    for (const auto& [distance, pair] : all) expected.push_back({pair, distance});
    const auto text_of = [](const std::vector<ClosestPair>& pairs) {
        std::string text;
        for (const ClosestPair& pair : pairs) {
            text += fmt::format("{} {}: {:a}  ", pair.bodies.a.slot, pair.bodies.b.slot, pair.distance);
        }
        return text;
    };
    const auto compare = [&](const char* what, const std::vector<ClosestPair>& got,
                             const std::vector<ClosestPair>& should_be) {
        if (text_of(got) != text_of(should_be)) throw CheckFailed(what, text_of(should_be), text_of(got));
    };
    const std::vector<ClosestPair> got = world.closest_pairs(World::no_limit, memory);
    compare("closest pairs", got, expected);
    std::vector<ClosestPair> of_groups = got;
    constexpr std::uint64_t odd = 5, even = 6;
    std::erase_if(of_groups, [&](const ClosestPair& pair) {
        const std::uint64_t x = world.filter(pair.bodies.a).groups, y = world.filter(pair.bodies.b).groups;
        return !((x & odd) != 0 && (y & even) != 0) && !((x & even) != 0 && (y & odd) != 0);
    });
    compare("closest pairs of groups", world.closest_pairs(World::no_limit, odd, even, memory), of_groups);
    const auto compare_first = [&](const char* what, const std::optional<ClosestPair>& first,
                                   const std::vector<ClosestPair>& pairs) {
        if (first.has_value() != !pairs.empty() || (first && *first != pairs.front())) {
            compare(what, first ? std::vector{*first} : std::vector<ClosestPair>(), pairs);
            throw CheckFailed(what, "the points of closest_pairs()", "others");
        }
    };
    compare_first("closest pair", world.closest_pair(World::no_limit, memory), got);
    compare_first("closest pair of groups", world.closest_pair(World::no_limit, even, odd, memory), of_groups);
}

}  // namespace

void check_nearest(World& world, BodyId body, Counters& counters) {
    constexpr std::size_t few = 24;
    const auto bodies = world.bodies();
    QueryMemory memory;
    std::optional<NearestBody> nearest;
    for (const BodyId other : bodies) {
        if (other == body || !may_meet(world, body, other)) continue;
        take_least(nearest, NearestBody{other, world.distance(body, other, memory)});
    }
    require_same("nearest body", world.nearest(body, World::no_limit, memory), nearest);
    if (nearest) require_same("nearest body up to its distance", world.nearest(body, 2 * nearest->distance), nearest);
    // A copy of it meets it, or a body before it that touches it.
    const auto of_copy = world.nearest({world.shape(body), world.pose(body)}, World::no_limit, memory);
    if (!of_copy || of_copy->distance != 0 || of_copy->body > body) {
        throw CheckFailed("nearest of a copy", "0", of_copy ? fmt::format("{:a}", of_copy->distance) : "none");
    }
    // A shape at its pose is as far from a body as the body that has both.
    if (nearest) {
        const double d = world.distance({world.shape(body), world.pose(body)}, nearest->body, memory);
        require_same("distance of a copy", std::optional(NearestBody{nearest->body, d}), nearest);
    }
    ++counters["checked: nearest bodies"];
    if (bodies.size() > few) return;
    check_closest_pairs(world, bodies, memory);
    ++counters["checked: closest pairs"];
}

}  // namespace ecods::fuzz
