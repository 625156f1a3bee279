// Binds questions about many poses, points or rays: one call, without the interpreter's lock, on several threads.
#include <algorithm>
#include <exception>
#include <functional>
#include <span>
#include <vector>

#include "ecods/distance.hpp"
#include "ecods/error.hpp"
#include "ecods/hit.hpp"
#include "ecods/intersection.hpp"
#include "ecods/solid.hpp"
#include "python/bind/ask.hpp"
#include "python/bind/bind.hpp"
#include "python/bind/shapes.hpp"
#include "python/bind/threads.hpp"

namespace ecods::python {
namespace {

// Divides `count` items into parts and calls part(begin, end) for each, on several threads. Parts are long, so that the
// witness of one query helps the next one.
template <class Part>
void in_parts(std::size_t count, std::size_t threads, const Part& part) {
    const auto executor = make_threads(threads);
    const py::gil_scoped_release release;
    if (!executor || count < 2) return part(std::size_t{0}, count);
    const std::size_t parts = std::min(count, 8 * threads);
    std::vector<std::exception_ptr> failures(parts);
    executor->run(parts, [&](std::size_t i, std::size_t) {
        try {
            part(count * i / parts, count * (i + 1) / parts);
        } catch (...) {
            failures[i] = std::current_exception();
        }
    });
    for (const auto& failure : failures) {
        if (failure) std::rethrow_exception(failure);
    }
}

std::size_t common_length(const PoseList& a, const PoseList& b) {
    if (a.is_single()) return b.size();
    if (!b.is_single() && a.size() != b.size()) {
        throw py::value_error("poses: " + std::to_string(a.size()) + " of a, " + std::to_string(b.size()) + " of b");
    }
    return a.size();
}

// Returns an array with the answers of question(a, b, ask), one for each place in the lists of poses. A single pose
// stands for all places.
template <class Answer, class Question>
py::array_t<Answer> at_poses(const MeshShape& a, const py::object& poses_a, const MeshShape& b,
                             const py::object& poses_b, std::size_t threads, const Question& question) {
    const PoseList of_a(poses_a, "poses_a");
    const PoseList of_b(poses_b, "poses_b");
    const std::size_t count = common_length(of_a, of_b);
    py::array_t<Answer> answers(static_cast<py::ssize_t>(count));
    Answer* const out = answers.mutable_data();
    in_parts(count, threads, [&](std::size_t begin, std::size_t end) {
        PairWitness witness;
        const Ask ask(witness);
        for (std::size_t i = begin; i < end; ++i) {
            const Posed<MeshShape> x{a, of_a[i]};
            const Posed<MeshShape> y{b, of_b[i]};
            out[i] = static_cast<Answer>(question(x, y, ask));
        }
    });
    return answers;
}

template <class Answer, class Question>
void add_at_poses(py::module_& m, const char* name, const char* doc, Question question) {
    m.def(
        name,
        [question](const MeshShape& a, const py::object& poses_a, const MeshShape& b, const py::object& poses_b,
                   std::size_t threads) { return at_poses<Answer>(a, poses_a, b, poses_b, threads, question); },
        py::arg("a"), py::arg("poses_a"), py::arg("b"), py::arg("poses_b") = py::none(), py::arg("threads") = 1, doc);
}

py::tuple first_hits(const py::object& origins, const py::object& directions, const PosedMesh& body,
                     double max_parameter, std::size_t threads) {
    const Doubles from = exact_points(origins, "origins");
    const Doubles along = exact_points(directions, "directions");
    if (from.shape(0) != along.shape(0)) throw py::value_error("origins and directions: of different lengths");
    py::array_t<double> parameters(from.shape(0));
    py::array_t<std::int64_t> triangles(from.shape(0));
    double* const s = parameters.mutable_data();
    std::int64_t* const t = triangles.mutable_data();
    in_parts(static_cast<std::size_t>(from.shape(0)), threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const double* o = from.data() + 3 * i;
            const double* d = along.data() + 3 * i;
            const Ray ray{
                .origin = {o[0], o[1], o[2]}, .direction = {d[0], d[1], d[2]}, .max_parameter = max_parameter};
            const auto hit = first_hit(ray, body);
            s[i] = hit ? hit->parameter : std::numeric_limits<double>::quiet_NaN();
            t[i] = hit && hit->kind != HitKind::inside ? std::int64_t{hit->triangle()} : -1;
        }
    });
    return py::make_tuple(parameters, triangles);
}

py::tuple all_hits_many(const py::object& origins, const py::object& directions, const PosedMesh& body,
                        double max_parameter) {
    const Doubles from = exact_points(origins, "origins");
    const Doubles along = exact_points(directions, "directions");
    if (from.shape(0) != along.shape(0)) throw py::value_error("origins and directions: of different lengths");
    std::vector<Ray> rays(static_cast<std::size_t>(from.shape(0)));
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const double* o = from.data() + 3 * i;
        const double* d = along.data() + 3 * i;
        rays[i] = {.origin = {o[0], o[1], o[2]}, .direction = {d[0], d[1], d[2]}, .max_parameter = max_parameter};
    }
    const HitLists lists = ask([&] { return all_hits(rays, body); });
    py::array_t<std::int64_t> first(static_cast<py::ssize_t>(lists.first.size()));
    std::ranges::copy(lists.first, first.mutable_data());
    py::array_t<double> parameters(static_cast<py::ssize_t>(lists.hits.size()));
    py::array_t<std::int64_t> triangles(static_cast<py::ssize_t>(lists.hits.size()));
    for (std::size_t i = 0; i < lists.hits.size(); ++i) {
        const Hit& hit = lists.hits[i];
        parameters.mutable_data()[i] = hit.parameter;
        triangles.mutable_data()[i] = hit.kind == HitKind::inside ? -1 : std::int64_t{hit.triangle()};
    }
    return py::make_tuple(first, parameters, triangles);
}

py::array_t<std::uint8_t> locate_many(const py::object& points, const PosedMesh& solid, std::size_t threads) {
    const Doubles rows = exact_points(points, "points");
    const auto posed = as<Solid>(solid, "solid");
    py::array_t<std::uint8_t> sides(rows.shape(0));
    std::uint8_t* const out = sides.mutable_data();
    in_parts(static_cast<std::size_t>(rows.shape(0)), threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const double* x = rows.data() + 3 * i;
            out[i] = static_cast<std::uint8_t>(locate({x[0], x[1], x[2]}, posed).side);
        }
    });
    return sides;
}

// Calls ask(points of a part, index of the part's first point) on several threads. If an error has an index, this
// becomes the index among all points.
template <class AskPart>
void ask_about_points(const Doubles& rows, std::size_t threads, const AskPart& ask) {
    std::vector<Vec3> points;
    const auto count = static_cast<std::size_t>(rows.shape(0));
    points.reserve(count);
    for (const double* x = rows.data(); points.size() < count; x += 3) points.emplace_back(x[0], x[1], x[2]);
    in_parts(count, threads, [&](std::size_t begin, std::size_t end) {
        try {
            ask(std::span<const Vec3>(points).subspan(begin, end - begin), begin);
        } catch (const InvalidArgument& error) {
            if (!error.index) throw;
            throw error.at({}, begin + *error.index);
        }
    });
}

py::array_t<double> signed_distance_many(const py::object& points, const PosedMesh& body, std::size_t threads) {
    const Doubles rows = exact_points(points, "points");
    py::array_t<double> numbers(rows.shape(0));
    double* const out = numbers.mutable_data();
    ask_about_points(rows, threads, [&](std::span<const Vec3> part, std::size_t begin) {
        std::ranges::copy(signed_distance(part, body), out + begin);
    });
    return numbers;
}

py::tuple closest_many(const py::object& points, const PosedMesh& body, std::size_t threads) {
    const Doubles rows = exact_points(points, "points");
    py::array_t<double> nearest({rows.shape(0), py::ssize_t{3}});
    py::array_t<double> distances(rows.shape(0));
    py::array_t<std::int64_t> triangles(rows.shape(0));
    double* const p = nearest.mutable_data();
    double* const d = distances.mutable_data();
    std::int64_t* const t = triangles.mutable_data();
    ask_about_points(rows, threads, [&](std::span<const Vec3> part, std::size_t begin) {
        for (std::size_t i = begin; const ClosestPoint& found : closest(part, body)) {
            for (int axis = 0; axis < 3; ++axis) p[3 * i + static_cast<std::size_t>(axis)] = found.point[axis];
            d[i] = found.distance;
            t[i] = found.feature == no_feature ? -1 : std::int64_t{found.feature.triangle};
            ++i;
        }
    });
    return py::make_tuple(nearest, distances, triangles);
}

}  // namespace

void bind_many(py::module_& m) {
    add_at_poses<bool>(
        m, "collide_many",
        "intersects() of a at each pose in poses_a and b at the pose at the same place in poses_b: (k,) bool. Poses "
        "are (k, 4, 4) or (k, 3, 4); a single pose, or None, stands for all. Raises InvalidArgument with the index.",
        ECODS_QUESTION(intersects));
    add_at_poses<double>(
        m, "distance_many",
        "distance() at the poses of collide_many(): (k,) float64, each the true distance, rounded once.",
        ECODS_QUESTION(distance));
    add_at_poses<std::uint8_t>(m, "relation_many",
                               "relation() at the poses of collide_many(): (k,) uint8, values of Relation.",
                               ECODS_QUESTION(relation));
    m.def(
        "within_many",
        [](const MeshShape& a, const py::object& poses_a, const MeshShape& b, const py::object& poses_b,
           double max_distance, std::size_t threads) {
            return at_poses<bool>(a, poses_a, b, poses_b, threads, [max_distance](auto& x, auto& y, const Ask& ask) {
                return within(x, y, max_distance, ask);
            });
        },
        py::arg("a"), py::arg("poses_a"), py::arg("b"), py::arg("poses_b"), py::arg("max_distance"),
        py::arg("threads") = 1,
        "within() of max_distance at the poses of collide_many(): (k,) bool. Raises InvalidArgument.");
    m.def("first_hits", &first_hits, py::arg("origins"), py::arg("directions"), py::arg("body"),
          py::arg("max_parameter") = std::numeric_limits<double>::infinity(), py::arg("threads") = 1,
          "first_hit() of rays with origins (k, 3) and directions (k, 3): parameters (k,) float64, NaN for a ray that "
          "hits nothing, and triangles (k,) int64, -1 for such a ray and for one that begins inside a Solid, whose "
          "parameter is 0. Raises InvalidArgument.");
    m.def("all_hits_many", &all_hits_many, py::arg("origins"), py::arg("directions"), py::arg("body"),
          py::arg("max_parameter") = std::numeric_limits<double>::infinity(),
          "all_hits() of rays with origins (k, 3) and directions (k, 3), one after another: first (k + 1,) int64, the "
          "hits of ray i being those from first[i] to first[i + 1] - 1; parameters (n,) float64; triangles (n,) int64, "
          "-1 for a ray that begins inside a Solid. Raises InvalidArgument with the index.");
    m.def("closest_many", &closest_many, py::arg("points"), py::arg("body"), py::arg("threads") = 1,
          "closest_point() of points (k, 3) and a body: the closest points (k, 3) float64, the distances (k,) float64 "
          "and the "
          "triangles (k,) int64, -1 for a point inside a Solid. Raises InvalidArgument with the index.");
    m.def("signed_distance_many", &signed_distance_many, py::arg("points"), py::arg("body"), py::arg("threads") = 1,
          "signed_distance() of points (k, 3) and a body: (k,) float64. Raises InvalidArgument with the index.");
    m.def("locate_many", &locate_many, py::arg("points"), py::arg("solid"), py::arg("threads") = 1,
          "locate() of points (k, 3): (k,) uint8, values of Side. Raises InvalidArgument.");
}

}  // namespace ecods::python
