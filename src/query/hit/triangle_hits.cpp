#include "query/hit/triangle_hits.hpp"

#include "exact/measure/measure_pair.hpp"
#include "exact/point/integer_points.hpp"

namespace ecods {

using namespace exact;

void TriangleHits::bind(const Line& line, const BodyRef& body) noexcept {
    line_ = &line;
    body_ = body;
    line_pose_.t = line.is_ray ? line.a : Vec3(0, 0, 0);
}

bool TriangleHits::find(std::uint32_t triangle, LineHit& hit) const {
    static const Vec3 origin(0, 0, 0);
    PosedPoints<5> posed;
    posed[0] = {&line_pose_, line_->is_ray ? &origin : &line_->a};
    posed[1] = {&line_pose_, &line_->b};
    for (std::size_t k = 0; k < 3; ++k) {
        posed[2 + k] = {body_.pose, &body_.mesh->vertices()[body_.mesh->triangles()[triangle][k]]};
    }
    return with_integers(posed, [&]<class Kernel>(const IntegerPoints<Kernel, 5>& points) {
        constexpr int L = limbs_of<Kernel>;
        const auto limbs = to_limbs(points);
        const LimbVector<L> d = difference<L>(limbs[1], limbs[0]);
        const std::array<LimbVector<L>, 3> corners{difference<L>(limbs[2], limbs[0]), difference<L>(limbs[3], limbs[0]),
                                                   difference<L>(limbs[4], limbs[0])};
        return LineTriangle<L>(d, corners, line_->end).find(hit);
    });
}

}  // namespace ecods
