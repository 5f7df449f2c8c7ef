#include "rigor/model/state.hpp"
#include "rigor/core/input_error.hpp"
#include "rigor/math/rotation.hpp"
#include "rigor/model/model_builder.hpp"

#include <gtest/gtest.h>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

namespace rigor::state_test {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

BodyDescription box(const std::string& name) {
  BodyDescription body;
  body.name = name;
  body.shapes = {{Box{Vec3(0.5, 1, 1.5)}}};
  return body;
}

std::shared_ptr<const Model> two_bodies() {
  ModelBuilder builder;
  BodyDescription moving = box("moving");
  moving.p_WU = Vec3(1, 2, 3);
  moving.q_WU = rotation_exp(Vec3(0.3, -0.2, 0.9));
  moving.velocity = Vec3(0.1, -0.2, 0.3);
  moving.angular_velocity = Vec3(-1, 2, 0.5);
  builder.add_body(moving);
  BodyDescription platform = box("platform");
  platform.motion = MotionType::kinematic;
  platform.velocity = Vec3(0, 0, 2);
  platform.angular_velocity = Vec3(0, 0, 1);
  builder.add_body(platform);
  return builder.build();
}

TEST(InitialState, VelocitiesAreThoseOfTheModel) {
  const std::shared_ptr<const Model> model = two_bodies();
  const State state = make_initial_state(*model);
  EXPECT_EQ(state.t, 0);
  EXPECT_EQ(state.position(0), Vec3(1, 2, 3));
  // ω -> L -> ω: three rotations and their inverses, a few roundings each.
  EXPECT_LT((angular_velocity(*model, state, 0) - Vec3(-1, 2, 0.5)).norm(), 16 * kEpsilon);
  EXPECT_LT((linear_velocity(*model, state, 0) - Vec3(0.1, -0.2, 0.3)).norm(), kEpsilon);
  EXPECT_EQ(linear_velocity(*model, state, 1), Vec3(0, 0, 2));
  EXPECT_EQ(angular_velocity(*model, state, 1), Vec3(0, 0, 1));
  EXPECT_EQ(state.linear_momentum(1), Vec3::Zero());
}

TEST(InitialState, MomentumIsMassTimesVelocity) {
  const std::shared_ptr<const Model> model = two_bodies();
  const State state = make_initial_state(*model);
  const double mass = 1000 * 1.0 * 2 * 3;  // Default density, full lengths.
  EXPECT_NEAR(state.linear_momentum(0).z(), mass * 0.3, 1e-12 * mass);
}

TEST(InitialState, EveryBodyIsAnchoredAtItsPhase) {
  const State state = make_initial_state(*two_bodies());
  ASSERT_EQ(state.anchor.size(), 26u);
  EXPECT_EQ(state.epoch, (std::vector<double>{0, 0}));
  EXPECT_EQ(Vec3::Map(&state.anchor[13]), state.position(1));
  EXPECT_EQ(Vec3::Map(&state.anchor[7]), state.linear_momentum(0));
  EXPECT_EQ(Vec3::Map(&state.anchor[10]), state.angular_momentum(0));
  EXPECT_EQ(state.anchor[3], state.orientation(0).w());
}

TEST(StateTest, SetBodyAnchorsItThereAndThen) {
  State state = make_initial_state(*two_bodies());
  state.t = 2;
  state.set_body(1, Vec3(1, 0, 0), Quat(0, 1, 0, 0), Vec3(4, 5, 6), Vec3(7, 8, 9));
  EXPECT_EQ(state.epoch, (std::vector<double>{0, 2}));
  EXPECT_EQ(state.orientation(1).x(), 1);
  EXPECT_EQ(Vec3::Map(&state.anchor[13 + 10]), Vec3(7, 8, 9));
}

Body kinematic(std::vector<PathPoint> path) {
  Body body;
  body.motion = MotionType::kinematic;
  body.path = std::move(path);
  return body;
}

TEST(PrescribedMotionTest, ConstantVelocitiesFromTimeZero) {
  Body body = kinematic({});
  body.p_WB = Vec3(1, 0, 0);
  body.v_WB = Vec3(0, 2, 0);
  body.w_WB = Vec3(0, 0, std::numbers::pi);
  const PrescribedMotion motion = prescribed_motion(body, 0.5);
  EXPECT_EQ(motion.p_WB, Vec3(1, 1, 0));
  // Quarter turn about z takes x to y.
  EXPECT_LT((rotation_matrix(motion.q_WB) * Vec3::UnitX() - Vec3::UnitY()).norm(), 4 * kEpsilon);
}

TEST(PrescribedMotionTest, FixedBodiesNeverMove) {
  Body body;
  body.motion = MotionType::fixed;
  body.p_WB = Vec3(1, 2, 3);
  body.v_WB = Vec3(1, 1, 1);
  EXPECT_EQ(prescribed_motion(body, 7).p_WB, Vec3(1, 2, 3));
  EXPECT_EQ(prescribed_motion(body, 7).v_WB, Vec3::Zero());
}

TEST(PrescribedMotionTest, PathIsPiecewiseLinearAndTurnsAtConstantRate) {
  const Quat quarter = rotation_exp(Vec3(0, 0, std::numbers::pi / 2));
  const Body body = kinematic(
      {{1, Vec3(0, 0, 0), Quat::Identity()}, {3, Vec3(4, 0, 0), quarter}, {4, Vec3(4, 1, 0), quarter}});
  const PrescribedMotion middle = prescribed_motion(body, 2);
  EXPECT_EQ(middle.p_WB, Vec3(2, 0, 0));
  EXPECT_EQ(middle.v_WB, Vec3(2, 0, 0));
  EXPECT_NEAR(middle.w_WB.z(), std::numbers::pi / 4, 4 * kEpsilon);
  EXPECT_LT(rotation_angle_between(middle.q_WB, rotation_exp(Vec3(0, 0, std::numbers::pi / 4))), 1e-15);
}

TEST(PrescribedMotionTest, PathRestsBeforeAndAfterAndBeginsEachLegAtItsPoint) {
  const Body body = kinematic({{1, Vec3(0, 0, 0), Quat::Identity()},
                               {3, Vec3(4, 0, 0), Quat::Identity()},
                               {4, Vec3(4, 1, 0), Quat::Identity()}});
  EXPECT_EQ(prescribed_motion(body, 0).v_WB, Vec3::Zero());
  EXPECT_EQ(prescribed_motion(body, 1).v_WB, Vec3(2, 0, 0));
  EXPECT_EQ(prescribed_motion(body, 3).v_WB, Vec3(0, 1, 0));
  EXPECT_EQ(prescribed_motion(body, 3).p_WB, Vec3(4, 0, 0));
  EXPECT_EQ(prescribed_motion(body, 4).v_WB, Vec3::Zero());
  EXPECT_EQ(prescribed_motion(body, 9).p_WB, Vec3(4, 1, 0));
}

TEST(Serialise, AllBitsComeBack) {
  State state = make_initial_state(*two_bodies());
  state.t = -0.0;
  state.x[0] = std::numeric_limits<double>::denorm_min();
  state.P[1] = -std::numeric_limits<double>::infinity();
  state.L[2] = std::bit_cast<double>(0x7FF8000000ABCDEFull);  // A NaN with its payload.
  const State back = deserialise(serialise(state));
  EXPECT_EQ(std::bit_cast<std::uint64_t>(back.t), std::bit_cast<std::uint64_t>(state.t));
  EXPECT_EQ(std::bit_cast<std::uint64_t>(back.L[2]), 0x7FF8000000ABCDEFull);
  state.L[2] = 0;
  EXPECT_EQ(deserialise(serialise(state)), state);
}

TEST(Serialise, RememberedContactsComeBack) {
  State state = make_initial_state(*two_bodies());
  state.contacts.resize(2);
  state.contacts[0] = {.body_A = 0, .body_B = 1, .shape_A = 2, .shape_B = -7, .feature = ~0ull};
  state.contacts[1].energy = 0.25;
  for (std::size_t i = 0; i < ContactMemory::value_count; ++i)
    state.contacts[1].values[i] = 1.0 / (1.0 + static_cast<double>(i));
  const State back = deserialise(serialise(state));
  EXPECT_EQ(back, state);
  EXPECT_EQ(back.contacts[0].shape_B, -7);
  State other = state;
  other.contacts[1].values[3] += 1e-16;
  EXPECT_NE(other, state);
}

TEST(Serialise, WhatEventsRememberComesBackUntilABodyIsMoved) {
  State state = make_initial_state(*two_bodies());
  state.contacts.resize(1);
  state.events.is_left = true;
  EXPECT_EQ(deserialise(serialise(state)), state);
  state.events.contacts.resize(2);
  state.events.contacts[0] = {.body_A = 0, .body_B = 1, .feature = 5};
  state.events.contacts[1].values[EventMemory::mode] = 2;
  const State back = deserialise(serialise(state));
  EXPECT_EQ(back, state);
  EXPECT_TRUE(back.events.is_left);
  EXPECT_EQ(back.events.contacts[0].feature, 5);
  state.anchor_body(1);
  EXPECT_EQ(state.events, EventMemory{});
}

TEST(Serialise, WhatTheManyBodyPathRemembersComesBack) {
  State state = make_initial_state(*two_bodies());
  for (int i = 0; i < 3; ++i) {
    ManifoldMemory manifold;
    manifold.body_A = i;
    manifold.body_B = i + 7;
    manifold.shape_A = -i;
    manifold.shape_B = 2 * i;
    manifold.part = i + 1;
    manifold.point_count = 4;
    manifold.feature = {1u, 0xffffffffu, 3u, static_cast<std::uint32_t>(i)};
    manifold.normal_impulse = {0.1f, 0.2f, 0.3f, 1e-30f};
    manifold.friction_impulse_W = {-1, 2, -3};
    manifold.twist_impulse = 0.5f;
    manifold.rolling_impulse_W = {0.5f, 1e-20f, -7};
    manifold.energy = 0.25f;
    state.manifolds.push_back(manifold);
  }
  for (std::size_t count = 0; count < 4; ++count) {
    state.joint_impulses.assign(count, 0.1f);
    state.quiet_time.assign(3 - count, std::numeric_limits<float>::infinity());
    EXPECT_EQ(deserialise(serialise(state)), state) << count;
  }
  std::vector<ManifoldMemory> memories(state.manifolds.begin(), state.manifolds.end());
  memories[2].rolling_impulse_W[1] = 0;
  State other = state;
  other.manifolds = memories;
  EXPECT_NE(other, state);
}

TEST(Serialise, TheEmptyStateComesBack) {
  EXPECT_EQ(deserialise(serialise(State{})), State{});
}

TEST(Serialise, IsLittleEndianWithAMagic) {
  State state;
  state.t = 1;  // 0x3FF0000000000000
  const std::vector<unsigned char> bytes = serialise(state);
  EXPECT_EQ(std::string(bytes.begin(), bytes.begin() + 7), "RIGORST");
  EXPECT_EQ(bytes[64 + 7], 0x3F);
  EXPECT_EQ(bytes[64 + 6], 0xF0);
}

TEST(Deserialise, EveryFlippedBitIsFound) {
  State state = make_initial_state(*two_bodies());
  state.contacts.resize(1);
  state.manifolds.push_back({});
  state.joint_impulses = {1, 2, 3};
  state.quiet_time = {0.5f};
  state.events.contacts.resize(1);
  const std::vector<unsigned char> good = serialise(state);
  for (std::size_t i = 0; i < good.size(); ++i) {
    std::vector<unsigned char> bad = good;
    bad[i] = static_cast<unsigned char>(bad[i] ^ (1u << (i % 8)));
    EXPECT_THROW(deserialise(bad), InputError) << "byte " << i;
  }
}

TEST(Deserialise, EveryTruncationIsFound) {
  const std::vector<unsigned char> good = serialise(make_initial_state(*two_bodies()));
  for (std::size_t length = 0; length < good.size(); ++length) {
    const std::vector<unsigned char> bad(good.begin(), good.begin() + static_cast<std::ptrdiff_t>(length));
    EXPECT_THROW(deserialise(bad), InputError) << length << " bytes";
  }
}

std::uint64_t checksum_of(const std::vector<unsigned char>& bytes, std::size_t length) {
  std::uint64_t hash = 14695981039346656037ull;
  for (std::size_t i = 0; i < length; ++i) hash = (hash ^ bytes[i]) * 1099511628211ull;
  return hash;
}

std::string message_of(const std::vector<unsigned char>& bytes) {
  try {
    deserialise(bytes);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Deserialise, SaysWhatIsWrong) {
  std::vector<unsigned char> bytes = serialise(State{});
  EXPECT_EQ(message_of({}), "state: damaged, it has only 0 bytes");
  bytes[0] = 'X';
  EXPECT_EQ(message_of(bytes), "state: not a saved state of Rigor");
  bytes = serialise(State{});
  bytes[8] = 2;
  EXPECT_EQ(message_of(bytes), "state: version 2, this program reads version 8");
  bytes = serialise(State{});
  // A count whose product with the size of a body would overflow.
  for (std::size_t i = 16; i < 24; ++i) bytes[i] = 0xFF;
  EXPECT_EQ(message_of(bytes),
            "state: damaged, 18446744073709551615 bodies, 0 contacts, 0 manifolds, 0 joint impulses, 0 quiet "
            "times and 0 contacts of events do not fit its 128 bytes");
  bytes = serialise(State{});
  bytes[64 + 8 * 6] = 1;  // A number beside 0 and 1.
  for (std::uint64_t i = 0, hash = checksum_of(bytes, bytes.size() - 8); i < 8; ++i)
    bytes[bytes.size() - 8 + i] = static_cast<unsigned char>(hash >> (8 * i));
  EXPECT_EQ(message_of(bytes), "state: damaged, it does not say whether a scheme of events has left it");
  bytes = serialise(State{});
  bytes.back() ^= 1;
  EXPECT_EQ(message_of(bytes), "state: damaged, its checksum is wrong");
}

}  // namespace
}  // namespace rigor::state_test
