// Defines the content of a certificate, and the function that writes the content as text.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>

#include "ecods/certificate.hpp"
#include "ecods/primitives.hpp"
#include "ecods/results.hpp"
#include "query/certificate/proof.hpp"

namespace ecods {

struct Certificate::Content {
    Claim claim = Claim::disjoint;
    double value = 0;
    // `a` and `b` are the closest features for the claims distance and within; for a claim that triangles meet, they
    // are the two triangles as faces.
    Feature a, b;
    bool names_triangles = false;  // true if a and b name triangles that meet

    std::shared_ptr<const MeshShape> shape_a;
    std::shared_ptr<const MeshShape> shape_b;  // null if the second body is the segment
    Pose pose_a, pose_b;
    Segment segment;
    Proof proof;
};

void require_surface(const MeshShape& shape);

struct CertificateAccess {
    // Returns the shape of `posed`, as a shared pointer. If `posed` owns its shape, the result shares the ownership;
    // otherwise the result does not own the shape. Throws NotSupported for a solid, because a proof is about triangles.
    static std::shared_ptr<const MeshShape> shape_of(const Posed<MeshShape>& posed) {
        require_surface(*posed.what);
        return posed.kept ? posed.kept : std::shared_ptr<const MeshShape>(std::shared_ptr<const void>(), posed.what);
    }
    using Content = Certificate::Content;
    static Certificate make(Content&& content) {
        return Certificate(std::make_shared<const Content>(std::move(content)));
    }
    static const Content& content(const Certificate& certificate) noexcept { return *certificate.content_; }
};

// Appends to `text` the lines of the certificate from `claim` to `end`.
void append_proof(std::string& text, const CertificateAccess::Content& content);

}  // namespace ecods
