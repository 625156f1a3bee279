// What a certificate holds, and its text.
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
    // The features of distance and within; or the triangles that meet, as faces.
    Feature a, b;
    bool names_triangles = false;  // of distance and within: whether these meet

    const MeshShape* shape_a = nullptr;
    const MeshShape* shape_b = nullptr;  // null: the second body is the segment
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

// The lines from `claim` to `end`.
void append_proof(std::string& text, const CertificateAccess::Content& content);

}  // namespace ecods
