// Shapes without a scene: this program needs the component `geometry` alone.
#include <rigor/geometry.hpp>

#include <cmath>
#include <iostream>

using namespace rigor;

int main() {
  const Shape box = Box{Vec3(0.5, 0.5, 0.5)}, ball = Sphere{0.25};
  const Pose at_origin, above{Mat3::Identity(), Vec3(0, 0, 2)};

  const DistanceResult apart = signed_distance(box, at_origin, ball, above);
  std::cout << "distance " << apart.distance << " m\n";

  const MassProperties mass = mass_properties(box, 1000);
  std::cout << "mass " << mass.mass << " kg, inertia " << mass.inertia(0, 0) << " kg m2\n";

  // The ball falls at 1 m/s and spins: when does it touch the box?
  const TwistMotion rest(at_origin, Vec3::Zero(), Vec3::Zero());
  const TwistMotion fall(above, Vec3(0, 0, -1), Vec3(0, 9, 0));
  const TimeOfContact touch = find_time_of_contact({&box, Pose(), &rest}, {&ball, Pose(), &fall}, 0, 10);
  std::cout << "contact at " << touch.upper << " s\n";

  const bool is_right = std::abs(apart.distance - 1.25) < 1e-12 && std::abs(mass.mass - 1000) < 1e-9 &&
                        touch.is_contact && std::abs(touch.upper - 1.25) < 1e-9;
  return is_right ? 0 : 1;
}
