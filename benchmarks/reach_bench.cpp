// What the library costs its callers: a step of a simulation without and with inputs that change in every
// step, and worlds of a batch against one world. Processor time of this thread, the least of several series.
// usage: rigor_reach_bench [STEPS]
#include <rigor/rigor.hpp>

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

#include <time.h>

using namespace rigor;

namespace {

double cpu_time() {
  timespec time{};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

const char* const arm = R"(
bodies:
  - {name: upper, position: [0.5, 0, 0], mass: 1, shapes: [{type: box, size: [1, 0.1, 0.1]}]}
  - {name: lower, position: [1.5, 0, 0], mass: 1, shapes: [{type: box, size: [1, 0.1, 0.1]}]}
joints:
  - {name: shoulder, type: hinge, bodies: [world, upper], anchor: [0, 0, 0], axis: [0, 1, 0]}
  - {name: elbow, type: hinge, bodies: [upper, lower], anchor: [1, 0, 0], axis: [0, 1, 0]}
)";
const char* const cart = R"(
materials: [{name: steel, friction: 0.3, restitution: 0.2}]
bodies:
  - {name: floor, motion: static, shapes: [{type: plane, normal: [0, 0, 1], offset: 0, material: steel}]}
  - {name: cart, position: [0, 0, 0.5], mass: 1, shapes: [{type: box, size: [0.4, 0.2, 0.1], material: steel}]}
  - {name: ball, position: [0, 0, 0.65], mass: 1, shapes: [{type: sphere, radius: 0.1, material: steel}]}
joints:
  - {name: elbow, type: slider, bodies: [world, cart], axis: [1, 0, 0]}
)";

Scene scene_of(const char* bodies, const std::string& method) {
  return parse_scene(
      "rigor: 1\nmethod: " + method + "\nrun: {duration: 1, step: 0.005, output_interval: 0.1}\n" + bodies,
      "bench.yaml", ".");
}

using Input = std::function<void(Simulation&, int)>;

/// Microseconds a step.
double step_time(const Scene& scene, int steps, const Input& input) {
  double best = 1e9;
  for (int series = 0; series < 5; ++series) {
    Simulation sim(scene);
    const double begin = cpu_time();
    for (int i = 0; i < steps; ++i) {
      if (input) input(sim, i);
      sim.step();
    }
    best = std::min(best, (cpu_time() - begin) / steps * 1e6);
  }
  return best;
}

}  // namespace

int main(int argc, char** argv) {
  const int steps = argc > 1 ? std::atoi(argv[1]) : 200;
  const std::vector<std::pair<const char*, Input>> inputs = {
      {"none", {}},
      {"force", [](Simulation& s, int i) { s.apply_force("cart", Vec3(0.1 * std::sin(i), 0, 0)); }},
      {"effort", [](Simulation& s, int i) { s.set_motor_effort("elbow", 0.1 * std::sin(i)); }},
      {"velocity", [](Simulation& s, int i) { s.set_motor_velocity("elbow", 0.1 * std::sin(i), 5); }},
      {"position", [](Simulation& s, int i) { s.set_motor_position("elbow", 0.1 * std::sin(i), 50, 5); }},
      {"limited",
       [](Simulation& s, int i) { s.set_motor_position("elbow", 0.1 * std::sin(i), 50, 5, 0, 3); }}};
  fmt::print("{:10} {:42}", "us a step", "");
  for (const auto& [name, input] : inputs) fmt::print(" {:>9}", name);
  fmt::print("\n");
  for (const auto& [scene_name, bodies] : {std::pair("arm", arm), std::pair("cart", cart)}) {
    for (const char* method : {"{scheme: event-driven}", "{scheme: auto}", "{scheme: time-stepping}",
                               "{scheme: time-stepping, solver: substep}", "{scheme: penalty}",
                               "{scheme: penalty, penalty: global}"}) {
      fmt::print("{:10} {:42}", scene_name, method);
      for (const auto& [name, input] : inputs) {
        if (std::string(name) == "force" && scene_name == std::string("arm")) {
          fmt::print(" {:>9}", "-");
          continue;
        }
        fmt::print(" {:9.2f}", step_time(scene_of(bodies, method), steps, input));
      }
      fmt::print("\n");
    }
  }
}
