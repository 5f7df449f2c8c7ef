#pragma once

#include "rigor/bulk/bulk_step_report.hpp"
#include "rigor/bulk/narrow_phase/manifold.hpp"
#include "rigor/bulk/sleep/sleep.hpp"
#include "rigor/bulk/state/bulk_bodies.hpp"
#include "rigor/bulk/state/manifold_memories.hpp"
#include "rigor/bulk/threads/executor.hpp"
#include "rigor/dynamics/body_phase.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace rigor {

struct BulkSettings {
  int substeps = 6;       ///< >= 1, of equal length.
  int threads = 1;        ///< >= 1. The answer does not depend on it.
  bool measures = false;  ///< Whether a step reports impacts, work, errors of momentum and joints.
  bool sleeping = false;  ///< Whether bodies at rest are left alone (Sleepers).
  SleepRules sleep_rules;
};

/// The world of the many-body path, for thousands of bodies (docs/theory/bulk.md): the bodies and what their
/// contacts remember, read from a State and written back to it.
class BulkWorld {
 public:
  BulkWorld(std::shared_ptr<const Model> model, const BulkSettings& settings);
  ~BulkWorld();
  BulkWorld(const BulkWorld&) = delete;
  BulkWorld& operator=(const BulkWorld&) = delete;

  /// Applies a force [N] and a torque about the centre of mass [N m] to a dynamic body during the next step,
  /// in W, besides those that it has been given before. Wakes the body.
  void add_wrench(int body, const Wrench& wrench);
  /// Applies an impulse [N s] and an angular impulse about the centre of mass [N m s] to a dynamic body, in
  /// W, at once. Wakes the body.
  void add_impulse(int body, const Wrench& impulse);
  /// Moves a body to another place between two steps: the pose of its body frame; it keeps its velocities.
  /// Wakes the body and what it touched; a kinematic body wakes all bodies.
  void set_pose(int body, const Pose& X_WB);
  /// Sets the velocities of a dynamic body, in W [m/s, rad/s]. Wakes the body.
  void set_velocity(int body, const Vec3& v_W, const Vec3& w_W);
  /// Sets where a kinematic body without velocity and path (PrescribedBodies::is_free) is to be at the end of
  /// the next step: centre p_WB [m], orientation q_WB. It moves there at a constant velocity and stays there.
  void set_target(int body, const Vec3& x, const Quat& q);
  /// See PairFinder::set_contact_filter.
  void set_contact_filter(std::function<bool(int, int)> may_touch);
  /// Is called after each part of a step that is taken in parts but the last: the bodies are where they are
  /// then.
  void set_part_observer(std::function<void()> observer) { after_part_ = std::move(observer); }

  // After the Model was changed in place (ModelEditor). It keeps its number of bodies, and every shape that
  // it has had stays alive. All of it takes effect as a fresh world of the changed Model would have it.
  /// A body came, went, or became another: it is where the Model has it, with the velocities of t = 0, and
  /// awake.
  void change_body(int body);
  /// With what a body may collide, by its group and mask.
  void change_filter(int body);
  /// Joints came, went or became others, or bodies may collide that could not before: was[i] is the number
  /// that the joint i had before, or -1 if it is new. Wakes these bodies.
  void change_joints(const std::vector<int>& was, const std::vector<int>& concerned);
  /// The laws along the coordinates of a joint have other numbers. Wakes its bodies.
  void change_laws(int joint);
  /// There are more materials, or others (then all bodies are to be woken).
  void change_surfaces();
  void change_gravity();
  void wake_all();

  /// What another world of as many bodies or fewer was asked to do in its next step.
  void take_given(const BulkWorld& from);

  /// Lets all parts of the solver know of changes, as each step does at its beginning: before the memories of
  /// contacts or the State are asked for.
  void settle_changes();

  void read(const State& state);
  void write(State& state) const;
  /// The bodies alone: where they are and how they move.
  void write_bodies(State& state) const;
  /// Takes one step of h > 0 [s].
  BulkStepReport step(double h) { return step(h, h); }
  /// The first h of a step of the length `whole` >= h [s], after steps of that length: its springs and
  /// impulses are those of such steps. For a look at the bodies between two steps; what contacts remember of
  /// it is of no use.
  BulkStepReport step(double h, double whole);

  double time() const { return t_; }
  const BulkBodies& bodies() const { return bodies_; }
  bool is_asleep(int body) const;
  /// Wakes a body, and in the next step all that it touches.
  void wake(int body);
  /// All manifolds of the last step in the order of their keys, except those of sleeping bodies, for which
  /// nothing was computed.
  std::vector<BulkContact> contacts() const;
  /// The same without a list of them: how many points each has, in the order of keys, ...
  std::vector<int> contact_points() const;
  /// ... and visit(number, contact) for each whose impulses are known, in any order. number: its own in that
  /// of keys.
  void for_contacts(const std::function<void(std::size_t, const BulkContact&)>& visit) const;
  /// What joints have done in the last substep, as if all of the step's were as long: six rows a joint, as in
  /// State::joint_impulses (joint_impulse()).
  const std::vector<float>& joint_impulses() const;
  /// The memories of the contacts at the end of the last step, in the order of their keys.
  const ManifoldMemories& memory() const { return memory_; }

 private:
  struct Scratch;
  void forget_contacts_of_changed();
  BulkStepReport step_in_parts(double h, double whole, double least, double longest_taut);
  /// Takes a step with the pairs and manifolds that were found for it, or a part of one of `step` [s]. Where
  /// its substeps do not resolve what joints hold taut, or its contacts end too deep, and it may be shorter,
  /// it is taken back, and nothing is returned.
  std::optional<BulkStepReport> take_step(double h, double whole, double step);
  bool is_too_taut(double h) const;
  double shorter_part(double h) const;
  void stop_passing(double h);
  double pair_margin(double h) const;
  /// Moves the bodies and remembers what goes into the next step, after the velocities are final.
  void end_step(double h, BulkStepReport& report);
  void find_contacts(double h);
  void take_substep(bool is_first, float h);
  void find_direct_islands(double substep);
  int solve_directly(double h);
  void load_joints_of_held();
  void bounce_apart();
  bool settles_impacts() const;
  void find_touching_bodies();
  void find_bodies_outside_chains(double h);
  void integrate_velocities(bool is_first, float h);
  void integrate_positions(float h);

  struct Changes {
    std::vector<int> bodies;   ///< That came, went or became others; some more than once.
    std::vector<int> filters;  ///< That collide with others than before.
    std::vector<char> is_new;  ///< Whether it is one of `bodies`, by body; empty if there are none.
    bool are_ties_new = false;
    bool are_surfaces_new = false;
    bool is_any() const { return are_ties_new || !bodies.empty() || !filters.empty(); }
  };

  std::shared_ptr<const Model> model_;
  Changes changes_;  ///< That the next step has to know.
  BulkSettings settings_;
  double t_ = 0;  ///< [s].
  BulkBodies bodies_;
  ManifoldMemories memory_;
  std::function<void()> after_part_;
  std::unique_ptr<Scratch> scratch_;
};

}  // namespace rigor
