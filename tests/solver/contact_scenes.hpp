#pragma once

#include "rigor/solver/coulomb/coulomb_problem.hpp"

#include <vector>

namespace rigor::scenes {

/// A body of a test scene, all in the world frame.
struct Body {
  double mass;                ///< [kg]
  Mat3 inertia;               ///< About the centre of mass [kg m²].
  Vec3 center;                ///< [m]
  Vec3 v = Vec3::Zero();      ///< Velocity or free acceleration of the centre.
  Vec3 omega = Vec3::Zero();  ///< Angular velocity or free angular acceleration.
};

/// The normal points from A to B; index -1 is the fixed world.
struct Contact {
  int body_A, body_B;
  Vec3 point;
  Mat3 axes;  ///< Columns t1, t2, n.
  double mu;
};

struct Scene {
  std::vector<Body> bodies;
  std::vector<Contact> contacts;
};

/// Right-handed contact axes whose t1 is turned by `angle` about the normal n.
Mat3 axes_of(const Vec3& n, double angle = 0);

Mat3 box_inertia(double mass, const Vec3& size);

/// J (3n × 6 bodies): w = J V, V = (v, ω) of every body.
MatX contact_jacobian(const Scene& scene);

MatX inverse_mass(const Scene& scene);

/// V of the bodies, without contact forces.
VecX free_motion(const Scene& scene);

/// All contacts as `cone` rows.
CoulombProblem problem_of(const Scene& scene);

/// V with the contact forces.
VecX motion_with(const Scene& scene, const VecX& lambda);

/// count × count contact points on a horizontal face, between -half and +half in x and y, at height z.
void add_face(Scene& scene, int below, int above, const Vec3& middle, const Vec2& half, int count, double mu,
              double frame_angle = 0);

/// A box of 1 kg, 1 × 0.8 × 0.6 m, on the plane z = 0 with count × count contact points, under `gravity`.
Scene box_on_plane(int count, double mu, const Vec3& gravity, double frame_angle = 0);

/// Boxes of 1 m side with the given masses one on another, four contact points per face, at rest under
/// gravity g.
Scene stack(const std::vector<double>& masses, double mu, double g = 9.81);

}  // namespace rigor::scenes
