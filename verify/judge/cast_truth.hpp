// Everything that include/ecods/cast.hpp answers about two bodies, judged by the oracle, and by intersects() at times
// at which the poses are doubles.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ecods/cast.hpp"
#include "judge/distance_truth.hpp"
#include "oracle/first_contact.hpp"

namespace ecods::judge {

// As the library writes it.
std::optional<FirstContact> to_first_contact(const std::optional<oracle::ExactContact>& exact);

// Whether all of it is the same, bit for bit.
bool is_same(const std::optional<FirstContact>& x, const std::optional<FirstContact>& y);

// In hexadecimal floats.
std::string text(const std::optional<FirstContact>& contact);

// What is true of two bodies on their way, known before the library is asked: it may be asked in any floating-point
// environment. In both orders; a translation also as the other body's, and as a motion between two poses where these
// are doubles. `samples`: how many times between 0 and 1 are asked for contact, beside the first time and its
// neighbours.
class CastTruth {
  public:
    CastTruth(const Posed<MeshShape>& a, const Vec3& motion, const Posed<MeshShape>& b, int samples = 8);
    CastTruth(const Moving<MeshShape>& a, const Moving<MeshShape>& b, int samples = 8);

    const std::optional<FirstContact>& contact() const { return questions_.front().expected; }
    const std::optional<oracle::ExactContact>& exact() const { return exact_; }
    std::size_t sample_count() const { return samples_.size(); }

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
    void add(const std::string& name, const Posed<MeshShape>& a, const Vec3& motion, const Posed<MeshShape>& b,
             const std::optional<oracle::ExactContact>& expected);
    void add(const std::string& name, const Moving<MeshShape>& a, const Moving<MeshShape>& b,
             const std::optional<oracle::ExactContact>& expected);
    void add_samples(const std::function<std::optional<std::array<Pose, 2>>(double)>& poses_at, const MeshShape& a,
                     const MeshShape& b, int count);

    std::optional<oracle::ExactContact> exact_;
    std::vector<Question> questions_;
    std::vector<Sample> samples_;
};

}  // namespace ecods::judge
