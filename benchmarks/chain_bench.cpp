// The falling chain of scenes/chain.yaml: CPU time a step by the number of links.

#include "rigor/io/scene/scene_reader.hpp"
#include "rigor/sim/event_driven/event_driven_stepper.hpp"

#include <fmt/format.h>

#include <ctime>

int main() {
  using namespace rigor;
  fmt::print("Falling chains of balls and sockets, steps of rk4\n");
  fmt::print("{:>8} {:>12} {:>22}\n", "links", "ms a step", "µs a link and step");
  for (const int links : {100, 200, 500, 1000}) {
    const Scene scene =
        read_scene(RIGOR_SOURCE_DIR "/scenes/chain.yaml",
                   {fmt::format("bodies.link.repeat.count=[{},1,1]", links),
                    fmt::format("joints.pin.repeat.count=[{},1,1]", links - 1), "method.integrator=rk4"});
    EventDrivenStepper stepper(scene.model, scene.method, 1e-3);
    State state = make_initial_state(*scene.model);
    AdvanceReport report = stepper.advance(state, 1e-3);  // The first one builds its windows.
    const std::clock_t begin = std::clock();
    report = stepper.advance(state, 0.011);
    const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    if (report.reason != StopReason::reached_end) return 1;
    const double step = seconds / static_cast<double>(report.steps);
    fmt::print("{:>8} {:>12.2f} {:>22.1f}\n", links, 1e3 * step, 1e6 * step / links);
  }
  return 0;
}
