// What certificates claim, how long they are, and how their meshes are named. That they are proofs is for the checkers
// of verify/certificates to say.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <sstream>
#include <string>

#include "base/sha256.hpp"
#include "certificates/samples/samples.hpp"
#include "ecods/certificate.hpp"
#include "ecods/distance.hpp"
#include "ecods/error.hpp"
#include "ecods/hit.hpp"
#include "ecods/intersection.hpp"
#include "environment/float_mode.hpp"
#include "scenes/distance_cases.hpp"
#include "scenes/each_case.hpp"
#include "scenes/expect_invalid.hpp"
#include "scenes/mesh_pairs.hpp"
#include "scenes/pose_at.hpp"
#include "scenes/shapes.hpp"
#include "scenes/ship.hpp"

namespace ecods {
namespace {

using Claim = Certificate::Claim;

Claim claim_of(Relation relation) {
    return relation == Relation::apart      ? Claim::disjoint
           : relation == Relation::touching ? Claim::touching
                                            : Claim::crossing;
}

Posed<MeshShape> at(const MeshShape& shape, const Vec3& t) {
    return {shape, ecods::at(t)};
}

TEST(Certificates, ClaimThePlainAnswers) {
    scenes::Random random(7);
    QueryMemory memory;
    scenes::for_each_case(scenes::distance_families(), random, 5, [&](const scenes::DistanceCase& made) {
        const MeshShape shape_a(made.a), shape_b(made.b);
        const Posed<MeshShape> a(shape_a, made.pose_a), b(shape_b, made.pose_b);
        EXPECT_EQ(certify(a, b, memory).claim(), claim_of(relation(a, b, memory)));
        const double d = distance(a, b, memory);
        const Certificate of_distance = certify_distance(a, b, memory);
        EXPECT_EQ(of_distance.claim(), Claim::distance);
        EXPECT_EQ(of_distance.value(), d);
        EXPECT_EQ(of_distance.step_count() == 0, d == 0);
        for (const double limit : {0.0, d / 2, d, 2 * d}) {
            const Certificate certificate = certify_within(a, b, limit, memory);
            EXPECT_EQ(certificate.claim(), within(a, b, limit, memory) ? Claim::within : Claim::beyond);
            EXPECT_EQ(certificate.value(), limit);
        }
    });
}

TEST(Certificates, ClaimTheFirstHit) {
    const MeshShape cube(scenes::cube(1));
    QueryMemory memory;
    const Posed<MeshShape> body = at(cube, Vec3::Zero());
    const Certificate hit = certify_hit({Vec3(-4, 0.25, 0.5), Vec3(4, 0.25, 0.5)}, body, memory);
    EXPECT_EQ(hit.claim(), Claim::hit);
    EXPECT_EQ(hit.value(), 0.375);
    EXPECT_GT(hit.step_count(), 0u);
    EXPECT_EQ(certify_hit({Vec3(1, 0, 0), Vec3(4, 0, 0)}, body, memory).step_count(), 0u);
    EXPECT_EQ(certify_hit({Vec3(-4, 0, 2), Vec3(4, 0, 2)}, body, memory).claim(), Claim::miss);
    EXPECT_INVALID(certify_hit({Vec3(NAN, 0, 0), Vec3::Zero()}, body, memory), Argument::segment);
}

TEST(Certificates, RefuseWhatIsNoDistance) {
    const MeshShape cube(scenes::cube(1));
    QueryMemory memory;
    EXPECT_INVALID(certify_within(at(cube, Vec3::Zero()), at(cube, Vec3::Ones()), -1, memory), Argument::distance);
    EXPECT_INVALID(certify_within(at(cube, Vec3::Zero()), at(cube, Vec3::Ones()), NAN, memory), Argument::distance);
}

TEST(Certificates, AreWithinInfinityAndZeroOfEitherSign) {
    const MeshShape cube(scenes::cube(1));
    QueryMemory memory;
    const Posed<MeshShape> a = at(cube, Vec3::Zero()), b = at(cube, Vec3(5, 0, 0));
    const std::string text = certify_within(a, b, std::numeric_limits<double>::infinity(), memory).to_string();
    EXPECT_NE(text.find("\nclaim within inf "), std::string::npos) << text;
    const std::string zero = certify_within(a, b, -0.0, memory).to_string();
    EXPECT_NE(zero.find("\nclaim beyond 0x0p+0\n"), std::string::npos) << zero;
}

TEST(Certificates, ArePrintedAsTheFormatSays) {
    const MeshShape cube(scenes::cube(1));
    QueryMemory memory;
    const std::string digest = certified_mesh_digest(cube);
    const std::string pose = " 0x1p+0 0x0p+0 0x0p+0 ";
    const Certificate certificate = certify_distance(at(cube, Vec3::Zero()), at(cube, Vec3(3, 0, 0)), memory);
    const std::string text = certificate.to_string();
    EXPECT_EQ(text.rfind("ecods-certificate 2\na " + digest + pose, 0), 0u) << text;
    EXPECT_NE(text.find("\nb " + digest + pose + "0x1.8p+1 "), std::string::npos) << text;
    EXPECT_NE(text.find("\nclaim distance 0x1p+0 "), std::string::npos) << text;
    EXPECT_TRUE(text.ends_with("\nend\n")) << text;
    std::ostringstream stream;
    certificate.write(stream);
    EXPECT_EQ(stream.str(), text);
}

std::string text_of(const MeshShape& shape) {
    std::ostringstream text;
    write_certified_mesh(text, shape);
    return text.str();
}

// Makes the digest of the whole text at once.
std::string plain_digest(const std::string& text) {
    Sha256 sha;
    sha(text);
    return hexadecimal(sha.finish());
}

// Where denormals are zero, too: the digest was that of another text there.
TEST(Certificates, NameAMeshAlikeInEachEnvironment) {
    for (const environment::FloatMode& mode : environment::float_modes) {
        const MeshShape shape(scenes::cube(0x1p-1060));
        std::string digest;
        {
            const environment::InFloatMode in_mode(mode);
            digest = certified_mesh_digest(shape);
        }
        EXPECT_EQ(digest, plain_digest(text_of(shape))) << mode.name;
    }
}

TEST(Certificates, NameAMeshByItsText) {
    for (const auto& mesh : {scenes::cube(0.1), scenes::ship(), scenes::torus(30, 20, 0.4)}) {
        const MeshShape shape(mesh);
        const std::string text = text_of(shape);
        EXPECT_EQ(certified_mesh_digest(shape), plain_digest(text));
        std::istringstream lines(text);
        std::string word, header;
        std::size_t vertices = 0, triangles = 0;
        std::getline(lines, header);
        EXPECT_EQ(header, "ecods-mesh 1");
        lines >> word >> vertices >> word >> triangles;
        EXPECT_EQ(vertices, mesh->vertices().size());
        EXPECT_EQ(triangles, mesh->triangles().size());
    }
}

// The canonical text has the shortest form of each number, the sign of a zero, and vertices without a triangle, as the
// format says. The digest is what sha256sum prints of it.
TEST(Certificates, NameAMeshByItsCanonicalText) {
    const MeshShape shape(
        Mesh::create({{1, -0.0, 0x1p-1074}, {-1.5, 0x1.8p-1030, 1e300}, {0.1, 3, 0x1p-1022}, {7, 8, 9}}, {{2, 0, 1}}));
    const std::string text =
        "ecods-mesh 1\nvertices 4 triangles 1 nodes 1\n"
        "0x1p+0 -0x0p+0 0x0.0000000000001p-1022\n"
        "-0x1.8p+0 0x0.018p-1022 0x1.7e43c8800759cp+996\n"
        "0x1.999999999999ap-4 0x1.8p+1 0x1p-1022\n"
        "0x1.cp+2 0x1p+3 0x1.2p+3\n"
        "2 0 1 0\nl 1\n";
    EXPECT_EQ(text_of(shape), text);
    EXPECT_EQ(certified_mesh_digest(shape), "9e61c45a41bd6ca60df2e050be4008a3c5940813ed33f1b61a68f502229e675c");
}

// Each certificate, whatever its shape, is of one line an axis.
TEST(Certificates, OfFlushFacesAreShort) {
    for (const std::uint32_t across : {10u, 40u}) {
        std::size_t steps_max = 0;
        certificates::make_flush_samples(across, 3, [&](const certificates::Sample& sample) {
            steps_max = std::max(steps_max, sample.certificate.step_count());
        });
        EXPECT_LE(steps_max, 160u) << across;
    }
    const auto plate = certificates::plate(40);
    QueryMemory memory;
    const Certificate touching = certify(at(*plate, Vec3::Zero()), at(*plate, Vec3(0.25, 0.5, 0)), memory);
    EXPECT_EQ(touching.claim(), Claim::touching);
    EXPECT_EQ(touching.step_count(), 1u);
    EXPECT_EQ(touching.axis_count(), 1u);
}

TEST(Certificates, OfShipsNearContactAreShort) {
    const MeshShape shape(scenes::ship());
    QueryMemory memory;
    for (const scenes::MeshQuery& query : scenes::gap_pairs("ship", scenes::ship(), 1e-4, 20, 3).queries) {
        const Posed<MeshShape> a(shape, query.a.pose), b(shape, query.b.pose);
        EXPECT_LE(certify(a, b, memory).to_string().size(), 3000u);
        EXPECT_LE(certify_distance(a, b, memory).to_string().size(), 3000u);
    }
}

}  // namespace
}  // namespace ecods
