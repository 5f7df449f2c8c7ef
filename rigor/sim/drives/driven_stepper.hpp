#pragma once

#include "rigor/dynamics/environment.hpp"
#include "rigor/sim/drives/driven_model.hpp"
#include "rigor/sim/fixed_steps/stepper.hpp"
#include "rigor/sim/report/energy.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace rigor {

/// Any scheme on a model whose motors and forces are functions of the time. It divides a span into equal
/// steps of at most H, in each of which the scheme runs a model without drives; what these give to the energy
/// is booked as work, so that the energies are those of the model itself. Bodies that are driven do not
/// sleep.
class DrivenStepper : public Stepper {
 public:
  /// Makes a stepper of the scheme, which does not look at drives.
  using Maker = std::function<std::unique_ptr<Stepper>(std::shared_ptr<const Model>)>;
  /// target_step H > 0 [s].
  DrivenStepper(std::shared_ptr<const Model> model, double target_step, Maker make);

  bool follow(const std::shared_ptr<const Model>& changed) override;
  double time_rounding() const override;
  std::optional<std::vector<TouchingPoint>> contacts_of(const State& state) const override {
    return laws_ ? inner_->contacts_of(state) : std::nullopt;
  }

 protected:
  AdvanceReport advance_span(State& state, double t_end) override { return pass(state, t_end, t_end); }
  AdvanceReport look_span(State& state, double t_end, double t) override { return pass(state, t_end, t); }
  double time_reached() const override { return t_; }

 private:
  AdvanceReport pass(State& state, double t_end, double t_look);
  void follow_laws(State& state, double t_end);
  AdvanceReport booked_step(State& state, double t_end, double t);
  Energy driven_energy(const State& state) const;
  double work_of_efforts(const std::vector<double>& before, const State& after) const;

  std::shared_ptr<const Model> model_;
  Environment environment_;
  double target_step_;
  Maker make_;
  std::vector<int> driven_bodies_;
  std::optional<DrivenLaws> laws_;
  // Under the laws; from the first step on.
  std::shared_ptr<const Model> driven_;
  std::unique_ptr<Environment> driven_environment_;
  std::unique_ptr<Stepper> inner_;
  double t_ = 0;
};

}  // namespace rigor
