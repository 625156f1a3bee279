// FCL's triangle test, the one that its meshes are tested with.
#include <fcl/narrowphase/detail/traversal/collision/intersect.h>

#include "suites/triangle_engines.hpp"

namespace ecods::bench {

Answers answer_by_fcl(std::span<const scenes::PosedPair> pairs) {
    Answers answers;
    answers.reserve(pairs.size());
    for (const scenes::PosedPair& pair : pairs) {
        std::array<Vec3, 6> p;
        for (std::size_t i = 0; i < 3; ++i) {
            p[i] = pair.pose_a.R * pair.a[i] + pair.pose_a.t;
            p[3 + i] = pair.pose_b.R * pair.b[i] + pair.pose_b.t;
        }
        answers.push_back(fcl::detail::Intersect<double>::intersect_Triangle(p[0], p[1], p[2], p[3], p[4], p[5]));
    }
    return answers;
}

}  // namespace ecods::bench
