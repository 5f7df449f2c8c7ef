// A hundred worlds on all threads: the same throw with a little more spin in each.
#include <rigor/rigor.hpp>

#include <iostream>

using namespace rigor;

int main() {
  const Scene scene = parse_scene(R"(
rigor: 1
materials: [{name: rubber, restitution: 0.7, friction: 0.5}]
bodies:
  - {name: floor, motion: static, shapes: [{type: plane, normal: [0, 0, 1], offset: 0, material: rubber}]}
  - {name: ball, position: [0, 0, 0.5], mass: 1, shapes: [{type: sphere, radius: 0.1, material: rubber}]}
)",
                                  "throw.yaml", ".");
  Batch batch(scene, 100);
  for (int i = 0; i < batch.size(); ++i)
    batch.world(i).set_velocity("ball", Vec3(2, 0, 0), Vec3(0, -0.5 * i, 0));
  batch.advance_to(1.0);

  // Backspin brings the ball back: it comes less far, the more it spins.
  double before = 1e9;
  for (int i = 0; i < batch.size(); i += 33) {
    const double x = batch.world(i).position("ball").x();
    std::cout << "spin " << -0.5 * i << " rad/s: x = " << x << " m\n";
    if (x > before) return 1;
    before = x;
  }
  return 0;
}
