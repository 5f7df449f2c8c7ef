#include "rigor/bulk/manifold_blocks.hpp"

#include "random_vectors.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <vector>

namespace rigor::manifold_blocks_test {
namespace {

using test::Random;

constexpr float kH = 1.0f / 240;

Vec3 vector_of(const float* p) {
  return Vec3(p[0], p[1], p[2]);
}
void set_vector(const Vec3& a, float* p) {
  for (int k = 0; k < 3; ++k) p[k] = static_cast<float>(a[k]);
}

/// Bodies of random place, velocity, mass and inertia; the last one is fixed.
BulkBodies random_bodies(int count, Random& random) {
  BulkBodies bodies;
  for (int i = 0; i < count; ++i) {
    bodies.x.push_back(5 * random.vector());
    bodies.q.push_back(Quat::Identity());
    MotionRecord motion;
    InverseInertia inertia;
    if (i + 1 < count) {
      set_vector(random.vector(), motion.v);
      set_vector(random.vector(), motion.w);
      const Vec3 a = random.vector(), b = random.vector();
      const Mat3 I = Mat3::Identity() + 0.3 * (a * a.transpose() + b * b.transpose());
      inertia.xx = static_cast<float>(I(0, 0));
      inertia.yy = static_cast<float>(I(1, 1));
      inertia.zz = static_cast<float>(I(2, 2));
      inertia.xy = static_cast<float>(I(0, 1));
      inertia.xz = static_cast<float>(I(0, 2));
      inertia.yz = static_cast<float>(I(1, 2));
      inertia.inv_mass = motion.inv_mass = static_cast<float>(std::exp(random.number()));
    }
    bodies.motion.push_back(motion);
    bodies.inertia.push_back(inertia);
  }
  return bodies;
}

Mat3 inverse_inertia(const BulkBodies& bodies, int body) {
  const InverseInertia& I = bodies.inertia[static_cast<std::size_t>(body)];
  Mat3 m;
  m << I.xx, I.xy, I.xz, I.xy, I.yy, I.yz, I.xz, I.yz, I.zz;
  return m;
}

/// Momentum and angular momentum about the origin, of the dynamic bodies.
std::pair<Vec3, Vec3> momenta(const BulkBodies& bodies) {
  Vec3 P = Vec3::Zero(), L = Vec3::Zero();
  for (int i = 0; i < bodies.count(); ++i) {
    if (!bodies.is_dynamic(i)) continue;
    const std::size_t k = static_cast<std::size_t>(i);
    const Vec3 p = vector_of(bodies.motion[k].v) / bodies.inertia[k].inv_mass;
    P += p;
    L += bodies.x[k].cross(p) + inverse_inertia(bodies, i).inverse() * vector_of(bodies.motion[k].w);
  }
  return {P, L};
}

double kinetic_energy(const BulkBodies& bodies) {
  double energy = 0;
  for (int i = 0; i < bodies.count(); ++i) {
    if (!bodies.is_dynamic(i)) continue;
    const std::size_t k = static_cast<std::size_t>(i);
    const Vec3 w = vector_of(bodies.motion[k].w);
    energy += 0.5 * vector_of(bodies.motion[k].v).squaredNorm() / bodies.inertia[k].inv_mass +
              0.5 * w.dot(inverse_inertia(bodies, i).inverse() * w);
  }
  return energy;
}

/// A patch of up to four points about half way between two bodies.
Manifold random_manifold(const BulkBodies& bodies, int a, int b, Random& random) {
  Manifold manifold;
  const Vec3 n = random.vector().normalized();
  set_vector(n, manifold.normal);
  const Vec3 center = 0.5 * (bodies.x[static_cast<std::size_t>(b)] - bodies.x[static_cast<std::size_t>(a)]);
  manifold.point_count = 1 + static_cast<int>(std::abs(random.number()) * 3.99);
  for (std::size_t i = 0; i < static_cast<std::size_t>(manifold.point_count); ++i) {
    Vec3 arm = random.vector();
    arm -= arm.dot(n) * n;
    set_vector(center + arm, manifold.points[i].p);
    manifold.points[i].gap = 0;
    manifold.points[i].feature = static_cast<std::uint32_t>(i);
  }
  return manifold;
}

/// A block of pairs (2 i, 2 i + 1), the last of them with the fixed body; `surface` for all.
struct BlockScene {
  BulkBodies bodies;
  std::vector<Manifold> manifolds;
  ManifoldBlock block;
};
BlockScene random_scene(const ManifoldSurface& surface, LaneTarget target, unsigned seed) {
  Random random(seed);
  BlockScene scene{random_bodies(12, random), {}, {}};
  clear_block(scene.block);
  for (int i = 0; i < 6; ++i) {
    scene.manifolds.push_back(random_manifold(scene.bodies, 2 * i, 2 * i + 1, random));
    fill_lane(scene.manifolds.back(), surface, Softness{}, 2 * i, 2 * i + 1, i, nullptr, scene.bodies, i,
              scene.block);
  }
  complete_block(target, scene.bodies, scene.block);
  return scene;
}

/// Velocity of B against A at a point of the manifold of lane i.
Vec3 relative_velocity(const BlockScene& scene, int i, const float* p) {
  const std::size_t a = static_cast<std::size_t>(2 * i), b = a + 1;
  const Vec3 rA = vector_of(p);
  const Vec3 rB = rA - (scene.bodies.x[b] - scene.bodies.x[a]);
  const MotionRecord& A = scene.bodies.motion[a];
  const MotionRecord& B = scene.bodies.motion[b];
  return vector_of(B.v) + vector_of(B.w).cross(rB) - vector_of(A.v) - vector_of(A.w).cross(rA);
}

std::vector<LaneTarget> all_targets() {
  return best_lane_target() == LaneTarget::avx2 ? std::vector{LaneTarget::portable, LaneTarget::avx2}
                                                : std::vector{LaneTarget::portable};
}

TEST(ManifoldBlocks, SweepsEndWithNormalsThatNeitherApproachNorPullAndFrictionWithinTheDisc) {
  for (const LaneTarget target : all_targets()) {
    for (unsigned seed = 1; seed <= 10; ++seed) {
      BlockScene scene = random_scene({.friction = 0.4f}, target, seed);
      for (int k = 0; k < 400; ++k) solve_block(target, BlockPass::relax, kH, scene.block, scene.bodies);
      for (int i = 0; i < 6; ++i) {
        const Manifold& manifold = scene.manifolds[static_cast<std::size_t>(i)];
        const Vec3 n = vector_of(manifold.normal);
        ManifoldMemory memory;
        read_lane(scene.block, i, memory);
        float pressed = 0;
        for (std::size_t j = 0; j < static_cast<std::size_t>(manifold.point_count); ++j) {
          const double speed = n.dot(relative_velocity(scene, i, manifold.points[j].p));
          const float impulse = memory.normal_impulse[j];
          // 32 bits, velocities of the order of 1 m/s; redundant points leave what one sweep rounds.
          EXPECT_GE(speed, -2e-5);
          EXPECT_GE(impulse, 0);
          EXPECT_LE(impulse * std::abs(speed), 2e-5) << "a pressed point does not part";
          pressed += impulse;
        }
        const Vec3 friction = vector_of(memory.friction_impulse_W.data());
        EXPECT_LE(friction.norm(), 0.4f * pressed * (1 + 1e-5f) + 1e-6f);
        EXPECT_NEAR(friction.dot(n), 0, 1e-6);
        if (pressed < 1e-3f || friction.norm() > 0.4f * pressed * 0.999f) continue;
        Vec3 center = Vec3::Zero();
        for (std::size_t j = 0; j < static_cast<std::size_t>(manifold.point_count); ++j)
          center += vector_of(manifold.points[j].p) / manifold.point_count;
        float at[3];
        set_vector(center, at);
        const Vec3 velocity = relative_velocity(scene, i, at);
        EXPECT_LE((velocity - velocity.dot(n) * n).norm(), 2e-5) << "friction within its disc sticks";
      }
    }
  }
}

TEST(ManifoldBlocks, ImpulsesKeepMomentumAndTakeEnergy) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    BlockScene scene = random_scene({.friction = 0.7f, .torsional_friction = 0.1f, .rolling_friction = 0.05f},
                                    best_lane_target(), seed);
    // Without the lane that rests on the fixed body.
    for (const int k : {10, 11}) scene.bodies.motion[static_cast<std::size_t>(k)] = MotionRecord{};
    const auto [P, L] = momenta(scene.bodies);
    const double energy = kinetic_energy(scene.bodies);
    for (int k = 0; k < 10; ++k) {
      solve_block(best_lane_target(), BlockPass::relax, kH, scene.block, scene.bodies);
      EXPECT_LE(kinetic_energy(scene.bodies), energy * (1 + 1e-5));
    }
    const auto [P_end, L_end] = momenta(scene.bodies);
    EXPECT_LT((P_end - P).norm(), 1e-4);
    EXPECT_LT((L_end - L).norm(), 1e-3);  // Arms of up to 5 m.
  }
}

TEST(ManifoldBlocks, HaveTheSameBitsOnEveryProcessor) {
  if (best_lane_target() != LaneTarget::avx2) return;
  for (unsigned seed = 1; seed <= 10; ++seed) {
    const ManifoldSurface surface{
        .friction = 0.5f, .restitution = 0.3f, .torsional_friction = 0.01f, .rolling_friction = 0.01f};
    BlockScene wide = random_scene(surface, LaneTarget::avx2, seed);
    BlockScene plain = random_scene(surface, LaneTarget::portable, seed);
    for (const BlockPass pass : {BlockPass::push, BlockPass::relax, BlockPass::restitution}) {
      solve_block(LaneTarget::avx2, pass, kH, wide.block, wide.bodies);
      solve_block(LaneTarget::portable, pass, kH, plain.block, plain.bodies);
    }
    warm_start_block(LaneTarget::avx2, wide.block, wide.bodies);
    warm_start_block(LaneTarget::portable, plain.block, plain.bodies);
    EXPECT_EQ(std::memcmp(wide.bodies.motion.data(), plain.bodies.motion.data(),
                          wide.bodies.motion.size() * sizeof(MotionRecord)),
              0);
  }
}

TEST(ManifoldBlocks, APointThatWasPressedPartsAtItsRestitution) {
  Random random(3);
  BulkBodies bodies = random_bodies(3, random);
  bodies.x = {Vec3::Zero(), Vec3(0, 0, 1), Vec3(0, 0, 5)};
  for (std::size_t k = 0; k < 2; ++k)
    bodies.motion[k].w[0] = bodies.motion[k].w[1] = bodies.motion[k].w[2] = 0;
  set_vector(Vec3(0, 0, 1), bodies.motion[0].v);
  set_vector(Vec3(0, 0, -2), bodies.motion[1].v);
  Manifold manifold;
  set_vector(Vec3(0, 0, 1), manifold.normal);
  manifold.point_count = 1;
  manifold.points[0] = {{0, 0, 0.5f}, 0, 7};
  ManifoldBlock block;
  clear_block(block);
  fill_lane(manifold, {.friction = 0, .restitution = 0.6f}, Softness{}, 0, 1, 0, nullptr, bodies, 0, block);
  complete_block(best_lane_target(), bodies, block);
  solve_block(best_lane_target(), BlockPass::relax, kH, block, bodies);
  EXPECT_NEAR(bodies.motion[1].v[2] - bodies.motion[0].v[2], 0, 1e-6);
  solve_block(best_lane_target(), BlockPass::restitution, kH, block, bodies);
  EXPECT_NEAR(bodies.motion[1].v[2] - bodies.motion[0].v[2], 0.6 * 3, 1e-6);
}

TEST(ManifoldBlocks, APointThatIsApartMayCloseItsGapInASubstep) {
  Random random(4);
  BulkBodies bodies = random_bodies(3, random);
  bodies.x = {Vec3::Zero(), Vec3(0, 0, 1), Vec3(0, 0, 5)};
  for (std::size_t k = 0; k < 2; ++k)
    bodies.motion[k].w[0] = bodies.motion[k].w[1] = bodies.motion[k].w[2] = 0;
  set_vector(Vec3(0, 0, 0), bodies.motion[0].v);
  set_vector(Vec3(0, 0, -3), bodies.motion[1].v);
  Manifold manifold;
  set_vector(Vec3(0, 0, 1), manifold.normal);
  manifold.point_count = 1;
  manifold.points[0] = {{0, 0, 0.5f}, 0.005f, 7};
  ManifoldBlock block;
  clear_block(block);
  fill_lane(manifold, {}, Softness{}, 0, 1, 0, nullptr, bodies, 0, block);
  complete_block(best_lane_target(), bodies, block);
  solve_block(best_lane_target(), BlockPass::push, kH, block, bodies);
  EXPECT_NEAR(bodies.motion[1].v[2] - bodies.motion[0].v[2], -0.005 / kH, 1e-5);
}

TEST(ManifoldBlocks, ASpringTakesItsOverlapBackAtItsRate) {
  // ω / (2 ζ + h ω) a second, met with the mass scale of an implicit step: make_softness.
  const Softness softness = make_softness(30, 5, kH);
  const double omega = 2 * 3.14159265358979 * 30;
  EXPECT_NEAR(softness.bias_rate, omega / (2 * 5 + kH * omega), 1e-4);
  EXPECT_NEAR(softness.mass_scale + softness.impulse_scale, 1, 1e-6);
  const double a = kH * omega * (2 * 5 + kH * omega);
  EXPECT_NEAR(softness.impulse_scale, 1 / (1 + a), 1e-6);
}

}  // namespace
}  // namespace rigor::manifold_blocks_test
