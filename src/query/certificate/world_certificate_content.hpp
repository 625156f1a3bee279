// Defines the content of a world's certificate.
#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "ecods/certificate.hpp"
#include "ecods/ids.hpp"

namespace ecods {

struct WorldCertificate::Content {
    struct Body {
        BodyId id;
        std::shared_ptr<const MeshShape> shape;
        Pose pose;
        CollisionFilter filter;
    };
    // A Pair holds one claim about a pair of bodies, or the two claims disjoint and within.
    struct Pair {
        BodyPair ids;
        Certificate first;
        std::optional<Certificate> second = {};
    };

    std::optional<double> clearance;
    std::vector<Body> bodies;   // ascending
    std::vector<BodyPair> off;  // ascending
    std::vector<Pair> pairs;    // ascending
};

struct WorldCertificateAccess {
    using Content = WorldCertificate::Content;
    static WorldCertificate make(Content&& content) {
        return WorldCertificate(std::make_shared<const Content>(std::move(content)));
    }
};

}  // namespace ecods
