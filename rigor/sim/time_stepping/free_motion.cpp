#include "rigor/sim/time_stepping/free_motion.hpp"

#include "rigor/core/sorted_unique.hpp"
#include "rigor/dynamics/free_flight.hpp"
#include "rigor/sim/islands/too_fast.hpp"
#include "rigor/sim/method/tolerances.hpp"
#include "rigor/sim/time_stepping/part_memory.hpp"

#include <algorithm>
#include <utility>

namespace rigor {

const FreeMotionMemory::Known* FreeMotionMemory::find(const Question& question) {
  const std::lock_guard lock(mutex_);
  const auto known = std::find_if(known_.begin(), known_.end(), [&](const Known& other) {
    return other.question.environment == question.environment && other.question.h == question.h &&
           other.question.bodies == question.bodies &&
           are_same_phases(other.question.phases, question.phases);
  });
  return known == known_.end() ? nullptr : &*known;
}

const FreeMotionMemory::Known& FreeMotionMemory::keep(Known known) {
  const std::lock_guard lock(mutex_);
  return known_.emplace_back(std::move(known));
}

FreeMotion::FreeMotion(const Model& model, const Environment& environment,
                       const ContactSystemAssembler& assembler, const JointProjection& joints,
                       const Method& method)
    : model_(model),
      environment_(environment),
      integrator_(model, environment, assembler, method),
      joints_(joints) {}

FreeEnd FreeMotion::fly(double h, const Cluster& part, FreeMotionMemory& memory,
                        AdvanceReport& report) const {
  FreeEnd result{.phases = part.phases};
  const auto is_forced = [this](const std::vector<int>& bodies) {
    return std::any_of(bodies.begin(), bodies.end(),
                       [this](int body) { return environment_.is_forced(body); });
  };
  if (!is_forced(part.bodies)) {
    for (std::size_t i = 0; i < part.bodies.size(); ++i)
      fly_freely(h, part.bodies[i], result.phases[i], result);
    return result;
  }

  for (Cluster& piece : connected_parts(part, {}, environment_)) {
    if (!is_forced(piece.bodies)) {
      for (const int body : piece.bodies)
        fly_freely(h, body, result.phases[place_of(part.bodies, body)], result);
      continue;
    }
    // What is known from an earlier try, or the integrator.
    FreeMotionMemory::Question question{&environment_, h, piece.bodies, piece.phases};
    const FreeMotionMemory::Known* known = memory.find(question);
    if (known == nullptr) {
      FreeMotionMemory::Known fresh{std::move(question), {}, {}};
      fresh.end = integrate(h, piece, fresh.report);
      known = &memory.keep(std::move(fresh));
    }
    for (std::size_t i = 0; i < piece.bodies.size(); ++i)
      result.phases[place_of(part.bodies, piece.bodies[i])] = known->end.phases[i];
    result.impulse += known->end.impulse;
    result.angular_impulse += known->end.angular_impulse;
    result.work += known->end.work;
    report.add(known->report);
  }
  return result;
}

/// The closed form under steady forces.
void FreeMotion::fly_freely(double h, int body, BodyPhase& phase, FreeEnd& end) const {
  const Body& of_model = model_.body(body);
  const BodyPhase start = phase;
  const FreeFlight flight(BodyInertia{of_model.mass, of_model.moments}, start, 0,
                          environment_.steady_acceleration(body));
  phase = flight.at(h);
  end.impulse += phase.P - start.P;
  end.angular_impulse += phase.x.cross(phase.P) - start.x.cross(start.P);
}

/// Steps of the integrator as its error allows, with positions projected on the joints after each.
FreeEnd FreeMotion::integrate(double h, const Cluster& part, AdvanceReport& report) const {
  FreeEnd result;
  Island island{part.bodies, part.phases, {}, {}, part.t};
  double left = h, wanted = h;
  // Damped steps are a sixty-fourth of h; so many parts are those whose books close in tiny ones only.
  constexpr long most_stiff_parts = 2000;
  for (long useless = 0, stiff = 0; left > 0;) {
    integrator_.choose_joint_rows(island);
    const ControlledStep taken = integrator_.controlled_step(
        island, std::min(left, wanted), {std::min(left, least_step_share * h), left, h, false});
    ++report.steps;
    if (taken.step.error > 1) ++report.coarse_steps;
    useless = taken.step.h < useless_share * h && taken.step.h < left ? useless + 1 : 0;
    stiff += taken.step.is_stiff ? 1 : 0;
    if (useless > most_useless_parts || stiff > most_stiff_parts)
      throw too_fast(model_, environment_, island.bodies, island.start, taken.step.h);
    report.quaternion_drift = std::max(report.quaternion_drift, taken.step.quaternion_drift);
    IslandStep step = taken.step;
    island.begin += step.h;
    joints_.project_positions(island.begin, island.bodies, step.end, report);
    result.impulse += step.impulse;
    result.angular_impulse += step.angular_impulse;
    result.work += step.work;
    island.start = std::move(step.end);
    left = step.h < left ? left - step.h : 0;
    wanted = std::max(taken.h_next, least_step_share * h);
  }
  result.phases = std::move(island.start);
  return result;
}

}  // namespace rigor
