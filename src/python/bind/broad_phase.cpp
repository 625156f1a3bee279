// Binds broad_phase.hpp: overlapping boxes without a world. All functions keep the interpreter's lock.
#include "ecods/broad_phase.hpp"

#include <functional>
#include <limits>
#include <memory>

#include "ecods/error.hpp"
#include "python/bind/bind.hpp"
#include "python/bind/casters.hpp"

namespace ecods::python {
namespace {

py::array_t<ProxyIndex> array_of(const std::vector<ProxyPair>& pairs) {
    return from_named_pairs<ProxyIndex>(pairs, std::identity());
}

template <class What>
py::array_t<ProxyIndex> found(const BroadPhase& self, const What& what) {
    return from_numbers(self.find(what));
}

// Returns the state to pickle or copy: the boxes with their numbers. A copy is in the state before its first update,
// with empty lists.
py::tuple boxes_of(const BroadPhase& self) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const Aabb everything{.min = Vec3::Constant(-infinity), .max = Vec3::Constant(infinity)};
    const std::vector<ProxyIndex> proxies = self.find(everything);
    std::vector<Vec3> corners;
    for (const ProxyIndex proxy : proxies) {
        const Aabb box = self.box(proxy);
        corners.insert(corners.end(), {box.min, box.max});
    }
    return py::make_tuple(self.kind(), from_numbers(proxies), from_points(corners));
}

std::unique_ptr<BroadPhase> with_boxes(const py::tuple& state) {
    auto made = make_broad_phase(state[0].cast<BroadPhaseKind>());
    const auto proxies = state[1].cast<py::array_t<ProxyIndex>>();
    const Doubles corners = exact_points(state[2], "boxes");
    if (corners.shape(0) != 2 * proxies.size()) throw py::value_error("a box for each proxy is expected");
    for (py::ssize_t i = 0; i < proxies.size(); ++i) {
        const double* const x = corners.data() + 6 * i;
        const Aabb box{.min = {x[0], x[1], x[2]}, .max = {x[3], x[4], x[5]}};
        validate(box);
        made->add(proxies.at(i), box);
    }
    return made;
}

}  // namespace

void bind_broad_phase(py::module_& m) {
    const py::arg proxy("proxy");
    const py::arg box("box");
    py::class_<BroadPhase> type(m, "BroadPhase",
                                "Finds which boxes (2, 3) overlap. The caller chooses a number for each box, its "
                                "proxy; proxies should be dense.");
    type.def(py::init([](BroadPhaseKind kind) { return make_broad_phase(kind); }), py::arg("kind") = "automatic");
    const auto add = [](BroadPhase& self, ProxyIndex which, const Aabb& at) {
        validate(at);
        self.add(which, at);
    };
    type.def("add", add, proxy, box,
             "Adds a box. Raises InvalidArgument, or Error if the proxy is present already or is not less than 2**31.");
    const auto move = [](BroadPhase& self, ProxyIndex which, const Aabb& at) {
        validate(at);
        self.move(which, at);
    };
    type.def("move", move, proxy, box,
             "Gives a proxy another box. Raises InvalidArgument, or Error if the proxy is not present.");
    type.def("remove", &BroadPhase::remove, proxy,
             "Removes the box of a proxy. Raises Error if the proxy is not present.");
    type.def("box", &BroadPhase::box, proxy, "The box of a proxy: (2, 3) float64.");
    type.def("__len__", &BroadPhase::size);
    type.def("__repr__", [](const BroadPhase& self) {
        return "<ecods.BroadPhase of " + std::to_string(self.size()) + " boxes, " +
               std::string(py::str(py::cast(self.kind()))) + ">";
    });
    type.def(py::pickle(&boxes_of, &with_boxes));
    type.def("update", &BroadPhase::update, "Sets pairs() to the pairs that overlap now.");
    type.def(
        "pairs", [](BroadPhase& self) { return array_of(self.pairs()); },
        "The pairs that overlapped at the last update: (k, 2) uint32, ascending.");
    type.def(
        "began", [](BroadPhase& self) { return array_of(self.began()); },
        "The pairs that began to overlap with the last update: (k, 2) uint32.");
    type.def(
        "ended", [](BroadPhase& self) { return array_of(self.ended()); },
        "The pairs that ceased to overlap with the last update: (k, 2) uint32.");
    const py::arg what("what");
    type.def("find", found<Segment>, what,
             "Boxes that share a point with a Segment, a Ball or a box, as of now: (k,) uint32.");
    type.def("find", found<Ball>, what);
    type.def("find", found<Aabb>, what);
}

}  // namespace ecods::python
