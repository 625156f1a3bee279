#include "judge/hit_truth.hpp"

#include <fmt/format.h>

#include <cmath>

#include "judge/text.hpp"
#include "oracle/float_environment.hpp"

namespace ecods::judge {
namespace {

std::string text(const std::optional<Hit>& hit) {
    return hit ? judge::text(*hit) : "nothing";
}

std::optional<Hit> first_of(const std::vector<Hit>& hits) {
    if (hits.empty()) return std::nullopt;
    return hits.front();
}

bool is_same(const std::optional<Hit>& x, const std::optional<Hit>& y) {
    return x.has_value() == y.has_value() && (!x || judge::is_same(*x, *y));
}

}  // namespace

std::vector<Hit> to_hits(const std::vector<oracle::ExactHit>& exact) {
    std::vector<Hit> hits;
    for (const oracle::ExactHit& from : exact) {
        Hit hit;
        hit.parameter = oracle::nearest_parameter(from.enter);
        hit.leave_parameter = oracle::nearest_parameter(from.leave);
        hit.kind = static_cast<HitKind>(from.way);
        hit.rank = from.rank;
        hit.feature = to_feature(from.feature);
        hit.point = from.point.nearest();
        hit.leave_point = from.leave_point.nearest();
        hits.push_back(hit);
    }
    return hits;
}

bool is_same(const Hit& x, const Hit& y) {
    return same_bits(x.parameter, y.parameter) && same_bits(x.leave_parameter, y.leave_parameter) && x.kind == y.kind &&
           x.rank == y.rank && x.feature == y.feature && same_bits(x.point, y.point) &&
           same_bits(x.leave_point, y.leave_point);
}

std::string text(const Hit& hit) {
    return fmt::format("{:a} to {:a} {} ({}) {} to {}, rank {}", hit.parameter, hit.leave_parameter, text(hit.feature),
                       written(hit.kind), text(hit.point), text(hit.leave_point), hit.rank);
}

std::string text(const HitLine& line) {
    if (const auto* s = std::get_if<Segment>(&line)) return fmt::format("segment {} {}", text(s->a), text(s->b));
    const Ray& ray = std::get<Ray>(line);
    return fmt::format("ray {} {} up to {:a}", text(ray.origin), text(ray.direction), ray.max_parameter);
}

std::vector<oracle::ExactHit> exact_hits(const HitLine& line, const Posed<MeshShape>& body) {
    if (const auto* s = std::get_if<Segment>(&line)) return oracle::all_hits({s->a, s->b, false, 1}, soup(body));
    const Ray& ray = std::get<Ray>(line);
    return oracle::all_hits({ray.origin, ray.direction, true, ray.max_parameter}, soup(body));
}

HitTruth::HitTruth(const HitLine& line, const Posed<MeshShape>& body) : body_(body) {
    add(line);
    if (const auto* segment = std::get_if<Segment>(&line)) {
        add(Segment{segment->b, segment->a});
        add_as_ray(*segment);
    } else {
        add_limits(std::get<Ray>(line));
    }
}

void HitTruth::add(const HitLine& line) {
    questions_.push_back({line, to_hits(exact_hits(line, body_))});
}

void HitTruth::add_as_ray(const Segment& segment) {
    const oracle::FloatEnvironment environment;
    Ray ray{segment.a, segment.b - segment.a, 1};
    bool is_exact = ray.direction.allFinite() && ray.direction != Vec3::Zero();
    for (int k = 0; k < 3 && is_exact; ++k) {
        is_exact = mpq_class(segment.b[k]) - mpq_class(segment.a[k]) == mpq_class(ray.direction[k]);
    }
    if (is_exact) questions_.push_back({ray, hits()});
}

void HitTruth::add_limits(Ray ray) {
    if (hits().empty()) return;
    for (const double at : {hits().front().parameter, hits().back().leave_parameter}) {
        if (std::isinf(at)) continue;
        for (const int step : {-1, 0, 1}) {
            if (at == 0 && step < 0) continue;
            ray.max_parameter = neighbour(at, step);
            add(ray);
        }
    }
}

std::optional<Wrong> HitTruth::ask(QueryMemory& memory, PairWitness& witness) const {
    for (const Question& question : questions_) {
        if (auto wrong = ask(question, memory, witness)) return wrong;
    }
    return std::nullopt;
}

std::optional<Wrong> HitTruth::ask(const Question& question, QueryMemory& memory, PairWitness& witness) const {
    const std::optional<Hit> first = first_of(question.expected);
    const auto visit = [&](const auto& line) -> std::optional<Wrong> {
        const std::vector<Hit> got = all_hits(line, body_, memory);
        for (std::size_t i = 0; i < std::min(got.size(), question.expected.size()); ++i) {
            if (judge::is_same(got[i], question.expected[i])) continue;
            return Wrong{fmt::format("all_hits, item {}", i), text(question.expected[i]), text(got[i])};
        }
        if (got.size() != question.expected.size()) {
            return Wrong{"all_hits: length", std::to_string(question.expected.size()), std::to_string(got.size())};
        }
        const std::pair<const char*, std::optional<Hit>> asked[] = {
            {"first_hit", first_hit(line, body_, memory)},
            {"first_hit, with a witness", first_hit(line, body_, {memory, witness})},
            {"first_hit, with its own witness", first_hit(line, body_, {memory, witness})},
            {"first_hit, asked once more", first_hit(line, body_, {memory, witness})},
            {"first_hit, in the thread's memory", first_hit(line, body_)}};
        for (const auto& [name, hit] : asked) {
            if (!is_same(first, hit)) return Wrong{name, text(first), text(hit)};
        }
        return std::nullopt;
    };
    auto wrong = std::visit(visit, question.line);
    if (wrong) wrong->question += " of " + text(question.line);
    return wrong;
}

}  // namespace ecods::judge
