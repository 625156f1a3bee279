// CGAL's triangle test with two of its kernels. All of CGAL that the benchmark links is in this file.
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/assertions_behaviour.h>
#include <CGAL/exceptions.h>

#include <array>
#include <optional>

#include "suites/triangle_engines.hpp"

namespace ecods::bench {
namespace {

using Epeck = CGAL::Exact_predicates_exact_constructions_kernel;
using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;

// R v + t in the kernel's numbers: exact for Epeck, in double for Epick.
template <class Kernel>
typename Kernel::Point_3 pose_point(const Pose& pose, const Vec3& v) {
    using Number = typename Kernel::FT;
    std::array<Number, 3> p;
    for (int row = 0; row < 3; ++row) {
        p[static_cast<std::size_t>(row)] = Number(pose.R(row, 0)) * Number(v[0]) +
                                           Number(pose.R(row, 1)) * Number(v[1]) +
                                           Number(pose.R(row, 2)) * Number(v[2]) + Number(pose.t[row]);
    }
    return {p[0], p[1], p[2]};
}

// The triangles of one body, posed when they are first asked for; each vertex is posed once.
template <class Kernel>
class PosedTriangles {
  public:
    explicit PosedTriangles(const PredicateBody& body)
        : body_(body), points_(body.mesh->vertices().size()), triangles_(body.mesh->triangles().size()) {}

    const typename Kernel::Triangle_3& at(std::uint32_t index) {
        auto& triangle = triangles_[index];
        if (!triangle) {
            const Triangle& corners = body_.mesh->triangles()[index];
            triangle.emplace(point(corners[0]), point(corners[1]), point(corners[2]));
        }
        return *triangle;
    }

  private:
    const typename Kernel::Point_3& point(std::uint32_t index) {
        auto& p = points_[index];
        if (!p) p = pose_point<Kernel>(body_.pose, body_.mesh->vertices()[index]);
        return *p;
    }

    const PredicateBody& body_;
    std::vector<std::optional<typename Kernel::Point_3>> points_;
    std::vector<std::optional<typename Kernel::Triangle_3>> triangles_;
};

template <class Kernel>
Answers decide(const PredicateScene& scene) {
    Answers answers;
    answers.reserve(scene.pair_count());
    for (const PredicateTask& task : scene.tasks) {
        PosedTriangles<Kernel> a(scene.bodies[task.a]), b(scene.bodies[task.b]);
        for (const TrianglePair pair : task.pairs) answers.push_back(CGAL::do_intersect(a.at(pair.a), b.at(pair.b)));
    }
    return answers;
}

// Rounding may leave a triangle without area, which CGAL's test excludes: what it says then is only caught, not shown.
void stay_silent(const char*, const char*, const char*, int, const char*) {}

class SilentErrors {
  public:
    SilentErrors() : previous_(CGAL::set_error_handler(stay_silent)) {}
    ~SilentErrors() { CGAL::set_error_handler(previous_); }
    SilentErrors(const SilentErrors&) = delete;
    SilentErrors& operator=(const SilentErrors&) = delete;

  private:
    CGAL::Failure_function previous_;
};

Epick::Triangle_3 posed(const Pose& pose, const std::array<Vec3, 3>& corners) {
    return {pose_point<Epick>(pose, corners[0]), pose_point<Epick>(pose, corners[1]),
            pose_point<Epick>(pose, corners[2])};
}

}  // namespace

Answers decide_by_epeck(const PredicateScene& scene) {
    return decide<Epeck>(scene);
}
Answers decide_by_epick(const PredicateScene& scene) {
    return decide<Epick>(scene);
}

Answers answer_by_epick(std::span<const scenes::PosedPair> pairs) {
    const SilentErrors silent;
    Answers answers;
    answers.reserve(pairs.size());
    for (const scenes::PosedPair& pair : pairs) {
        try {
            answers.push_back(CGAL::do_intersect(posed(pair.pose_a, pair.a), posed(pair.pose_b, pair.b)));
        } catch (const CGAL::Failure_exception&) {
            answers.push_back(no_answer);
        }
    }
    return answers;
}

}  // namespace ecods::bench
