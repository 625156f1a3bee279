// What rays hit, against the oracle.
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "check_oracle.hpp"
#include "judge/hit_truth.hpp"

namespace ecods::check {
namespace {

struct TrueHit {
    mpq_class at;
    std::size_t body;
    Hit hit;
};

// Of all bodies, in the order of the exact parameters, then of bodies and triangles.
std::vector<TrueHit> true_hits(const SceneWorld& world, std::size_t body_count, const Ray& ray) {
    std::vector<TrueHit> all;
    for (std::size_t body = 0; body < body_count; ++body) {
        const auto exact = judge::exact_hits(ray, world.posed(body));
        const std::vector<Hit> hits = judge::to_hits(exact);
        for (std::size_t i = 0; i < hits.size(); ++i) all.push_back({exact[i].enter, body, hits[i]});
    }
    std::ranges::stable_sort(all, [](const TrueHit& a, const TrueHit& b) { return a.at < b.at; });
    for (std::size_t i = 0; i < all.size(); ++i) {
        const bool is_tie = i > 0 && all[i].at == all[i - 1].at;
        all[i].hit.rank = i == 0 ? 0 : all[i - 1].hit.rank + (is_tie ? 0 : 1);
    }
    return all;
}

}  // namespace

void OracleJudge::check_hits(const SceneWorld& world, const FrameAnswer& answer) {
    const std::vector<Ray>& rays = world.questions().rays;
    for (std::size_t ray = 0; ray < rays.size(); ++ray) {
        ++report_.rays;
        const auto found = std::ranges::equal_range(answer.hits, ray, {}, &HitAnswer::ray);
        const std::vector<TrueHit> exact = true_hits(world, scene_.bodies.size(), rays[ray]);
        const bool is_same = std::ranges::equal(found, exact, [](const HitAnswer& a, const TrueHit& b) {
            return a.body == b.body && judge::is_same(a.hit, b.hit);
        });
        if (is_same) continue;
        std::string listed, right;
        for (const auto& [number, body, hit] : found)
            listed += scene_.bodies[body].name + " " + judge::text(hit) + ", ";
        for (const auto& [at, body, hit] : exact) right += scene_.bodies[body].name + " " + judge::text(hit) + ", ";
        differ(answer, fmt::format("ray {}", ray), fmt::format("hits {}but exactly {}", listed, right));
    }
}

}  // namespace ecods::check
