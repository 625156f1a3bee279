#include "judge/way_truth.hpp"

#include <fmt/format.h>

#include <utility>

#include "ecods/intersection.hpp"
#include "judge/cast_truth.hpp"

namespace ecods::judge {

std::vector<double> WayTruth::sample_times(int count) const {
    std::vector<double> times;
    for (int i = 0; i <= count; ++i) times.push_back(static_cast<double>(i) / count);
    if (exact_) times.push_back(exact_->rounded);
    return times;
}

void WayTruth::add_samples(std::span<const double> times, const PosesAt& poses_at, const MeshShape& a,
                           const MeshShape& b) {
    for (const double s : times) {
        const int order = exact_ ? exact_->time.compare(mpq_class(s)) : 1;
        if (order < 0) continue;
        const auto poses = poses_at(s);
        if (poses) samples_.push_back({s, {a, (*poses)[0]}, {b, (*poses)[1]}, order == 0});
    }
}

std::optional<Wrong> WayTruth::ask(QueryMemory& memory, PairWitness& witness) const {
    for (const Question& question : questions_) {
        const std::pair<const char*, std::optional<FirstContact>> asked[] = {
            {"", question.ask(memory)},
            {", with a witness", question.ask({memory, witness})},
            {", with its own witness", question.ask({memory, witness})},
            {", in the thread's memory", question.ask({})}};
        for (const auto& [how, contact] : asked) {
            if (is_same(contact, question.expected)) continue;
            return Wrong{question.name + how, text(question.expected), text(contact)};
        }
    }
    for (const Sample& sample : samples_) {
        if (intersects(sample.a, sample.b, memory) == sample.intersects) continue;
        return Wrong{fmt::format("intersects at time {:a}", sample.time), sample.intersects ? "yes" : "no",
                     "the contrary"};
    }
    return std::nullopt;
}

}  // namespace ecods::judge
