#include "contact/impact_systems.hpp"

#include "rigor/math/rotation.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rigor::test {

BodyKinetics body(double mass, const Vec3& x, const Vec3& v, const Vec3& w, const Mat3& inertia) {
  BodyKinetics result;
  result.x = x;
  result.v = v;
  result.w = w;
  result.inverse_mass = 1 / mass;
  result.inertia = inertia;
  result.inverse_inertia = inertia.inverse();
  return result;
}

BodyKinetics ball(double mass, const Vec3& x, const Vec3& v, const Vec3& w) {
  return body(mass, x, v, w, 0.4 * mass * Mat3::Identity());
}

Contact contact_at(int A, int B, const Vec3& p_W, const Vec3& n_W, double mu, double e) {
  Contact contact{};
  contact.body_A = A;
  contact.body_B = B;
  contact.point.p_WA = contact.point.p_WB = p_W;
  contact.point.n_W = n_W;
  contact.friction = mu;
  contact.restitution = e;
  return contact;
}

std::vector<double> restitutions_of(const ContactSystem& system) {
  std::vector<double> e;
  for (const Contact& contact : system.contacts) e.push_back(contact.restitution);
  return e;
}

ContactSystem chain(const std::vector<double>& masses, const std::vector<double>& speeds, double e) {
  std::vector<BodyKinetics> kinetics;
  std::vector<Contact> contacts;
  std::vector<int> indices;
  for (std::size_t i = 0; i < masses.size(); ++i) {
    const int index = static_cast<int>(i);
    const double x = 2.0 * index;
    kinetics.push_back(ball(masses[i], Vec3(x, 0, 0), Vec3(speeds[i], 0, 0)));
    indices.push_back(index);
    if (i > 0) contacts.push_back(contact_at(index - 1, index, Vec3(x - 1, 0, 0), Vec3::UnitX(), 0, e));
  }
  return make_contact_system(contacts, indices, kinetics);
}

Totals totals(const ContactSystem& system) {
  Totals sum;
  for (const BodyKinetics& k : system.kinetics) {
    if (k.inverse_mass == 0) continue;
    const Vec3 P = k.v / k.inverse_mass;
    sum.P += P;
    sum.L += k.inertia * k.w + k.x.cross(P);
  }
  return sum;
}

ContactSystem after_impact(const ContactSystem& before, SimultaneousLaw law, RestitutionLaw collision_law) {
  ContactSystem after = before;
  const ImpactSolution impact = solve_impact(before, restitutions_of(before), collision_law, law);
  EXPECT_TRUE(impact.converged);
  apply_impulses(impact.lambda, after);
  return after;
}

ContactSystem random_system(Random& random, double mu_max) {
  const auto up_to = [&random](double size) { return 0.5 * size * (1 + random.number()); };
  const int body_count = 2 + static_cast<int>(up_to(4)), contact_count = 2 + static_cast<int>(up_to(7));
  const bool has_fixed = random.number() > 0;
  std::vector<BodyKinetics> kinetics;
  std::vector<int> indices;
  for (int i = 0; i < body_count; ++i) {
    const Mat3 R = rotation_matrix(rotation_exp(3 * random.vector()));
    const Vec3 moments = Vec3(1, 1.2, 0.9) + 0.3 * random.vector();
    const double mass = std::pow(10.0, random.number());
    const Vec3 x = 2.0 * i * Vec3::UnitX() + 0.2 * random.vector(), v = random.vector(), w = random.vector();
    kinetics.push_back(i == 0 && has_fixed
                           ? BodyKinetics{}
                           : body(mass, x, v, w, 0.4 * mass * R * moments.asDiagonal() * R.transpose()));
    indices.push_back(i);
  }
  std::vector<Contact> contacts;
  const bool has_one_e = random.number() > 0;
  const double common_e = up_to(1);
  for (int k = 0; k < contact_count; ++k) {
    const int a = static_cast<int>(up_to(body_count - 1));
    const Vec3 p = (2.0 * a + 1) * Vec3::UnitX() + 0.6 * random.vector();
    const Vec3 n = (Vec3::UnitX() + 0.6 * random.vector()).normalized();
    const double mu = up_to(mu_max), e = up_to(1);
    contacts.push_back(contact_at(a, a + 1, p, n, mu, has_one_e ? common_e : e));
  }
  return make_contact_system(contacts, indices, kinetics);
}

}  // namespace rigor::test
