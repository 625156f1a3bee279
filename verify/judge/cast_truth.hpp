// Everything that include/ecods/cast.hpp answers about two bodies, judged by the oracle, and by intersects() at times
// at which the poses are doubles.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ecods/cast.hpp"
#include "judge/distance_truth.hpp"
#include "judge/way_truth.hpp"
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
class CastTruth : public WayTruth {
  public:
    CastTruth(const Posed<MeshShape>& a, const Vec3& motion, const Posed<MeshShape>& b, int samples = 8);
    CastTruth(const Moving<MeshShape>& a, const Moving<MeshShape>& b, int samples = 8);

  private:
    void add(const std::string& name, const Posed<MeshShape>& a, const Vec3& motion, const Posed<MeshShape>& b,
             const std::optional<oracle::ExactContact>& expected);
    void add(const std::string& name, const Moving<MeshShape>& a, const Moving<MeshShape>& b,
             const std::optional<oracle::ExactContact>& expected);
    void add_samples(const PosesAt& poses_at, const MeshShape& a, const MeshShape& b, int count);
};

}  // namespace ecods::judge
