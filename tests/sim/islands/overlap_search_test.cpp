// Points of bodies in contact that meet and part again between two places at which a step is looked at.

#include "rigor/sim/islands/overlap_search.hpp"
#include "random_vectors.hpp"
#include "rigor/dynamics/dense_phase.hpp"
#include "sim/time_stepping_scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace rigor::overlap_search_test {
namespace {

constexpr double half_edge = 0.1, h = 1e-3;

std::shared_ptr<const Model> cube_on_plane() {
  ModelBuilder builder = test::stepping_builder(0.5, 0, Vec3(0, 0, -9.81));
  builder.add_body(test::stepping_body("cube", Box{Vec3::Constant(half_edge)}, Vec3(0, 0, half_edge)));
  return builder.build();
}

/// A step in which the cube stands still but for its height: a parabola that is `depth` below its begin at
/// the part `lowest` of the step. Its contacts with the plane are those of its begin, or none of its corners
/// but the first.
struct Dip {
  Island island;
  IslandStep step;
};

Dip dip(const Model& model, double start_gap, double depth, double lowest) {
  Dip result;
  BodyPhase start;
  start.x = Vec3(0, 0, half_edge + start_gap);
  const Pose pose{Mat3::Identity(), start.x};
  const std::vector<Contact> contacts = find_contacts(model, 0, 1, {}, pose, 1e-6);
  result.island.bodies = {1};
  result.island.start = {start};
  result.island.contacts = {contacts.front()};
  result.island.states = {ContactState{}};

  // z(θ) = -2 depth θ / lowest + depth (θ / lowest)², so that it is lowest there.
  const double rate = -2 * depth / lowest;
  BodyPhase end = start;
  end.x.z() += rate + depth / (lowest * lowest);
  result.step.h = h;
  result.step.end = {end};
  result.step.dense = {quadratic_dense_phase(start, end, Vec3(0, 0, rate / h), Vec3::Zero(), h)};
  return result;
}

TEST(OverlapSearch, SeesWhatMeetsAndPartsBetweenTwoLooks) {
  const std::shared_ptr<const Model> model = cube_on_plane();
  const Method method;
  const OverlapSearch search(*model, method);
  test::Random random(7);
  int found = 0;
  for (int k = 0; k < 200; ++k) {
    SCOPED_TRACE(k);
    const double start_gap = random.uniform(0, 0.9) * method.contact_tolerance;
    const double depth = method.contact_tolerance * std::pow(10.0, random.uniform(-1, 2));
    const double lowest = std::pow(10.0, random.uniform(-3, -0.4));
    const Dip path = dip(*model, start_gap, depth, lowest);
    const std::optional<double> met = search.find(path.island, path.step, 1);

    // Up to there nothing is deeper than is allowed, and nothing that deep is missed.
    const auto gap = [&](double theta) { return path.step.dense[0].at(theta).x.z() - half_edge; };
    const double until = met.value_or(1);
    const double deepest = until < lowest ? gap(until) : start_gap - depth;
    EXPECT_GE(deepest, -0.5 * method.contact_tolerance);
    if (met) {
      ++found;
      EXPECT_LT(gap(*met), 0);
    }
  }
  EXPECT_GT(found, 50);
}

}  // namespace
}  // namespace rigor::overlap_search_test
