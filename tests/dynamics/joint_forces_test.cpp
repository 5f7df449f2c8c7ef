#include "rigor/dynamics/joint_forces.hpp"

#include "dynamics/joint_samples.hpp"
#include "rigor/dynamics/integrator.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace rigor::joint_forces_test {
namespace {

using test::Random;
using tests::place;
using tests::turned;

/// Spring of 20 N/m or N m/rad and damper on every coordinate; the rests are half a unit off.
Joint sprung_joint(JointType type, double damping, Random& random) {
  Joint joint = tests::random_joint(type, random);
  for (JointAxis& axis : joint.axes) {
    axis.stiffness = 20;
    axis.rest = 0.5;
    axis.damping = damping;
  }
  return joint;
}

double power_of(const Wrench& wrench, const BodyMotion& body) {
  return wrench.f_W.dot(body.v) + wrench.tau_W.dot(body.w);
}

class JointSprings : public testing::TestWithParam<JointType> {};
INSTANTIATE_TEST_SUITE_P(All, JointSprings,
                         testing::Values(JointType::ball, JointType::hinge, JointType::slider,
                                         JointType::universal, JointType::cylindrical, JointType::planar,
                                         JointType::distance, JointType::screw, JointType::point_on_line));

TEST_P(JointSprings, SupplyTheEnergyThatTheyLose) {
  Random random(1);
  for (int sample = 0; sample < 100; ++sample) {
    const Joint joint = sprung_joint(GetParam(), 0, random);
    const BodyMotion A = tests::random_motion(random);
    BodyMotion B = tests::random_motion(random);
    place(joint, A, tests::random_allowed_pose(joint, random).X_FK, B);
    B.x += 0.05 * random.vector();
    const JointForces forces = spring_forces(joint, A, B);
    const auto energy = [&](double t) {
      return stored_energy(joint, tests::moved(A, t), tests::moved(B, t));
    };
    // Differences of order h⁴: the rest is about 20 h⁴ times fifth derivatives of order 1.
    constexpr double h = 1e-3;
    const double rate = (8 * (energy(h) - energy(-h)) - (energy(2 * h) - energy(-2 * h))) / (12 * h);
    EXPECT_NEAR(power_of(forces.on_A, A) + power_of(forces.on_B, B), -rate, 1e-8);
  }
}

TEST_P(JointSprings, AreActionAndReaction) {
  Random random(2);
  for (int sample = 0; sample < 100; ++sample) {
    const Joint joint = sprung_joint(GetParam(), 3, random);
    const BodyMotion A = tests::random_motion(random), B = tests::random_motion(random);
    const JointForces forces = spring_forces(joint, A, B);
    const double size = forces.on_A.f_W.norm() + forces.on_A.tau_W.norm();
    EXPECT_GT(size, 0.1);
    EXPECT_LE((forces.on_A.f_W + forces.on_B.f_W).norm(), 1e-15 * size);
    const Vec3 moment =
        forces.on_A.tau_W + A.x.cross(forces.on_A.f_W) + forces.on_B.tau_W + B.x.cross(forces.on_B.f_W);
    EXPECT_LE(moment.norm(), 4e-15 * size);
  }
}

TEST_P(JointSprings, DampersTakeTheirCoefficientTimesTheRateSquared) {
  Random random(3);
  for (int sample = 0; sample < 100; ++sample) {
    const Joint with = sprung_joint(GetParam(), 3, random);
    Joint without = with;
    for (JointAxis& axis : without.axes) axis.damping = 0;
    const BodyMotion A = tests::random_motion(random), B = tests::random_motion(random);
    const auto power = [&](const Joint& joint) {
      const JointForces forces = spring_forces(joint, A, B);
      return power_of(forces.on_A, A) + power_of(forces.on_B, B);
    };
    double squares = 0;
    for (int k = 0; k < coordinate_count(GetParam()); ++k) {
      const double rate = joint_coordinate(with, k, A, B).rate;
      squares += rate * rate;
    }
    if (GetParam() == JointType::ball) squares = (B.w - A.w).squaredNorm();
    // Rounding of the springs' power, which is taken away: forces of about 100.
    EXPECT_NEAR(power(with) - power(without), -3 * squares, 1e-12);
  }
}

TEST(JointForces, PushTheCoordinateTowardsItsRest) {
  for (const double rest : {-0.4, 0.4}) {
    Joint joint;
    joint.axes.resize(1);
    joint.axes[0].stiffness = 10;
    joint.axes[0].rest = rest;
    joint.type = JointType::slider;
    EXPECT_NEAR(spring_forces(joint, BodyMotion{}, BodyMotion{}).on_B.f_W.z(), 10 * rest, 1e-15);
    joint.type = JointType::hinge;
    EXPECT_NEAR(spring_forces(joint, BodyMotion{}, BodyMotion{}).on_B.tau_W.z(), 10 * rest, 1e-15);
    EXPECT_NEAR(stored_energy(joint, BodyMotion{}, BodyMotion{}), 0.5 * 10 * rest * rest, 1e-15);
  }
}

TEST(JointForces, ASpringOfAnAngleActsTheShorterWayRound) {
  Joint joint;
  joint.type = JointType::hinge;
  joint.axes.resize(1);
  joint.axes[0].stiffness = 10;
  joint.axes[0].rest = 3;
  BodyMotion B;
  B.R = turned(Vec3(0, 0, -3));
  // From -3 to 3 rad: back through π, by 2π - 6.
  const double way = 2 * M_PI - 6;
  EXPECT_NEAR(spring_forces(joint, BodyMotion{}, B).on_B.tau_W.z(), -10 * way, 1e-13);
  EXPECT_NEAR(stored_energy(joint, BodyMotion{}, B), 5 * way * way, 1e-13);
}

TEST(JointForces, ABallTurnsBackAboutItsRotationAndIsBrakedAlike) {
  Joint joint;
  joint.type = JointType::ball;
  joint.axes.resize(1);
  joint.axes[0].stiffness = 10;
  joint.axes[0].damping = 2;
  const Vec3 phi(0.3, -0.4, 1.2), w(1, 2, 3);
  const BodyMotion A{Vec3::Zero(), Mat3::Identity(), Vec3::Zero(), Vec3(1, 0, 0)};
  const BodyMotion B{Vec3::Zero(), turned(phi), Vec3::Zero(), w};
  const JointForces forces = spring_forces(joint, A, B);
  EXPECT_LE((forces.on_B.tau_W - (-10 * phi - 2 * (w - A.w))).norm(), 1e-14);
  EXPECT_LE(forces.on_B.f_W.norm() + forces.on_A.f_W.norm(), 1e-15);
}

/// Dormand and Prince's method over the time of one oscillation, in 200 steps: errors of order 200 (2π/200)⁶
/// /6! of the amplitude, 3e-10.
std::vector<BodyPhase> after(double time, const std::vector<BodyInertia>& inertias,
                             std::vector<BodyPhase> phases, const Joint& joint) {
  const auto motion = [&](const BodyPhase& phase, const BodyInertia& inertia) {
    return BodyMotion{phase.x, rotation_matrix(phase.q), phase.P / inertia.mass,
                      angular_velocity(inertia, phase.q, phase.L)};
  };
  const WrenchField field = [&](double, std::span<const BodyPhase> now, std::span<Wrench> wrenches) {
    const bool has_two = now.size() == 2;
    const BodyMotion B = motion(now.back(), inertias.back());
    const JointForces forces =
        spring_forces(joint, has_two ? motion(now.front(), inertias.front()) : BodyMotion{}, B);
    wrenches.front() = forces.on_A;
    wrenches.back() = forces.on_B;
  };
  constexpr int steps = 200;
  for (int i = 0; i < steps; ++i) {
    phases = integrate_step(IntegratorName::dopri5, OrientationForm::quaternion, inertias, phases,
                            i * time / steps, time / steps, field, {})
                 .end;
  }
  return phases;
}

TEST(JointForces, ATorsionPendulumHasThePeriodOfItsInertiaAndStiffness) {
  constexpr double k = 3, amplitude = 1.5;
  const std::vector<BodyInertia> inertias = {{2, Vec3(0.1, 0.2, 0.25)}};
  for (const JointType type :
       {JointType::hinge, JointType::cylindrical, JointType::planar, JointType::ball}) {
    Joint joint;
    joint.type = type;
    joint.body_A = world_body;
    joint.axes.resize(static_cast<std::size_t>(coordinate_count(type)));
    joint.axes.back().stiffness = k;
    BodyPhase start;
    start.q = rotation_exp(Vec3(0, 0, amplitude));
    const double period = 2 * M_PI * std::sqrt(0.25 / k);
    for (const double part : {1.0, 1.0 / 3, 0.5}) {
      const BodyPhase end = after(part * period, inertias, {start}, joint).front();
      EXPECT_NEAR(rotation_log(end.q).z(), amplitude * std::cos(2 * M_PI * part), 1e-8);
    }
  }
}

TEST(JointForces, TwoMassesOnASliderSwingWithTheirReducedMass) {
  constexpr double k = 5, m_A = 1, m_B = 3, stretch = 0.2;
  Joint joint;
  joint.type = JointType::slider;
  joint.axes.resize(1);
  joint.axes[0].stiffness = k;
  const std::vector<BodyInertia> inertias = {{m_A, Vec3::Ones()}, {m_B, Vec3::Ones()}};
  std::vector<BodyPhase> phases(2);
  phases[1].x.z() = stretch;
  const double period = 2 * M_PI * std::sqrt(m_A * m_B / (m_A + m_B) / k);
  phases = after(period / 2, inertias, phases, joint);
  EXPECT_NEAR(phases[1].x.z() - phases[0].x.z(), -stretch, 1e-9);
  // The centre of mass stays.
  EXPECT_NEAR(m_A * phases[0].x.z() + m_B * phases[1].x.z(), m_B * stretch, 1e-14);
}

TEST(JointForces, AJointWithoutSpringsAndDampersHasNone) {
  Joint joint;
  joint.type = JointType::cylindrical;
  joint.axes.resize(2);
  EXPECT_FALSE(has_springs(joint));
  joint.axes[1].damping = 1;
  EXPECT_TRUE(has_springs(joint));
}

}  // namespace
}  // namespace rigor::joint_forces_test
