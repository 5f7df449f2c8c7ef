#pragma once

#include "rigor/bulk/broad_phase/pair_finder.hpp"
#include "rigor/bulk/bulk_world.hpp"
#include "rigor/bulk/contacts/bounce_limits.hpp"
#include "rigor/bulk/contacts/bulk_contacts.hpp"
#include "rigor/bulk/contacts/elastic_tilts.hpp"
#include "rigor/bulk/contacts/energy_bound.hpp"
#include "rigor/bulk/direct/direct_islands.hpp"
#include "rigor/bulk/gyroscopic/gyroscopic_terms.hpp"
#include "rigor/bulk/half_kicks.hpp"
#include "rigor/bulk/joints/bulk_joints.hpp"
#include "rigor/bulk/narrow_phase/hidden_sides.hpp"
#include "rigor/bulk/narrow_phase/narrow_phase.hpp"
#include "rigor/bulk/passing/passing_guard.hpp"
#include "rigor/bulk/settled_impacts.hpp"
#include "rigor/bulk/sleep/sleepers.hpp"
#include "rigor/bulk/state/flight_velocities.hpp"
#include "rigor/bulk/state/held_bodies.hpp"
#include "rigor/bulk/state/prescribed_bodies.hpp"
#include "rigor/bulk/step_balance.hpp"
#include "rigor/bulk/step_forces.hpp"

#include <optional>
#include <utility>
#include <vector>

namespace rigor {

/// The parts of a BulkWorld and their working memory.
struct BulkWorld::Scratch {
  Scratch(const Model& model, const BulkSettings& settings)
      : executor(settings.threads),
        pair_finder(model),
        narrow_phase(model),
        contacts(model),
        tilts(model),
        direct(model),
        joints(std::in_place, model),
        held(model),
        impacts(model),
        gyroscopic_terms(model),
        prescribed(model),
        bounce_limits(model),
        energy_bound(model),
        passing(model, settings.substeps),
        balance(model),
        forces(model) {}

  Executor executor;
  PairFinder pair_finder;
  NarrowPhase narrow_phase;
  HiddenSides hidden_sides;
  BulkContacts contacts;
  ElasticTilts tilts;
  DirectIslands direct;
  std::optional<BulkJoints> joints;  ///< Always there: made anew when joints come and go.
  HeldBodies held;
  SettledImpacts impacts;
  GyroscopicTerms gyroscopic_terms;
  PrescribedBodies prescribed;
  BounceLimits bounce_limits;
  EnergyBound energy_bound;
  PassingGuard passing;
  StepBalance balance;
  StepForces forces;
  FlightVelocities flight;
  HalfKicks half_kicks;
  std::optional<Sleepers> sleepers;  ///< Only if bodies may sleep.
  std::vector<ShapePair> pairs;
  ManifoldList manifolds;
  std::vector<float> joint_impulses;
  std::vector<MotionRow> turns;          ///< Changes of angular velocity in a substep, by gyroscopic terms.
  std::vector<MotionRow> unconstrained;  ///< Velocities of a substep before its constraints.
  std::vector<char> touches;  ///< Whether each body may touch another in the step, or a spring holds it.
  std::vector<char> waits;    ///< Whether each body does, or turns fast near another.
  std::vector<MotionRecord> motion_before;  ///< At the beginning of a step that may be taken back.
  double vibration = 0;                     ///< The fastest that taut joints have held in the step [rad/s].
  std::vector<int> outside_chains;          ///< Bodies that move and are not in a contact-free chain.
  std::vector<int> displaced_alone;         ///< Those of them that joints do not displace.
};

}  // namespace rigor
