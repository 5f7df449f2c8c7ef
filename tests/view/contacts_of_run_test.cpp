// What a stepper tells of the contacts of the State that it left: forces that moved the bodies, by the
// balance of their momenta.
#include "rigor/io/scene/scene_reader.hpp"
#include "rigor/sim/make_stepper.hpp"
#include "rigor/sim/simulation.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

namespace rigor::contacts_of_run_test {
namespace {

/// Three boxes on each other, and one that slides by itself.
std::string heap(const std::string& method) {
  return R"(rigor: 1
name: heap
world: {gravity: [0, 0, -10]}
run: {duration: 0.5, step: 0.005, output_interval: 0.02}
method: {)" +
         method +
         R"(}
materials: [{name: wood, density: 700, friction: 0.5, restitution: 0}]
bodies:
  - {name: floor, motion: static, shapes: [{type: plane, normal: [0, 0, 1], offset: 0, material: wood}]}
  - {name: low, position: [0, 0, 0.1], mass: 4, shapes: [{type: box, size: [0.4, 0.4, 0.2], material: wood}]}
  - {name: middle, position: [0.03, 0, 0.3], mass: 2, shapes: [{type: box, size: [0.3, 0.4, 0.2], material: wood}]}
  - {name: top, position: [0, 0.04, 0.5], mass: 1, shapes: [{type: box, size: [0.2, 0.3, 0.2], material: wood}]}
  - {name: slider, position: [2, 0, 0.1], mass: 3, velocity: [3, 0, 0], shapes: [{type: box, size: [0.5, 0.5, 0.2], material: wood}]}
)";
}

Scene scene_of(const std::string& method) {
  return parse_scene(heap(method), "heap.yaml", ".");
}

Vec3 force_on(int body, const std::vector<TouchingPoint>& points) {
  Vec3 sum = Vec3::Zero();
  for (const TouchingPoint& point : points) {
    if (point.body_B == body) sum += point.force_W;
    if (point.body_A == body) sum -= point.force_W;
  }
  return sum;
}

struct Case {
  std::string method;
  double error;  ///< Of forces, as a share of the weight: of the solver's numbers.
};
class ContactsOf : public testing::TestWithParam<Case> {};

TEST_P(ContactsOf, AStepperAreTheForcesThatMovedTheBodies) {
  const Scene scene = scene_of(GetParam().method);
  const std::unique_ptr<Stepper> stepper = make_stepper(scene.model, scene.method, scene.run.step);
  State state = make_initial_state(*scene.model);
  const double h = scene.run.step, g = 10;
  // Until all has settled; the slider still slides.
  ASSERT_EQ(stepper->advance(state, 20 * h).reason, StopReason::reached_end);
  const State before = state;
  const AdvanceReport report = stepper->advance(state, 21 * h);
  ASSERT_TRUE(report.contacts);
  const std::optional<std::vector<TouchingPoint>> points = report.contacts(state);
  ASSERT_TRUE(points);

  for (int body = 1; body <= 4; ++body) {
    const double weight = g * scene.model->body(body).mass;
    // Newton: the forces of the step, with the weight, are what changed the momentum.
    const Vec3 needed = (state.linear_momentum(body) - before.linear_momentum(body)) / h + Vec3(0, 0, weight);
    EXPECT_LE((force_on(body, *points) - needed).norm(), GetParam().error * weight) << body;
  }
  for (const TouchingPoint& point : *points) {
    const bool is_slider = point.body_B == 4;
    EXPECT_EQ(point.mode == TouchingPoint::Mode::slide, is_slider && !point.force_W.isZero(0));
    EXPECT_NEAR(point.n_W.z(), 1, 1e-3);
    EXPECT_NEAR(point.u_W.x(), is_slider ? state.linear_momentum(4).x() / 3 : 0, 1e-2);
  }
}

INSTANTIATE_TEST_SUITE_P(, ContactsOf,
                         testing::Values(Case{"scheme: event-driven", 1e-8}, Case{"scheme: hybrid", 1e-8},
                                         Case{"scheme: time-stepping", 1e-8}, Case{"scheme: auto", 1e-8},
                                         Case{"scheme: time-stepping, solver: substep", 0.03}),
                         [](const auto& of) {
                           std::string name;
                           for (const char c : of.param.method)
                             if (std::isalnum(static_cast<unsigned char>(c))) name += c;
                           return name;
                         });

TEST(ContactsOfARun, AreAskedForWithoutAnyBitOfTheMotionChanging) {
  for (const std::string method : {"scheme: event-driven", "scheme: time-stepping", "scheme: auto",
                                   "scheme: time-stepping, solver: substep"}) {
    const Scene scene = scene_of(method);
    std::size_t seen = 0;
    const auto run = [&](bool asks) {
      return run_simulation(scene.model, scene.method, scene.run, std::nullopt,
                            [&](const State& state, const AdvanceReport& since, const Auditor&) {
                              if (asks && since.contacts) seen += since.contacts(state)->size();
                              return true;
                            });
    };
    const RunResult unasked = run(false), asked = run(true);
    EXPECT_GT(seen, 0u);
    EXPECT_EQ(unasked.state, asked.state) << method;
    EXPECT_FALSE(asked.audit.report.contacts) << "a sum of reports has no contacts";
  }
}

TEST(ContactsOfARun, AreNotKnownWhereTheSchemeHasNone) {
  const Scene scene = scene_of("scheme: impulse-based");
  const std::unique_ptr<Stepper> stepper = make_stepper(scene.model, scene.method, scene.run.step);
  State state = make_initial_state(*scene.model);
  const AdvanceReport report = stepper->advance(state, 0.01);
  ASSERT_TRUE(report.contacts);
  EXPECT_FALSE(report.contacts(state));
}

}  // namespace
}  // namespace rigor::contacts_of_run_test
