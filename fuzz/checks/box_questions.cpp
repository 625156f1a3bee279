#include "fuzz/checks/box_questions.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <string>
#include <vector>

#include "fuzz/base/failure.hpp"
#include "oracle/box_questions.hpp"
#include "oracle/oracle.hpp"

namespace ecods::fuzz {
namespace {

ProxyIndex proxy_of(BodyId body) {
    return body.slot - 1;
}

std::string text(const std::vector<ProxyIndex>& found) {
    std::string result = fmt::format("{} [", found.size());
    for (std::size_t i = 0; i < found.size() && i < 12; ++i) result += fmt::format("{} ", found[i]);
    return result + "]";
}

}  // namespace

BoxQuestions::BoxQuestions()
    : kinds_{make_broad_phase(BroadPhaseKind::brute_force), make_broad_phase(BroadPhaseKind::sweep_and_prune),
             make_broad_phase(BroadPhaseKind::kept_candidates), make_broad_phase(BroadPhaseKind::automatic)} {}

void BoxQuestions::follow(const World& world) {
    for (auto each = boxes_.begin(); each != boxes_.end();) {
        if (world.is_alive(each->first)) {
            ++each;
            continue;
        }
        for (const auto& kind : kinds_) kind->remove(proxy_of(each->first));
        each = boxes_.erase(each);
    }
    for (const BodyId body : world.bodies()) {
        const Aabb box = world.box(body);
        const bool is_new = boxes_.insert_or_assign(body, box).second;
        for (const auto& kind : kinds_) {
            is_new ? kind->add(proxy_of(body), box) : kind->move(proxy_of(body), box);
        }
    }
    for (const auto& kind : kinds_) kind->update();
}

Aabb BoxQuestions::any_box(scenes::Random& random) const {
    return std::next(boxes_.begin(), random.below(static_cast<std::uint32_t>(boxes_.size())))->second;
}

// The origin, where a corner is at infinity.
Vec3 BoxQuestions::any_corner(scenes::Random& random) const {
    const Aabb box = any_box(random);
    Vec3 corner;
    for (int axis = 0; axis < 3; ++axis) corner[axis] = random.below(2) == 0 ? box.min[axis] : box.max[axis];
    return corner.allFinite() ? corner : Vec3(0, 0, 0);
}

template <class Question, class Meets>
void BoxQuestions::require(const char* name, const Question& question, Meets meets, Counters& counters) {
    std::vector<ProxyIndex> expected;
    for (const auto& [body, box] : boxes_) {
        if (meets(box)) expected.push_back(proxy_of(body));
    }
    for (const auto& kind : kinds_) {
        const std::vector<ProxyIndex> got = kind->find(question);
        if (got != expected)
            throw CheckFailed(std::string("boxes that a ") + name + " meets", text(expected), text(got));
    }
    ++counters[std::string("checked: boxes that a ") + name + " meets"];
    counters["checked: boxes found by questions"] += expected.size();
}

void BoxQuestions::check(std::uint32_t seed, Counters& counters) {
    if (boxes_.empty()) return;
    scenes::Random random(seed);
    const Aabb one = any_box(random);
    require(
        "box", one, [&](const Aabb& box) { return oracle::boxes_overlap(one, box); }, counters);
    // What lies between a corner and another one touches others with its sides.
    const Vec3 a = any_corner(random), b = any_corner(random);
    const Aabb between{a.cwiseMin(b), a.cwiseMax(b)};
    require(
        "box", between, [&](const Aabb& box) { return oracle::boxes_overlap(between, box); }, counters);
    require(
        "segment", Segment{a, b}, [&](const Aabb& box) { return oracle::segment_meets_box(a, b, box); }, counters);
    // Along an axis, and so along the sides of a box.
    Vec3 along = a;
    along[static_cast<int>(random.below(3))] = b[static_cast<int>(random.below(3))];
    require(
        "segment", Segment{a, along}, [&](const Aabb& box) { return oracle::segment_meets_box(a, along, box); },
        counters);
    // To one coordinate of another corner: balls that touch a box from one side, if the difference is exact.
    const int axis = static_cast<int>(random.below(3));
    const double radius = std::abs(b[axis] - a[axis]);
    require(
        "ball", Ball{a, radius}, [&](const Aabb& box) { return oracle::ball_meets_box(a, radius, box); }, counters);
    if (random.below(4) == 0) give_own_answer(random);
}

void BoxQuestions::give_own_answer(scenes::Random& random) {
    const BodyId body = std::next(boxes_.begin(), random.below(static_cast<std::uint32_t>(boxes_.size())))->first;
    const BodyId other = std::next(boxes_.begin(), random.below(static_cast<std::uint32_t>(boxes_.size())))->first;
    for (const auto& kind : kinds_) kind->move(proxy_of(body), kind->box(proxy_of(other)));
    boxes_.at(body) = boxes_.at(other);
}

}  // namespace ecods::fuzz
