// Random fast bodies against thin plates, and spinning blades against bodies at rest: nothing passes, and
// nothing gains energy. The truth: on which side of the plate the centre is, and that a body in the way of a
// blade has been hit.

#include "bulk/random_bodies.hpp"
#include "rigor/bulk/bulk_world.hpp"
#include "rigor/core/index.hpp"
#include "rigor/geometry/distance/thickness.hpp"

#include <gtest/gtest.h>

#include <array>
#include <numbers>

namespace rigor::passing_guard_test {
namespace {

using random_bodies_test::Draw;
using random_bodies_test::kinetic_energy_of;
using random_bodies_test::random_body;
using random_bodies_test::random_shape;

/// A body on its way to a plate of 2 mm at z = 0.
std::shared_ptr<const Model> plate_and_body(Draw& draw) {
  ModelBuilder builder;
  builder.set_gravity(Vec3::Zero());
  builder.add_material({"m", 2000, draw.between(0, 0.8), draw.below(2) == 0 ? 0 : draw.between(0, 1)});
  BodyDescription plate = random_body("plate", Box{Vec3(20, 20, 1e-3)}, Vec3::Zero());
  plate.motion = MotionType::fixed;
  builder.add_body(plate);

  const double size = draw.spread(1e-3, 0.1), speed = draw.spread(30, 3000);
  Vec3 way = draw.direction();
  way.z() = -std::max(0.15, std::abs(way.z()));
  way.normalize();
  BodyDescription body =
      random_body("body", random_shape(draw, size), -way * (speed * draw.between(1e-3, 0.04) + 3 * size));
  body.q_WU = draw.orientation();
  body.velocity = speed * way;
  body.angular_velocity = draw.spread(1, 1000) * draw.direction();
  builder.add_body(body);
  return builder.build();
}

TEST(PassingGuard, NoRandomBodyPassesAPlate) {
  Draw draw(1);
  for (int k = 0; k < 120; ++k) {
    SCOPED_TRACE(k);
    const std::shared_ptr<const Model> model = plate_and_body(draw);
    State state = make_initial_state(*model);
    const double energy = kinetic_energy_of(*model, state), step = draw.spread(1e-3, 1.0 / 60);
    BulkWorld world(model, {});
    world.read(state);
    const double P = state.linear_momentum(1).z();  // Less than 0.
    bool was_near = false;
    while (world.time() < 0.1) {
      world.step(step);
      world.write(state);
      const Vec3 x = state.position(1);
      ASSERT_TRUE(x.allFinite());
      if (was_near && std::max(std::abs(x.x()), std::abs(x.y())) > 19) break;
      ASSERT_GT(x.z(), 0);
      was_near = was_near || state.linear_momentum(1).z() > 0.999 * P;
      ASSERT_LE(kinetic_energy_of(*model, state), energy * (1 + 1e-4));
    }
    EXPECT_TRUE(was_near);
  }
}

/// 300 bodies of all shapes above each other in a pen.
ModelBuilder crowd_in_a_pen(unsigned seed) {
  Draw draw(seed);
  ModelBuilder builder;
  builder.set_gravity(Vec3(0, 0, -9.81));
  builder.add_material({"m", 1000, 0.5, 0.2});
  const auto add_fixed = [&](const std::string& name, const Vec3& half, const Vec3& at_W) {
    BodyDescription body = random_body(name, Box{half}, at_W);
    body.motion = MotionType::fixed;
    builder.add_body(body);
  };
  add_fixed("floor", Vec3(4, 4, 0.5), Vec3(0, 0, -0.5));
  for (const int side : {-1, 1}) {
    add_fixed("x" + std::to_string(side), Vec3(0.5, 4, 6), Vec3(1.6 * side, 0, 5));
    add_fixed("y" + std::to_string(side), Vec3(4, 0.5, 6), Vec3(0, 1.6 * side, 5));
  }
  for (int k = 0; k < 300; ++k) {
    const Vec3 cell(k % 5 - 2, k / 5 % 5 - 2, k / 25 + 1);
    BodyDescription body = random_body("b" + std::to_string(k), random_shape(draw, 0.16), 0.4 * cell);
    body.q_WU = draw.orientation();
    builder.add_body(body);
  }
  return builder;
}

/// They fall on each other. What others hold does not go on into them with a motion that no contact sees: the
/// overlaps that a step finds are seldom more than a quarter of a thickness. Returns how many are in 1.5 s.
int deep_contacts_in_pen(unsigned seed) {
  const std::shared_ptr<const Model> model = crowd_in_a_pen(seed).build();
  BulkWorld world(model, {});
  world.read(make_initial_state(*model));

  int deep = 0;
  for (int step = 0; step < 90; ++step) {
    world.step(1.0 / 60);
    for (const BulkContact& contact : world.contacts()) {
      double thinner = 1;
      for (const int body : {contact.body_A, contact.body_B})
        thinner = std::min(thinner, thickness_of(model->body(body).shapes.front().shape));
      double gap = 0;
      for (int p = 0; p < contact.point_count; ++p) gap = std::min(gap, contact.points[at(p)].gap);
      if (gap < -0.25 * thinner) ++deep;
    }
  }
  return deep;
}

TEST(PassingGuard, JammedBodiesDoNotGoIntoEachOther) {
  // 531 here, 0 to 157 a draw; 1,400 where the jams of a step are not calmed, 19 to 313 a draw.
  int deep = 0;
  for (unsigned seed = 6; seed < 22; ++seed) deep += deep_contacts_in_pen(seed);
  EXPECT_LT(deep, 950);
}

/// What is driven must get out of the way, however deep it is; a crowd that nothing drives is held as if
/// there were no driven body in the world.
TEST(PassingGuard, ADrivenBodyElsewhereChangesNothing) {
  const std::shared_ptr<const Model> alone = crowd_in_a_pen(6).build();
  ModelBuilder builder = crowd_in_a_pen(6);
  BodyDescription fan = random_body("fan", Box{Vec3(3, 0.1, 0.5)}, Vec3(50, 0, 0));
  fan.motion = MotionType::kinematic;
  fan.angular_velocity = Vec3(0, 0, 1);
  builder.add_body(fan);
  const std::shared_ptr<const Model> both = builder.build();
  BulkWorld a(alone, {}), b(both, {});
  a.read(make_initial_state(*alone));
  b.read(make_initial_state(*both));
  for (int step = 0; step < 60; ++step) {
    a.step(1.0 / 60);
    b.step(1.0 / 60);
    for (int body = 0; body < alone->body_count(); ++body) {
      ASSERT_EQ(a.bodies().x[at(body)], b.bodies().x[at(body)]) << "body " << body << ", step " << step;
    }
  }
}

/// How far two balls of 0.1 m overlap after a step of 1/60 s without gravity, where all is rotated. box: half
/// lengths of a fixed one at the origin [m].
double overlap_of_balls(const Vec3& box, const std::array<BodyDescription, 2>& balls, const Quat& turn) {
  ModelBuilder builder;
  builder.set_gravity(Vec3::Zero());
  builder.add_material({"m", 1000, 0, 0});
  for (BodyDescription ball : balls) {
    ball.p_WU = turn * ball.p_WU;
    ball.velocity = turn * ball.velocity;
    builder.add_body(ball);
  }
  BodyDescription fixed = random_body("box", Box{box}, Vec3::Zero());
  fixed.q_WU = turn;
  fixed.motion = MotionType::fixed;
  builder.add_body(fixed);
  const std::shared_ptr<const Model> model = builder.build();
  State state = make_initial_state(*model);
  BulkWorld world(model, {});
  world.read(state);
  world.step(1.0 / 60);
  world.write(state);
  return 2 * 0.1 - (state.position(1) - state.position(0)).norm();
}

/// A ball of 0.1 m.
BodyDescription ball_at(const std::string& name, const Vec3& x, const Vec3& v) {
  BodyDescription ball = random_body(name, Sphere{0.1}, x);
  ball.velocity = v;
  return ball;
}

/// Two balls go one behind the other, equally fast; the first is stopped at a plate.
TEST(PassingGuard, WhatFollowsAStoppedBodyIsStoppedToo) {
  Draw draw(7);
  for (int k = 0; k < 20; ++k) {
    SCOPED_TRACE(k);
    const double speed = draw.between(30, 60), height = draw.between(0.12, 0.2);
    const Vec3 v(0, 0, -speed);
    const double overlap = overlap_of_balls(
        Vec3(1, 1, 0.01), {ball_at("a", Vec3(0, 0, height), v), ball_at("b", Vec3(0, 0, height + 0.25), v)},
        draw.orientation());
    EXPECT_LT(overlap, 0.16 * 0.1);
  }
}

/// A ball strikes a face at a slant and goes on along it, where nobody looked for what it meets: the box
/// about its path without the face, which is along an axis, is narrow.
TEST(PassingGuard, WhatADeflectedBodyMeetsIsSeen) {
  Draw draw(8);
  for (int k = 0; k < 20; ++k) {
    SCOPED_TRACE(k);
    const Vec3 along(draw.between(20, 25), 0, 0), down(0, 0, -draw.between(20, 25));
    const double overlap =
        overlap_of_balls(Vec3(5, 5, 0.5),
                         {ball_at("a", Vec3(0, 0, 0.601), along + down),
                          ball_at("b", Vec3(draw.between(0.25, 0.4), 0, 0.6), Vec3::Zero())},
                         draw.orientation());
    EXPECT_LT(overlap, 0.16 * 0.1);
  }
}

TEST(PassingGuard, NoBladePassesABodyAtRest) {
  Draw draw(2);
  for (int k = 0; k < 40; ++k) {
    SCOPED_TRACE(k);
    ModelBuilder builder;
    builder.set_gravity(Vec3::Zero());
    builder.add_material({"m", 2000, 0.3, draw.below(2) == 0 ? 0 : 0.5});
    const double length = draw.between(0.3, 1), width = draw.between(0.03, 0.1), spin = draw.spread(5, 1000);
    BodyDescription blade = random_body("blade", Box{0.5 * Vec3(length, 0.002, width)}, Vec3::Zero());
    blade.mass = draw.spread(0.1, 100);
    blade.angular_velocity = Vec3(0, 0, spin);
    builder.add_body(blade);
    const double angle = draw.between(0.6, 2.5), radius = 0.5 * length * draw.between(0.3, 0.9);
    builder.add_body(random_body("body", random_shape(draw, draw.between(0.02, 0.1)),
                                 radius * Vec3(std::cos(angle), std::sin(angle), 0)));
    const bool is_hinged = k % 2 == 0;
    if (is_hinged) {
      ModelBuilder::JointDescription hinge;
      hinge.name = "hinge";
      hinge.type = JointType::hinge;
      hinge.bodies = {"world", "blade"};
      hinge.anchors = {Vec3::Zero()};
      hinge.axis = Vec3::UnitZ();
      builder.add_joint(hinge);
    }
    const std::shared_ptr<const Model> model = builder.build();

    State state = make_initial_state(*model);
    const double energy = kinetic_energy_of(*model, state), step = draw.spread(1e-3, 1.0 / 60);
    BulkWorld world(model, {});
    world.read(state);
    // One turn at least: the body is in the way.
    while (world.time() < 6.3 / spin + 2 * step) {
      world.step(step);
      world.write(state);
      ASSERT_LE(kinetic_energy_of(*model, state), energy * (1 + 1e-4));
    }
    EXPECT_GT(state.linear_momentum(1).norm(), 0);
  }
}

/// A kinematic blade that turns by a whole number of circles in a step, or nearly so, is where it was before:
/// poses alone do not tell that it has turned. Its velocity is given, or follows from a path whose points are
/// closer than the steps.
TEST(PassingGuard, NoDrivenBladePassesABodyInWholeTurns) {
  Draw draw(4);
  for (int k = 0; k < 40; ++k) {
    SCOPED_TRACE(k);
    const double step = draw.spread(5e-3, 1.0 / 60);
    const double turns = 1 + draw.below(2) + (k % 4 == 0 ? 0 : draw.between(-0.08, 0.08));
    const double spin = turns * 2 * std::numbers::pi / step;
    ModelBuilder builder;
    builder.set_gravity(Vec3::Zero());
    builder.add_material({"m", 2000, draw.below(2) == 0 ? 0 : 0.8, draw.below(2) == 0 ? 0 : 0.5});
    const double length = draw.between(0.3, 1), width = draw.between(0.03, 0.1);
    BodyDescription blade = random_body("blade", Box{0.5 * Vec3(length, 0.002, width)}, Vec3::Zero());
    blade.motion = MotionType::kinematic;
    const bool has_path = k % 2 == 1;
    if (has_path) {
      const double quarter = 0.5 * std::numbers::pi / spin;
      for (int i = 0; i * quarter < 4 * step; ++i) {
        const double half_angle = 0.25 * std::numbers::pi * i;
        blade.path.push_back(
            {i * quarter, Vec3::Zero(), Quat(std::cos(half_angle), 0, 0, std::sin(half_angle))});
      }
    } else {
      blade.angular_velocity = Vec3(0, 0, spin);
    }
    builder.add_body(blade);
    const double angle = draw.between(0.6, 2.5), radius = 0.5 * length * draw.between(0.3, 0.9);
    builder.add_body(random_body("body", random_shape(draw, draw.between(0.02, 0.1)),
                                 radius * Vec3(std::cos(angle), std::sin(angle), 0)));
    const std::shared_ptr<const Model> model = builder.build();

    State state = make_initial_state(*model);
    BulkWorld world(model, {});
    world.read(state);
    // At least as many parts as half radians, by which tolerances of rounding are counted.
    EXPECT_GE(world.step(step).parts, 2 * spin * step * (1 - 1e-6));
    world.step(step);
    world.write(state);
    EXPECT_GT(state.linear_momentum(1).norm(), 0);
  }
}

/// A thin kinematic blade strikes bodies and takes them along, through steps in which it goes farther than
/// they are thick: few overlap by more than the audit allows, and none by much more.
TEST(PassingGuard, NoDrivenBladeSinksFarIntoWhatItTakesAlong) {
  Draw draw(5);
  int deep = 0;  // More than the audit allows.
  for (int k = 0; k < 60; ++k) {
    SCOPED_TRACE(k);
    ModelBuilder builder;
    builder.set_gravity(Vec3::Zero());
    builder.add_material({"m", 1000, draw.below(2) == 0 ? 0 : 0.8, draw.below(2) == 0 ? 0 : 0.5});
    const double length = draw.between(0.3, 1), width = draw.between(0.06, 0.2), spin = draw.spread(30, 300);
    BodyDescription blade =
        random_body("blade", Box{0.5 * Vec3(2 * length, draw.between(1e-3, 3e-3), width)}, Vec3::Zero());
    blade.motion = MotionType::kinematic;
    blade.angular_velocity = Vec3(0, 0, spin);
    builder.add_body(blade);
    const double angle = draw.between(0.4, 2.7), radius = length * draw.between(0.3, 0.7);
    BodyDescription body = random_body("body", random_shape(draw, draw.between(0.02, 0.1)),
                                       radius * Vec3(std::cos(angle), std::sin(angle), 0));
    body.q_WU = draw.orientation();
    builder.add_body(body);

    State state = make_initial_state(*builder.build());
    BulkWorld world(builder.build(), {});
    world.read(state);
    const double step = draw.spread(1e-3, 1.0 / 60);
    double worst = 0;
    while (world.time() < 6.9 / spin) worst = std::max(worst, world.step(step).worst_share);
    world.write(state);
    EXPECT_GT(state.linear_momentum(1).norm(), 0);
    // Of the thinner one's thickness; bodies that stopped while the blade went on were deeper by many times
    // it.
    EXPECT_LE(worst, 0.6);
    if (worst > 0.25) ++deep;
  }
  EXPECT_LE(deep, 6);
}

/// Limbs that are thick and hinged at one end go on arcs, which are not their chords.
TEST(PassingGuard, NoThickLimbPassesABodyAtRest) {
  Draw draw(3);
  for (int k = 0; k < 60; ++k) {
    SCOPED_TRACE(k);
    ModelBuilder builder;
    builder.set_gravity(Vec3::Zero());
    builder.add_material({"m", 1000, 0.3, draw.below(2) == 0 ? 0 : 0.5});
    const double length = draw.between(0.15, 0.5), spin = draw.between(20, 150);
    const Vec3 size(length, draw.between(0.03, 0.12), draw.between(0.03, 0.1));
    BodyDescription limb = random_body("limb", Box{0.5 * size}, Vec3(0.5 * length, 0, 0));
    limb.velocity = Vec3(0, 0.5 * length * spin, 0);
    limb.angular_velocity = Vec3(0, 0, spin);
    builder.add_body(limb);
    const double angle = draw.between(1.5, 4), radius = length * draw.between(0.4, 0.9);
    builder.add_body(random_body("body", random_shape(draw, draw.between(0.02, 0.1)),
                                 radius * Vec3(std::cos(angle), std::sin(angle), 0)));
    ModelBuilder::JointDescription hinge;
    hinge.name = "hinge";
    hinge.type = JointType::hinge;
    hinge.bodies = {"world", "limb"};
    hinge.anchors = {Vec3::Zero()};
    hinge.axis = Vec3::UnitZ();
    builder.add_joint(hinge);
    const std::shared_ptr<const Model> model = builder.build();

    State state = make_initial_state(*model);
    const double energy = kinetic_energy_of(*model, state), step = draw.between(0.005, 1.0 / 60);
    BulkWorld world(model, {});
    world.read(state);
    while (world.time() < 6.3 / spin + 2 * step) {
      world.step(step);
      world.write(state);
      ASSERT_LE(kinetic_energy_of(*model, state), energy * (1 + 1e-4));
      // Where it was stopped it is on the arc that the substeps have taken: within the sagitta of one of
      // them, l θ²/8 of a distance l / 2 from the hinge.
      constexpr double turn = 0.2;
      const Vec3 anchor = state.position(0) + state.orientation(0) * Vec3(-0.5 * length, 0, 0);
      ASSERT_LE(anchor.norm(), 0.5 * length * turn * turn / 8);
    }
    EXPECT_GT(state.linear_momentum(1).norm(), 0);
  }
}

/// Heavy balls, one above the other, fall on a light one that sweeps alone hold (it has a joint): they take
/// many steps to stop them, and the guard keeps the lowest from passing it. Those above it went into it
/// meanwhile, by 1.8 m, since their velocities are the same. (Of 1,700 and 5,800 times its mass. With 20
/// times as much the world broke after three steps; now they sink into one another, and the audit says so.)
TEST(PassingGuard, WhatFollowsABodyThatIsStoppedStopsToo) {
  for (const double radius : {0.6, 0.9}) {
    ModelBuilder builder;
    builder.set_gravity(Vec3::Zero());
    builder.add_material({"m", 50, 0.5, 0});
    builder.add_material({"light", 50, 0.5, 0});
    BodyDescription ground = random_body("ground", HalfSpace{Vec3::UnitZ(), 0}, Vec3::Zero());
    ground.motion = MotionType::fixed;
    builder.add_body(ground);
    for (int k = 0; k < 2; ++k) {
      BodyDescription light =
          random_body("light " + std::to_string(k), Sphere{0.05}, Vec3(0.11 * k, 0, 0.05));
      light.shapes[0].material = "light";
      builder.add_body(light);
    }
    ModelBuilder::JointDescription joint;
    joint.name = "joint";
    joint.type = JointType::ball;
    joint.bodies = {"light 0", "light 1"};
    joint.anchors = {Vec3(0.055, 0, 0.05)};
    builder.add_joint(joint);
    for (int k = 0; k < 4; ++k) {
      BodyDescription ball = random_body("ball " + std::to_string(k), Sphere{radius},
                                         Vec3(0, 0, 0.2 + radius + (2 * radius + 0.3) * k));
      ball.velocity = Vec3(0, 0, -15);
      builder.add_body(ball);
    }
    const std::shared_ptr<const Model> model = builder.build();
    State state = make_initial_state(*model);
    BulkWorld world(model, {});
    world.read(state);
    double nearest = INFINITY;
    for (int k = 0; k < 60; ++k) {
      ASSERT_LT(world.step(1.0 / 60).broken_body, 0);
      for (std::size_t i = 4; i < 7; ++i)
        nearest = std::min(nearest, (world.bodies().x[i] - world.bodies().x[i - 1]).norm());
    }
    // A quarter of the thickness, and what each step may add to it.
    EXPECT_GT(nearest, 1.5 * radius);
  }
}

}  // namespace
}  // namespace rigor::passing_guard_test
