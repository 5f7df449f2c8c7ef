#pragma once

#include "rigor/geometry/contacts/contact_set.hpp"
#include "rigor/geometry/shape/shape.hpp"
#include "rigor/math/pose.hpp"

#include <vector>

namespace rigor {

/// One contact for each corner ball whose gap is at most the tolerance, in the order of the corners. None for
/// shapes without corner balls.
std::vector<ContactPoint> cavity_contacts(const Cavity& cavity, const Pose& X_WA, const Shape& b,
                                          const Pose& X_WB, double tolerance);

/// The contact of one ball of B about the point p_W.
ContactPoint cavity_contact(const Cavity& cavity, const Pose& X_WA, const Vec3& p_W, double radius);

}  // namespace rigor
