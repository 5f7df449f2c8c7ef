#pragma once

#include "rigor/api/inputs.hpp"
#include "rigor/io/scene/scene_reader.hpp"
#include "rigor/model/state.hpp"
#include "rigor/sim/audit/audit.hpp"
#include "rigor/sim/audit/contact_snapshot.hpp"
#include "rigor/sim/fixed_steps/stepper.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rigor {

class BulkStepper;

/// A scheme at work on a scene whose inputs may change between two advances. A change is a new Model with the
/// same State and a new stepper, as in the live simulation; what it gives to the energy is booked as work.
/// The substep scheme takes loads without a new Model.
class SimulationEngine {
 public:
  /// Throws InputError if the scheme refuses the scene, or bodies overlap; separate: they are pushed apart.
  SimulationEngine(Scene scene, bool separate);
  ~SimulationEngine();

  const Scene& scene() const { return scene_; }
  /// The scene with the changes of the last advance.
  const Model& model() const { return *model_; }
  const Method& method() const { return choice_.method; }  ///< With the scheme that `auto` has chosen.
  const State& state() const { return state_; }
  SimulationInputs& inputs() { return inputs_; }
  const SimulationInputs& inputs() const { return inputs_; }
  void set_interrupt(std::function<bool()> interrupt);

  /// Says that the inputs have changed: the next advance follows them, and may try again after a stop.
  void inputs_changed();
  /// Advances to t under the loads besides those of the inputs. Throws SimulationStopped; Interrupted, with
  /// everything as it was.
  void advance(double t, const std::vector<BodyLoad>& loads);
  /// Changes the phase of a body at once; what that gives to the energy is work.
  void set_phase(int body, const Vec3& x, const Quat& q, const Vec3& P, const Vec3& L);
  /// Forgets what contacts of a body remember, since it is somewhere else.
  void forget_contacts(int body);
  /// Puts everything back to t = 0, with new books and the inputs that are set.
  void reset();

  /// Contacts now, with their forces under the inputs and loads of the last advance.
  std::vector<TouchingPoint> contacts() const;
  /// Joints now, with reactions and efforts likewise.
  std::vector<JointReaction> joint_forces() const;
  std::vector<JointReaction> joint_motions() const;
  /// Events since the last call, in their order; the newest `most_events` of them.
  std::vector<MotionEvent> take_events();
  static constexpr std::size_t most_events = 1'000'000;
  Audit audit() const;
  double energy() const;  ///< [J].

  /// Loads that wait: of the caller, of the controller.
  struct WaitingLoads {
    std::vector<BodyLoad> given, of_control;
  };
  /// All there is, with the loads that wait; and back. Throws InputError for bytes that are not from save()
  /// of this scene, and leaves everything as it was.
  std::string save(const WaitingLoads& loads) const;
  WaitingLoads restore(std::string_view bytes);

 private:
  void follow_inputs(const std::vector<BodyLoad>& loads);
  bool choose_scheme();
  void make_stepper_anew();
  void use(ModelChanges changes, std::vector<BodyLoad> loads);
  void wake();
  std::shared_ptr<const Model> model_with_loads() const;
  std::vector<BodyLoad> all_loads(const std::vector<BodyLoad>& loads) const;

  Scene scene_;
  /// Which scheme runs: `auto` chooses anew only where surfaces are others, on which it may depend.
  ResolvedMethod choice_;
  std::vector<ModelChanges::Surface> surfaces_;  ///< For which it has chosen.
  SimulationInputs inputs_;
  State state_;
  State start_;
  std::shared_ptr<const Model> model_;
  ModelChanges applied_;         ///< The changes of the inputs that are in the model.
  std::vector<BodyLoad> loads_;  ///< That act in the model, or in the stepper.
  bool inputs_changed_ = false;
  bool is_as_left_ = false;  ///< The State is the one that the stepper's last call has left.
  std::function<bool()> interrupt_;
  std::unique_ptr<Stepper> stepper_;
  BulkStepper* steps_in_bulk_ = nullptr;  ///< The stepper, if it is one of the many-body path.
  std::unique_ptr<Auditor> auditor_;
  std::vector<MotionEvent> events_;
};

}  // namespace rigor
