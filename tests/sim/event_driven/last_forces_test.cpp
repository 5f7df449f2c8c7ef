#include "rigor/sim/event_driven/last_forces.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace rigor::last_forces_test {
namespace {

ContactForce force_of(int a, int b, int feature = 0) {
  ContactForce force{};
  force.key.body_A = a;
  force.key.body_B = b;
  force.key.feature = static_cast<decltype(force.key.feature)>(feature);
  force.p_W = Vec3(a, b, feature);
  return force;
}

/// The pairs of bodies of all forces that act.
std::vector<std::vector<int>> pairs_in(const LastForces& forces) {
  std::vector<std::vector<int>> pairs;
  for (const ContactForce& force : forces.all()) pairs.push_back({force.key.body_A, force.key.body_B});
  return pairs;
}

TEST(LastForces, ActUntilTheNextEventOfOneOfTheirBodies) {
  LastForces forces;
  forces.reset({true, true, true, false});
  for (const ContactForce& force : {force_of(0, 1), force_of(1, 2), force_of(2, 3)}) forces.note(force);
  EXPECT_EQ(pairs_in(forces).size(), 3u);

  // Of both its bodies: as A, and as B.
  forces.forget(1);
  EXPECT_EQ(pairs_in(forces), (std::vector<std::vector<int>>{{2, 3}}));
  forces.note(force_of(0, 1));
  forces.forget(2);
  EXPECT_EQ(pairs_in(forces), (std::vector<std::vector<int>>{{0, 1}}));
}

TEST(LastForces, NoneAreKeptAfterTheyHaveEnded) {
  // A body that bounces for long, of a ground that comes before it and of one that comes after it: what is
  // kept is what its last events have found.
  LastForces forces;
  forces.reset({false, true, true, false});
  for (int event = 0; event < 1000; ++event) {
    for (const int body : {1, 2}) {
      forces.forget(body);
      for (int feature = 0; feature < 4; ++feature) {
        forces.note(force_of(0, body, feature));
        forces.note(force_of(body, 3, feature));
      }
    }
    ASSERT_EQ(forces.kept_count(), 16u);
  }
  EXPECT_EQ(forces.all().size(), 16u);
}

}  // namespace
}  // namespace rigor::last_forces_test
