// A picture of what an example asks about: meshes, segments and balls, as a scene that POV-Ray draws.
#pragma once

#include <map>
#include <string>

#include "ecods/mesh.hpp"
#include "ecods/pose.hpp"

namespace ecods::examples {

// A color that has this much of red, green and blue, each from 0 to 1; transparent ones let that share of light
// through.
struct Paint {
    double red = 0, green = 0, blue = 0;
    double transparency = 0;
};

inline constexpr Paint gray{0.42, 0.48, 0.56}, blue{0.10, 0.36, 0.74}, amber{0.95, 0.62, 0.10}, red{0.85, 0.11, 0.16},
    black{0.05, 0.05, 0.08};

constexpr Paint glassy(const Paint& paint, double transparency) {
    return {paint.red, paint.green, paint.blue, transparency};
}

class Stage {
  public:
    // z is up; `angle` is how wide the picture is, in degrees.
    Stage(const Vec3& eye, const Vec3& target, double angle = 40);

    void add(const Mesh& mesh, const Pose& pose, const Paint& paint);
    void add_segment(const Vec3& from, const Vec3& to, double radius, const Paint& paint);
    void add_ball(const Vec3& center, double radius, const Paint& paint);

    // Throws std::runtime_error if the file cannot be written. `povray +IFILE` makes a PNG of it.
    void write(const std::string& file) const;

  private:
    std::map<const Mesh*, std::size_t> meshes_;  // those that have been declared
    std::string text_;
};

}  // namespace ecods::examples
