// A scene from text, run to its end: where is the ball, and can the answer be trusted?
#include <rigor/rigor.hpp>

#include <iostream>

int main() {
  const rigor::Scene scene = rigor::parse_scene(R"(
rigor: 1
materials: [{name: rubber, restitution: 0.8}]
bodies:
  - {name: floor, motion: static, shapes: [{type: plane, normal: [0, 0, 1], offset: 0, material: rubber}]}
  - {name: ball, position: [0, 0, 1], mass: 1, shapes: [{type: sphere, radius: 0.1, material: rubber}]}
)",
                                                "hello.yaml", ".");
  rigor::Simulation sim(scene);
  sim.advance_to(1.0);
  std::cout << "height " << sim.position("ball").z() << " m\n";
  for (const rigor::MotionEvent& event : sim.take_events())
    std::cout << "impact at " << event.time << " s, impulse " << event.j_W.z() << " N s\n";
  return sim.audit().violations.empty() ? 0 : 1;
}
