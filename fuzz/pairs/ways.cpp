#include <fmt/format.h>

#include <string>
#include <vector>

#include "ecods/error.hpp"
#include "fuzz/pairs/case_run.hpp"
#include "judge/along_questions.hpp"
#include "judge/text.hpp"
#include "judge/turn_truth.hpp"
#include "judge/way_questions.hpp"

namespace ecods::fuzz {
namespace {

using scenes::TurnCase;
using Nodes = std::vector<WayNode>;

// Ways that a turn is made into. All quaternions of `divided` are on the line from 1 to that of the turn, so the body
// goes the same way, and meets the other one if it does on the turn.
Nodes divided(scenes::Random& random, const Turn& turn) {
    const int count = random.below(2) == 0 ? 2 : 4;
    Nodes nodes;
    for (int k = 0; k <= count; ++k) {
        const double s = static_cast<double>(k) / count;
        const auto& [w, x, y, z] = turn.q;
        nodes.push_back(
            {{1 - s + s * w, s * x, s * y, s * z}, turn.pivot_from + s * (turn.pivot_to - turn.pivot_from)});
    }
    return nodes;
}

Nodes there_and_back(scenes::Random& random, const Turn& turn) {
    const WayNode first{{}, turn.pivot_from}, last{turn.q, turn.pivot_to};
    return random.below(2) == 0 ? Nodes{first, last, first} : Nodes{first, last, last, first, last};
}

// Node by node, each with a factor of its own, which changes the speed alone.
Nodes with_factors(scenes::Random& random, const Turn& turn) {
    Nodes nodes{{{0.5, 0, 0, 0}, turn.pivot_from}};
    for (auto left = 1 + random.below(3); left > 0; --left) {
        const double factor = std::ldexp(1.0, static_cast<int>(random.below(9)) - 4);
        const auto number = [&] { return factor * (static_cast<double>(random.below(9)) - 4); };
        nodes.push_back({{number(), number(), number(), factor / 2}, turn.pivot_from});
    }
    nodes.push_back({turn.q, turn.pivot_to});
    return nodes;
}

// Glides away and turns there: later legs alone come near the other body.
Nodes glide_first(scenes::Random& random, const Turn& turn) {
    const Vec3 away = turn.pivot_from + random.uniform(1, 4) * random.direction();
    return {{{}, turn.pivot_from}, {{}, away}, {{0.5, 0.5, 0, 1}, away}, {turn.q, turn.pivot_to}};
}

struct WayFamily {
    const char* name;
    Nodes (*nodes)(scenes::Random& random, const Turn& turn);
};
constexpr WayFamily way_families[] = {{"divided turns", divided},
                                      {"there and back", there_and_back},
                                      {"nodes with factors", with_factors},
                                      {"glides first", glide_first}};

std::string text(const Nodes& nodes) {
    std::string result = "nodes";
    for (const auto& [q, pivot] : nodes) {
        result += fmt::format(" [{:a} {:a} {:a} {:a} at {}]", q.w, q.x, q.y, q.z, judge::text(pivot));
    }
    return result;
}

class Run : CaseRun {
  public:
    using CaseRun::CaseRun;

    // Families of ways take turns, and with each of them those of turns.
    void check_one() {
        const auto turns = scenes::turn_families();
        const WayFamily& way = way_families[index_ % std::size(way_families)];
        const scenes::Family<TurnCase>& turn = turns[index_ / std::size(way_families) % turns.size()];
        ++index_;
        const TurnCase made = turn.make(random_);
        const std::size_t pairs = made.a->triangles().size() * made.b->triangles().size();
        if (pairs > pairs_max || (pairs > few_pairs && random_.below(8) != 0)) return;
        family_ = std::string(way.name) + ", " + std::string(turn.name);
        const Nodes nodes = way.nodes(random_, made.turn);
        try {
            check(made, nodes, way.nodes == divided);
        } catch (const NotSupported&) {
            ++counts_.checks["a way that is not supported"];
        } catch (const InvalidArgument&) {
            ++counts_.checks["a way with opposite nodes"];
        }
    }

  private:
    static constexpr std::size_t pairs_max = 150, few_pairs = 64;  // the oracle asks all of them

    void check(const TurnCase& made, const Nodes& nodes, bool is_divided) {
        const MeshShape a(made.a), b(made.b);
        const Way<MeshShape> way(a, made.pose_a, nodes);
        const Posed<MeshShape> other(b, made.pose_b);
        const std::string how = text(nodes);
        const auto met = cast(way, other, memory_);
        ++counts_.cases;
        ++counts_.kinds[family_][met ? judge::written(met->contact.kind) : "nothing"];
        if (lie_ && met) fail({"cast", "nothing", judge::text(std::optional(met->contact))}, made, "a lie");
        require_right(judge::ask_about_way(way, other, {memory_, witness_}), made, "a way", how);
        require_right(judge::ask_about_along(way, other, {memory_, witness_}), made, "shares of the time", how);
        if (random_.below(4) == 0) {
            require_in_environment(made, [&] { return judge::ask_about_along(way, other, {memory_, witness_}); });
        }
        if (!is_divided || !is_exact(made.turn, nodes)) return;
        const auto turned = cast(Turning<MeshShape>(a, made.pose_a, made.turn), other, 1, memory_);
        const bool is_kept = (turned.has_value() != has_wrong_recipe_) == met.has_value();
        ++counts_.checks["known by its recipe"];
        require_promise(is_kept, judge::text(turned) + " of the turn", met ? "a contact" : "nothing", made);
    }

    void require_right(const std::optional<judge::Wrong>& wrong, const TurnCase& made, const std::string& what,
                       const std::string& how) {
        ++counts_.checks[what];
        if (wrong) fail(*wrong, made, how);
    }

    // True if all nodes are exactly on the turn: sums of few digits.
    static bool is_exact(const Turn& turn, const Nodes& nodes) {
        const auto is_short = [](double x) {
            return std::ldexp(std::round(std::ldexp(x, 20)), -20) == x && std::abs(x) < 0x1p20;
        };
        bool all = true;
        for (const double x : {turn.q.w, turn.q.x, turn.q.y, turn.q.z}) all = all && is_short(x);
        for (int k = 0; k < 3; ++k) all = all && is_short(turn.pivot_from[k]) && is_short(turn.pivot_to[k]);
        return all && nodes.back().q == turn.q;
    }
};

}  // namespace

void run_ways(std::uint32_t seed, Lie lie, CaseCounts& counts) {
    check_cases(seed, lie, counts, 104, &Run::check_one);
}

}  // namespace ecods::fuzz
