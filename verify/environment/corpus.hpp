// The corpus of single triangles as a file of records of doubles: pairs of posed triangles, lines at one of them, and
// triangles on their way.
#pragma once

#include <array>
#include <cstddef>

namespace ecods::environment {

// What is asked of a record, its first number.
enum class Asked { pair, segment, ray, translation, motion };

// Then of either body R (rows), t and three corners; where it goes, R and t; two vectors, which are the ends of a
// segment, origin and direction of a ray, or (the first) a motion; and the largest parameter of a ray.
inline constexpr std::size_t doubles_per_pose = 9 + 3;
inline constexpr std::size_t doubles_per_body = 2 * doubles_per_pose + 9;
inline constexpr std::size_t doubles_per_record = 1 + 2 * doubles_per_body + 2 * 3 + 1;
using Record = std::array<double, doubles_per_record>;

}  // namespace ecods::environment
