// Poses say where a body is; Posed is a thing at a pose, Moving a thing on its way from one pose to another.
//
// Example: verify/examples/how_do_i, pose_a_body().
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <concepts>
#include <cstdint>
#include <memory>
#include <utility>

#include "ecods/export.hpp"

namespace ecods {

// Points, differences and sizes, in the unit that the caller chose for lengths. No unit is preferred: an answer
// for coordinates times a power of two is the same answer.
using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;

// The map v -> R v + t (FCL, Coal: Transform3; Parry: Isometry). A body is the set of the real points R v + t for the
// points v of its shape, nothing rounded. Any finite R is allowed: it may scale, shear, mirror or be singular, and the
// image is what counts. A rotation written in doubles is in general not exactly orthogonal; the pose is taken as it is
// written.
struct Pose {
    Mat3 R = Mat3::Identity();
    Vec3 t = Vec3::Zero();

    // Takes q as given, not normalised: R is what Eigen's toRotationMatrix() computes from it, sums and products of
    // its coefficients, each rounded. That R is then the pose, like any other R.
    static Pose from_quaternion(const Eigen::Quaterniond& q, const Vec3& t) {
        return from_quaternion(q.w(), q.x(), q.y(), q.z(), t);
    }
    static Pose from_isometry(const Eigen::Isometry3d& m) { return {m.linear(), m.translation()}; }

    // Throws InvalidArgument unless the last row is 0 0 0 1. Nothing is rounded.
    static Pose from_matrix(const Eigen::Matrix4d& m) {
        require_last_row(m(3, 0), m(3, 1), m(3, 2), m(3, 3));
        return {m.topLeftCorner<3, 3>(), m.topRightCorner<3, 1>()};
    }

    friend bool operator==(const Pose& a, const Pose& b) { return a.R == b.R && a.t == b.t; }

  private:
    // Numbers, not Eigen's types of 32 bytes and more: how those are aligned depends on how the caller is compiled.
    ECODS_API static Pose from_quaternion(double w, double x, double y, double z, const Vec3& t);
    ECODS_API static void require_last_row(double x, double y, double z, double w);
};

// Library and caller must agree on the layout whatever instruction set each is compiled for.
static_assert(alignof(Pose) == alignof(double) && sizeof(Pose) == 12 * sizeof(double));

// Throws InvalidArgument for the first entry, row by row of [R t], that is NaN or infinite.
ECODS_API void validate(const Pose& pose);

// Throws InvalidArgument: a pointer to a thing to be posed is null.
[[noreturn]] ECODS_API void refuse_null_thing();

// A thing at a pose: the set of the real points R v + t for the points v of `what`.
//
// Made of a reference, it refers to the thing, which must outlive it. Made of a shared pointer, it keeps the thing. A
// Posed may be returned, stored and copied; the pose is a copy.
template <class T>
struct Posed {
    Posed(const T& thing, const Pose& at) : what(&thing), pose(at) {}
    Posed(const T&& thing, const Pose& at) = delete;  // a temporary, which would be gone

    // Throws InvalidArgument for a null pointer.
    template <std::derived_from<T> Derived>
    Posed(std::shared_ptr<Derived> thing, const Pose& at) : what(thing.get()), pose(at), kept(std::move(thing)) {
        if (what == nullptr) refuse_null_thing();
    }

    // A posed thing of a derived class is one of its base: a solid is a mesh's shape.
    template <std::derived_from<T> Derived>
    Posed(const Posed<Derived>& posed) : what(posed.what), pose(posed.pose), kept(posed.kept) {}

    const T* what;  // never null
    Pose pose;
    std::shared_ptr<const T> kept;  // null where the thing is referred to
};

template <class T>
Posed(std::shared_ptr<T>, const Pose&) -> Posed<std::remove_const_t<T>>;

// A thing on its way: each point v of `what` goes from R v + t of one pose to that of the other, on a straight line and
// at constant speed, in the time from 0 to 1. The poses are copies; the thing is referred to or kept as by Posed.
template <class T>
struct Moving {
    Moving(const T& thing, const Pose& start, const Pose& end) : what(&thing), from(start), to(end) {}
    Moving(const T&& thing, const Pose& start, const Pose& end) = delete;  // a temporary, which would be gone

    // Throws InvalidArgument for a null pointer.
    template <std::derived_from<T> Derived>
    Moving(std::shared_ptr<Derived> thing, const Pose& start, const Pose& end)
        : what(thing.get()), from(start), to(end), kept(std::move(thing)) {
        if (what == nullptr) refuse_null_thing();
    }

    const T* what;  // never null
    Pose from;
    Pose to;
    std::shared_ptr<const T> kept;  // null where the thing is referred to
};

template <class T>
Moving(std::shared_ptr<T>, const Pose&, const Pose&) -> Moving<std::remove_const_t<T>>;

}  // namespace ecods
