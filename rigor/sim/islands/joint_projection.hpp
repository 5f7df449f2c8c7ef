#pragma once

#include "rigor/sim/islands/contact_system_assembler.hpp"
#include "rigor/sim/report/advance_report.hpp"
#include "rigor/sim/report/unresolved.hpp"

#include <vector>

namespace rigor {

/// What keeps joints from drifting: positions and velocities are put back after each step.
class JointProjection {
 public:
  JointProjection(const Model& model, const ContactSystemAssembler& assembler)
      : model_(model), assembler_(assembler) {}

  /// Moves bodies back to where their joints hold, by the smallest displacements in the metric of the mass
  /// matrix (Newton's method); the momenta stay. One phase per body, of dynamic bodies with all that are
  /// jointed to them.
  void project_positions(double t, const std::vector<int>& bodies, std::vector<BodyPhase>& phases,
                         AdvanceReport& report) const;
  /// Gives bodies that joints hold to each other and to nothing else the sums of momenta that follow from the
  /// impulses of the step, by a velocity as of one rigid body, which no joint notices: what the integrator
  /// and the projection of positions leave would else add up. Other islands stay as they are; so do those
  /// with contacts after an accurate step.
  void restore_momenta(const Island& island, IslandStep& step) const;
  /// Puts velocities back to what the joints allow: the projection in the metric of the mass matrix.
  void project_velocities(Cluster& cluster, AdvanceReport& report) const;

 private:
  /// What closing the joints came to.
  struct Closed {
    double first_residual, residual;  ///< Largest |g| before and after [m or 1].
    int joint;                        ///< Which one that is.
    bool has_motors;                  ///< Whether there are motors without a limit of force.
  };
  /// The impulses of the joints of the system after which they have the rates that they want.
  void give_rates(const ContactSystem& system, Cluster& cluster, AdvanceReport& report) const;
  Unresolved loop_against_motor(const std::vector<int>& bodies) const;
  Closed close_joints(double t, const std::vector<int>& bodies, bool with_motors,
                      std::vector<BodyPhase>& phases) const;

  const Model& model_;
  const ContactSystemAssembler& assembler_;
};

}  // namespace rigor
