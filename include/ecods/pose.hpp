// A Pose says where a body is. A Posed is a thing at a pose, a Moving is a thing that moves from one pose to another on
// straight lines, and a Turning is a thing that moves rigidly.
//
// Example: verify/examples/how_do_i, pose_a_body().
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <concepts>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <variant>
#include <vector>

#include "ecods/export.hpp"

namespace ecods {

// A Vec3 is a point, a difference of points or a size, in a unit of length that the caller chooses. No unit is
// preferred: if all coordinates are multiplied by a power of two, answers stay the same.
using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;

// A Pose is the map v -> R v + t (FCL, Coal: Transform3; Parry: Isometry). A body is the set of the real points R v + t
// for the points v of its shape; nothing is rounded. Any finite R is allowed: it may scale, shear, mirror or be
// singular, and the body is the image. A rotation in doubles is rarely exactly orthogonal; the pose is taken as given.
struct Pose {
    Mat3 R = Mat3::Identity();
    Vec3 t = Vec3::Zero();

    // Makes a pose from q, which is not normalised. R is the matrix that Eigen's toRotationMatrix() computes: sums and
    // products of q's coefficients, each rounded. R is then used exactly, as in any other pose.
    static Pose from_quaternion(const Eigen::Quaterniond& q, const Vec3& t) {
        return from_quaternion(q.w(), q.x(), q.y(), q.z(), t);
    }
    static Pose from_isometry(const Eigen::Isometry3d& m) { return {m.linear(), m.translation()}; }

    // Makes a pose from a 4x4 matrix, without rounding. Throws InvalidArgument unless the last row is 0 0 0 1.
    static Pose from_matrix(const Eigen::Matrix4d& m) {
        require_last_row(m(3, 0), m(3, 1), m(3, 2), m(3, 3));
        return {m.topLeftCorner<3, 3>(), m.topRightCorner<3, 1>()};
    }

    friend bool operator==(const Pose& a, const Pose& b) { return a.R == b.R && a.t == b.t; }

  private:
    // Takes numbers instead of Eigen's quaternion, because the alignment of a quaternion depends on how the caller is
    // compiled.
    ECODS_API static Pose from_quaternion(double w, double x, double y, double z, const Vec3& t);
    ECODS_API static void require_last_row(double x, double y, double z, double w);
};

// Library and caller must agree on the layout, whatever instruction set each of them is compiled for.
static_assert(alignof(Pose) == alignof(double) && sizeof(Pose) == 12 * sizeof(double));

// Throws InvalidArgument for the first entry, row by row of [R t], that is NaN or infinite.
ECODS_API void validate(const Pose& pose);

// Throws the InvalidArgument of a null pointer to a thing that was to be posed.
[[noreturn]] ECODS_API void refuse_null_thing();

// A Posed is a thing at a pose: the set of the real points R v + t for the points v of `what`.
//
// If made from a reference, it refers to the thing, which must outlive it. If made from a shared pointer, it keeps the
// thing alive. A Posed may be returned, stored and copied; it has its own copy of the pose.
template <class T>
struct Posed {
    Posed(const T& thing, const Pose& at) : what(&thing), pose(at) {}
    Posed(const T&& thing, const Pose& at) = delete;  // a temporary would dangle

    // Throws InvalidArgument for a null pointer.
    template <std::derived_from<T> Derived>
    Posed(std::shared_ptr<Derived> thing, const Pose& at) : what(thing.get()), pose(at), kept(std::move(thing)) {
        if (what == nullptr) refuse_null_thing();
    }

    // Converts a posed thing of a derived class to its base class: a Solid is a MeshShape.
    template <std::derived_from<T> Derived>
    Posed(const Posed<Derived>& posed) : what(posed.what), pose(posed.pose), kept(posed.kept) {}

    const T* what;  // never null
    Pose pose;
    std::shared_ptr<const T> kept;  // null if the thing is held by reference
};

template <class T>
Posed(std::shared_ptr<T>, const Pose&) -> Posed<std::remove_const_t<T>>;

// A Moving is a moving thing: in the time from 0 to 1, each point v of `what` moves from R v + t of one pose to R v + t
// of the other, on a straight line and at constant speed. It has copies of the poses, and refers to the thing or keeps
// it alive as Posed does.
template <class T>
struct Moving {
    Moving(const T& thing, const Pose& start, const Pose& end) : what(&thing), from(start), to(end) {}
    Moving(const T&& thing, const Pose& start, const Pose& end) = delete;  // a temporary would dangle

    // Throws InvalidArgument for a null pointer.
    template <std::derived_from<T> Derived>
    Moving(std::shared_ptr<Derived> thing, const Pose& start, const Pose& end)
        : what(thing.get()), from(start), to(end), kept(std::move(thing)) {
        if (what == nullptr) refuse_null_thing();
    }

    const T* what;  // never null
    Pose from;
    Pose to;
    std::shared_ptr<const T> kept;  // null if the thing is held by reference
};

template <class T>
Moving(std::shared_ptr<T>, const Pose&, const Pose&) -> Moving<std::remove_const_t<T>>;

// A Quaternion is w + x i + y j + z k. It may have any length but zero.
struct Quaternion {
    double w = 1, x = 0, y = 0, z = 0;

    friend bool operator==(const Quaternion&, const Quaternion&) = default;
};

// A Turn is the turn by q about a pivot that goes from one point of the world to another. If x = y = z = 0, w must be
// positive, and the body is translated without turning.
struct Turn {
    Quaternion q;
    Vec3 pivot_from = Vec3::Zero();
    Vec3 pivot_to = Vec3::Zero();

    friend bool operator==(const Turn& a, const Turn& b) {
        return a.q == b.q && a.pivot_from == b.pivot_from && a.pivot_to == b.pivot_to;
    }
};

// Throws InvalidArgument (Argument::turn) if a number is not finite: "q.w", "q.x", "pivot_from(0)", "pivot_to(2)". Also
// throws, with "q", if the quaternion is zero, or if w < 0 and x = y = z = 0, which is a whole turn and has no axis.
ECODS_API void validate(const Turn& turn);

// A Turning is a thing that is at a pose at time 0, and then turns. It has copies of pose and turn, and refers to the
// thing or keeps it alive as Posed does.
template <class T>
struct Turning {
    Turning(const T& thing, const Pose& start, const Turn& motion) : what(&thing), pose(start), turn(motion) {}
    Turning(const T&& thing, const Pose& start, const Turn& motion) = delete;  // a temporary would dangle

    // Throws InvalidArgument for a null pointer.
    template <std::derived_from<T> Derived>
    Turning(std::shared_ptr<Derived> thing, const Pose& start, const Turn& motion)
        : what(thing.get()), pose(start), turn(motion), kept(std::move(thing)) {
        if (what == nullptr) refuse_null_thing();
    }

    const T* what;  // never null
    Pose pose;
    Turn turn;
    std::shared_ptr<const T> kept;  // null if the thing is held by reference
};

template <class T>
Turning(std::shared_ptr<T>, const Pose&, const Turn&) -> Turning<std::remove_const_t<T>>;

// ---- motions

// A Motion says how a body moves in the time from 0 to 1: it is translated, or goes straight to another pose, or turns,
// or goes along the nodes of a way. Two bodies may have any two of the first three motions; beside a body that goes
// along a way, the other one stays (turn.hpp, world.hpp). (FCL: MotionBase; Parry: NonlinearRigidMotion; Box3D:
// b3Sweep.)
//
// Example: verify/examples/how_do_i, move_at_once().

// A Translation moves a body by time times `by`; the default is no motion.
struct Translation {
    Vec3 by = Vec3::Zero();

    friend bool operator==(const Translation& a, const Translation& b) { return a.by == b.by; }
};

// A Straight motion moves each point of a body on a straight line, at constant speed, to its place at the pose `to`.
// This motion is no rotation (cast.hpp).
struct Straight {
    Pose to;

    friend bool operator==(const Straight&, const Straight&) = default;
};

// A WayNode is a node of a way (turn.hpp): the quaternion of the turn since the beginning, and the place of the pivot.
struct WayNode {
    Quaternion q;
    Vec3 pivot = Vec3::Zero();

    friend bool operator==(const WayNode& a, const WayNode& b) { return a.q == b.q && a.pivot == b.pivot; }
};

// An Along moves a body along a way (turn.hpp), each leg in an equal share of the time: of n legs, leg k (from 0) takes
// the time from k / n to (k + 1) / n. A contact on leg k, at the time s of the leg, which cast(Way, Posed) returns as a
// double, is at the time (k + s) / n, rounded once; the contact counts if this time is at most max_time. So the time is
// 0 exactly if the bodies share a point at the start. Divide legs that should take longer; call cast(Way, Posed) to get
// the leg itself.
//
// A body on a way meets bodies at rest. Casts and meetings of a body on a way and a body that moves throw NotSupported:
// where a leg begins, the other body is at no pose of doubles. There is one exception: two nodes, of which the first
// has the quaternion 1 (without a factor), are treated as a Turn everywhere. A cast searches every leg that begins by
// max_time.
struct Along {
    std::vector<WayNode> nodes;

    friend bool operator==(const Along&, const Along&) = default;
};

// A Motion is the motion of one body; Motion() is that of a body at rest. Turn and Along keep the body rigid
// (turn.hpp).
using Motion = std::variant<Translation, Straight, Turn, Along>;

// Throws InvalidArgument if a number is not finite (Argument::motion for a translation, pose, turn), and the other
// errors of validate() for a turn or nodes.
ECODS_API void validate(const Motion& motion);

// Throws InvalidArgument (Argument::turn), whose index is that of the node: if a number is not finite ("q.w", "q.x",
// "pivot(0)"); if a quaternion is zero, or a negative multiple of the one before it, which would be a whole turn about
// no axis ("q"); if the first node's quaternion is not a positive number ("q"); or, without an index, if there are
// fewer than two nodes ("nodes").
ECODS_API void validate(std::span<const WayNode> nodes);

}  // namespace ecods
