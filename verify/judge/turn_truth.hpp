// Everything that include/ecods/turn.hpp answers about a turning body and one at rest, judged by the oracle; the
// oracle by pieces of the time; and both by intersects() at times at which the poses, times a common factor, are
// doubles.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ecods/turn.hpp"
#include "judge/cast_truth.hpp"

namespace ecods::judge {

// In hexadecimal floats.
std::string text(const Turn& turn);

// What is true of a body that turns, known before the library is asked: it may be asked in any floating-point
// environment. If the pivot stays, the other body turns, too, the other way round: in space as the first one sees it.
class TurnTruth {
  public:
    TurnTruth(const Turning<MeshShape>& a, const Posed<MeshShape>& b, int samples = 8);

    const std::optional<FirstContact>& contact() const { return questions_.front().expected; }
    const std::optional<oracle::ExactContact>& exact() const { return exact_; }
    std::size_t sample_count() const { return samples_.size(); }

    // Nothing, or what pieces of the time say against the first time. Slow: for few triangles.
    std::optional<std::string> contradiction() const;

    // Asks all of it, with the witness, which may come from anywhere, and in the thread's own memory.
    std::optional<Wrong> ask(QueryMemory& memory, PairWitness& witness) const;

  private:
    struct Question {
        std::string name;
        std::function<std::optional<FirstContact>(const Ask&)> ask;
        std::optional<FirstContact> expected;
    };
    // Before the first time bodies do not intersect, and at it they do.
    struct Sample {
        double time;
        Posed<MeshShape> a, b;
        bool intersects;
    };
    void add(const std::string& name, const Turning<MeshShape>& a, const Posed<MeshShape>& b, double max_time,
             const std::optional<oracle::ExactContact>& expected);
    void add_limits(const Turning<MeshShape>& a, const Posed<MeshShape>& b);
    void add_samples(const Turning<MeshShape>& a, const Posed<MeshShape>& b, int count);

    oracle::TurningSoup of_a_;
    oracle::Soup of_b_;
    std::optional<oracle::ExactContact> exact_;
    std::vector<Question> questions_;
    std::vector<Sample> samples_;
};

}  // namespace ecods::judge
