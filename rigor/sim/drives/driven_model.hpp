#pragma once

#include "rigor/model/model.hpp"
#include "rigor/model/state.hpp"

#include <memory>
#include <vector>

namespace rigor {

/// What the drives of a model are for a while: a motor or a spring for each drive of a joint, in their order,
/// and the efforts and factors of forces.
struct DrivenLaws {
  std::vector<JointAxis> axes;
  std::vector<double> efforts;  ///< One for each drive of a joint; 0 where it is only a motor or a spring.
  std::vector<double> factors;  ///< One for each drive of a force.
};
bool are_same(const DrivenLaws& a, const DrivenLaws& b);

/// The laws from the State's time to t_end [s], t_end >= state.t: functions are their means, so that
/// impulses and angles at t_end are right. A servo whose force at t_end would be beyond its largest one is
/// that force, or a motor where it would overshoot.
DrivenLaws driven_laws(const Model& model, const State& state, double t_end);

/// The coordinates of the drives of joints, in their order [rad] or [m].
std::vector<double> driven_coordinates(const Model& model, const State& state);

/// The model under these laws, without drives. Throws InputError where a function has left what is allowed.
std::shared_ptr<const Model> driven_model(const Model& model, const DrivenLaws& laws);

}  // namespace rigor
