// Bodies that fall together into a heap: processor time a step of time stepping with the exact solver, beside
// MuJoCo where it is installed (elliptic cone, Newton's method, soft contact), on the same scene in the same
// run. usage: rigor_heap_bench [most bodies, 48 unless given]

#include "peer_cases.hpp"
#ifdef RIGOR_BENCH_MUJOCO
#include "mujoco_world.hpp"
#endif

#include "rigor/geometry/mass/mass_properties.hpp"
#include "rigor/math/rotation.hpp"
#include "rigor/model/model_builder.hpp"
#include "rigor/sim/make_stepper.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <limits>
#include <random>
#include <string>

namespace rigor::bench {

namespace {

using ShapeKind = PeerBody::Shape;

constexpr double density = 1000, duration = 1;

double seconds_of(const std::function<void()>& call) {
  const std::clock_t begin = std::clock();
  call();
  return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
}

Shape shape_of(const PeerBody& body) {
  switch (body.shape) {
    case ShapeKind::sphere:
      return Sphere{body.half.x()};
    case ShapeKind::capsule:
      return Capsule{body.half.x(), body.half.z()};
    case ShapeKind::cylinder:
      return Cylinder{body.half.x(), body.half.z()};
    default:
      return Box{body.half};
  }
}

/// Bodies in layers, a little askew, above the floor.
PeerScene heap(int count, bool is_mixed, unsigned seed) {
  std::vector<std::pair<ShapeKind, Vec3>> shapes{{ShapeKind::box, {0.075, 0.06, 0.05}}};
  if (is_mixed) {
    shapes.emplace_back(ShapeKind::sphere, Vec3::Constant(0.07));
    shapes.emplace_back(ShapeKind::capsule, Vec3(0.05, 0.05, 0.05));
    shapes.emplace_back(ShapeKind::cylinder, Vec3(0.06, 0.06, 0.05));
  }
  PeerScene scene;
  scene.step = 0.01;
  scene.gravity = Vec3(0, 0, -g);
  scene.friction = 0.5;
  scene.planes = {PeerPlane{}};
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  constexpr double pitch = 0.25;
  const int side = std::max(2, static_cast<int>(std::lround(std::cbrt(count / 4.0))));
  for (int k = 0; k < count; ++k) {
    PeerBody body;
    std::tie(body.shape, body.half) = shapes[static_cast<std::size_t>(k) % shapes.size()];
    body.p = Vec3(pitch * (k % side) + 0.02 * uniform(generator),
                  pitch * (k / side % side) + 0.02 * uniform(generator), 0.3 + pitch * (k / (side * side)));
    body.q = rotation_exp(Vec3(uniform(generator), uniform(generator), uniform(generator)));
    const MassProperties mass = mass_properties(shape_of(body), density);
    body.mass = mass.mass;
    body.moments = mass.inertia.diagonal();
    scene.bodies.push_back(body);
  }
  return scene;
}

std::shared_ptr<const Model> model_of(const PeerScene& scene) {
  ModelBuilder builder;
  builder.set_gravity(scene.gravity);
  builder.add_material({"m", density, scene.friction, scene.restitution});
  const auto add = [&](const std::string& name, const Shape& shape, const PeerBody* body) {
    BodyDescription description;
    description.name = name;
    description.motion = body ? MotionType::dynamic : MotionType::fixed;
    if (body) {
      description.p_WU = body->p;
      description.q_WU = body->q;
    }
    description.shapes.push_back({shape, Vec3::Zero(), Quat::Identity(), "m", ""});
    builder.add_body(description);
  };
  for (const PeerPlane& plane : scene.planes) add("floor", HalfSpace{plane.n, plane.d}, nullptr);
  for (std::size_t k = 0; k < scene.bodies.size(); ++k)
    add(fmt::format("b{}", k), shape_of(scene.bodies[k]), &scene.bodies[k]);
  return builder.build();
}

struct HeapRun {
  double ms_per_step = 0;
  AdvanceReport report;
};

HeapRun run_rigor(const PeerScene& scene) {
  const std::shared_ptr<const Model> model = model_of(scene);
  Method method;
  method.scheme = Scheme::time_stepping;
  State state = make_initial_state(*model);
  HeapRun run;
  const double seconds = seconds_of([&] {
    const std::unique_ptr<Stepper> stepper = make_stepper(model, method, scene.step);
    run.report = stepper->advance(state, duration);
  });
  run.ms_per_step = 1e3 * seconds * scene.step / duration;
  return run;
}

/// NaN without MuJoCo.
double run_peer([[maybe_unused]] const PeerScene& scene) {
#ifdef RIGOR_BENCH_MUJOCO
  const std::unique_ptr<PeerWorld> world = make_mujoco_world(scene, MujocoSettings::elliptic);
  const long steps = std::lround(duration / scene.step);
  const double seconds = seconds_of([&] {
    for (long k = 0; k < steps; ++k) world->step();
  });
  return 1e3 * seconds / static_cast<double>(steps);
#else
  return std::numeric_limits<double>::quiet_NaN();
#endif
}

}  // namespace

void print_heaps(int most_bodies) {
  fmt::print("Heaps that fall for {} s, steps of 0.01 s: processor time a step [ms]\n", duration);
  fmt::print("{:>8} {:>6} {:>10} {:>10} {:>8} {:>10} {:>10} {:>10} {:>12}\n", "heap", "bodies", "Rigor",
             "MuJoCo", "ratio", "problems", "fallbacks", "residual", "overlap [m]");
  for (const bool is_mixed : {false, true}) {
    for (const int bodies : {12, 24, 48, 100, 300}) {
      if (bodies > most_bodies) break;
      const PeerScene scene = heap(bodies, is_mixed, static_cast<unsigned>(bodies));
      const HeapRun run = run_rigor(scene);
      const double peer = run_peer(scene);
      fmt::print("{:>8} {:>6} {:>10.2f} {:>10.2f} {:>8.1f} {:>10} {:>10} {:>10.1e} {:>12.1e}{}\n",
                 is_mixed ? "mixed" : "boxes", bodies, run.ms_per_step, peer, run.ms_per_step / peer,
                 run.report.steps, run.report.fallbacks, run.report.max_residual, run.report.max_penetration,
                 run.report.reason == StopReason::reached_end ? "" : "  stopped");
      std::fflush(stdout);
    }
  }
}

}  // namespace rigor::bench

int main(int argc, char** argv) {
  const int most_bodies = argc > 1 ? std::max(1, std::atoi(argv[1])) : 48;
  rigor::bench::print_heaps(most_bodies);
  return 0;
}
