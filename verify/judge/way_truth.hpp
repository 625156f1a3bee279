// WayTruth has what is true of two bodies on their way, whatever their motion is, and asks the library about it.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "ecods/cast.hpp"
#include "judge/wrong.hpp"
#include "oracle/first_contact.hpp"

namespace ecods::judge {

class WayTruth {
  public:
    const std::optional<FirstContact>& contact() const { return questions_.front().expected; }
    const std::optional<oracle::ExactContact>& exact() const { return exact_; }
    std::size_t sample_count() const { return samples_.size(); }

    // Asks all of it, with the witness, which may come from anywhere, and in the thread's own memory.
    std::optional<Wrong> ask(QueryMemory& memory, PairWitness& witness) const;

  protected:
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
    using PosesAt = std::function<std::optional<std::array<Pose, 2>>(double time)>;

    // Returns equally distant times from 0 to 1, and the rounded first time.
    std::vector<double> sample_times(int count) const;
    // Adds a sample for each time up to the first one at which both poses are doubles.
    void add_samples(std::span<const double> times, const PosesAt& poses_at, const MeshShape& a, const MeshShape& b);

    std::optional<oracle::ExactContact> exact_;
    std::vector<Question> questions_;
    std::vector<Sample> samples_;
};

}  // namespace ecods::judge
