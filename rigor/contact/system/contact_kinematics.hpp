#pragma once

#include "rigor/contact/system/contact.hpp"

namespace rigor {

/// Relative velocity u of B against A at the contact, in the contact frame C = [t1 t2 n] (frame_with_z(n))
/// [m/s].
Vec3 relative_velocity(const Contact& contact, const BodyKinetics& A, const BodyKinetics& B);

/// The part of u̇ that does not depend on accelerations, in the contact frame [m/s²]: with body accelerations
/// a, α
///   u̇ = Cᵀ (a_B + α_B × r_B - a_A - α_A × r_A) + bias.
/// It contains the rotation of the normal and the motion of the witness points on both bodies, so that u̇_n =
/// g̈.
/// The tangential part is that of a contact that sticks or rolls (u_t = 0).
///
/// The normal rotates at ṅ and the witness points move on their bodies at s_A, s_B (tangential) with
///   s_A = H_A (ṅ - ω_A × n) + D_A α,   s_B = -H_B (ṅ - ω_B × n) + D_B β,
///   u_t + s_B - s_A = g ṅ,   D_Aᵀ (ṅ - ω_A × n) = 0,   D_Bᵀ (ṅ - ω_B × n) = 0,
/// with the relative velocity u_t of the witness points, where H are the finite radii of curvature and D the
/// flat directions of SurfaceCurvature. Source: Montana, The Kinematics of Contact and Grasp, IJRR 7(3),
/// 1988, in the support-function form (radii instead of curvatures, so that vertices, edges and faces are
/// ordinary cases).
Vec3 acceleration_bias(const Contact& contact, const BodyKinetics& A, const BodyKinetics& B);

/// ṅ: how fast the normal of the contact rotates as the closest points move along the surfaces [rad/s].
Vec3 normal_rate(const Contact& contact, const BodyKinetics& A, const BodyKinetics& B);

/// How fast the contact goes round its bodies as the closest points move along the surfaces [rad/s]: the rate
/// of its normal, or that at which both closest points move, seen from the bodies' centres of mass.
double feature_rate(const Contact& contact, const BodyKinetics& A, const BodyKinetics& B);

/// The same contact a little later: the features that met keep meeting. Faces carry their normal, vertices
/// and round ends their material centre, edges their line; contacts of surfaces that both curve are found
/// anew by distance. X_WA0, X_WB0 are the poses at which the contact was found; X_WA, X_WB the later ones.
ContactPoint tracked_contact(const Model& model, const Contact& contact, const Pose& X_WA0, const Pose& X_WB0,
                             const Pose& X_WA, const Pose& X_WB);

}  // namespace rigor
