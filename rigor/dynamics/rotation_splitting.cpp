#include "rigor/dynamics/rotation_splitting.hpp"

#include "rigor/math/rotation.hpp"

#include <array>
#include <cmath>

namespace rigor {
namespace {

/// Suzuki's fractions of a step.
std::array<double, 5> suzuki_fractions() {
  const double p = 1 / (4 - std::cbrt(4.0));
  return {p, p, 1 - 4 * p, p, p};
}

/// Exact flow of M²/2I about one body axis for h: rotates the body by h M/I and updates M = Rᵀ L.
void rotate_about_axis(int axis, double h_over_I, Quat& q_WB, Vec3& L_B) {
  // q ← q exp(h M/I e/2).
  const double half = 0.5 * h_over_I * L_B[axis];
  Vec4 rotation(std::cos(half), 0, 0, 0);
  rotation[axis + 1] = std::sin(half);
  q_WB = q_WB * Quat(rotation[0], rotation[1], rotation[2], rotation[3]);

  // In the body M rotates in the opposite direction, by the double angle.
  const double c = rotation[0] * rotation[0] - rotation[axis + 1] * rotation[axis + 1];
  const double s = 2 * rotation[0] * rotation[axis + 1];
  const int i = (axis + 1) % 3, k = (axis + 2) % 3;
  const double L_i = L_B[i], L_k = L_B[k];
  L_B[i] = c * L_i + s * L_k;
  L_B[k] = c * L_k - s * L_i;
}

void kick(std::span<const Wrench> wrenches, double h, std::span<BodyPhase> phases) {
  for (std::size_t i = 0; i < phases.size(); ++i) {
    phases[i].P += h * wrenches[i].f_W;
    phases[i].L += h * wrenches[i].tau_W;
  }
}

}  // namespace

Quat rotate_by_splitting(const Vec3& moments, const Quat& q_WB, const Vec3& L_W, double h) {
  Quat q = q_WB;
  Vec3 L_B = rotation_matrix(q_WB).transpose() * L_W;
  rotate_about_axis(0, 0.5 * h / moments[0], q, L_B);
  rotate_about_axis(1, 0.5 * h / moments[1], q, L_B);
  rotate_about_axis(2, h / moments[2], q, L_B);
  rotate_about_axis(1, 0.5 * h / moments[1], q, L_B);
  rotate_about_axis(0, 0.5 * h / moments[0], q, L_B);
  return q.normalized();
}

Quat rotate_by_splitting4(const Vec3& moments, const Quat& q_WB, const Vec3& L_W, double h) {
  Quat q = q_WB;
  for (const double fraction : suzuki_fractions()) q = rotate_by_splitting(moments, q, L_W, fraction * h);
  return q;
}

std::vector<BodyPhase> leapfrog_step(std::span<const BodyInertia> inertias, std::span<const BodyPhase> start,
                                     double t, double h, const WrenchField& wrenches) {
  // Half a kick.
  std::vector<BodyPhase> phases(start.begin(), start.end());
  std::vector<Wrench> forces(start.size());
  wrenches(t, phases, forces);
  kick(forces, 0.5 * h, phases);

  // Drift: free motion with these momenta.
  for (std::size_t i = 0; i < phases.size(); ++i) {
    phases[i].x += h * (phases[i].P / inertias[i].mass);
    phases[i].q = rotate_by_splitting(inertias[i].moments, phases[i].q, phases[i].L, h);
  }

  // Half a kick with the forces at the end.
  forces.assign(start.size(), Wrench{});
  wrenches(t + h, phases, forces);
  kick(forces, 0.5 * h, phases);
  return phases;
}

std::vector<BodyPhase> leapfrog4_step(std::span<const BodyInertia> inertias, std::span<const BodyPhase> start,
                                      double t, double h, const WrenchField& wrenches) {
  std::vector<BodyPhase> phases(start.begin(), start.end());
  for (const double fraction : suzuki_fractions()) {
    phases = leapfrog_step(inertias, phases, t, fraction * h, wrenches);
    t += fraction * h;
  }
  return phases;
}

}  // namespace rigor
