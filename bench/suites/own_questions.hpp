// Two builds are compared by their answers to these questions about two bodies, and by the time that they take.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "ecods/intersection.hpp"
#include "ecods/pose.hpp"

namespace ecods::bench {

// FNV-1a, 64 bits.
class Hash {
  public:
    void add(std::uint64_t value);
    void add(double value);
    std::uint64_t value() const { return state_; }
    std::string text() const;

  private:
    std::uint64_t state_ = 14695981039346656037u;
};

struct OwnQuestion {
    const char* name;  // behind that of the pairs; empty for whether they touch
    // The shape that the question is about: a solid, for some.
    std::unique_ptr<MeshShape> (*make)(const std::shared_ptr<const Mesh>& mesh);
    // The whole answer, as bits or a hash of them.
    std::uint64_t (*answer)(const Posed<MeshShape>& a, const Posed<MeshShape>& b, const Ask& ask);
};

extern const OwnQuestion touch_question;
extern const OwnQuestion distance_question;
extern const OwnQuestion closest_question;

// The others about any two meshes, or their convex hulls.
std::span<const OwnQuestion> surface_questions();

// About the solids of closed meshes that do not meet themselves.
std::span<const OwnQuestion> solid_questions();

}  // namespace ecods::bench
