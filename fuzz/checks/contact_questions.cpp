#include "fuzz/checks/contact_questions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ecods/cast.hpp"
#include "ecods/contact.hpp"
#include "fuzz/base/failure.hpp"
#include "fuzz/checks/text.hpp"
#include "fuzz/checks/truth.hpp"
#include "fuzz/checks/way_bodies.hpp"
#include "judge/cast_truth.hpp"
#include "oracle/distance.hpp"
#include "oracle/first_contact.hpp"
#include "oracle/rounded.hpp"
#include "oracle/rounded_motion.hpp"
#include "oracle/solid.hpp"
#include "scenes/numbers_of.hpp"
#include "scenes/random.hpp"

namespace ecods::fuzz {
namespace {

constexpr std::size_t solid_pairs_max = 300, near_pairs_max = 1000, distance_pairs_max = 12;

// Two bodies, of which the first is translated.
struct Way {
    Posed<MeshShape> a, b;
    Vec3 motion;

    Way mirrored() const { return {b, a, -motion}; }
    bool are_solids() const { return a.what->form() != MeshForm::surface && b.what->form() != MeshForm::surface; }
    bool are_surfaces() const { return a.what->form() == MeshForm::surface && b.what->form() == MeshForm::surface; }
    bool are_convex() const { return a.what->form() == MeshForm::convex && b.what->form() == MeshForm::convex; }
    std::size_t pair_count() const { return a.what->mesh().triangles().size() * b.what->mesh().triangles().size(); }
};

std::string time_text(const std::optional<double>& time) {
    return time ? fmt::format("{:a}", *time) : "never";
}
std::optional<double> time_of(const auto& found) {
    return found ? std::optional(found->time) : std::nullopt;
}
void require_same(const char* what, const std::optional<double>& expected, const std::optional<double>& got) {
    if (expected != got) throw CheckFailed(what, time_text(expected), time_text(got));
}
bool is_after(const std::optional<double>& x, double time) {
    return !x || *x > time;
}

// The pose at a time, if its numbers are doubles.
std::optional<Pose> exact_pose(const Way& way, double s) {
    Pose pose = way.a.pose;
    for (int k = 0; k < 3; ++k) {
        const mpq_class x = oracle::exactly(pose.t[k]) + oracle::exactly(s) * oracle::exactly(way.motion[k]);
        pose.t[k] = x.get_d();
        if (!std::isfinite(pose.t[k]) || oracle::exactly(pose.t[k]) != x) return std::nullopt;
    }
    return pose;
}

oracle::Soup soup_of(const Boundary& boundary, const Pose& pose) {
    return {boundary.mesh->vertices(), boundary.mesh->triangles(), pose};
}

// True if inner points of solids, or of triangles of surfaces, are shared when a is at the pose.
bool do_overlap(const Way& way, const Pose& pose) {
    const Boundary a = boundary_of(*way.a.what, way.a.what->mesh_ptr(), pose),
                   b = boundary_of(*way.b.what, way.b.what->mesh_ptr(), way.b.pose);
    if (!way.are_solids()) {
        return oracle::relation({a.mesh, pose}, {b.mesh, way.b.pose}) == Relation::crossing;
    }
    const Relation relation = oracle::solid_relation(soup_of(a, pose), soup_of(b, way.b.pose));
    return relation != Relation::apart && relation != Relation::touching;
}

void check_samples(const Way& way, const std::optional<double>& entry, Counters& counters) {
    std::optional<double> last_overlap;
    for (int k = 8; k >= 0; --k) {
        const double s = k / 8.0;
        const auto pose = exact_pose(way, s);
        if (!pose) continue;
        ++counters["checked: samples of bodies that enter"];
        const bool overlap = do_overlap(way, *pose);
        if (overlap && (s > 0 || way.are_solids()) && is_after(entry, s)) {
            throw CheckFailed("entering", fmt::format("by {:a}", s), time_text(entry));
        }
        const bool is_between = last_overlap && !is_after(entry, s) && *entry < s;
        if (!overlap && is_between && way.are_convex()) {
            throw CheckFailed("entering of convex bodies", fmt::format("after {:a}", s), time_text(entry));
        }
        if (overlap && !last_overlap) last_overlap = s;
    }
}

void check_entering(const Way& way, QueryMemory& memory, Counters& counters) {
    if (way.are_solids() == way.are_surfaces()) return;
    const auto entering_of = [&](const Way& w, double max_time) {
        return entering(w.a, w.motion, w.b, max_time, memory);
    };
    std::optional<FirstEntry> entry;
    try {
        entry = entering_of(way, 1);
    } catch (const NotSupported&) {  // a flat solid, or one at a singular pose
        return;
    }
    ++counters["checked: bodies that may enter"];
    counters["checked: bodies that enter"] += entry.has_value();
    const std::optional<double> time = time_of(entry);
    require_same("entering, exchanged", time, time_of(entering_of(way.mirrored(), 1)));
    if (entry) {
        const bool overlap_at_start = entry->a == no_feature;
        require_same("entering, up to a time after it", time,
                     time_of(entering_of(way, std::nextafter(entry->time, 2))));
        if (entry->time > 0) {
            require_same("entering, up to a time before it", {},
                         time_of(entering_of(way, std::nextafter(entry->time, 0))));
        }
        const auto contact = cast(way.a, way.motion, way.b, 1, memory);
        if (is_after(time_of(contact), entry->time)) {
            throw CheckFailed("entering", "after " + time_text(time_of(contact)), time_text(time));
        }
        const auto before = pose_before(way.a, way.motion, way.b, entry->time, memory);
        const bool is_free_at_start = !overlap_at_start && way.are_solids();
        if (!before && is_free_at_start) throw CheckFailed("pose before entering", "one", "none");
        if (before && way.pair_count() <= solid_pairs_max && do_overlap(way, *before)) {
            throw CheckFailed("pose before entering", "apart or touching", "overlapping");
        }
        if (overlap_at_start) {
            require_same("entering, at the start", 0.0, time_of(entering_of(way, 0)));
        }
    }
    if (way.are_solids() && !(entry && entry->a == no_feature)) {
        const MeshShape surface_a(way.a.what->mesh_ptr()), surface_b(way.b.what->mesh_ptr());
        const auto boundary_has_all = [](const Posed<MeshShape>& body) {
            return boundary_of(*body.what, body.what->mesh_ptr(), body.pose).names.empty();
        };
        if (boundary_has_all(way.a) && boundary_has_all(way.b)) {
            const auto of_surfaces = entering({surface_a, way.a.pose}, way.motion, {surface_b, way.b.pose}, 1, memory);
            if (of_surfaces && is_after(time, of_surfaces->time)) {
                throw CheckFailed("entering of solids", "by " + time_text(time_of(of_surfaces)), time_text(time));
            }
        }
    }
    const bool moves = !way.motion.isZero(0);
    if (moves && way.pair_count() <= solid_pairs_max) check_samples(way, time, counters);
}

void check_contact_point(const Way& way, QueryMemory& memory, Counters& counters) {
    const auto contact = cast(way.a, way.motion, way.b, 1, memory);
    if (!contact) return;
    const ContactPoint found = contact_point(way.a, way.motion, way.b, *contact, memory);
    if (found.normal.has_value() != (contact->time > 0)) throw CheckFailed("normal of a contact", "one", "none");
    ++counters["checked: points of first contacts"];
    if (contact->time <= 0) return;
    std::vector<Vec3> corners;
    for (int k = 0; k < 8; ++k) {
        Vec3 corner;
        for (int axis = 0; axis < 3; ++axis) {
            const double end = (k >> axis & 1) != 0 ? std::numeric_limits<double>::infinity()
                                                    : -std::numeric_limits<double>::infinity();
            corner[axis] = std::nextafter(found.point[axis], end);
        }
        if (!corner.allFinite()) return;
        corners.push_back(corner);
    }
    const std::vector<Triangle> faces{{0, 1, 3}, {0, 3, 2}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                                      {2, 3, 7}, {2, 7, 6}, {0, 2, 6}, {0, 6, 4}, {1, 3, 7}, {1, 7, 5}};
    const auto box = Mesh::create(corners, faces);
    const Boundary b = boundary_of(*way.b.what, way.b.what->mesh_ptr(), way.b.pose);
    const oracle::Soup of_box{box->vertices(), box->triangles(), Pose()}, of_b = soup_of(b, way.b.pose);
    if (!oracle::intersects({box, Pose()}, {b.mesh, way.b.pose}) &&
        oracle::surface_relation(of_b, of_box) == Relation::apart) {  // a triangle smaller than the box may be inside
        throw CheckFailed("point of a first contact", "on the body", judge::text(found.point));
    }
    const Vec3& n = *found.normal;
    const double along = n.dot(way.motion.normalized());
    if (std::abs(n.norm() - 1) > 0x1p-50 || along < -0x1p-40) {
        throw CheckFailed("normal of a first contact", "a unit vector along the motion", judge::text(n));
    }
    // The order of the bodies chooses among pairs of triangles that tie.
    if (contact->kind != ClosestKind::vertex_face && contact->kind != ClosestKind::edge_edge) return;
    FirstContact back = *contact;
    std::swap(back.a, back.b);
    const Way mirrored = way.mirrored();
    const auto other = contact_point(mirrored.a, mirrored.motion, mirrored.b, back, memory).normal;
    if (!other || *other != Vec3(-n)) {
        throw CheckFailed("normal of a first contact, exchanged", judge::text(Vec3(-n)),
                          other ? judge::text(*other) : "none");
    }
}

std::optional<double> true_time_within(const Way& way, double d) {
    const auto corners_of = [](const Boundary& body, const Pose& pose, std::uint32_t triangle) {
        const auto points = oracle::posed_points(*body.mesh, pose);
        const Triangle& t = body.mesh->triangles()[triangle];
        return oracle::RoundedMotion::Corners{points[t[0]], points[t[1]], points[t[2]]};
    };
    const Boundary a = boundary_of(*way.a.what, way.a.what->mesh_ptr(), way.a.pose),
                   b = boundary_of(*way.b.what, way.b.what->mesh_ptr(), way.b.pose);
    const oracle::Vector<mpq_class> motion{oracle::exactly(way.motion[0]), oracle::exactly(way.motion[1]),
                                           oracle::exactly(way.motion[2])};
    std::optional<double> least;
    for (std::uint32_t i = 0; i < a.mesh->triangles().size(); ++i) {
        for (std::uint32_t j = 0; j < b.mesh->triangles().size(); ++j) {
            const oracle::RoundedMotion pair(corners_of(a, way.a.pose, i), corners_of(b, way.b.pose, j), motion,
                                             oracle::exactly(d));
            const auto time = pair.first(1);
            if (time && (!least || *time < *least)) least = time;
        }
    }
    return least;
}

void check_to_distance(const Way& way, double d, QueryMemory& memory, Counters& counters) {
    const auto ask = [&](const Way& w, double max_time) {
        return time_of(cast_to_distance(w.a, w.motion, w.b, d, max_time, memory));
    };
    const std::optional<double> time = ask(way, 1);
    ++counters["checked: casts to a distance"];
    counters["checked: bodies that come within a distance"] += time.has_value();
    require_same("cast to a distance, exchanged", time, ask(way.mirrored(), 1));
    const auto contact = cast(way.a, way.motion, way.b, 1, memory);
    if (contact && is_after(time, contact->time)) {
        throw CheckFailed("cast to a distance", "by " + time_text(time_of(contact)), time_text(time));
    }
    if (time) {
        require_same("cast to a distance, up to a time after it", time, ask(way, std::nextafter(*time, 2)));
        if (*time > 0) {
            require_same("cast to a distance, up to a time before it", {}, ask(way, std::nextafter(*time, 0)));
        }
    }
    const Boundary a = boundary_of(*way.a.what, way.a.what->mesh_ptr(), way.a.pose),
                   b = boundary_of(*way.b.what, way.b.what->mesh_ptr(), way.b.pose);
    if (a.has_inside || b.has_inside) return;  // the oracle below knows of surfaces
    for (int k = 0; k <= 4; ++k) {
        const auto pose = exact_pose(way, k / 4.0);
        if (!pose) continue;
        const auto nearest = oracle::MeshDistances(soup_of(a, *pose), soup_of(b, way.b.pose)).closest();
        const bool is_near = oracle::RoundedDistance(nearest, 0, 0).compare(d) <= 0;
        if (is_near && is_after(time, k / 4.0)) {
            throw CheckFailed("cast to a distance", fmt::format("by {:a}", k / 4.0), time_text(time));
        }
        if (k == 0 && is_near != (time == 0.0)) throw CheckFailed("cast to a distance", "0 if near", time_text(time));
    }
    if (time == 0.0 || d <= 0 || way.motion.isZero(0)) return;
    if (a.mesh->triangles().size() * b.mesh->triangles().size() > distance_pairs_max) return;
    require_same("cast to a distance", true_time_within(way, d), time);
    ++counters["checked: casts to a distance by the oracle"];
}

// A surface in the world whose vertices go along the motion, each a bit aside, against the other one, which is at rest.
void check_deforming(const Way& way, scenes::Random& random, QueryMemory& memory, Counters& counters) {
    const auto made = deformed(way.a, way.motion, random);
    if (!made) return;
    const Deforming& mesh = *made;
    const std::shared_ptr<const MeshShape>& start = mesh.shape();
    const auto triangles = start->mesh().triangles();
    const MeshShape other(way.b.what->mesh_ptr());
    const Posed<MeshShape> at_rest(other, way.b.pose);
    const oracle::Soup there{other.mesh().vertices(), other.mesh().triangles(), way.b.pose};
    const auto require = [](const char* what, const std::optional<FirstContact>& got,
                            const std::optional<oracle::ExactContact>& exact) {
        const auto expected = judge::to_first_contact(exact);
        if (!judge::is_same(got, expected)) throw CheckFailed(what, judge::text(expected), judge::text(got));
    };
    const oracle::DeformingSoup moves{{start->mesh().vertices(), triangles, Pose()},
                                      {mesh.mesh_at_end().vertices(), triangles, Pose()}};
    const auto exact = oracle::first_contact(moves, oracle::DeformingSoup{there, there});
    require("cast of a deforming mesh", cast(mesh, at_rest, 1, memory), exact);
    require("cast of a deforming mesh, exchanged", cast(at_rest, mesh, 1, memory),
            oracle::first_contact(oracle::DeformingSoup{there, there}, moves));
    ++counters["checked: casts of deforming meshes"];
    counters["checked: deforming meshes that meet others"] += exact.has_value();
}

}  // namespace

void check_contacts(std::span<World* const> worlds, std::uint32_t seed, Counters& counters) {
    const World& first = *worlds.front();
    const auto bodies = first.bodies();
    if (bodies.size() < 2 || !are_soon_asked(first, bodies)) return;
    scenes::Random random(seed);
    const auto any = [&] { return bodies[random.below(static_cast<std::uint32_t>(bodies.size()))]; };
    const BodyId own = numbers_of(any()), other = numbers_of(any());
    const auto is_mesh = [&](BodyId body) { return first.shape(body)->kind() == ShapeKind::mesh(); };
    if (own == other || !is_mesh(own) || !is_mesh(other)) return;
    const Vec3 from = any_point(first, {own}, random), to = any_point(first, {other}, random);
    Vec3 motion = to - from;
    if (random.below(2) == 0) motion *= 2;
    if (random.below(4) == 0) motion[static_cast<int>(random.below(3))] = 0;
    if (!motion.allFinite()) return;
    QueryMemory memory;
    const Way way{mesh_at(first, own), mesh_at(first, other), motion};
    check_entering(way, memory, counters);
    check_contact_point(way, memory, counters);
    const double size = motion.norm();
    const double d = random.below(4) == 0 ? 0.25 : size * (random.below(2) == 0 ? 0.125 : random.uniform(0, 0.5));
    if (std::isfinite(d) && way.pair_count() <= near_pairs_max) check_to_distance(way, d, memory, counters);
    if (way.pair_count() <= solid_pairs_max) check_deforming(way, random, memory, counters);
    if (!std::ranges::all_of(bodies, is_mesh)) return;
    check_contacts_of_world(*worlds[seed % worlds.size()], own, motion, random, memory, counters);
}

}  // namespace ecods::fuzz
