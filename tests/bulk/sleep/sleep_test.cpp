#include "rigor/bulk/sleep/sleep.hpp"

#include "rigor/model/model_builder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <memory>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace rigor::sleep_test {
namespace {

constexpr float kAsleep = std::numeric_limits<float>::infinity();
constexpr double kStep = 0.1;

BodyDescription body_at(double x, const std::string& name, MotionType motion, const Shape& shape) {
  BodyDescription body;
  body.name = name;
  body.motion = motion;
  body.p_WU = Vec3(x, 0, 0);
  body.shapes.push_back({shape, Vec3::Zero(), Quat::Identity(), "", ""});
  return body;
}

/// Body 0 is fixed, body 1 kinematic; the others are dynamic. 2 and 3 are held by a spring.
std::shared_ptr<const Model> balls(int dynamic_count) {
  ModelBuilder builder;
  const Shape ball = Sphere{0.5};
  builder.add_body(body_at(0, "fixed", MotionType::fixed, ball));
  builder.add_body(body_at(1, "kinematic", MotionType::kinematic, ball));
  for (int i = 2; i < dynamic_count + 2; ++i)
    builder.add_body(body_at(i, "b" + std::to_string(i), MotionType::dynamic, ball));
  ModelBuilder::ForceDescription spring;
  spring.type = ModelBuilder::ForceDescription::Type::spring;
  spring.bodies = {"b2", "b3"};
  spring.stiffness = 1;
  builder.add_force(spring);
  return builder.build();
}

ManifoldMemory contact(int a, int b) {
  ManifoldMemory memory;
  memory.body_A = a;
  memory.body_B = b;
  memory.shape_A = memory.shape_B = 0;
  memory.point_count = 1;
  return memory;
}

/// Contacts of a row: each body from `first` to `last` with the next one.
std::vector<ManifoldMemory> row(int first, int last) {
  std::vector<ManifoldMemory> contacts;
  for (int i = first; i < last; ++i) contacts.push_back(contact(i, i + 1));
  return contacts;
}

TEST(BulkIslands, AreWhatContactsAndSpringsHoldTogether) {
  const std::shared_ptr<const Model> model = balls(6);
  BulkIslands islands(*model);
  islands.build(ManifoldMemories{contact(0, 2), contact(0, 4), contact(1, 5), contact(4, 6)});
  // 2 and 3 by the spring, 4 and 6 by their contact; the fixed and the kinematic body join nothing.
  const std::vector<int> expected = {-1, -1, 2, 2, 4, 5, 4, 7};
  for (int i = 0; i < 8; ++i) EXPECT_EQ(islands.island_of(i), expected[static_cast<std::size_t>(i)]) << i;
  islands.build(row(2, 7));
  for (int i = 2; i < 8; ++i) EXPECT_EQ(islands.island_of(i), 2) << i;
}

/// The lowest body that can be reached from each over dynamic bodies, with a spring between 2 and 3.
std::vector<int> reached(const std::vector<ManifoldMemory>& contacts, int count) {
  std::vector<int> lowest(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) lowest[static_cast<std::size_t>(i)] = i < 2 ? -1 : i;
  std::vector<std::pair<int, int>> pairs = {{2, 3}};
  for (const ManifoldMemory& contact : contacts) pairs.emplace_back(contact.body_A, contact.body_B);
  for (int round = 0; round < count; ++round) {
    for (const auto& [a, b] : pairs) {
      int &of_a = lowest[static_cast<std::size_t>(a)], &of_b = lowest[static_cast<std::size_t>(b)];
      if (of_a >= 0 && of_b >= 0) of_a = of_b = std::min(of_a, of_b);
    }
  }
  return lowest;
}

TEST(BulkIslands, FollowContactsThatComeAndGo) {
  constexpr int count = 32;
  const std::shared_ptr<const Model> model = balls(count - 2);
  BulkIslands islands(*model);
  std::mt19937 engine(3);
  std::uniform_int_distribution<int> body(0, count - 1), change(0, 3);
  std::set<std::pair<int, int>> touching;
  int largest = 0;
  for (int round = 0; round < 500; ++round) {
    // None, some come, some go, or both.
    const int kind = change(engine);
    for (int k = 0; k < (kind == 1 || kind == 3 ? 5 : 0); ++k) {
      const int a = body(engine), b = body(engine);
      if (a != b) touching.insert(std::minmax(a, b));
    }
    for (int k = 0; k < (kind >= 2 ? 5 : 0) && !touching.empty(); ++k)
      touching.erase(std::next(touching.begin(), body(engine) % static_cast<int>(touching.size())));
    std::vector<ManifoldMemory> contacts;
    for (const auto& [a, b] : touching) contacts.push_back(contact(a, b));
    if (round % 5 == 0) std::reverse(contacts.begin(), contacts.end());
    islands.build(contacts);
    const std::vector<int> expected = reached(contacts, count);
    for (int i = 0; i < count; ++i)
      EXPECT_EQ(islands.island_of(i), expected[static_cast<std::size_t>(i)]) << round;
    for (int i = 0; i < count; ++i)
      largest = std::max(largest, static_cast<int>(std::count(expected.begin(), expected.end(), i)));
  }
  EXPECT_GT(largest, 5);
}

/// Bodies, what they touch and how long they have been quiet.
struct Sleepers {
  explicit Sleepers(int dynamic_count)
      : model(balls(dynamic_count)),
        keeper(*model, SleepRules{0.01, 0.5}),
        bodies(read_bulk_bodies(*model, make_initial_state(*model))),
        contacts(row(2, dynamic_count + 1)),
        quiet_time(static_cast<std::size_t>(model->body_count())) {
    contacts.insert(contacts.begin(), contact(0, 2));
  }
  void settle(int steps) {
    for (int k = 0; k < steps; ++k) keeper.settle(kStep, contacts, bodies, quiet_time);
  }
  void wake(const std::vector<ManifoldMemory>& now, const Disturbances& disturbances = {}) {
    keeper.wake(bodies, contacts, now, disturbances, quiet_time);
  }
  int sleeping() const { return static_cast<int>(std::count(quiet_time.begin(), quiet_time.end(), kAsleep)); }

  std::shared_ptr<const Model> model;
  SleepManager keeper;
  BulkBodies bodies;
  std::vector<ManifoldMemory> contacts;
  std::vector<float> quiet_time;
};

TEST(SleepManager, IslandFallsAsleepWhenAllOfItHasBeenQuietForTheDelay) {
  Sleepers row_of_ten(10);
  row_of_ten.bodies.motion[11].v[0] = 0.005f;
  row_of_ten.settle(4);
  EXPECT_EQ(row_of_ten.sleeping(), 0);
  row_of_ten.settle(2);
  EXPECT_EQ(row_of_ten.sleeping(), 10);
  EXPECT_EQ(row_of_ten.bodies.motion[11].v[0], 0);
}

TEST(SleepManager, OneBodyThatMovesOrTurnsKeepsItsIslandAwake) {
  Sleepers moves(10), turns(10);
  moves.bodies.motion[11].v[1] = 0.02f;
  turns.bodies.motion[11].w[2] = 0.03f;  // 0.015 m/s at its surface.
  moves.settle(20);
  turns.settle(20);
  EXPECT_EQ(moves.sleeping(), 0);
  EXPECT_EQ(turns.sleeping(), 0);
  // What it does not touch sleeps.
  moves.contacts.pop_back();
  moves.settle(1);
  EXPECT_EQ(moves.sleeping(), 9);
}

TEST(SleepManager, WholeChainWakesAtOnceWhenItsEndIsHit) {
  Sleepers chain(1000);
  chain.contacts = row(2, 1000);
  chain.settle(6);
  ASSERT_EQ(chain.sleeping(), 1000);
  // The last body, which touches nothing, wakes and comes.
  chain.quiet_time[1001] = 0;
  chain.wake(chain.contacts);
  EXPECT_EQ(chain.sleeping(), 999);
  chain.wake(row(2, 1001));
  EXPECT_EQ(chain.sleeping(), 0);
}

TEST(SleepManager, LossOfASupportAForceAndAMovingKinematicBodyWake) {
  Sleepers sleepers(5);
  const std::vector<ManifoldMemory> all = sleepers.contacts;
  sleepers.settle(6);
  ASSERT_EQ(sleepers.sleeping(), 5);
  sleepers.wake(all);
  EXPECT_EQ(sleepers.sleeping(), 5);

  Sleepers unsupported = sleepers;
  unsupported.wake(std::vector<ManifoldMemory>(all.begin() + 1, all.end()));
  EXPECT_EQ(unsupported.sleeping(), 0);

  Sleepers pulled = sleepers;
  pulled.wake(all, {{6}});
  EXPECT_EQ(pulled.sleeping(), 0);

  std::vector<ManifoldMemory> on_lift = all;
  on_lift.insert(on_lift.begin() + 1, contact(1, 4));
  Sleepers on_a_still_one = sleepers;
  on_a_still_one.wake(on_lift);
  EXPECT_EQ(on_a_still_one.sleeping(), 5);
  Sleepers on_a_moving_one = sleepers;
  on_a_moving_one.bodies.motion[1].v[2] = 0.001f;
  on_a_moving_one.wake(on_lift);
  EXPECT_EQ(on_a_moving_one.sleeping(), 0);
}

TEST(SleepManager, DependsOnTheStateAlone) {
  // A keeper that has seen other scenes says the same as a fresh one.
  Sleepers used(8);
  used.settle(3);
  used.wake({});
  Sleepers fresh(8);
  used.quiet_time = fresh.quiet_time;
  for (int k = 0; k < 7; ++k) {
    used.settle(1);
    SleepManager(*fresh.model, SleepRules{0.01, 0.5})
        .settle(kStep, fresh.contacts, fresh.bodies, fresh.quiet_time);
    EXPECT_EQ(used.quiet_time, fresh.quiet_time);
  }
  EXPECT_EQ(used.sleeping(), 8);
}

}  // namespace
}  // namespace rigor::sleep_test
