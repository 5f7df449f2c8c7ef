#pragma once

#include "rigor/geometry/contact_set.hpp"
#include "rigor/geometry/distance.hpp"
#include "rigor/geometry/time_of_contact.hpp"

namespace rigor {

// A cavity against what is inside it. What decides is the point farthest from the centre; of hulls of balls
// (of one radius: spheres, capsules, boxes, convex polyhedra, meshes) it is on one of them, a corner, and
// each corner may touch by itself: contacts and motions are for them.

/// Whether the shape is the hull of finitely many balls of one radius, or a mesh, whose hull is one of
/// points.
bool has_corner_balls(const Shape& shape);

/// Signed distance of the wall and a bounded shape, negative where it sticks into the wall: R less the
/// largest distance of a point of the shape from the centre. A has the cavity.
DistanceResult cavity_distance(const Cavity& cavity, const Pose& X_WA, const Shape& b, const Pose& X_WB);

/// One contact for each corner ball whose gap is at most the tolerance, in the order of the corners. None for
/// shapes without corner balls.
std::vector<ContactPoint> cavity_contacts(const Cavity& cavity, const Pose& X_WA, const Shape& b,
                                          const Pose& X_WB, double tolerance);

/// The contact of one ball of B about the point p_W.
ContactPoint cavity_contact(const Cavity& cavity, const Pose& X_WA, const Vec3& p_W, double radius);

/// A span from t on, at most to t_end, during which no corner of B comes nearer to the wall than `level` [m].
/// A moving corner at r from the centre, with velocity u against it, is at most |r + τ u| + ½ a τ² from it
/// later, where a bounds the accelerations: a convex function of τ.
double safe_step_in_cavity(const MovingShape& cavity, const MovingShape& inside, double t, double t_end,
                           double level);

}  // namespace rigor
