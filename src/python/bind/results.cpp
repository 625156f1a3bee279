// Binds the answers to questions, field by field.
#include <algorithm>

#include "ecods/results.hpp"
#include "python/bind/bind.hpp"
#include "python/bind/record.hpp"

namespace ecods::python {
namespace {

template <class T>
void add_triangles(py::class_<T>& type) {
    type.def_property_readonly(
        "triangles", [](const T& self) { return self.triangles(); },
        "A triangle of each mesh that has the feature, as a tuple of two indices.");
}

void add_features(py::module_& m) {
    add_record(
        m, "Feature",
        "A vertex, an edge or a face of a mesh, named by a triangle and the least of its corners that names it: the "
        "vertex; the corner from which the edge goes to the next one; 0 for a face. Of kind `none` it names nothing, "
        "and "
        "its triangle is no index.",
        Field{"kind", &Feature::kind, "FeatureKind"},
        Field{"triangle", &Feature::triangle, "Index of a face of the mesh."},
        Field{"corner", &Feature::corner, "0 to 2"});

    auto closest = add_record(
        m, "ClosestPoints",
        "The closest points of two bodies, and the features that hold them. Among several pairs of features it "
        "is the first one, by kind and then by names. If the kind is `intersecting`, the distance is 0, and both "
        "points are the least common corner of the least two triangles that share a point. If it is `contained`, no "
        "two "
        "triangles do: both points are corner 0 of a triangle that is inside the other body, whose feature is of kind "
        "`none`.",
        Field{"distance", &ClosestPoints::distance, "The true distance, rounded once."},
        Field{"kind", &ClosestPoints::kind, "ClosestKind"},
        Field{"a", &ClosestPoints::a, "The feature that holds point_a."},
        Field{"b", &ClosestPoints::b, "The feature that holds point_b."},
        Field{"point_a", &ClosestPoints::point_a, "(3,) float64, each coordinate rounded once."},
        Field{"point_b", &ClosestPoints::point_b, "(3,) float64, each coordinate rounded once."});
    add_triangles(closest);

    add_record(m, "ClosestPoint",
               "The point of a body that is closest to a given point, and the feature that holds it: the face of the "
               "least triangle if the given point is on the surface, of kind `none` if it is inside a Solid.",
               Field{"distance", &ClosestPoint::distance, "The true distance, rounded once."},
               Field{"feature", &ClosestPoint::feature, "The feature that holds the point."},
               Field{"point", &ClosestPoint::point, "(3,) float64, each coordinate rounded once."});

    add_record(m, "CloseFeatures", "Two features that are near each other (close_features).",
               Field{"closest", &CloseFeatures::closest, "Distance, features and points."},
               Field{"direction", &CloseFeatures::direction,
                     "Unit vector (3,) from a to b; at distance 0 the normal that the features define, or None."});

    add_record(m, "DistanceBounds", "An interval that contains the true distance.",
               Field{"lower", &DistanceBounds::lower, "A lower bound of the distance."},
               Field{"upper", &DistanceBounds::upper, "An upper bound of the distance."});
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
        "Unit vector (3,) if one face or two edges define it; None if triangles cross or corners touch.");
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
    auto hit =
        add_record(m, "Hit", "The points that a segment or ray shares with one triangle.",
                   Field{"parameter", &Hit::parameter, "Parameter of the first common point, rounded once."},
                   Field{"leave_parameter", &Hit::leave_parameter, "Parameter of the last one; equal unless `along`."},
                   Field{"kind", &Hit::kind, "HitKind"},
                   Field{"rank", &Hit::rank, "Number of smaller real parameters that are hit."},
                   Field{"feature", &Hit::feature, "The feature of the triangle that holds the common points."},
                   Field{"point", &Hit::point, "First common point: (3,) float64, each rounded once."},
                   Field{"leave_point", &Hit::leave_point, "Last common point: (3,) float64."});
    hit.def_property_readonly("triangle", &Hit::triangle, "Index of the face; no index if the kind is `inside`.");

    auto contact = add_record(
        m, "FirstContact", "The time at which two bodies first share a point, and the first two features that do.",
        Field{"time", &FirstContact::time, "From 0 to 1: the true time, rounded once."},
        Field{"kind", &FirstContact::kind, "ClosestKind; `intersecting` or `contained` at time 0."},
        Field{"a", &FirstContact::a, "Feature of the first body."},
        Field{"b", &FirstContact::b, "Feature of the second body."});
    add_triangles(contact);
}

void add_solid_answers(py::module_& m) {
    add_record(m, "Location", "The place of a point with respect to a solid.",
               Field{"side", &Location::side, "Side: outside, on or inside."},
               Field{"feature", &Location::feature, "The feature that the point is on, if it is on the surface."});
    add_record(m, "Depth", "The shortest translation of b that separates two convex solids.",
               Field{"depth", &Depth::depth, "Its length, rounded once; 0 if they touch."},
               Field{"a", &Depth::a, "The feature of a that is furthest along the direction."},
               Field{"b", &Depth::b, "The feature of b that is furthest against the direction."},
               Field{"direction", &Depth::direction, "Unit vector (3,); b moves along it."});
    add_record(m, "DepthBounds", "Proven bounds of the depth of two solids.",
               Field{"lower", &DepthBounds::lower, "A lower bound of the depth."},
               Field{"upper", &DepthBounds::upper, "An upper bound of the depth."},
               Field{"parted", &DepthBounds::parted, "A translation of b's pose that separates them."});
}

void add_world_answers(py::module_& m) {
    add_record(m, "NearestBody", "A body that is nearest to something.", Field{"body", &NearestBody::body, "Its id."},
               Field{"distance", &NearestBody::distance, "The true distance, rounded once."});
    add_record(m, "ClosestPair", "Two bodies of a world that are close to each other.",
               Field{"bodies", &ClosestPair::bodies, "Their ids, the lesser first."},
               Field{"distance", &ClosestPair::distance,
                     "The true distance, rounded once: signed if both are convex (ConvexSolid, Rounded), or one is a "
                     "HalfSpace."},
               Field{"points", &ClosestPair::points, "ClosestPoints with that distance; None for two half spaces."},
               Field{"direction", &ClosestPair::direction,
                     "Unit vector (3,), along which the second body would move; None if the distance is positive or "
                     "has no sign."});
    add_record(m, "BodyHit", "A hit of a segment or a ray on a body.", Field{"body", &BodyHit::body, "Its id."},
               Field{"hit", &BodyHit::hit, "The Hit; its rank counts the parameters of all bodies."});
    add_record(m, "BodyContact", "The body that a moving one meets first.",
               Field{"body", &BodyContact::body, "Its id."},
               Field{"contact", &BodyContact::contact, "The FirstContact; a is a feature of the moving body."});
    add_record(m, "Meeting", "Two bodies that meet while bodies move.",
               Field{"bodies", &Meeting::bodies, "Their ids, the lesser first."},
               Field{"contact", &Meeting::contact, "The time and the features."});
    add_record(m, "PairRelation", "Two bodies that collide, and how.",
               Field{"bodies", &PairRelation::bodies, "Their ids, the lesser first."},
               Field{"relation", &PairRelation::relation, "The Relation of the first to the second."});
    add_record(m, "BodyDepth", "Two convex solids that share a point, and their depth.",
               Field{"bodies", &BodyDepth::bodies, "Their ids, the lesser first."},
               Field{"depth", &BodyDepth::depth, "The Depth, by which the second body would move."});
    add_record(m, "PairDistance", "Two bodies and their distance.",
               Field{"bodies", &PairDistance::bodies, "Their ids, the lesser first."},
               Field{"distance", &PairDistance::distance, "The distance, signed as that of ClosestPair."});
    add_record(m, "BodyAt", "A body that a point is in, or on.", Field{"body", &BodyAt::body, "Its id."},
               Field{"side", &BodyAt::side, "Side: on or inside."});
    add_record(m, "BodiesContaining", "The solids of a world that a point is in, or on.",
               Field{"bodies", &BodiesContaining::bodies, "Ascending."},
               Field{"skipped_count", &BodiesContaining::skipped_count,
                     "Number of bodies that were not asked: surfaces, half spaces, shapes of one's own."});
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
