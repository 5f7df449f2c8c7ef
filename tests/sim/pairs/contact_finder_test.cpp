#include "rigor/sim/pairs/contact_finder.hpp"

#include "rigor/model/model_builder.hpp"

#include <gtest/gtest.h>

namespace rigor::contact_finder_test {
namespace {

/// Three balls of radius 0.5 in a row at x = 0, 1.1, 3 on a floor below z = -0.5, and a wall that stands
/// still.
std::shared_ptr<const Model> balls_in_a_row() {
  ModelBuilder builder;
  builder.add_material({"m", 1000, 0.5, 0});
  const auto add = [&](const std::string& name, const Shape& shape, const Vec3& x, MotionType motion) {
    BodyDescription body;
    body.name = name;
    body.p_WU = x;
    body.motion = motion;
    if (motion == MotionType::dynamic) body.mass = 1;
    body.shapes.push_back({shape, Vec3::Zero(), Quat::Identity(), "m", ""});
    builder.add_body(body);
  };
  add("floor", HalfSpace{Vec3::UnitZ(), -0.5}, Vec3::Zero(), MotionType::fixed);
  add("a", Sphere{0.5}, Vec3(0, 0, 0), MotionType::dynamic);
  add("b", Sphere{0.5}, Vec3(1.1, 0, 0.3), MotionType::dynamic);
  add("c", Sphere{0.5}, Vec3(3, 0, 0.3), MotionType::dynamic);
  add("wall", Box{Vec3(0.5, 0.5, 0.5)}, Vec3(0, 5, -0.5), MotionType::fixed);
  return builder.build();
}

std::vector<std::pair<int, int>> pairs_of(const std::vector<Contact>& contacts) {
  std::vector<std::pair<int, int>> pairs;
  for (const Contact& contact : contacts) pairs.push_back({contact.body_A, contact.body_B});
  return pairs;
}

TEST(ContactFinder, FindsWhatTheReachesBridge) {
  using Pairs = std::vector<std::pair<int, int>>;
  const std::shared_ptr<const Model> model = balls_in_a_row();
  const State state = make_initial_state(*model);
  for (const BroadPhaseMethod method : {BroadPhaseMethod::tree, BroadPhaseMethod::sweep_and_prune}) {
    ContactFinder finder(*model, method);
    EXPECT_EQ(pairs_of(finder.find(state, {0, 0, 0, 0, 0}, 1e-6)), (Pairs{{0, 1}}));
    // The gap of a and b is sqrt(1.1² + 0.3²) - 1 = 0.1402.
    EXPECT_EQ(pairs_of(finder.find(state, {0, 0.08, 0.06, 0, 0}, 1e-6)), (Pairs{{0, 1}}));
    EXPECT_EQ(pairs_of(finder.find(state, {0, 0.08, 0.061, 0, 0}, 1e-6)), (Pairs{{0, 1}, {1, 2}}));
    // What it has seen before does not matter.
    EXPECT_EQ(pairs_of(finder.find(state, {0, 0, 0, 0, 0}, 1e-6)), (Pairs{{0, 1}}));
    EXPECT_EQ(pairs_of(finder.find(state, {0, 0, 0.3, 0.9, 0}, 1e-6)),
              (Pairs{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {2, 3}}));
  }
}

TEST(ContactFinder, BodiesThatStandStillDoNotMeetEachOther) {
  const std::shared_ptr<const Model> model = balls_in_a_row();
  const State state = make_initial_state(*model);
  ContactFinder finder(*model, BroadPhaseMethod::tree);
  for (const auto& [a, b] : finder.near_pairs(state, {1, 1, 1, 1, 1})) EXPECT_FALSE(a == 0 && b == 4);
}

}  // namespace
}  // namespace rigor::contact_finder_test
