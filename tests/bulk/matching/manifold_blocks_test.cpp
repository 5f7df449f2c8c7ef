#include "rigor/bulk/matching/manifold_blocks.hpp"
#include "rigor/bulk/contacts/solved_manifold.hpp"

#include "random_vectors.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <numbers>
#include <utility>
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

/// A patch of up to `most` points about half way between two bodies.
Manifold random_manifold(const BulkBodies& bodies, int a, int b, int most, Random& random) {
  Manifold manifold;
  const Vec3 n = random.vector().normalized();
  set_vector(n, manifold.normal);
  const Vec3 center = 0.5 * (bodies.x[static_cast<std::size_t>(b)] - bodies.x[static_cast<std::size_t>(a)]);
  manifold.point_count = 1 + static_cast<int>(std::abs(random.number()) * (most - 0.01));
  for (std::size_t i = 0; i < static_cast<std::size_t>(manifold.point_count); ++i) {
    Vec3 arm = random.vector();
    arm -= arm.dot(n) * n;
    set_vector(center + arm, manifold.points[i].p);
    manifold.points[i].gap = 0;
    manifold.points[i].feature = static_cast<std::uint32_t>(i);
  }
  return manifold;
}

/// The same inertia about all axes.
void make_round(BulkBodies& bodies) {
  for (InverseInertia& I : bodies.inertia) {
    I.yy = I.zz = I.xx;
    I.xy = I.xz = I.yz = 0;
  }
}

/// A block of pairs (2 i, 2 i + 1), the last of them with the fixed body; `surface` for all.
template <BlockKind kind>
struct BlockScene {
  BulkBodies bodies;
  std::vector<Manifold> manifolds;
  ManifoldBlock<kind> block;
};
template <BlockKind kind>
BlockScene<kind> random_scene(ManifoldSurface surface, LaneTarget target, unsigned seed) {
  Random random(seed);
  BlockScene<kind> scene{random_bodies(12, random), {}, {}};
  if (kind.is_round) make_round(scene.bodies);
  if (!kind.has_moments) surface.torsional_friction = surface.rolling_friction = 0;
  for (int i = 0; i < 6; ++i)
    scene.manifolds.push_back(random_manifold(scene.bodies, 2 * i, 2 * i + 1, kind.points, random));
  const Softness softness;
  std::vector<BlockLane> lanes;
  for (int i = 0; i < 6; ++i) {
    const Manifold& manifold = scene.manifolds[static_cast<std::size_t>(i)];
    lanes.push_back({ManifoldView(manifold), &surface, &softness, {}, 2 * i, 2 * i + 1});
  }
  fill_block(target, lanes, scene.bodies, scene.block);
  return scene;
}

/// Velocity of B against A at a point of the manifold of lane i.
template <class Scene>
Vec3 relative_velocity(const Scene& scene, int i, const float* p) {
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

/// As if the step had begun with the friction that there is now.
template <class Block>
void begin_friction_where_it_is(Block& block) {
  if constexpr (Block::kind.turns()) {
    for (std::size_t k = 0; k < 2; ++k) block.first_friction[k] = block.impulses.tangent(k);
    block.first_friction[2] = block.impulses.twist();
  }
}

/// The friction along W, and about the normal, that the next step begins with in the first lane.
template <class Block>
std::pair<Vec3, double> remembered_friction(const Block& block) {
  ManifoldMemory memory;
  read_lane(block, 0,
            {.point_count = static_cast<int>(Block::point_count),
             .normal_impulse = memory.normal_impulse.data(),
             .friction_impulse_W = memory.friction_impulse_W.data(),
             .twist_impulse = &memory.twist_impulse,
             .rolling_impulse_W = memory.rolling_impulse_W.data()});
  return {vector_of(memory.friction_impulse_W.data()), static_cast<double>(memory.twist_impulse)};
}

template <class Block>
class ManifoldBlocks : public testing::Test {};
template <class Numbers>
struct AllKinds;
template <std::size_t... kind>
struct AllKinds<std::index_sequence<kind...>> {
  using Types = testing::Types<ManifoldBlock<block_kinds[kind]>...>;
};
TYPED_TEST_SUITE(ManifoldBlocks, AllKinds<std::make_index_sequence<block_kinds.size()>>::Types);

TYPED_TEST(ManifoldBlocks, SweepsEndWithNormalsThatNeitherApproachNorPullAndFrictionWithinTheDisc) {
  for (const LaneTarget target : all_targets()) {
    for (unsigned seed = 1; seed <= 10; ++seed) {
      auto scene = random_scene<TypeParam::kind>({.friction = 0.4f}, target, seed);
      for (int k = 0; k < 400; ++k) solve_block(target, BlockPass::relax, kH, scene.block, scene.bodies);
      // Read back without the mean with what the step began with.
      begin_friction_where_it_is(scene.block);
      for (int i = 0; i < 6; ++i) {
        const Manifold& manifold = scene.manifolds[static_cast<std::size_t>(i)];
        const Vec3 n = vector_of(manifold.normal);
        ManifoldMemory memory;
        read_lane(scene.block, i,
                  {.point_count = manifold.point_count,
                   .normal_impulse = memory.normal_impulse.data(),
                   .friction_impulse_W = memory.friction_impulse_W.data(),
                   .twist_impulse = &memory.twist_impulse,
                   .rolling_impulse_W = memory.rolling_impulse_W.data()});
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

TYPED_TEST(ManifoldBlocks, FrictionOfPatchesIsRememberedHalfwayFromWhereTheStepBegan) {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    auto scene = random_scene<TypeParam::kind>({.friction = 0.4f}, LaneTarget::portable, seed);
    begin_friction_where_it_is(scene.block);
    const auto [first, first_twist] = remembered_friction(scene.block);
    for (int k = 0; k < 20; ++k)
      solve_block(LaneTarget::portable, BlockPass::relax, kH, scene.block, scene.bodies);
    const auto [half, half_twist] = remembered_friction(scene.block);
    begin_friction_where_it_is(scene.block);
    const auto [last, last_twist] = remembered_friction(scene.block);
    const double share = TypeParam::kind.turns() ? 0.5 : 1, rounding = 1e-6;
    EXPECT_LE((half - first - share * (last - first)).norm(), rounding * (first.norm() + last.norm()))
        << seed;
    EXPECT_NEAR(half_twist, first_twist + share * (last_twist - first_twist),
                rounding * (std::abs(first_twist) + std::abs(last_twist)))
        << seed;
  }
}

TYPED_TEST(ManifoldBlocks, ImpulsesKeepMomentumAndTakeEnergy) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    auto scene = random_scene<TypeParam::kind>(
        {.friction = 0.7f, .torsional_friction = 0.1f, .rolling_friction = 0.05f}, best_lane_target(), seed);
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

TYPED_TEST(ManifoldBlocks, HaveTheSameBitsOnEveryProcessor) {
  if (best_lane_target() != LaneTarget::avx2) return;
  for (unsigned seed = 1; seed <= 10; ++seed) {
    const ManifoldSurface surface{
        .friction = 0.5f, .restitution = 0.3f, .torsional_friction = 0.01f, .rolling_friction = 0.01f};
    auto wide = random_scene<TypeParam::kind>(surface, LaneTarget::avx2, seed);
    auto plain = random_scene<TypeParam::kind>(surface, LaneTarget::portable, seed);
    for (const BlockPass pass : {BlockPass::push, BlockPass::relax}) {
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

// A point goes with the displacements of both bodies, and its spring has the stiffness m ω².
TYPED_TEST(ManifoldBlocks, SpringsHoldHalfTheSquareOfTheirOverlapsAndNoMoreThanWasPutIntoThem) {
  constexpr double frequency = 40;
  constexpr int substeps = 6;
  const double omega = 2 * std::numbers::pi * frequency;
  const Softness spring = make_softness(frequency, 5, kH);
  for (unsigned seed = 1; seed <= 10; ++seed) {
    std::vector<LaneArray> of_targets;
    for (const LaneTarget target : all_targets()) {
      Random random(100 + seed);
      auto scene = random_scene<TypeParam::kind>({.friction = 0.4f}, target, seed);
      for (MotionRecord& motion : scene.bodies.motion) {
        set_vector(1e-3 * random.vector(), motion.dp);
        set_vector(1e-3 * random.vector(), motion.dr);
      }
      BlockImpulses<TypeParam::kind> total;
      LaneArray held{};
      std::array<double, kLaneCount> energy{}, work{};
      for (int lane = 0; lane < 6; ++lane) {
        const std::size_t i = static_cast<std::size_t>(lane);
        const Manifold& manifold = scene.manifolds[i];
        scene.block.bias_rate[i] = spring.bias_rate;
        scene.block.mass_scale[i] = spring.mass_scale;
        // Every other manifold held more before than it can now.
        held[i] = lane % 2 == 0 ? 1e9F : static_cast<float>(1e-3 * std::abs(random.number()));
        for (std::size_t k = 0; k < static_cast<std::size_t>(manifold.point_count); ++k) {
          scene.block.points[k].gap[i] = static_cast<float>(2e-3 * random.number());
          total.normal(k)[i] = static_cast<float>(std::abs(random.number()));
          const double before = static_cast<double>(scene.block.points[k].gap[i]);
          const Vec3 r_A = vector_of(manifold.points[k].p);
          const Vec3 r_B = r_A - (scene.bodies.x[2 * i + 1] - scene.bodies.x[2 * i]);
          const MotionRecord &A = scene.bodies.motion[2 * i], &B = scene.bodies.motion[2 * i + 1];
          const Vec3 way =
              vector_of(B.dp) + vector_of(B.dr).cross(r_B) - vector_of(A.dp) - vector_of(A.dr).cross(r_A);
          const double overlap = std::max(0.0, -(before + vector_of(manifold.normal).dot(way)));
          energy[i] +=
              0.5 * static_cast<double>(scene.block.points[k].mass[i]) * omega * omega * overlap * overlap;
          work[i] += static_cast<double>(total.normal(k)[i]) / (static_cast<double>(kH) * substeps) *
                     std::max(0.0, overlap - std::max(0.0, -before));
        }
      }
      LaneArray found = held;
      find_spring_energies(target, scene.block, total, scene.bodies, {kH, substeps}, found);
      for (std::size_t i = 0; i < 6; ++i) {
        const double expected = std::min(energy[i], static_cast<double>(held[i]) + work[i]);
        // Frames and arms of blocks are 32-bit numbers.
        ASSERT_NEAR(static_cast<double>(found[i]), expected, 2e-3 * (energy[i] + work[i]) + 1e-9) << seed;
      }
      of_targets.push_back(found);
    }
    for (const LaneArray& found : of_targets)
      EXPECT_EQ(std::memcmp(found.data(), of_targets[0].data(), 6 * sizeof(float)), 0);
  }
}

TEST(ContactSpring, APointThatIsApartMayCloseItsGapInASubstep) {
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
  ManifoldBlock<BlockKind{1, false, false}> block;
  const ManifoldSurface surface;
  const Softness softness;
  const BlockLane own = {ManifoldView(manifold), &surface, &softness, {}, 0, 1};
  fill_block(best_lane_target(), std::span(&own, 1), bodies, block);
  solve_block(best_lane_target(), BlockPass::push, kH, block, bodies);
  EXPECT_NEAR(bodies.motion[1].v[2] - bodies.motion[0].v[2], -0.005 / kH, 1e-5);
}

TEST(BlockKinds, AreTheLeastThatAManifoldNeeds) {
  const ManifoldSurface plain{.friction = 0.5f}, rolling{.rolling_friction = 0.01f},
      torsional{.torsional_friction = 0.01f};
  const auto kind = [](int points, const ManifoldSurface& surface, bool is_round) {
    return block_kinds[static_cast<std::size_t>(find_block_kind(points, surface, is_round))];
  };
  EXPECT_EQ(kind(1, plain, true), (BlockKind{1, false, true}));
  EXPECT_EQ(kind(1, plain, false), (BlockKind{1, false, false}));
  EXPECT_EQ(kind(2, plain, true), (BlockKind{2, false, false}));
  EXPECT_EQ(kind(3, plain, false), (BlockKind{4, false, false}));
  EXPECT_EQ(kind(1, rolling, true), (BlockKind{1, true, false}));
  EXPECT_EQ(kind(4, torsional, true), (BlockKind{4, true, false}));
}

/// A point alone is a patch whose points are at one place. (Friction of a patch takes a part of the slip in a
/// sweep without springs: there it is compared without friction.)
TEST(BlockKinds, OfOnePointDoWhatAPatchDoes) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const bool has_friction = seed <= 10;
    const ManifoldSurface surface{.friction = has_friction ? 0.5f : 0.0f};
    auto point = random_scene<BlockKind{1, false, true}>(surface, best_lane_target(), seed);
    auto patch = random_scene<BlockKind{1, true, false}>(surface, best_lane_target(), seed);
    patch.bodies = point.bodies;
    const Softness softness;
    std::vector<BlockLane> lanes;
    for (int i = 0; i < 6; ++i)
      lanes.push_back({ManifoldView(point.manifolds[static_cast<std::size_t>(i)]),
                       &surface,
                       &softness,
                       {},
                       2 * i,
                       2 * i + 1});
    fill_block(best_lane_target(), std::span<const BlockLane>(lanes), patch.bodies, patch.block);
    for (const BlockPass second : {BlockPass::push, BlockPass::relax, BlockPass::push}) {
      const BlockPass pass = has_friction ? BlockPass::push : second;
      solve_block(best_lane_target(), pass, kH, point.block, point.bodies);
      solve_block(best_lane_target(), pass, kH, patch.block, patch.bodies);
    }
    // Rounding of a few terms of the order of 1 m/s and 5 m.
    for (std::size_t k = 0; k < point.bodies.motion.size(); ++k) {
      for (std::size_t j = 0; j < 3; ++j) {
        EXPECT_NEAR(point.bodies.motion[k].v[j], patch.bodies.motion[k].v[j], 1e-5);
        EXPECT_NEAR(point.bodies.motion[k].w[j], patch.bodies.motion[k].w[j], 1e-5);
      }
    }
  }
}

TEST(ContactSpring, ASpringTakesItsOverlapBackAtItsRate) {
  // ω / (2 ζ + h ω) a second, met with the mass scale of an implicit step: make_softness.
  const Softness softness = make_softness(30, 5, kH);
  const double omega = 2 * 3.14159265358979 * 30;
  EXPECT_NEAR(softness.bias_rate, omega / (2 * 5 + kH * omega), 1e-4);
  EXPECT_NEAR(softness.mass_scale + softness.impulse_scale, 1, 1e-6);
  const double a = kH * omega * (2 * 5 + kH * omega);
  EXPECT_NEAR(softness.impulse_scale, 1 / (1 + a), 1e-6);
}

TEST(RememberedImpulses, OfCornersThatAreCalledOtherwiseGoOn) {
  // Features: crossings of edges are small numbers, vertices of A have bit 30.
  constexpr std::uint32_t vertex = 1U << 30;
  ManifoldMemory memory;
  memory.point_count = 4;
  memory.feature = {1, 2, 3, vertex};
  memory.normal_impulse = {0.5F, 1, 2, 4};
  const ManifoldMemories memories({memory});
  const auto impulses_of = [&](const std::vector<std::uint32_t>& features) {
    Manifold manifold{{0, 0, 1}, static_cast<int>(features.size()), {}};
    for (std::size_t k = 0; k < features.size(); ++k) manifold.points[k].feature = features[k];
    return remembered_impulses(memories.view(0), ManifoldView(manifold));
  };
  using Impulses = std::array<float, Manifold::max_points>;
  EXPECT_EQ(impulses_of({1, 2, 3, vertex}), (Impulses{0.5F, 1, 2, 4}));
  EXPECT_EQ(impulses_of({3, 2, 1, vertex}), (Impulses{2, 1, 0.5F, 4}));
  // Two crossings are vertices now.
  EXPECT_EQ(impulses_of({1, vertex, vertex + 1, vertex + 2}), (Impulses{0.5F, 4, 1.5F, 1.5F}));
  // A crossing that comes for one that is gone is elsewhere; a point that is gone takes its impulse along.
  EXPECT_EQ(impulses_of({1, 2, 7, vertex}), (Impulses{0.5F, 1, 0, 4}));
  EXPECT_EQ(impulses_of({1, 3, vertex}), (Impulses{0.5F, 2, 4, 0}));
}

}  // namespace
}  // namespace rigor::manifold_blocks_test
