// Certificates are answers with a proof that can be checked without this library.
//
// A certificate is a text that says what is claimed of which posed meshes, and why it is true: how the trees of both
// meshes are gone through, and for every pair of their parts a direction along which it is apart. A small program that
// knows nothing of this library checks it with exact arithmetic; the format and why an accepted certificate is true are
// in verify/certificates/README.md, two such programs beside it. They read the meshes from files that
// write_certified_mesh() writes once a shape, and poses from the certificate.
//
// A certificate names a mesh by a digest that nobody can give to a second mesh (SHA-256). It proves something about
// your mesh if it names the digest of your mesh: that of certified_mesh_digest(), or of a mesh file that you wrote.
//
// The claim is the answer of the plain question (intersection.hpp, distance.hpp, hit.hpp), for all finite poses and
// zero-area triangles; so it depends on the bits of meshes and poses alone. The proof may be another in another
// floating-point environment, and is one in each. A pose must be finite (validate(Pose)).
//
// Cost: the plain question, and a second walk that costs about as much; text is made when it is asked for.
//
// Thread safety: as in intersection.hpp.
//
// Example: verify/examples/how_do_i, prove_an_answer().
#pragma once

#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <memory>
#include <string>
#include <vector>

#include "ecods/ask.hpp"
#include "ecods/export.hpp"
#include "ecods/pose.hpp"
#include "ecods/primitives.hpp"
#include "ecods/shape.hpp"

namespace ecods {

// A claim and its proof: a value, cheap to copy. It keeps the shapes that it is about if the Posed kept them, and
// refers to them otherwise.
class ECODS_API Certificate {
  public:
    enum class Claim : std::uint8_t {
        disjoint,  // no common point
        touching,  // a common point, and no two triangles cross
        crossing,  // two triangles cross
        distance,  // the distance, rounded once, is value()
        within,    // the distance is at most value()
        beyond,    // the distance is more than value()
        hit,       // the first hit is at the parameter that, rounded once, is value()
        miss,      // the segment shares no point with the body
    };

    Claim claim() const noexcept;
    // Returns the number in the claims distance, within, beyond and hit; 0 for the others.
    double value() const noexcept;
    // How many steps the proof has, and how many directions they name. 0 where a claim is its own proof: a crossing, a
    // distance of 0, what is within a distance, and a hit at parameter 0.
    std::size_t step_count() const noexcept;
    std::size_t axis_count() const noexcept;

    // The text, of format 2. The digests of the meshes are in it, and are made when the first certificate about a shape
    // is written: about a microsecond a triangle.
    std::string to_string() const;
    void write(std::ostream& out) const;

  private:
    friend struct CertificateAccess;

    struct ECODS_HIDDEN Content;
    explicit Certificate(std::shared_ptr<const Content> content) noexcept;
    std::shared_ptr<const Content> content_;
};

// relation(a, b): claims disjoint (the format's word for apart), touching or crossing.
ECODS_API Certificate certify(const Posed<MeshShape>& a, const Posed<MeshShape>& b, const Ask& ask = {});

// distance(a, b): claims distance.
ECODS_API Certificate certify_distance(const Posed<MeshShape>& a, const Posed<MeshShape>& b, const Ask& ask = {});

// within(a, b, max_distance): claims within or beyond. Throws InvalidArgument if that is negative or NaN.
ECODS_API Certificate certify_within(const Posed<MeshShape>& a, const Posed<MeshShape>& b, double max_distance,
                                     const Ask& ask = {});

// first_hit(segment, body): claims hit or miss. Throws InvalidArgument.
ECODS_API Certificate certify_hit(const Segment& segment, const Posed<MeshShape>& body, const Ask& ask = {});

// Proves a world's lists (World::certify): which bodies there are, which pairs filters and switches leave, that the
// listed pairs of the last update collide or are close, and that no other unfiltered pair does or is. A value, cheap to
// copy, which keeps the shapes that it is about. World::certify throws NotUpdated if a call since the last update
// changed the world or the clearance; NotSupported, with the first body of a kind of the caller's own. Where a test of
// the caller's own replaces that of meshes, the proof is of what the meshes do. Pairs that filters or
// set_pair_enabled() leave out are not judged; the checkers say how many they are. Cost: certify(), and with a
// clearance certify_within(), for each pair of bodies whose boxes are not proven to be further apart.
class ECODS_API WorldCertificate {
  public:
    // How many pairs collide, how many are close, colliding ones included, and how many were proven to be neither.
    std::size_t colliding_count() const noexcept;
    std::size_t close_count() const noexcept;
    std::size_t apart_count() const noexcept;

    // Each shape once, in the order of the bodies: the checkers need the mesh of each.
    std::vector<std::shared_ptr<const MeshShape>> shapes() const;

    std::string to_string() const;
    void write(std::ostream& out) const;

  private:
    friend struct WorldCertificateAccess;

    struct ECODS_HIDDEN Content;
    explicit WorldCertificate(std::shared_ptr<const Content> content) noexcept;
    std::shared_ptr<const Content> content_;
};

// Writes the canonical text of a mesh (verify/certificates/README.md), which is what certificates are about: vertices,
// triangles and the tree, with exact numbers. The text is the same bytes on every machine. A shape made by refit() may
// have another tree than one made of the same mesh, and then another text.
ECODS_API void write_certified_mesh(std::ostream& out, const MeshShape& shape);

// The name of that text in certificates: its SHA-256 as 64 lower-case hexadecimal digits, as sha256sum prints it of
// the file. Cost: about a microsecond a triangle the first time, then that of a copy.
ECODS_API std::string certified_mesh_digest(const MeshShape& shape);

}  // namespace ecods
