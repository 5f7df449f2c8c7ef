#pragma once

#include "random_vectors.hpp"
#include "rigor/contact/impact/impact.hpp"

#include <vector>

namespace rigor::test {

BodyKinetics body(double mass, const Vec3& x, const Vec3& v, const Vec3& w, const Mat3& inertia);

/// A solid ball of radius 1.
BodyKinetics ball(double mass, const Vec3& x, const Vec3& v, const Vec3& w = Vec3::Zero());

Contact contact_at(int A, int B, const Vec3& p_W, const Vec3& n_W, double mu, double e);

std::vector<double> restitutions_of(const ContactSystem& system);

/// Balls of radius 1 in a row along x that touch, without friction.
ContactSystem chain(const std::vector<double>& masses, const std::vector<double>& speeds, double e);

struct Totals {
  Vec3 P = Vec3::Zero(), L = Vec3::Zero();
};
Totals totals(const ContactSystem& system);

ContactSystem after_impact(const ContactSystem& before, SimultaneousLaw law = SimultaneousLaw::reflections,
                           RestitutionLaw collision_law = RestitutionLaw::newton);

/// Some bodies in a row, the first one fixed in every other system, with 2 to 8 contacts between neighbours
/// at random points with random normals, masses over two decades, μ up to mu_max.
ContactSystem random_system(Random& random, double mu_max);

}  // namespace rigor::test
