// A thing at a pose.
#pragma once

#include <concepts>

#include "ecods/export.hpp"
#include "ecods/pose.hpp"

namespace ecods {

// The set of the real points R v + t for the points v of `what`. The pose is a copy; `what` is referred to and must
// outlive this: a Posed may be returned, stored and copied wherever the thing itself stays.
template <class T>
struct Posed {
    Posed(const T& thing, const Pose& at) : what(&thing), pose(at) {}
    Posed(const T&& thing, const Pose& at) = delete;  // a temporary, which would be gone

    // A posed thing of a derived class is one of its base: a solid is a mesh's shape.
    template <std::derived_from<T> Derived>
    Posed(const Posed<Derived>& posed) : what(posed.what), pose(posed.pose) {}

    const T* what;  // never null
    Pose pose;
};

}  // namespace ecods
