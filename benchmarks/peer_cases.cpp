// The reference scenes and their errors, the same for all peers.

#include "peer_cases.hpp"

#include "rigor/dynamics/free_rotation.hpp"
#include "rigor/io/scene/scene_reader.hpp"
#include "rigor/math/rotation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rigor::bench {

namespace {

constexpr double degree = std::numbers::pi / 180;

PeerBody make_sphere(double radius) {
  PeerBody body;
  body.shape = PeerBody::Shape::sphere;
  body.half = Vec3::Constant(radius);
  body.moments = Vec3::Constant(0.4 * radius * radius);
  return body;
}

/// "1e-3" for a power of ten.
std::string with_step(const Peer& peer, double step) {
  return fmt::format(fmt::runtime(peer.name), fmt::format("1e-{:.0f}", -std::log10(step)));
}

long steps_of(double duration, double step) {
  return std::lround(duration / step);
}

void advance(PeerWorld& world, long steps) {
  for (long k = 0; k < steps; ++k) world.step();
}

/// Block at rest on the plane z = 0 under tilted gravity, 10 s.
struct Ramp {
  double friction_ratio;  ///< Friction over the tangent of the slope.
  double azimuth;         ///< Of the fall line [rad].
};

/// Way of the block in the plane [m].
double way_on_ramp(const Peer& peer, const Ramp& ramp, double& seconds) {
  constexpr double slope = 20 * degree;
  PeerScene scene;
  const Vec3 fall(std::cos(ramp.azimuth), std::sin(ramp.azimuth), 0);
  scene.gravity = g * (std::sin(slope) * fall - std::cos(slope) * Vec3::UnitZ());
  scene.friction = ramp.friction_ratio * std::tan(slope);
  scene.planes = {PeerPlane{}};
  PeerBody block;
  block.shape = PeerBody::Shape::box;
  block.half = Vec3(0.2, 0.2, 0.1);
  const Vec3 squares = block.half.cwiseAbs2();
  block.moments = (Vec3::Constant(squares.sum()) - squares) / 3;
  block.p = Vec3(0, 0, 0.1);
  scene.bodies = {block};
  const std::unique_ptr<PeerWorld> world = peer.make(scene);
  seconds = cpu_seconds([&] { advance(*world, steps_of(10, scene.step)); });
  return world->position(0).head<2>().norm();
}

double kinetic_energy(const PeerWorld& world, const PeerScene& scene) {
  double energy = 0;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    energy += 0.5 * scene.bodies[i].mass * world.velocity(static_cast<int>(i)).squaredNorm();
  }
  return energy;
}

}  // namespace

Row free_top(const Peer& peer, double step) {
  PeerScene scene;
  scene.step = step;
  PeerBody body;
  body.moments = Vec3(1, 2, 3);
  body.w = Vec3(0.01, 1, 0.01);
  scene.bodies = {body};
  const FreeRotation exact(body.moments, Quat::Identity(), body.moments.cwiseProduct(body.w));
  const std::unique_ptr<PeerWorld> world = peer.make(scene);
  double worst = 0;
  const double seconds = cpu_seconds([&] {
    for (int t = 1; t <= 100; ++t) {
      advance(*world, steps_of(1, step));
      worst = std::max(worst, rotation_angle_between(world->orientation(0), exact.orientation(t)));
    }
  });
  return {"free top, 100 s", with_step(peer, step), "angle [rad]", worst, seconds};
}

Row bounce(const Peer& peer, double step) {
  PeerScene scene;
  scene.step = step;
  scene.gravity = Vec3(0, 0, -g);
  scene.restitution = 1;
  scene.planes = {PeerPlane{}};
  scene.bodies = {make_sphere(0.1)};
  scene.bodies[0].p = Vec3(0, 0, 1.1);
  const std::unique_ptr<PeerWorld> world = peer.make(scene);
  double worst = 0;
  const double seconds = cpu_seconds([&] {
    const long steps = steps_of(10, step);
    for (long k = 1; k <= steps; ++k) {
      world->step();
      const double height = world->position(0).z() - 0.1;
      worst = std::max(worst, std::abs(height - bouncing_height(1, static_cast<double>(k) * step)));
    }
  });
  return {"bounce e = 1, 10 s", with_step(peer, step), "height [m]", worst, seconds};
}

Row block_sticks(const Peer& peer) {
  double seconds = 0;
  const double way = way_on_ramp(peer, {1.01, 0}, seconds);
  return {"block on 20 deg, mu 1.01 tan, 10 s", with_step(peer, 1e-3), "creep [m]", way, seconds};
}

Row block_slides(const Peer& peer) {
  double seconds = 0;
  const double error = std::abs(way_on_ramp(peer, {0.99, 30 * degree}, seconds) - ramp_distance());
  return {"block on 20 deg, mu 0.99 tan, 30 deg off", with_step(peer, 1e-3), "distance [m]", error, seconds};
}

Row slide_to_roll(const Peer& peer) {
  PeerScene scene;
  scene.gravity = Vec3(0, 0, -g);
  scene.friction = 0.2;
  scene.planes = {PeerPlane{}};
  scene.bodies = {make_sphere(0.1)};
  PeerBody& ball = scene.bodies[0];
  ball.p = Vec3(0, 0, 0.1);
  ball.v = Vec3(5, 0, 0);
  ball.w = Vec3(0, -20, 0);
  const std::unique_ptr<PeerWorld> world = peer.make(scene);
  const double seconds = cpu_seconds([&] { advance(*world, steps_of(2, scene.step)); });
  const double error = std::abs(world->velocity(0).x() - 3);
  return {"slide to roll, mu 0.2", with_step(peer, scene.step), "velocity [m/s]", error, seconds};
}

Row gas(const Peer& peer) {
  PeerScene scene;
  scene.step = 1e-2;
  scene.restitution = 1;
  for (int axis = 0; axis < 3; ++axis) {
    scene.planes.push_back({Vec3::Unit(axis), 0});
    scene.planes.push_back({-Vec3::Unit(axis), -3});
  }
  for (const Body& given : read_scene(RIGOR_SOURCE_DIR "/scenes/gas.yaml").model->bodies()) {
    if (given.motion != MotionType::dynamic) continue;
    scene.bodies.push_back(make_sphere(0.1));
    scene.bodies.back().p = given.p_WB;
    scene.bodies.back().v = given.v_WB;
  }
  const std::unique_ptr<PeerWorld> world = peer.make(scene);
  const double start = kinetic_energy(*world, scene);
  const double seconds = cpu_seconds([&] { advance(*world, steps_of(10, scene.step)); });
  const double error = std::abs(kinetic_energy(*world, scene) / start - 1);
  return {"gas of 216 balls, 10 s", with_step(peer, scene.step), "energy [relative]", error, seconds};
}

Row fast_ball(const Peer& peer) {
  PeerScene scene;
  scene.step = 1.0 / 60;
  scene.restitution = 1;
  scene.walls = {{Vec3(0.01, 1, 1), Vec3(1, 0, 0)}};
  scene.bodies = {make_sphere(0.05)};
  scene.bodies[0].v = Vec3(100, 0, 0);
  const std::unique_ptr<PeerWorld> world = peer.make(scene);
  const double seconds = cpu_seconds([&] { advance(*world, 6); });
  const double passed = world->position(0).x() > 1 ? 1 : 0;
  return {"ball at 100 m/s, 20 mm plate", fmt::format(fmt::runtime(peer.name), "1/60"),
          "passed through (1 = yes)", passed, seconds};
}

}  // namespace rigor::bench
