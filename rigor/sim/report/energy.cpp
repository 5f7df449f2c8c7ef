#include "rigor/sim/report/energy.hpp"

#include "rigor/dynamics/environment.hpp"
#include "rigor/math/compensated_sum.hpp"
#include "rigor/math/rotation.hpp"
#include "rigor/model/state.hpp"

namespace rigor {

Energy mechanical_energy(const Model& model, const Environment& environment, const State& state) {
  // Kinetic energy of the dynamic bodies, and their potential energy in steady forces.
  CompensatedSum kinetic, potential;
  for (int i = 0; i < model.body_count(); ++i) {
    const Body& body = model.body(i);
    if (body.motion != MotionType::dynamic) continue;
    const BodyPhase phase{state.position(i), state.orientation(i), state.linear_momentum(i),
                          state.angular_momentum(i)};
    kinetic.add(kinetic_energy(BodyInertia{body.mass, body.moments}, phase));
    potential.add(environment.potential(i, phase.x));
  }
  // Elastic energy: springs between bodies, then the springs that penalty and bulk contacts remember.
  const auto view = [&](int i) {
    return Environment::BodyView{state.position(i), linear_velocity(model, state, i),
                                 angular_velocity(model, state, i), rotation_matrix(state.orientation(i)),
                                 model.body(i).motion == MotionType::dynamic};
  };
  CompensatedSum elastic;
  elastic.add(environment.spring_energy(view));
  for (const ContactMemory& contact : state.contacts) elastic.add(contact.energy);
  for (const ManifoldMemory& manifold : state.manifolds) elastic.add(manifold.energy);
  return {kinetic.value(), potential.value(), elastic.value()};
}

Momentum total_momentum(const Model& model, const State& state) {
  Momentum sum;
  for (int i = 0; i < model.body_count(); ++i) {
    if (model.body(i).motion != MotionType::dynamic) continue;
    sum.linear += state.linear_momentum(i);
    sum.angular += state.angular_momentum(i) + state.position(i).cross(state.linear_momentum(i));
  }
  return sum;
}

}  // namespace rigor
