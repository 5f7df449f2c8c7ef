// Time stepping with the exact solver on the scenes of many bodies.

#include "bulk_engines.hpp"

#include "rigor/sim/make_stepper.hpp"

namespace rigor::bench {

namespace {

class TimeSteppingEngine : public BulkEngine {
 public:
  TimeSteppingEngine(std::shared_ptr<const Model> model, const Method& method)
      : state_(make_initial_state(*model)), model_(std::move(model)), method_(method) {}
  void step(double h) override {
    if (!stepper_) stepper_ = make_stepper(model_, method_, h);
    stepper_->advance(state_, state_.t + h);
  }
  State state() const override { return state_; }

 private:
  State state_;
  std::shared_ptr<const Model> model_;
  Method method_;
  std::unique_ptr<Stepper> stepper_;
};

}  // namespace

std::unique_ptr<BulkEngine> make_time_stepping_engine(std::shared_ptr<const Model> model) {
  Method method;
  method.scheme = Scheme::time_stepping;
  return std::make_unique<TimeSteppingEngine>(std::move(model), method);
}

}  // namespace rigor::bench
