#include "rigor/core/sorted_unique.hpp"
#include "rigor/sim/islands/energy_repair.hpp"
#include "rigor/sim/time_stepping/time_stepper.hpp"

#include <algorithm>

namespace rigor {

/// What is left of the error of the step where shorter ones were no help: the paths of bodies under one that
/// turns fast are curved, and a step takes a chord. Each part gives back what it has gained, of its motion
/// relative to what it touches.
void TimeStepper::take_gain(Trial& trial) const {
  double left = trial.gain;
  for (std::size_t k = 0; k < trial.parts.size() && left > 0; ++k) {
    const Cluster& part = trial.parts[k];
    if (part.contacts.empty()) continue;
    const EnergyBalance balance =
        energy_balance(*model_, environment_, trial.end.t, part.bodies, part.contacts);
    if (!balance.is_closed) continue;

    // What the part has gained beyond the work that it was done.
    std::vector<BodyPhase> phases;
    for (const int body : part.bodies) phases.push_back(trial.end.phase_of(body));
    const double gained = energy_of_bodies(*model_, environment_, trial.end.t, part.bodies, phases) -
                          energy_of_bodies(*model_, environment_, part.t, part.bodies, part.phases) -
                          trial.moved[k]->report.work;
    if (!(gained > 0)) continue;
    const TakenEnergy taken =
        take_kinetic_energy(*model_, part.bodies, std::min(gained, left), balance, phases);
    left -= taken.energy;
    trial.report.work += taken.work;
    for (std::size_t i = 0; i < part.bodies.size(); ++i) trial.end.phase_of(part.bodies[i]) = phases[i];
  }
}

}  // namespace rigor
