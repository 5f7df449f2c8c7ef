// Contact-free chains: all substeps at once, against substeps taken one by one.

#include "rigor/bulk/joints/bulk_joints.hpp"

#include "bulk/joint_scenes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

namespace rigor::contact_free_chains_test {
namespace {

using tests::JointRun;

constexpr double kStep = 1.0 / 60;
const Vec3 kGravity(0, -9.81, 0);

/// Steps of a model whose trees touch nothing but for the bodies in `touches`.
void step_freely(JointRun& run, double H, int substeps, const std::vector<char>& touches) {
  const Executor executor(1);
  const std::size_t count = run.bodies.x.size();
  std::vector<MotionRow> accelerations(count, MotionRow{});
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t k = 0; run.bodies.is_dynamic(static_cast<int>(i)) && k < 3; ++k) {
      accelerations[i][k] = static_cast<float>(run.model->g_W()[static_cast<Eigen::Index>(k)]);
    }
  }
  begin_bulk_step(*run.model, executor, run.bodies);
  run.joints.find_contact_free_chains(run.bodies, touches);
  run.joints.prepare(run.bodies, H / substeps, executor);
  run.joints.advance_contact_free_chains(accelerations, substeps, run.bodies, executor);
  end_bulk_step(executor, run.bodies);
}

void run_freely(JointRun& run, double time, int substeps) {
  const std::vector<char> touches(run.bodies.x.size(), 0);
  for (int k = 0; k < std::lround(time / kStep); ++k) step_freely(run, kStep, substeps, touches);
}

double largest_distance(const JointRun& a, const JointRun& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.bodies.x.size(); ++i) {
    largest = std::max(largest, (a.bodies.x[i] - b.bodies.x[i]).norm());
  }
  return largest;
}

/// A body with two arms that floats: each arm has bodies of its own, none of them of revolution. unit: by
/// what all masses and moments are multiplied.
std::shared_ptr<const Model> floating_fork(double unit = 1) {
  ModelBuilder builder;
  builder.set_gravity(kGravity);
  const Vec3 moments = unit * Vec3(0.02, 0.05, 0.06);
  builder.add_body(tests::bulk_body("root", Vec3(0, 0, 0), 2 * unit, moments));
  const auto add = [&](const std::string& parent, const std::string& name, const Vec3& p,
                       const Vec3& anchor) {
    builder.add_body(tests::bulk_body(name, p, unit, moments));
    ModelBuilder::JointDescription joint;
    joint.name = "j" + name;
    joint.type = JointType::ball;
    joint.bodies = {name, parent};  // The child is body A.
    joint.anchors = {anchor};
    builder.add_joint(joint);
  };
  add("root", "left", Vec3(-0.5, 0, 0), Vec3(-0.25, 0, 0.1));
  add("root", "right", Vec3(0.5, 0, 0), Vec3(0.25, 0, 0.1));
  add("right", "end", Vec3(1, 0, 0), Vec3(0.75, 0.1, 0));
  return builder.build();
}

TEST(ContactFreeChains, MoveAsByStagesDo) {
  // The two differ by what is left of each correction, 4e-5 m at most and put right in the next substep, and
  // by 32 bits.
  JointRun free(tests::rod_chain(5, kGravity, 11)), staged(tests::rod_chain(5, kGravity, 11));
  run_freely(free, 0.5, 8);
  staged.run(0.5, kStep, 8, true);
  EXPECT_LT(largest_distance(free, staged), 2e-4);
  EXPECT_GT((free.bodies.x[4] - Vec3(2.25, 0, 0)).norm(), 0.5);  // It has fallen.
  std::vector<float> of_free = free.impulses(), of_staged = staged.impulses();
  ASSERT_EQ(of_free.size(), of_staged.size());
  for (std::size_t k = 0; k < of_free.size(); ++k) EXPECT_NEAR(of_free[k], of_staged[k], 2e-3) << k;
}

TEST(ContactFreeChains, MoveTheSameHoweverLightTheyAre) {
  // Masses times a power of two: the same bits. Products of three such moments would underflow.
  JointRun heavy(floating_fork()), light(floating_fork(0x1p-48));
  for (JointRun* run : {&heavy, &light}) {
    for (int i = 0; i < 4; ++i) run->set(i, Vec3(0.2, 0, 0), Vec3(2 - i, 1, 0.5 * i));
    run_freely(*run, 0.5, 8);
  }
  EXPECT_EQ(largest_distance(heavy, light), 0);
}

TEST(ContactFreeChains, ThatFloatAndBranchMoveAsByStagesDo) {
  JointRun free(floating_fork()), staged(floating_fork());
  for (JointRun* run : {&free, &staged}) {
    for (int i = 0; i < 4; ++i) run->set(i, Vec3(0.2, 0, 0), Vec3(2 - i, 1, 0.5 * i));
  }
  run_freely(free, 0.5, 8);
  staged.run(0.5, kStep, 8, true);
  EXPECT_LT(largest_distance(free, staged), 2e-4);
  EXPECT_LT(free.error(), 2e-5);
  // What floats falls freely: the path of the centre of mass is g t²/2.
  Vec3 center = Vec3::Zero(), start = Vec3::Zero(), momentum = Vec3::Zero();
  const JointRun before(floating_fork());
  for (int i = 0; i < 4; ++i) {
    const double mass = free.model->body(i).mass;
    center += mass / 5 * free.bodies.x[static_cast<std::size_t>(i)];
    start += mass / 5 * before.bodies.x[static_cast<std::size_t>(i)];
    momentum += mass * free.velocity(i);
  }
  const double t = 0.5;
  EXPECT_LT((momentum - 5 * Vec3(0.2, -9.81 * t, 0)).norm(), 1e-4);  // 32 bits.
  EXPECT_LT((center - start - Vec3(0.2 * t, -9.81 * t * t / 2, 0)).norm(), 2e-5);
}

TEST(ContactFreeChains, OfRodsKeepTheirEnergyAndTheirJoints) {
  JointRun run(tests::rod_chain(12, kGravity));
  const double before = run.energy(), scale = 12 * 9.81 * 3;  // A fall by half of the length.
  run_freely(run, 2, 6);
  EXPECT_LT(std::abs(run.energy() - before), 0.01 * scale);
  EXPECT_LT(run.error(), 1e-4);
}

TEST(ContactFreeChains, BothTargetsOfLanesGiveTheSameBits) {
  for (const bool forks : {false, true}) {
    const auto model = [&] { return forks ? floating_fork() : tests::rod_chain(5, kGravity, 11); };
    JointRun portable(model(), LaneTarget::portable), best(model());
    for (JointRun* run : {&portable, &best}) {
      run->set(0, Vec3::Zero(), Vec3(1, 2, 300));  // Far turns too.
      run_freely(*run, 0.3, 4);
    }
    EXPECT_EQ(std::memcmp(portable.bodies.motion.data(), best.bodies.motion.data(),
                          portable.bodies.motion.size() * sizeof(portable.bodies.motion[0])),
              0);
  }
}

TEST(ContactFreeChains, AreWholeTreesAndTheOthersStay) {
  // The second of three chains touches something with its fourth rod.
  JointRun run(tests::rod_chain(5, kGravity, 3)), alone(tests::rod_chain(5, kGravity));
  std::vector<char> touches(15, 0);
  touches[8] = 1;
  step_freely(run, kStep, 6, touches);
  step_freely(alone, kStep, 6, std::vector<char>(5, 0));
  for (int i = 0; i < 15; ++i) {
    EXPECT_EQ(run.joints.is_free(i), i < 5 || i >= 10) << i;
    // Those that are free move the same in any lane and whoever is beside them.
    EXPECT_EQ(run.velocity(i), run.joints.is_free(i) ? alone.velocity(i % 5) : Vec3(0, 0, 0)) << i;
  }
}

}  // namespace
}  // namespace rigor::contact_free_chains_test
