// The first time at which a translated mesh is within a distance of another one, by all pairs of triangles.
#pragma once

#include <optional>

#include "ecods/pose.hpp"
#include "ecods/shape.hpp"
#include "oracle/rounded.hpp"
#include "oracle/rounded_motion.hpp"

namespace ecods::near_times {

inline oracle::RoundedMotion::Corners corners_of(const Posed<MeshShape>& body, std::uint32_t triangle) {
    const auto points = oracle::posed_points(body.what->mesh(), body.pose);
    const Triangle& corners = body.what->mesh().triangles()[triangle];
    return {points[corners[0]], points[corners[1]], points[corners[2]]};
}

// Of surfaces that are more than p > 0 apart at the start; nullopt if there is none up to time 1.
inline std::optional<double> first_within(const Posed<MeshShape>& a, const Vec3& motion, const Posed<MeshShape>& b,
                                          const mpq_class& p) {
    const oracle::Vector<mpq_class> way{oracle::exactly(motion[0]), oracle::exactly(motion[1]),
                                        oracle::exactly(motion[2])};
    std::optional<double> least;
    for (std::uint32_t i = 0; i < a.what->mesh().triangles().size(); ++i) {
        for (std::uint32_t j = 0; j < b.what->mesh().triangles().size(); ++j) {
            const auto time = oracle::RoundedMotion(corners_of(a, i), corners_of(b, j), way, p).first(1);
            if (time && (!least || *time < *least)) least = time;
        }
    }
    return least;
}

}  // namespace ecods::near_times
