#include "programs/clash/judge.hpp"

#include <algorithm>
#include <tuple>
#include <utility>
#include <vector>

#include "ecods/broad_phase.hpp"
#include "ecods/intersection.hpp"
#include "process/parallel.hpp"
#include "process/progress.hpp"
#include "programs/clash/penetration.hpp"
#include "programs/clash/place.hpp"
#include "programs/clash/verdict.hpp"

namespace ecods::clash {
namespace {

using Pair = std::pair<std::size_t, std::size_t>;

// Pairs whose boxes are not proven to be further apart than the clearance, ascending. Which these are may depend on
// rounding; what they are judged to be does not.
std::vector<Pair> find_candidates(const std::vector<Part>& parts, const std::vector<Aabb>& boxes,
                                  const JudgeOptions& options) {
    const PairFilter filter(parts, options.rules);
    const auto broad_phase = make_broad_phase(BroadPhaseKind::kept_candidates);
    broad_phase->reserve(parts.size());
    for (std::size_t i = 0; i < parts.size(); ++i) broad_phase->add(static_cast<ProxyIndex>(i), boxes[i]);
    std::vector<Pair> pairs;
    const double limit = options.clearance.value_or(0);
    broad_phase->visit_near_pairs(limit, [&](ProxyPair pair) {
        if (filter.is_judged(pair.a, pair.b)) pairs.emplace_back(pair.a, pair.b);
        return limit;
    });
    std::sort(pairs.begin(), pairs.end());
    return pairs;
}

// Work on consecutive items is handed out in blocks: a pair may cost less than a microsecond.
constexpr std::size_t block_size = 16;

template <class Task>
void for_each_block(std::size_t count, const JudgeOptions& options, const char* label, const Task& task) {
    std::vector<QueryMemory> memories(std::max<std::size_t>(options.jobs, 1));
    const std::size_t block_count = (count + block_size - 1) / block_size;
    process::Progress progress(label, block_count);
    process::for_each_in_parallel(block_count, memories.size(), [&](std::size_t block, std::size_t worker) {
        const std::size_t end = std::min(count, (block + 1) * block_size);
        for (std::size_t i = block * block_size; i < end; ++i) task(i, memories[worker]);
        progress.step();
    });
}

std::vector<Aabb> find_boxes(const std::vector<Part>& parts, const JudgeOptions& options) {
    std::vector<Aabb> boxes(parts.size());
    for_each_block(parts.size(), options, "finding boxes",
                   [&](std::size_t i, QueryMemory&) { boxes[i] = bounds_of(parts[i]); });
    return boxes;
}

// As judge_pair() asks: interiors that meet do so inside both boxes. Triangles without area belong to no interior, so
// that a box around them is only larger.
bool can_be_deep(const Aabb& a, const Aabb& b) {
    return (a.min.array() < b.max.array()).all() && (b.min.array() < a.max.array()).all();
}

std::vector<Clash> find_clashes(const std::vector<Part>& parts, const JudgeOptions& options) {
    const std::vector<Aabb> boxes = find_boxes(parts, options);
    const std::vector<Pair> pairs = find_candidates(parts, boxes, options);
    std::vector<std::optional<Verdict>> verdicts(pairs.size());
    for_each_block(pairs.size(), options, "judging", [&](std::size_t i, QueryMemory& memory) {
        const auto [a, b] = pairs[i];
        verdicts[i] = judge_pair(parts[a], parts[b], options.clearance, memory, can_be_deep(boxes[a], boxes[b]));
    });
    std::vector<Clash> clashes;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        if (!verdicts[i] || (verdicts[i]->kind == Kind::touching && !options.has_touching)) continue;
        clashes.push_back({.a = pairs[i].first,
                           .b = pairs[i].second,
                           .kind = verdicts[i]->kind,
                           .relation = verdicts[i]->relation,
                           .distance = verdicts[i]->distance});
    }
    return clashes;
}

bool has_depth(const std::vector<Part>& parts, const Clash& clash) {
    const bool share_inner_points =
        clash.kind == Kind::equal || clash.kind == Kind::inside || clash.kind == Kind::overlapping;
    return share_inner_points && parts[clash.a].is_solid && parts[clash.b].is_solid;
}

void find_places(const std::vector<Part>& parts, const JudgeOptions& options, std::vector<Clash>& clashes) {
    const auto has_bounds = [&](const Clash& clash) {
        return has_depth(parts, clash) && !are_convex(parts[clash.a], parts[clash.b]);
    };
    const auto bound_count = static_cast<std::size_t>(std::count_if(clashes.begin(), clashes.end(), has_bounds));
    const bool is_narrow = options.has_narrow_depths || bound_count <= narrow_depth_limit;
    for_each_block(clashes.size(), options, "finding places", [&](std::size_t i, QueryMemory& memory) {
        Clash& clash = clashes[i];
        const Part& a = parts[clash.a];
        const Part& b = parts[clash.b];
        const Verdict verdict{clash.kind, clash.relation, clash.distance};
        clash.place = options.line_limit == 0 ? place_of(a, b, verdict, memory)
                                              : place_with_lines(a, b, verdict, options.line_limit, memory);
        if (!has_depth(parts, clash)) return;
        clash.depth = is_narrow ? narrow_depth_of(a, b, memory) : depth_of(a, b, clash.place.box, memory);
    });
}

}  // namespace

ClashReport judge(Inputs inputs, const JudgeOptions& options) {
    ClashReport report;
    report.parts = std::move(inputs.parts);
    report.failed = std::move(inputs.failed);
    report.notes = std::move(inputs.notes);
    report.line_limit = options.line_limit;
    set_groups(report.parts, options.rules);
    report.clashes = find_clashes(report.parts, options);
    find_places(report.parts, options, report.clashes);
    std::sort(report.clashes.begin(), report.clashes.end(),
              [](const Clash& x, const Clash& y) { return std::tie(x.kind, x.a, x.b) < std::tie(y.kind, y.a, y.b); });
    for (const Clash& clash : report.clashes) ++report.counts[static_cast<std::size_t>(clash.kind)];
    return report;
}

}  // namespace ecods::clash
