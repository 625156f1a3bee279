#include <ecods/ecods.hpp>
#include <iostream>
#include <vector>

int main() {
    const std::vector<ecods::Vec3> points{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}};
    const ecods::ConvexSolid corner(points);
    const ecods::Posed<ecods::ConvexSolid> a(corner, {});
    for (const double x : {5.0, 3.0}) {
        const ecods::Posed<ecods::ConvexSolid> b(corner, {.t = {x, 0, 0}});
        const ecods::ClosestPoints p = closest(a, b);
        std::cout << relation(a, b) << ", " << p.distance << " from " << p.point_b.transpose() << '\n';
        if (const auto out = depth(a, b))
            std::cout << "depth " << out->depth << " along " << out->direction.transpose() << '\n';
    }
}
