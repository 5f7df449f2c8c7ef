// Painlevé's rod: a thin rod that slides tip first over a rough floor, against closed forms.

#include "laws/scene_runs.hpp"

#include "rigor/contact/resting/paradox.hpp"
#include "rigor/math/rotation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rigor::test::painleve_test {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double g = 9.81;

/// The rod of the scene with its tip on the floor, leaning at `lean` from it, turning with `spin` about y;
/// the tip slides into the lean at 1 m/s.
ContactSystem sliding_rod(const Model& model, double lean, double mu, double spin) {
  const Vec3 axis(std::cos(lean), 0, std::sin(lean)), w(0, spin, 0);
  const int rod = model.find_body("rod").value();
  const Pose X_WU{rotation_matrix(rotation_exp(Vec3(0, pi / 2 - lean, 0))), Vec3(0, 0, std::sin(lean))};
  const Pose X_WB = X_WU * model.body(rod).X_BU.inverse();
  BodyKinetics kinetics =
      dynamic_kinetics(model.body(rod), {X_WB.p, quaternion_of(X_WB.R), Vec3::Zero(), Vec3::Zero()});
  kinetics.w = w;
  kinetics.v = -Vec3::UnitX() + w.cross(axis);
  std::vector<Contact> contacts = find_contacts(model, 0, rod, Pose(), kinetics.pose(), 1e-6);
  for (Contact& contact : contacts) contact.friction = mu;
  return make_contact_system(contacts, {0, rod}, {BodyKinetics(), kinetics});
}

Paradox::Kind paradox_of(const Model& model, double lean, double mu, double spin = 0) {
  const ContactSystem system = sliding_rod(model, lean, mu, spin);
  EXPECT_EQ(system.contacts.size(), 1u);
  std::vector<Wrench> wrenches(2);
  wrenches[1].f_W = -g * Vec3::UnitZ();
  return find_paradox(system, wrenches, 1e-9, true).kind;
}

/// The friction above which no finite force exists, by bisection.
double critical_friction(const Model& model, double lean) {
  double low = 0, high = 16;
  for (int i = 0; i < 60; ++i) {
    const double mu = 0.5 * (low + high);
    (paradox_of(model, lean, mu) == Paradox::Kind::none ? low : high) = mu;
  }
  return high;
}

bool has_warning(const SceneRun& run, const std::string& start) {
  const std::vector<std::string>& warnings = run.audit().warnings;
  return std::any_of(warnings.begin(), warnings.end(),
                     [&](const std::string& line) { return line.starts_with(start); });
}

// (1 + 3 cos²) / (3 sin cos) of the lean: of moment m l² / 3 about the middle.
TEST(Painleve, TheCriticalFrictionOfTheRodIsThatOfTheClosedForm) {
  const Scene scene = read_scene(std::string(RIGOR_SOURCE_DIR) + "/scenes/painleve.yaml");
  EXPECT_NEAR(critical_friction(*scene.model, pi / 4), 5.0 / 3, 1e-14);
  for (const double lean : {0.3, 0.8, 1.1, 1.4}) {
    const double c = std::cos(lean), s = std::sin(lean);
    const double expected = (1 + 3 * c * c) / (3 * s * c);
    EXPECT_NEAR(critical_friction(*scene.model, lean), expected, 1e-14 * expected) << lean;
  }
}

TEST(Painleve, TheLeastCriticalFrictionIsFourThirdsWhereTheTangentIsTwo) {
  const Scene scene = read_scene(std::string(RIGOR_SOURCE_DIR) + "/scenes/painleve.yaml");
  double low = 0.8, high = 1.4;
  while (high - low > 1e-7) {
    const double a = low + (high - low) / 3, b = high - (high - low) / 3;
    const bool is_left = critical_friction(*scene.model, a) < critical_friction(*scene.model, b);
    (is_left ? high : low) = is_left ? b : a;
  }
  // At a minimum the place is known to the root of the rounding of the value.
  EXPECT_NEAR(0.5 * (low + high), std::atan(2.0), 1e-6);
  EXPECT_NEAR(critical_friction(*scene.model, std::atan(2.0)), 4.0 / 3, 1e-14);
}

TEST(Painleve, ATipThatLiftsMayAlsoBePressedWhereFrictionIsAboveTheCritical) {
  const Scene scene = read_scene(std::string(RIGOR_SOURCE_DIR) + "/scenes/painleve.yaml");
  // The tip turns about the middle: ω² sin 45° = 17.7 m/s² up, more than g.
  EXPECT_EQ(paradox_of(*scene.model, pi / 4, 2, 5), Paradox::Kind::indeterminate);
  EXPECT_EQ(paradox_of(*scene.model, pi / 4, 1.6, 5), Paradox::Kind::none);
  // Slower, less than g: no force at all.
  EXPECT_EQ(paradox_of(*scene.model, pi / 4, 2, 3), Paradox::Kind::inconsistent);
}

// The impulse (λ_t, λ_n) that stops the tip, K λ = (1, 0), K = [5/2 -3/2; -3/2 5/2], is in the cone:
// λ_t / λ_n = 5/3. It takes 1/2 λ_t = 5/16 J.
TEST(Painleve, TheTipJamsByAnImpulseAndTheAuditSaysSo) {
  std::vector<double> errors;
  for (const char* step : {"run.step=0.001", "run.step=0.0005"}) {
    const SceneRun run = run_scene("painleve.yaml", {step});
    const AdvanceReport& report = run.audit().report;
    EXPECT_EQ(report.reason, StopReason::reached_end);
    EXPECT_TRUE(run.audit().violations.empty());
    EXPECT_EQ(report.inconsistent.instants, 1);
    EXPECT_EQ(report.inconsistent.first, 0);
    EXPECT_EQ(report.indeterminate.instants, 0);
    EXPECT_EQ(report.fallbacks, 0);
    EXPECT_EQ(report.impacts, 0);
    EXPECT_GT(report.coarse_steps, 0);
    EXPECT_TRUE(has_warning(run, "no finite contact force at floor and rod at t = 0 s, once"));
    const int rod = run.body("rod");
    const Mat3 R_BU = run.scene.model->body(rod).X_BU.R;
    const auto tip = [&](const State& state) {
      return Vec3(state.position(rod) - rotation_matrix(state.orientation(rod)) * R_BU.col(2));
    };
    // The impulse comes with the first step, a tenth of run.step; the tip stands from its start.
    EXPECT_LE((tip(run.states.back()) - tip(run.states.front())).norm(), 1e-4);
    errors.push_back(std::abs(run.audit().dissipated - 5.0 / 16));
  }
  // Steps at velocity level are of first order.
  EXPECT_LE(errors[0], 5e-4);
  EXPECT_NEAR(errors[0] / errors[1], 2, 0.1);
}

TEST(Painleve, BelowTheCriticalFrictionTheRodSlidesOnFiniteForces) {
  const SceneRun run = run_scene("painleve.yaml", {"materials.rough.friction=1.6"});
  EXPECT_EQ(run.audit().report.inconsistent.instants, 0);
  EXPECT_EQ(run.audit().report.indeterminate.instants, 0);
  EXPECT_EQ(run.audit().report.coarse_steps, 0);
  EXPECT_EQ(run.audit().report.slip_to_stick, 1);
  EXPECT_TRUE(run.audit().warnings.empty());
}

TEST(Painleve, ARunSaysWhereItsMotionCouldGoOnInTwoWays) {
  // As sliding_rod with a spin of 5 rad/s.
  const double lift = 5 * std::sqrt(0.5);
  const SceneRun run = run_scene("painleve.yaml", {"bodies.rod.angular_velocity=[0, 5, 0]",
                                                   "bodies.rod.velocity=[" + std::to_string(lift - 1) +
                                                       ", 0, " + std::to_string(-lift + 1e-6) + "]",
                                                   "run.duration=0.01"});
  EXPECT_EQ(run.audit().report.inconsistent.instants, 0);
  EXPECT_EQ(run.audit().report.indeterminate.instants, 1);
  EXPECT_TRUE(has_warning(run, "more than one possible contact force at floor and rod at t = 0 s, once"));
}

}  // namespace
}  // namespace rigor::test::painleve_test
