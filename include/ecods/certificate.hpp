// Certificates are answers with a proof that can be checked without this library.
//
// A certificate is a text that states a claim about posed meshes, and why it is true: how the trees of both meshes are
// traversed, and for every pair of their parts a direction along which the two are apart. A small program that knows
// nothing of this library checks it with exact arithmetic. verify/certificates/README.md has the format and the proof
// that an accepted certificate is true; two such programs are beside it. They read the meshes from files that
// write_certified_mesh() writes, once for each shape, and the poses from the certificate.
//
// A certificate names a mesh by a digest (SHA-256); nobody can make a second mesh with the same digest. It proves
// something about your mesh if it names your mesh's digest: that of certified_mesh_digest(), or of your mesh file.
//
// The claim is the answer that the function without certificate (intersection.hpp, distance.hpp, hit.hpp) gives about
// surfaces, for all finite poses and zero-area triangles. So the claim depends on the bits of meshes and poses alone.
// For a solid the functions throw NotSupported, since a proof is about triangles; ask about surface_of(solid). Casts
// have no certificates, whatever the motion. The proof may differ between floating-point environments, and is valid in
// each. A pose must be finite (validate(Pose)).
//
// Cost: that of the function without certificate, and a second walk that costs about as much. The text is made when it
// is requested.
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

// A Certificate is a claim and its proof, as a value that is cheap to copy. If it was made from a Posed that keeps its
// shape alive, it keeps the shape alive, too; otherwise the shapes must outlive it.
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
    // Returns the number in the claims distance, within, beyond and hit; 0 for other claims.
    double value() const noexcept;
    // Return the number of steps of the proof, and the number of directions that the steps name. Both are 0 if the
    // claim needs no steps: a crossing, a distance of 0, `within`, and a hit at parameter 0.
    std::size_t step_count() const noexcept;
    std::size_t axis_count() const noexcept;

    // Return or write the text, of format 2. It contains the digests of the meshes; a digest is computed when the first
    // certificate about a shape is written, in about a microsecond a triangle.
    std::string to_string() const;
    void write(std::ostream& out) const;

  private:
    friend struct CertificateAccess;

    struct ECODS_HIDDEN Content;
    explicit Certificate(std::shared_ptr<const Content> content) noexcept;
    std::shared_ptr<const Content> content_;
};

// Returns a proof of the answer of relation(a, b): claims disjoint (the format's word for apart), touching or crossing.
ECODS_API Certificate certify(const Posed<MeshShape>& a, const Posed<MeshShape>& b, const Ask& ask = {});

// Returns a proof of the answer of distance(a, b): claims distance.
ECODS_API Certificate certify_distance(const Posed<MeshShape>& a, const Posed<MeshShape>& b, const Ask& ask = {});

// Returns a proof of the answer of within(a, b, max_distance): claims within or beyond. Throws InvalidArgument if
// max_distance is negative or NaN.
ECODS_API Certificate certify_within(const Posed<MeshShape>& a, const Posed<MeshShape>& b, double max_distance,
                                     const Ask& ask = {});

// Returns a proof of the answer of first_hit(segment, body): claims hit or miss. Throws InvalidArgument.
ECODS_API Certificate certify_hit(const Segment& segment, const Posed<MeshShape>& body, const Ask& ask = {});

// A WorldCertificate proves a world's lists (World::certify). It states which bodies there are, and which pairs filters
// and switches leave; and it proves that the listed pairs of the last update collide or are close, and that no other
// pair collides or is close. It is a value that is cheap to copy, and keeps its shapes alive. World::certify throws
// NotUpdated if a call since the last update changed the world or the clearance; NotSupported if a body is a solid or
// of a kind of the caller's own. If a caller's test replaces the test of meshes, the proof is still about the meshes.
// It claims nothing about pairs that filters or set_pair_enabled() exclude; the checkers report how many such pairs
// there are. Cost: certify(), and with a clearance certify_within(), for each pair of bodies whose boxes are not proven
// to be further apart.
class ECODS_API WorldCertificate {
  public:
    // Return the number of pairs that are proven to collide; to be close (colliding pairs included); and to be neither.
    std::size_t colliding_count() const noexcept;
    std::size_t close_count() const noexcept;
    std::size_t apart_count() const noexcept;

    // Returns each shape once, in the order of the bodies. The checkers need the mesh of each.
    std::vector<std::shared_ptr<const MeshShape>> shapes() const;

    std::string to_string() const;
    void write(std::ostream& out) const;

  private:
    friend struct WorldCertificateAccess;

    struct ECODS_HIDDEN Content;
    explicit WorldCertificate(std::shared_ptr<const Content> content) noexcept;
    std::shared_ptr<const Content> content_;
};

// Writes the canonical text of a mesh, which certificates refer to (verify/certificates/README.md): vertices, triangles
// and the tree, with exact numbers. The text has the same bytes on every machine. A shape made by refit() may have
// another tree than a new shape of the same mesh, and then another text.
ECODS_API void write_certified_mesh(std::ostream& out, const MeshShape& shape);

// Returns the name that certificates use for this text: its SHA-256 as 64 lower-case hexadecimal digits, as sha256sum
// prints it for the file. Cost: about a microsecond a triangle the first time, then that of a copy.
ECODS_API std::string certified_mesh_digest(const MeshShape& shape);

}  // namespace ecods
