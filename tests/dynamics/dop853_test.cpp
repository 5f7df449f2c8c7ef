#include "rigor/dynamics/end_of_step.hpp"
#include "rigor/dynamics/free_flight.hpp"
#include "rigor/dynamics/step_control.hpp"
#include "rigor/math/rotation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace rigor::dop853_test {
namespace {

constexpr OrientationForm kForms[] = {OrientationForm::quaternion, OrientationForm::matrix};

/// A heavy symmetric top on a fixed point in regular precession: its axis, tilted by θ, goes round the
/// vertical at Ω while the body turns about it at ψ̇. Moments about the fixed point. L is
/// sin θ (I₃ (ψ̇ + Ω cos θ) - I₁ Ω cos θ) across the vertical and goes round with the axis, so the torque
/// m g l sin θ must be Ω times that:
///
///   m g l = Ω (I₃ (ψ̇ + Ω cos θ) - I₁ Ω cos θ).
struct HeavyTop {
  static constexpr double tilt = 0.7, precession = 0.8, spin = 5, I1 = 0.9, I3 = 0.5;
  BodyInertia inertia{1, Vec3(I1, I1, I3)};

  double moment() const {
    return precession * (I3 * (spin + precession * std::cos(tilt)) - I1 * precession * std::cos(tilt));
  }
  BodyPhase at(double t) const {
    const Quat q = rotation_exp(Vec3(0, 0, precession * t)) * rotation_exp(Vec3(tilt, 0, 0)) *
                   rotation_exp(Vec3(0, 0, spin * t));
    const Mat3 R = rotation_matrix(q);
    const Vec3 w = precession * Vec3::UnitZ() + spin * R.col(2);
    return {Vec3::Zero(), q, Vec3::Zero(), R * inertia.moments.cwiseProduct(R.transpose() * w)};
  }
  /// Weight at the distance l along the axis.
  void field(std::span<const BodyPhase> phases, std::span<Wrench> wrenches) const {
    const Vec3 axis = rotation_matrix(phases[0].q).col(2);
    wrenches[0] = {Vec3::Zero(), axis.cross(Vec3(0, 0, -moment()))};
  }
};

double heavy_top_error(IntegratorName name, OrientationForm form, int steps) {
  const HeavyTop top;
  const auto field = [&top](double, std::span<const BodyPhase> phases, std::span<Wrench> wrenches) {
    top.field(phases, wrenches);
  };
  const double end = 4, h = end / steps;
  std::vector<BodyPhase> phases = {top.at(0)};
  for (int i = 0; i < steps; ++i)
    phases = integrate_step(name, form, std::span(&top.inertia, 1), phases, i * h, h, field, {}).end;
  return rotation_angle_between(phases[0].q, top.at(end).q) + (phases[0].L - top.at(end).L).norm();
}

TEST(Dop853, AHeavyTopConvergesAtOrderEight) {
  for (const OrientationForm form : kForms) {
    const double coarse = heavy_top_error(IntegratorName::dop853, form, 30);
    const double fine = heavy_top_error(IntegratorName::dop853, form, 60);
    EXPECT_NEAR(std::log2(coarse / fine), 8, 0.3) << static_cast<int>(form);
    // For as many evaluations of the forces as dopri5 takes, it is far better.
    EXPECT_LT(fine, 1e-2 * heavy_top_error(IntegratorName::dopri5, form, 60 * 16 / 7));
  }
}

void no_forces(double, std::span<const BodyPhase>, std::span<Wrench>) {}

const BodyInertia asymmetric{1, Vec3(1, 2, 3)};
const BodyPhase tumbling{.L = Vec3(0.3, 4, 0.5)};

TEST(Dop853, AFreeAsymmetricTopConvergesAtOrderEight) {
  const double end = 3;
  const BodyPhase exact = FreeFlight(asymmetric, tumbling, 0, Vec3::Zero()).at(end);
  for (const OrientationForm form : kForms) {
    const auto error = [&](int steps) {
      std::vector<BodyPhase> phases = {tumbling};
      const double h = end / steps;
      for (int i = 0; i < steps; ++i)
        phases = integrate_step(IntegratorName::dop853, form, std::span(&asymmetric, 1), phases, i * h, h,
                                no_forces, {})
                     .end;
      return rotation_angle_between(phases[0].q, exact.q);
    };
    EXPECT_NEAR(std::log2(error(15) / error(30)), 8, 0.3) << static_cast<int>(form);
  }
}

struct ControlledRun {
  int evaluations = 0;
  double error = 0;
};

/// The free top up to t = 10 under step control.
ControlledRun controlled_run(IntegratorName name, double tolerance) {
  ControlledRun run;
  const WrenchField counted = [&run](double, std::span<const BodyPhase>, std::span<Wrench>) {
    ++run.evaluations;
  };
  StepController controller(integrator_order(name));
  std::vector<BodyPhase> phases = {tumbling};
  double t = 0, h = 0.01;
  while (t < 10) {
    const double tried = std::min(h, 10 - t);
    const SystemStep step = integrate_step(name, OrientationForm::quaternion, std::span(&asymmetric, 1),
                                           phases, t, tried, counted, {.relative = tolerance});
    const StepDecision decision = controller.decide(tried, step.error);
    h = decision.h_next;
    if (!decision.is_accepted) continue;
    t = tried == 10 - t ? 10 : t + tried;
    phases = step.end;
  }
  run.error = rotation_angle_between(phases[0].q, FreeFlight(asymmetric, tumbling, 0, Vec3::Zero()).at(10).q);
  return run;
}

// Local errors of the tolerance add up, and grow a little on the way.
TEST(Dop853, UnderStepControlTheErrorFollowsTheToleranceWithFewerEvaluationsThanDopri5) {
  for (const double tolerance : {1e-8, 1e-10, 1e-12}) {
    const ControlledRun run = controlled_run(IntegratorName::dop853, tolerance);
    EXPECT_LT(run.error, 1000 * tolerance);
    EXPECT_LT(run.evaluations, controlled_run(IntegratorName::dopri5, tolerance).evaluations) << tolerance;
  }
}

TEST(Dop853, ErrorEstimateIsOfOrderEightAndRelativeToTheTolerance) {
  const auto error = [](double tolerance, double h) {
    return integrate_step(IntegratorName::dop853, OrientationForm::quaternion, std::span(&asymmetric, 1),
                          std::span(&tumbling, 1), 0, h, no_forces, {.relative = tolerance})
        .error;
  };
  EXPECT_NEAR(error(1e-10, 0.1) / error(1e-8, 0.1), 100, 1e-9);
  EXPECT_NEAR(std::log2(error(1e-10, 0.1) / error(1e-10, 0.05)), 8, 0.3);
  EXPECT_TRUE(std::isinf(error(1e-10, 1e300)));
}

TEST(Dop853, EndOfStepHasTheSameBitsForTwelveWrenches) {
  int asked = 0;
  const WrenchField counted = [&asked](double, std::span<const BodyPhase> phases,
                                       std::span<Wrench> wrenches) {
    ++asked;
    wrenches[0].tau_W = 0.1 * phases[0].L.cross(Vec3::UnitX());
  };
  const auto take = [&](auto integrate) {
    return integrate(IntegratorName::dop853, OrientationForm::quaternion, std::span(&asymmetric, 1),
                     std::span(&tumbling, 1), 0.0, 0.1, counted, IntegratorTolerances{});
  };
  const SystemStep whole = take(integrate_step);
  EXPECT_EQ(asked, 16);
  const SystemStep end = take(integrate_end_of_step);
  EXPECT_EQ(asked, 16 + 12);
  EXPECT_TRUE(end.dense.empty());
  EXPECT_EQ(end.error, whole.error);
  EXPECT_EQ(end.end[0].q.coeffs(), whole.end[0].q.coeffs());
  EXPECT_EQ(end.end[0].L, whole.end[0].L);
}

}  // namespace
}  // namespace rigor::dop853_test
