// Two posed convex solids in integers, and the faces of the set of differences of their points.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "oracle/convex.hpp"
#include "oracle/triangle_distance.hpp"

namespace ecods::oracle {

// A posed convex solid in the numbers of a template.
template <class N>
struct ConvexBody {
    std::vector<Vector<N>> vertices;
    std::vector<TriangleOf<N>> edges;  // of each the first edge of a triangle that is folded
    struct Face {
        Vector<N> normal;
        std::vector<Vector<N>> corners;  // counterclockwise around the normal
    };
    std::vector<Face> faces;  // normals outwards; of a polygon the one face, as its first triangle turns

    bool is_flat() const { return faces.size() < 2; }
};

struct ConvexBodies {
    std::array<ConvexFeatures, 2> features;
    std::array<ConvexBody<mpz_class>, 2> exact;
    std::array<ConvexBody<Interval>, 2> around;
    long unit = 0;

    // Needs a FloatEnvironment.
    ConvexBodies(const std::array<const Mesh*, 2>& meshes, const std::array<Pose, 2>& poses);
};

// A face of { p - q }, and how far it is from the origin: height / |normal|, negative beyond it. Points of b are
// furthest against the normal.
struct DifferenceFacet {
    enum class Kind { face_of_a, face_of_b, edges };
    Kind kind = Kind::edges;
    std::uint32_t a = 0, b = 0;  // by kind the face, or the two edges; faces of a have no b, and so on
    Vector<mpz_class> normal;
    mpz_class height, square;  // of the normal's length

    // The sign of the distance of the origin less that of another.
    int compare(const DifferenceFacet& other) const;
};

// The normal along which the depth is 0 if all of the difference is in one plane, as results.hpp has it; else nothing.
std::optional<Vector<mpz_class>> normal_of_flat_difference(const ConvexBodies& bodies);

// In the order in which ties are broken. If all of the difference is in one plane, only its two normals. Needs a
// FloatEnvironment.
std::vector<DifferenceFacet> difference_facets(const ConvexBodies& bodies);

// The vertices of the body that are furthest along the vector, ascending.
std::vector<std::uint32_t> furthest(const ConvexBody<mpz_class>& body, const Vector<mpz_class>& along);

// Where two solids that share no point are closest, by the rule of ClosestPoints. Needs a FloatEnvironment.
ExactClosest closest_features(const ConvexBodies& bodies);

// Which two points of two solids that share a point are brought together by the translation of b that is the height of
// the facet, along its normal: by the same rule. All pairs of features are seen along the normal: of a vertex each,
// whether they cover each other; of a vertex and an edge or a face, whether it lies on it; of two edges, whether they
// cross. `distance` is the length of the translation.
ExactClosest deepest_features(const ConvexBodies& bodies, const DifferenceFacet& facet);

}  // namespace ecods::oracle
