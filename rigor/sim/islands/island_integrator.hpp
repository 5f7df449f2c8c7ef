#pragma once

#include "rigor/dynamics/integrator.hpp"
#include "rigor/sim/islands/contact_system_assembler.hpp"
#include "rigor/sim/islands/island.hpp"
#include "rigor/sim/method/method.hpp"

#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace rigor {

/// A step whose size the error estimate chose, and the size it suggests for the next.
struct ControlledStep {
  IslandStep step;
  double h_next;  ///< [s]; infinite if the method has no estimate.
  /// The least time in which one of its slips would end, opposed, where it begins [s]; infinite if none
  /// slides.
  double slip_time = std::numeric_limits<double>::infinity();
};

/// Smooth motion of islands: the contact forces are solved for at every stage of the integrator, so that its
/// order survives the contacts.
class IslandIntegrator {
 public:
  /// Holds references to all but the method. The assembler is of the same model and environment.
  /// target_step: of islands with contacts at most [s].
  IslandIntegrator(const Model& model, const Environment& environment,
                   const ContactSystemAssembler& assembler, const Method& method, double target_step = 0);

  /// Chooses the rows of the island's redundant joints that count, where a step begins.
  void choose_joint_rows(Island& island) const;
  /// One step of exactly h with the contact modes held fixed; is_stiff: by the integrator for stiff forces.
  IslandStep step(const Island& island, double h, bool is_stiff = false) const;
  /// The step that was taken, again with another end: of the same kind.
  IslandStep repeated(const Island& island, double h, const IslandStep& taken) const;
  /// Of the size of a step: the shortest and the longest possible, and the target step that it is part of.
  struct StepBounds {
    double least, longest, whole;  ///< [s].
    bool needs_path = true;        ///< Whether the motion within the step is asked for.
    /// The slip time of the step whose error suggested the size of this one; infinite where nothing slid or
    /// nothing suggests one.
    double slip_time = std::numeric_limits<double>::infinity();
  };
  /// A step of at most h, shorter where the error estimate asks for it, but not shorter than the least: there
  /// `error` may exceed 1. Where explicit steps would have to be shorter than a ten-thousandth of the whole
  /// step because forces are stiff, the integrator for them takes over; what even it would resolve in steps
  /// below a sixty-fourth only, it damps.
  ControlledStep controlled_step(const Island& island, double h, const StepBounds& bounds) const;
  /// A first-order step at velocity level (Moreau-Jean): impulses of the whole step by one Coulomb problem on
  /// all contacts, whatever their modes. It never fails where slip directions change faster than an
  /// integrator can follow or where forces have no finite value (Painlevé). It ends where no contact
  /// overlaps, and where nothing but gravity and contacts act it takes energy only. Source: Moreau,
  /// Unilateral Contact and Dry Friction in Finite Freedom Dynamics, CISM 302, 1988.
  IslandStep implicit_step(const Island& island, double h) const;

 private:
  struct Load;  ///< All wrenches at one stage with their part of the ledger.
  Load load(const Island& island, double t, std::span<const BodyPhase> phases) const;
  /// Puts the end of an implicit step on its contacts, without more energy than the step began with.
  void close_implicit_step(const Island& island, IslandStep& step) const;
  IntegratorName integrator_for(const Island& island) const;
  ControlledStep stiff_step(const Island& island, double damped, const StepBounds& bounds) const;
  bool is_only_dragged(const Island& island) const;
  IslandStep dragged_step(const Island& island, double h) const;
  bool is_free(const Island& island) const;
  double energy_of(const Island& island, double t, const std::vector<BodyPhase>& phases) const;
  double spring_energy_of(const Island& island, double t, const std::vector<BodyPhase>& phases) const;
  /// Energies of a step [J].
  struct Gain {
    double energy, scale, rounding;
  };
  Gain gain_of(const Island& island, const IslandStep& step) const;
  double energy_error(const Island& island, const IslandStep& step) const;
  bool gains(const Island& island, const IslandStep& step) const;
  bool has_exploded(const Island& island, const IslandStep& step) const;
  /// Closes the books of a stiff step that is coarser than its tolerance; false if it gained more energy than
  /// can be taken from it.
  bool close_stiff_step(const Island& island, IslandStep& step) const;
  IntegratorTolerances tolerances(const Island& island) const;
  enum class StepKind { with_path, end_only, stiff };
  double slip_time(const Island& island, const Load& load) const;
  /// `first`: the load where the step begins, which is found once for all its tries.
  IslandStep step_of(StepKind kind, const Island& island, double h, std::optional<Load>& first) const;

  const Model& model_;
  const Environment& environment_;
  const ContactSystemAssembler& assembler_;
  IntegratorMethod integrator_;
  double target_step_;
  OrientationForm orientation_;
  double tolerance_;
  double direction_tolerance_;
  double resting_velocity_;
  bool moves_prescribed_;  ///< Whether a prescribed body moves: its springs' work is not booked step by step.
  RestingChoice resting_;
};

}  // namespace rigor
