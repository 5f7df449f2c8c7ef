// Who presses on whom, and what is under a sensor? A stack of two boxes in three schemes.
#include <rigor/rigor.hpp>

#include <cmath>
#include <iostream>

using namespace rigor;

int main() {
  bool is_right = true;
  for (const char* method :
       {"{scheme: event-driven}", "{scheme: time-stepping}", "{scheme: time-stepping, solver: substep}"}) {
    Simulation sim(parse_scene(std::string("rigor: 1\nmethod: ") + method + R"(
bodies:
  - {name: floor, motion: static, shapes: [{type: plane, normal: [0, 0, 1], offset: 0}]}
  - {name: lower, position: [0, 0, 0.1], mass: 2, shapes: [{type: box, size: [0.2, 0.2, 0.2]}]}
  - {name: upper, position: [0, 0, 0.3], mass: 1, shapes: [{type: box, size: [0.2, 0.2, 0.2]}]}
)",
                               "stack.yaml", "."));
    sim.advance_to(0.5);

    // The floor carries both, the lower box the upper one.
    const BodyHandle lower = sim.body("lower"), upper = sim.body("upper");
    double on_floor = 0, on_lower = 0;
    for (const TouchingPoint& point : sim.contacts()) {
      if (point.body_B == lower.index) on_floor += point.force_W.z();
      if (point.body_A == lower.index && point.body_B == upper.index) on_lower += point.force_W.z();
    }
    std::cout << method << ": floor " << on_floor << " N, lower box " << on_lower << " N\n";
    is_right = is_right && std::abs(on_floor - 3 * 9.80665) < 0.3 && std::abs(on_lower - 9.80665) < 0.1;

    // A ray from above meets the upper box 0.6 m down.
    const auto hit = sim.queries().first_hit({Vec3(0, 0, 1), Vec3(0, 0, -1)});
    is_right = is_right && hit && hit->on.body == upper.index && std::abs(hit->hit.fraction - 0.6) < 1e-3;
  }
  return is_right ? 0 : 1;
}
