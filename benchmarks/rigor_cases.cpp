// Rigor on the reference scenes.

#include "bench.hpp"

#include "rigor/dynamics/free_rotation.hpp"
#include "rigor/geometry/mass/mass_properties.hpp"
#include "rigor/geometry/shape/triangle_mesh.hpp"
#include "rigor/io/scene/scene_reader.hpp"
#include "rigor/math/rotation.hpp"
#include "rigor/model/model_builder.hpp"
#include "rigor/sim/simulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace rigor::bench {

namespace {

struct Run {
  Scene scene;
  RunResult result;
  std::vector<State> states;
  std::vector<MotionEvent> events;
  double seconds = 0;
};

Run run_scene(const std::string& file, const std::vector<std::string>& overrides) {
  Run run;
  run.scene = read_scene(std::string(RIGOR_SOURCE_DIR) + "/scenes/" + file, overrides);
  const Observer keep = [&run](const State& state, const AdvanceReport& since, const Auditor&) {
    run.states.push_back(state);
    run.events.insert(run.events.end(), since.events.begin(), since.events.end());
    return true;
  };
  run.seconds = cpu_seconds([&] {
    run.result = run_simulation(run.scene.model, run.scene.method, run.scene.run, std::nullopt, keep);
  });
  return run;
}

const Audit::BodyEnd& end_of(const Run& run, const std::string& name) {
  return *std::find_if(run.result.audit.bodies.begin(), run.result.audit.bodies.end(),
                       [&](const Audit::BodyEnd& body) { return body.name == name; });
}

/// The closed form evaluated from its start is compared with the one that starts at 37.1 s: the two share the
/// physics but no number (the tests compare it with independent integration).
void add_free_top(std::vector<Row>& rows) {
  const Vec3 moments(1, 2, 3), w(0.01, 1, 0.01);
  const Vec3 L = moments.cwiseProduct(w);
  constexpr int outputs = 10000;
  double worst = 0, energy = 0;
  const double T = 0.5 * L.dot(w);
  std::vector<Quat> attitudes;
  const double seconds = cpu_seconds([&] {
    const FreeRotation rotation(moments, Quat::Identity(), L);
    for (int k = 1; k <= outputs; ++k) attitudes.push_back(rotation.orientation(0.01 * k));
  });
  const FreeRotation first(moments, Quat::Identity(), L);
  const FreeRotation second(moments, first.orientation(37.1), L);
  for (int k = 1; k <= outputs; ++k) {
    const Quat& q = attitudes[static_cast<std::size_t>(k - 1)];
    worst = std::max(worst, rotation_angle_between(q, second.orientation(0.01 * k - 37.1)));
    const Vec3 L_B = rotation_matrix(q).transpose() * L;
    energy = std::max(energy, std::abs(0.5 * L_B.dot(L_B.cwiseQuotient(moments)) / T - 1));
  }
  rows.push_back({"free top, 100 s", "Rigor", "angle, two halves [rad]", worst, seconds});
  rows.push_back({"free top, 100 s", "Rigor", "energy [relative]", energy, seconds});
}

void add_bounces(std::vector<Row>& rows) {
  for (const char* step : {"0.1", "0.01", "0.001"}) {
    const Run run = run_scene("bouncing_ball.yaml", {std::string("run.step=") + step});
    double worst = 0;
    for (const State& state : run.states) {
      worst = std::max(worst, std::abs(state.position(1).z() - 0.1 - bouncing_height(1, state.t)));
    }
    rows.push_back(
        {"bounce e = 1, 10 s", fmt::format("Rigor, step {}", step), "height [m]", worst, run.seconds});
  }
  const Run run = run_scene("bouncing_ball_e05.yaml", {});
  double rest = 0;
  for (const MotionEvent& event : run.events) {
    if (event.kind == MotionEvent::Kind::rest) rest = event.time;
  }
  rows.push_back({"bounce e = 0.5: end of bouncing", "Rigor", "time [s]",
                  std::abs(rest - 3 * std::sqrt(2 / g)), run.seconds});
}

void add_friction(std::vector<Row>& rows) {
  const Run roll = run_scene("slide_to_roll.yaml", {});
  double slip_end = 0;
  for (const MotionEvent& event : roll.events) {
    if (event.kind == MotionEvent::Kind::slip_to_stick) slip_end = event.time;
  }
  rows.push_back({"slide to roll, mu 0.2", "Rigor", "velocity [m/s]",
                  std::abs(end_of(roll, "ball").velocity.x() - 3), roll.seconds});
  rows.push_back({"slide to roll, mu 0.2", "Rigor", "transition [s]",
                  std::abs(slip_end - 7 / (3.5 * 0.2 * g)), roll.seconds});
  const Vec3 start(0, 0, 0.1);
  const Run stick = run_scene("ramp_stick.yaml", {});
  rows.push_back({"block on 20 deg, mu 1.01 tan, 10 s", "Rigor", "creep [m]",
                  (end_of(stick, "block").position - start).norm(), stick.seconds});
  const Run slide = run_scene("ramp_slide.yaml", {});
  const double distance = (end_of(slide, "block").position - start).norm();
  rows.push_back({"block on 20 deg, mu 0.99 tan, 30 deg off", "Rigor", "distance [m]",
                  std::abs(distance - ramp_distance()), slide.seconds});
  const Run table = run_scene("turntable.yaml", {});
  rows.push_back({"turntable, one turn of the ball", "Rigor", "closure [m]",
                  (end_of(table, "ball").position - Vec3(1, 0, 0.1)).norm(), table.seconds});
}

void add_many_and_fast(std::vector<Row>& rows) {
  const Run gas = run_scene("gas.yaml", {});
  const Audit& audit = gas.result.audit;
  rows.push_back({"gas of 216 balls, 10 s", "Rigor", "energy [relative]",
                  std::abs(audit.final.total() / audit.initial.total() - 1), gas.seconds});
  rows.push_back(
      {"gas of 216 balls, 10 s", "Rigor", "overlap [m]", audit.report.max_penetration, gas.seconds});
  for (const char* speed : {"100", "1000"}) {
    const Run bullet = run_scene("bullet.yaml", {fmt::format("bodies.ball.velocity=[{}, 0, 0]", speed)});
    const bool passed = end_of(bullet, "ball").position.x() > 1;
    rows.push_back({fmt::format("ball at {} m/s, 20 mm plate", speed), "Rigor", "passed through (1 = yes)",
                    passed ? 1.0 : 0.0, bullet.seconds});
  }
}

/// Sphere of stacks × segments quads, in triangles.
TriangleMesh make_sphere(int stacks, int segments) {
  TriangleMesh mesh;
  const auto ring = [segments](int stack, int segment) {
    return 1 + (stack - 1) * segments + segment % segments;
  };
  mesh.vertices.push_back(Vec3::UnitZ());
  for (int i = 1; i < stacks; ++i) {
    const double polar = M_PI * i / stacks;
    for (int k = 0; k < segments; ++k) {
      const double turn = 2 * M_PI * k / segments;
      mesh.vertices.push_back(
          Vec3(std::sin(polar) * std::cos(turn), std::sin(polar) * std::sin(turn), std::cos(polar)));
    }
  }
  mesh.vertices.push_back(-Vec3::UnitZ());
  const int south = static_cast<int>(mesh.vertices.size()) - 1;
  for (int k = 0; k < segments; ++k) {
    mesh.triangles.push_back({0, ring(1, k), ring(1, k + 1)});
    mesh.triangles.push_back({south, ring(stacks - 1, k + 1), ring(stacks - 1, k)});
    for (int i = 1; i + 1 < stacks; ++i) {
      mesh.triangles.push_back({ring(i, k), ring(i + 1, k), ring(i + 1, k + 1)});
      mesh.triangles.push_back({ring(i, k), ring(i + 1, k + 1), ring(i, k + 1)});
    }
  }
  return mesh;
}

void add_mass(std::vector<Row>& rows) {
  // 2 segments (stacks - 1) triangles; the volume of this polyhedron in closed form: a sum of frusta of
  // regular n-gons.
  constexpr int stacks = 126, segments = 400;
  const TriangleMesh mesh = make_sphere(stacks, segments);
  MassProperties properties;
  const double seconds = cpu_seconds([&] { properties = mass_properties(mesh, 1); });
  double volume = 0;
  for (int i = 0; i < stacks; ++i) {
    const double a = std::sin(M_PI * i / stacks), b = std::sin(M_PI * (i + 1) / stacks);
    const double height = std::cos(M_PI * i / stacks) - std::cos(M_PI * (i + 1) / stacks);
    volume += 0.5 * segments * std::sin(2 * M_PI / segments) * height / 3 * (a * a + a * b + b * b);
  }
  rows.push_back({fmt::format("mass of {} triangles", mesh.triangles.size()), "Rigor", "volume [relative]",
                  std::abs(properties.mass / volume - 1), seconds});
}

/// Time an event of two gases of the same density, in one advance each.
void add_scaling(std::vector<Row>& rows) {
  for (const int n : {6, 21}) {
    ModelBuilder builder;
    builder.set_gravity(Vec3::Zero());
    builder.add_material({"ideal", 1000, 0, 1});
    for (int axis = 0; axis < 3; ++axis) {
      for (const double sign : {1.0, -1.0}) {
        BodyDescription wall;
        wall.name = fmt::format("wall{}{}", axis, sign > 0 ? "a" : "b");
        wall.motion = MotionType::fixed;
        wall.shapes.push_back({HalfSpace{sign * Vec3::Unit(axis), sign > 0 ? 0.0 : -0.5 * n}, Vec3::Zero(),
                               Quat::Identity(), "ideal", ""});
        builder.add_body(wall);
      }
    }
    std::uint32_t seed = 42;
    const auto draw = [&seed] {
      seed = seed * 1664525u + 1013904223u;
      return 2 * static_cast<double>(seed >> 8) / 16777216.0 - 1;
    };
    for (int k = 0; k < n * n * n; ++k) {
      BodyDescription ball;
      ball.name = fmt::format("ball{}", k);
      ball.p_WU = Vec3(0.25 + 0.5 * (k % n), 0.25 + 0.5 * (k / n % n), 0.25 + 0.5 * (k / n / n));
      const double vx = draw(), vy = draw(), vz = draw();
      ball.velocity = Vec3(vx, vy, vz);
      ball.mass = 1;
      ball.shapes.push_back({Sphere{0.1}, Vec3::Zero(), Quat::Identity(), "ideal", ""});
      builder.add_body(ball);
    }
    RunSettings settings;
    settings.duration = settings.output_interval = n == 6 ? 10 : 1;
    RunResult result;
    const Observer ignore = [](const State&, const AdvanceReport&, const Auditor&) { return true; };
    const std::shared_ptr<const Model> model = builder.build();
    const double seconds =
        cpu_seconds([&] { result = run_simulation(model, Method{}, settings, std::nullopt, ignore); });
    rows.push_back({"gas: CPU time an impact", fmt::format("Rigor, {} balls", n * n * n),
                    "time an impact [us]", 1e6 * seconds / static_cast<double>(result.audit.report.impacts),
                    seconds});
  }
}

}  // namespace

std::vector<Row> rigor_rows() {
  std::vector<Row> rows;
  add_free_top(rows);
  add_bounces(rows);
  add_friction(rows);
  add_many_and_fast(rows);
  add_mass(rows);
  add_scaling(rows);
  return rows;
}

}  // namespace rigor::bench
