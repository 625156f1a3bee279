// Defines what a certificate holds, and how its text is made.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "ecods/certificate.hpp"
#include "ecods/closest_points.hpp"
#include "ecods/segment.hpp"
#include "query/certificate/proof.hpp"

namespace ecods {

struct Certificate::Content {
    Claim claim = Claim::disjoint;
    double value = 0;
    // The closest features, for distance and within; or the triangles that meet, as faces.
    Feature a, b;
    bool names_triangles = false;  // for distance and within: true if the triangles meet

    const MeshShape* shape_a = nullptr;
    const MeshShape* shape_b = nullptr;  // null if the second body is the segment
    Pose pose_a, pose_b;
    Segment segment;
    Proof proof;
};

struct CertificateAccess {
    using Content = Certificate::Content;
    static Certificate make(Content&& content) {
        return Certificate(std::make_shared<const Content>(std::move(content)));
    }
    static const Content& content(const Certificate& certificate) noexcept { return *certificate.content_; }
};

// Appends the lines from `claim` to `end`.
void append_proof(std::string& text, const CertificateAccess::Content& content);
// Appends a space and the coordinate, three times.
void append_coordinates(std::string& text, const Vec3& point);
inline constexpr std::size_t digest_length = 64;
// Appends DIGEST POSE and a newline.
void append_body(std::string& text, const MeshShape& shape, const Pose& pose);

}  // namespace ecods
