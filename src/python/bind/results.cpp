// Binds the answers to questions, field by field.
#include <algorithm>

#include "ecods/depth.hpp"
#include "ecods/distance.hpp"
#include "ecods/shared_set.hpp"
#include "ecods/world_answers.hpp"
#include "python/bind/bind.hpp"
#include "python/bind/record.hpp"

namespace ecods::python {
namespace {

template <class T>
void add_triangles(py::class_<T>& type) {
    type.def_property_readonly(
        "triangles", [](const T& self) { return self.triangles(); },
        "Of each mesh a triangle that has the feature, as a tuple of two indices.");
}

void add_features(py::module_& m) {
    add_record(
        m, "Feature",
        "A vertex, an edge or a face of a mesh, named by a triangle and the least of its corners that names it: the "
        "vertex; the corner from which the edge goes to the next one; 0 of a face.",
        Field{"kind", &Feature::kind, "FeatureKind"},
        Field{"triangle", &Feature::triangle, "Index of a face of the mesh."},
        Field{"corner", &Feature::corner, "0 to 2"});

    auto closest = add_record(
        m, "ClosestPoints",
        "Where two bodies are closest to each other, and what the points are on. Of several pairs of "
        "features the first one, by kind and then by names. `intersecting`: the distance is 0, and both "
        "points are the least common corner of the least two triangles that share a point.",
        Field{"distance", &ClosestPoints::distance, "The true distance, rounded once."},
        Field{"kind", &ClosestPoints::kind, "ClosestKind"}, Field{"a", &ClosestPoints::a, "What point_a is on."},
        Field{"b", &ClosestPoints::b, "What point_b is on."},
        Field{"point_a", &ClosestPoints::point_a, "(3,) float64, each coordinate rounded once."},
        Field{"point_b", &ClosestPoints::point_b, "(3,) float64, each coordinate rounded once."});
    add_triangles(closest);

    add_record(m, "CloseFeatures", "Two features that are near each other (close_features).",
               Field{"closest", &CloseFeatures::closest, "Distance, features and points."},
               Field{"direction", &CloseFeatures::direction,
                     "Unit vector (3,) from a to b; at distance 0 the normal that the features define, or None."});

    add_record(m, "DistanceBounds", "An interval that contains the true distance.",
               Field{"lower", &DistanceBounds::lower, "Not above the distance."},
               Field{"upper", &DistanceBounds::upper, "Not below the distance."});
}

void add_shared(py::module_& m) {
    using Shared = TriangleIntersection;
    py::class_<Shared> type(m, "TriangleIntersection", "Two triangles that share a point, and what they share.");
    type.def_property_readonly(
        "triangles", [](const Shared& self) { return self.triangles; }, "Indices of the two faces, a tuple.");
    type.def_property_readonly(
        "corners", [](const Shared& self) { return from_points(self.shared.corners()); },
        "(k, 3) float64, k from 1 to 6: a point, a segment, or the corners of a polygon in a common plane.");
    type.def_property_readonly(
        "normal", [](const Shared& self) { return self.shared.normal; },
        "Unit vector (3,) where one face or two edges define it; None where triangles cross or corners touch.");
    type.def("__repr__", [](const py::object& self) {
        return py::str("TriangleIntersection(triangles={}, corners={}, normal={})")
            .format(self.attr("triangles"), text_of_value(self.attr("corners")), text_of_value(self.attr("normal")));
    });
    type.def(
        "__eq__",
        [](const Shared& a, const Shared& b) {
            return a.triangles == b.triangles && std::ranges::equal(a.shared.corners(), b.shared.corners()) &&
                   a.shared.normal == b.shared.normal;
        },
        py::is_operator());
    type.def(py::pickle(
        [](const Shared& self) {
            return py::make_tuple(self.triangles, from_points(self.shared.corners()), self.shared.normal);
        },
        [](const py::tuple& state) {
            Shared made{.triangles = state[0].cast<TrianglePair>(), .shared = {}};
            const Doubles corners = exact_points(state[1], "corners");
            made.shared.corner_count = static_cast<std::size_t>(corners.shape(0));
            if (made.shared.corner_count > made.shared.all_corners.size()) throw py::value_error("too many corners");
            std::copy_n(corners.data(), corners.size(), made.shared.all_corners.front().data());
            made.shared.normal = state[2].cast<std::optional<Vec3>>();
            return made;
        }));
}

void add_hits(py::module_& m) {
    auto hit = add_record(m, "Hit", "What a segment or ray shares with one triangle.",
                          Field{"parameter", &Hit::parameter, "Of the first common point, rounded once."},
                          Field{"leave_parameter", &Hit::leave_parameter, "Of the last one; the same unless `along`."},
                          Field{"kind", &Hit::kind, "HitKind"},
                          Field{"rank", &Hit::rank, "How many smaller real parameters are hit; ties have one rank."},
                          Field{"feature", &Hit::feature, "The feature of the triangle that holds the common points."},
                          Field{"point", &Hit::point, "(3,) float64, each coordinate rounded once."},
                          Field{"leave_point", &Hit::leave_point, "(3,) float64."});
    hit.def_property_readonly("triangle", &Hit::triangle, "Index of the face.");

    auto contact =
        add_record(m, "FirstContact", "When two bodies first share a point, and the first two features that do then.",
                   Field{"time", &FirstContact::time, "From 0 to 1: the true time, rounded once."},
                   Field{"kind", &FirstContact::kind, "ClosestKind; `intersecting` at time 0."},
                   Field{"a", &FirstContact::a, "Feature of the first body."},
                   Field{"b", &FirstContact::b, "Feature of the second body."});
    add_triangles(contact);
}

void add_solid_answers(py::module_& m) {
    add_record(m, "Location", "Where a point is with respect to a solid.",
               Field{"side", &Location::side, "Side: outside, on or inside."},
               Field{"feature", &Location::feature, "What the point is on, if it is on the surface."});
    add_record(m, "Depth", "The shortest translation of b that parts two convex solids.",
               Field{"depth", &Depth::depth, "Its length, rounded once; 0 where they touch."},
               Field{"a", &Depth::a, "What of a is furthest along the direction."},
               Field{"b", &Depth::b, "What of b is furthest against it."},
               Field{"direction", &Depth::direction, "Unit vector (3,); b moves along it."});
    add_record(m, "DepthBounds", "Proven bounds of the depth of two solids.",
               Field{"lower", &DepthBounds::lower, "Not above the depth."},
               Field{"upper", &DepthBounds::upper, "Not below the depth."},
               Field{"parted", &DepthBounds::parted, "A translation of b's pose that parts them."});
}

void add_world_answers(py::module_& m) {
    add_record(m, "NearestBody", "A body that is nearest to something.", Field{"body", &NearestBody::body, "Its id."},
               Field{"distance", &NearestBody::distance, "The true distance, rounded once."});
    add_record(m, "ClosestPair", "Two bodies of a world that are closest to each other.",
               Field{"bodies", &ClosestPair::bodies, "Their ids, the lesser first."},
               Field{"distance", &ClosestPair::distance, "The true distance, rounded once."});
    add_record(m, "BodyHit", "What a segment or a ray meets of a body.", Field{"body", &BodyHit::body, "Its id."},
               Field{"hit", &BodyHit::hit, "Its rank counts the parameters of all bodies."});
    add_record(m, "BodyContact", "A body that is met first by one on the move.",
               Field{"body", &BodyContact::body, "Its id."},
               Field{"contact", &BodyContact::contact, "a: of the one that moves."});
    add_record(m, "Meeting", "Two bodies that meet while bodies move.",
               Field{"bodies", &Meeting::bodies, "Their ids, the lesser first."},
               Field{"contact", &Meeting::contact, "When, and with which features."});
    add_record(m, "SolidPair", "Two solids that are not apart.",
               Field{"bodies", &SolidPair::bodies, "Their ids, the lesser first."},
               Field{"relation", &SolidPair::relation, "How the first is to the second."});
    add_record(m, "BodyDepth", "Two convex solids that share a point, and the shortest way out, of the second.",
               Field{"bodies", &BodyDepth::bodies, "Their ids, the lesser first."},
               Field{"depth", &BodyDepth::depth, "How deep they are in each other."});
    add_record(m, "SolidDistance", "Two convex solids and their distance.",
               Field{"bodies", &SolidDistance::bodies, "Their ids, the lesser first."},
               Field{"distance", &SolidDistance::distance, "Rounded once; 0 where they meet."});
    add_record(m, "BodyAt", "A body that a point is in, or on.", Field{"body", &BodyAt::body, "Its id."},
               Field{"side", &BodyAt::side, "Side: on or inside."});
    add_record(
        m, "BodiesContaining", "The solids of a world that a point is in, or on.",
        Field{"bodies", &BodiesContaining::bodies, "Ascending."},
        Field{"skipped_count", &BodiesContaining::skipped_count, "How many bodies are no solids, and were not asked."});
}

}  // namespace

void bind_results(py::module_& m) {
    add_features(m);
    add_shared(m);
    add_hits(m);
    add_solid_answers(m);
    add_world_answers(m);
}

}  // namespace ecods::python
