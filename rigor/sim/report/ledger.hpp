#pragma once

#include "rigor/dynamics/body_phase.hpp"
#include "rigor/sim/report/advance_report.hpp"

#include <initializer_list>
#include <vector>

namespace rigor {

class Model;

/// Totals over some dynamic bodies.
struct BodyTotals {
  Vec3 P = Vec3::Zero();  ///< Momentum [kg m/s].
  Vec3 L = Vec3::Zero();  ///< Angular momentum about the origin of W [kg m²/s].
  double T = 0;           ///< Kinetic energy [J].
  double P_norms = 0;     ///< Σ |P| [kg m/s].
  double L_norms = 0;     ///< Σ |L| + |x| |P|: of moments about the origin of W [kg m²/s].
};
/// Totals of bodies (model indices) in these phases, one per body.
BodyTotals totals_of(const Model& model, const std::vector<int>& bodies,
                     const std::vector<BodyPhase>& phases);

/// The account of the report to which a change of momenta charges the kinetic energy that it takes.
enum class EnergyAccount {
  impact,          ///< impact_loss, or impact_gain where the change added energy.
  plastic_impact,  ///< impact_loss, whichever sign the change has.
  projection,      ///< projection_loss.
};

/// Keeps the energy ledger while impulses act on some bodies: takes their kinetic energy and the work booked
/// so far when it is opened, and at the end of its scope charges the account with what the bodies have lost
/// and what the work has supplied meanwhile. Refers to the phases and the report, which must outlive it.
class EnergyScope {
 public:
  EnergyScope(EnergyAccount account, const Model& model, const std::vector<int>& bodies,
              const std::vector<BodyPhase>& phases, AdvanceReport& report);
  ~EnergyScope();
  EnergyScope(const EnergyScope&) = delete;
  EnergyScope& operator=(const EnergyScope&) = delete;

  /// Work that is booked in the report while the scope is open is noticed.
 private:
  EnergyAccount account_;
  const Model& model_;
  const std::vector<int>& bodies_;
  const std::vector<BodyPhase>& phases_;
  AdvanceReport& report_;
  double T_before_;     ///< [J].
  double work_before_;  ///< Booked when the scope was opened [J].
};

/// Keeps the ledger of the momenta: takes those of some bodies when it is made. Refers to the phases, which
/// must outlive it.
class MomentumScope {
 public:
  MomentumScope(const Model& model, const std::vector<int>& bodies, const std::vector<BodyPhase>& phases);

  /// Books as errors of the report what the momenta have changed by since then without being given it by
  /// these impulses from outside (f_W [N s], tau_W about the origin of W [N m s]).
  void book_error(std::initializer_list<Wrench> external, AdvanceReport& report) const;
  /// Adds the change of the momenta since then to the impulses [N s], [N m s] of what stands still around the
  /// bodies.
  void add_change(Vec3& impulse, Vec3& angular_impulse) const;

 private:
  const Model& model_;
  const std::vector<int>& bodies_;
  const std::vector<BodyPhase>& phases_;
  BodyTotals before_;
};

}  // namespace rigor
