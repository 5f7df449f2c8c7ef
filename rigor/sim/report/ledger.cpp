#include "rigor/sim/report/ledger.hpp"

#include "rigor/model/model.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

BodyTotals totals_of(const Model& model, const std::vector<int>& bodies,
                     const std::vector<BodyPhase>& phases) {
  BodyTotals sum;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const Body& body = model.body(bodies[i]);
    const BodyPhase& phase = phases[i];
    sum.P += phase.P;
    sum.L += phase.L + phase.x.cross(phase.P);
    sum.P_norms += phase.P.norm();
    sum.L_norms += phase.L.norm() + phase.x.norm() * phase.P.norm();
    sum.T += kinetic_energy(BodyInertia{body.mass, body.moments}, phase);
  }
  return sum;
}

EnergyScope::EnergyScope(EnergyAccount account, const Model& model, const std::vector<int>& bodies,
                         const std::vector<BodyPhase>& phases, AdvanceReport& report)
    : account_(account),
      model_(model),
      bodies_(bodies),
      phases_(phases),
      report_(report),
      T_before_(totals_of(model, bodies, phases).T),
      work_before_(report.work) {}

EnergyScope::~EnergyScope() {
  const double supplied = report_.work - work_before_;
  const double taken = T_before_ - totals_of(model_, bodies_, phases_).T + supplied;
  switch (account_) {
    case EnergyAccount::impact:
      (taken > 0 ? report_.impact_loss : report_.impact_gain) += std::abs(taken);
      break;
    case EnergyAccount::plastic_impact:
      report_.impact_loss += taken;
      break;
    case EnergyAccount::projection:
      report_.projection_loss += taken;
      break;
  }
}

MomentumScope::MomentumScope(const Model& model, const std::vector<int>& bodies,
                             const std::vector<BodyPhase>& phases)
    : model_(model), bodies_(bodies), phases_(phases), before_(totals_of(model, bodies, phases)) {}

void MomentumScope::book_error(std::initializer_list<Wrench> external, AdvanceReport& report) const {
  const BodyTotals after = totals_of(model_, bodies_, phases_);
  Vec3 P = after.P - before_.P, L = after.L - before_.L;
  for (const Wrench& impulse : external) {
    P -= impulse.f_W;
    L -= impulse.tau_W;
  }
  report.momentum_error += P;
  report.angular_momentum_error += L;
  report.moved_energy = std::max({report.moved_energy, before_.T, after.T});
  report.moved_momentum = std::max({report.moved_momentum, before_.P_norms, after.P_norms});
  report.moved_angular_momentum = std::max({report.moved_angular_momentum, before_.L_norms, after.L_norms});
}

void MomentumScope::add_change(Vec3& impulse, Vec3& angular_impulse) const {
  const BodyTotals after = totals_of(model_, bodies_, phases_);
  impulse += after.P - before_.P;
  angular_impulse += after.L - before_.L;
}

}  // namespace rigor
