// Predicates of a triangle with segments, rays, lines and triangles, for all orders of corners (CGAL,
// Intersections_3/test/Intersections_3/triangle_other.cpp).
#include <array>
#include <string_view>
#include <vector>

#include "ecods/primitives.hpp"
#include "foreign/shapes.hpp"
#include "foreign/sources.hpp"

namespace ecods::foreign::cgal_orders {
namespace {

using Corners = std::array<Vec3, 3>;

Corners in_order(const Corners& t, const std::array<std::size_t, 3>& order) {
    return {t[order[0]], t[order[1]], t[order[2]]};
}

// Half the way to the plane z = 2 of the triangle; through the first 12 a line from the origin misses it.
constexpr std::size_t missing_count = 12;
constexpr double below[19][2] = {{-1, 1}, {-1, -1}, {-1, 0}, {0, 1},  {0, -1}, {2, -3}, {2, 3},
                                 {4, 6},  {4, 4},   {4, -6}, {4, -4}, {4, 0},  {0, 0},  {2, -2},
                                 {2, 2},  {1, 0},   {1, -1}, {2, 0},  {1, 1}};

// Points of the triangle's plane. From each to the double of each point above: does the segment, which is the same as
// the ray, or the opposite ray meet the triangle?
struct InPlane {
    double x, y;
    std::string_view onwards, opposite;
};
constexpr InPlane in_plane[5] = {{-1, -1, "0000000010011111111", "0100000000000000000"},
                                 {-1, 0, "0000000000011111111", "0010000000000000000"},
                                 {0, 0, "1111111111111111111", "1111111111111111111"},
                                 {0, 1, "0000110001111111111", "1011000000000000000"},
                                 {1, 1, "1111111111111111111", "1111111111111111111"}};

class LinesOfOneTriangle {
  public:
    explicit LinesOfOneTriangle(Expectations& expect) : expect_(expect) {
        const Corners t{Vec3(0, 0, 2), Vec3(4, 4, 2), Vec3(4, -4, 2)};
        for (const auto& order : orders) {
            const Corners o = in_order(t, order);
            shapes_.push_back(std::make_unique<MeshShape>(Mesh::create({o.begin(), o.end()}, {{0, 1, 2}})));
        }
    }

    void ask() {
        expect_.from("segments, rays and lines across the plane");
        for (const double k : {-3.0, -1.0, 1.0, 3.0}) {
            for (std::size_t i = 0; i < 19; ++i) {
                const bool hits = i >= missing_count;
                check(Vec3::Zero(), k * Vec3(below[i][0], below[i][1], 1), hits && k > 2, hits && k > 0, hits && k < 0);
            }
        }
        expect_.from("segments, rays and lines in the plane");
        for (const InPlane& from : in_plane) {
            for (std::size_t i = 0; i < 19; ++i) {
                const Vec3 p(from.x, from.y, 2), q = 2 * Vec3(below[i][0], below[i][1], 1);
                if (p == q) continue;
                const bool onwards = from.onwards[i] == '1';
                check(p, q, onwards, onwards, from.opposite[i] == '1');
            }
        }
        expect_.from("a parallel ray");
        for (const auto& shape : shapes_) expect_.is(meets(Ray{{-1, 0, 1}, {5, 0, 0}}, *shape), false);
    }

  private:
    template <class Line>
    static bool meets(const Line& line, const MeshShape& shape) {
        return first_hit(line, {shape, Pose{}}).has_value();
    }

    void check(const Vec3& p, const Vec3& q, bool segment, bool onwards, bool opposite) {
        for (const auto& shape : shapes_) {
            expect_.is(meets(Segment{p, q}, *shape), segment);
            expect_.is(meets(Segment{q, p}, *shape), segment);
            const bool forth = meets(Ray{p, q - p}, *shape), back = meets(Ray{p, p - q}, *shape);
            expect_.is(forth, onwards);
            expect_.is(back, opposite);
            expect_.is(forth || back, onwards || opposite);  // the whole line
        }
    }

    Expectations& expect_;
    std::vector<std::unique_ptr<MeshShape>> shapes_;
};

// The triangles in all orders of their corners and in both orders of the two: 72 expectations.
void check_orders(Expectations& expect, const Corners& a, const Corners& b, bool answer) {
    for (const auto& order_a : orders) {
        for (const auto& order_b : orders) {
            const Corners p = in_order(a, order_a), q = in_order(b, order_b);
            expect.is(triangle_triangle(p, q) != Relation::apart, answer);
            expect.is(triangle_triangle(q, p) != Relation::apart, answer);
        }
    }
}

// Seven triangles of the plane z = 0 by their x and y, and seven of y = 0 by their x and z. On the x axis they have
// nothing, a point, lengths of 1, 2 and 3.
constexpr double flat[7][6] = {{0, -3, 4, -5, 4, -1},  {0, 0, 0, -4, 4, -2}, {0, 1, 0, -3, 2, -1},
                               {-1, -1, 1, -3, 1, 1},  {0, 2, 0, -2, 2, 0},  {0, 0, 2, 2, 2, -2},
                               {0, 0, 3, 0, 1.5, -1.5}};
constexpr double upright[7][6] = {{0, 3, 4, 5, 4, 1},  {0, 0, 0, 4, 4, 2},  {0, -1, 0, 3, 2, 1},   {-1, 1, 1, 3, 1, -1},
                                  {0, -2, 0, 2, 2, 0}, {0, 0, 2, -2, 2, 2}, {0, 0, 3, 0, 1.5, 1.5}};

// The first triangles are moved along x from -4 to 4. Both must be beyond these numbers to meet: those that reach as
// far.
constexpr int flat_beyond[9] = {8, 5, 3, 1, 0, 0, 0, 0, 0};
constexpr int upright_beyond[9] = {0, 0, 0, 0, 0, 1, 3, 5, 8};

void ask_crossed(Expectations& expect) {
    expect.from("triangles of two planes");
    for (std::size_t move = 0; move < 9; ++move) {
        const double x = static_cast<double>(move) - 4;
        for (std::size_t i = 0; i < 7; ++i) {
            for (std::size_t j = 0; j < 7; ++j) {
                const double *f = flat[i], *u = upright[j];
                const Corners a{Vec3(f[0] + x, f[1], 0), Vec3(f[2] + x, f[3], 0), Vec3(f[4] + x, f[5], 0)};
                const Corners b{Vec3(u[0], 0, u[1]), Vec3(u[2], 0, u[3]), Vec3(u[4], 0, u[5])};
                check_orders(expect, a, b,
                             static_cast<int>(i) > flat_beyond[move] && static_cast<int>(j) > upright_beyond[move]);
            }
        }
    }
}

// Points around the triangle (0, 0), (4, -4), (4, 4), and from number 25 on below, in and right of it.
constexpr double around[50][2] = {{7, 5},  {6, 5},  {6, 6},  {6, 7},  {5, 5},  {5, 7},  {4, 6},   {4, 7},  {2, 5},
                                  {2, 6},  {2, 7},  {1, 4},  {1, 5},  {0, 3},  {0, 4},  {0, 4.5}, {0, 6},  {0, 7},
                                  {-1, 3}, {-1, 5}, {-1, 7}, {-1, 8}, {-2, 7}, {-5, 5}, {-5, 4},  {0, -3}, {0, -5},
                                  {2, -5}, {4, -7}, {4, -5}, {5, -7}, {6, -6}, {5, -5}, {0, 0},   {1, 1},  {1, -1},
                                  {2, 2},  {2, 1},  {2, 0},  {3, 3},  {3, 0},  {3, -3}, {4, 4},   {4, 1},  {4, -1},
                                  {4, -4}, {6, 3},  {6, 1},  {6, -1}, {8, 2}};

// Whether the triangle of this third point and of the points j < k meets the one above.
struct Third {
    double x, y;
    bool (*meets)(int j, int k);
};
bool always(int, int) {
    return true;
}
bool if_reaching_in(int, int k) {
    return k >= 25;
}
bool if_not_passing_by(int j, int k) {
    return k >= 25 && !(k <= 26 && j >= 18 && j <= 22) && !(k <= 30 && j >= 23);
}
bool if_not_passing_by_lower(int j, int k) {
    return if_not_passing_by(j, k) && !(k <= 32 && j >= 24);
}
constexpr Third thirds[6] = {{0, 0, always},
                             {2, 1, always},
                             {2, 2, always},
                             {0, 6, if_reaching_in},
                             {-5.5, 5.5, if_not_passing_by},
                             {-5, 4, if_not_passing_by_lower}};

void ask_coplanar(Expectations& expect) {
    expect.from("triangles of one plane");
    const Corners t{Vec3(0, 0, 1), Vec3(4, -4, 1), Vec3(4, 4, 1)};
    for (const Third& third : thirds) {
        for (int j = 0; j < 50; ++j) {
            for (int k = j + 1; k < 50; ++k) {
                const double *p = around[j], *q = around[k];
                if ((p[0] - third.x) * (q[1] - third.y) == (p[1] - third.y) * (q[0] - third.x)) continue;
                check_orders(expect, t, {Vec3(third.x, third.y, 1), Vec3(p[0], p[1], 1), Vec3(q[0], q[1], 1)},
                             third.meets(j, k));
            }
        }
    }
}

}  // namespace

void ask(Expectations& expect) {
    LinesOfOneTriangle(expect).ask();
    ask_crossed(expect);
    ask_coplanar(expect);
}

}  // namespace ecods::foreign::cgal_orders
