// This header declares the point of a first contact of two rounded bodies, for the public functions and a World.
#pragma once

#include "ecods/contact.hpp"
#include "query/body/rounded_pair.hpp"

namespace ecods {

// Returns the point and the normal of a contact that RoundedPair::cast(motion, 0, ...) returned. If no body has a
// radius, returns the contact point of the cores. Throws the errors of contact_point().
ContactPoint contact_point(const RoundedPair& bodies, const Vec3& motion, const FirstContact& contact, const Ask& ask);

}  // namespace ecods
