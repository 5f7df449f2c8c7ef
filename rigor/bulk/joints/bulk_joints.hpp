#pragma once

#include "rigor/bulk/state/bulk_bodies.hpp"
#include "rigor/bulk/threads/executor.hpp"
#include "rigor/geometry/lanes/lane_target.hpp"

#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace rigor {

/// What the joints do within a substep of length h.
enum class JointPass {
  places,       ///< Before the displacements: joints hold after the time h.
  places_anew,  ///< The same for callers that have repeated, as a guess, what all constraints changed in the
                ///< substep before, or have gone on from a first call: what of it was of the joints is taken
                ///< back.
  rates,        ///< After the displacements: rates are what joints allow, after impacts at limits too.
};

/// The joints of the many-body path, eight systems at a time: what they hold, their limits, motors, springs,
/// dampers and dry friction. Trees of joints are solved in a time that grows with their number; systems with
/// loops or gears by a sparse factorisation. Derivation: docs/theory/bulk_joints.md.
///
/// A step is prepare(), then for each substep: forces on the velocities, solve(places), displacements
/// (dp += h v, turn_further()), solve(rates). Of a substep the next one knows by its impulses what is taut
/// (taut_links.hpp), and nothing else; nothing of what joints have done to velocities may be done again in
/// the next substep: joints turn.
class BulkJoints {
 public:
  explicit BulkJoints(const Model& model, LaneTarget target = best_lane_target());
  ~BulkJoints();
  BulkJoints(const BulkJoints&) = delete;
  BulkJoints& operator=(const BulkJoints&) = delete;

  /// Limits of coordinates have changed in the Model; other numbers are read where they are used.
  void take_limits();
  /// At the beginning of a step of substeps of h > 0 [s]; after begin_bulk_step(). The bodies stay where they
  /// are in memory until its end. `impulses`: those of the substep before, as read_impulses() gives them,
  /// which tell what is taut; none if it is not known.
  void prepare(BulkBodies& bodies, double h, const Executor& executor,
               const std::vector<float>& impulses = {});
  /// Trees of ball joints without laws that touch nothing need not wait for the contacts between substeps.
  /// touches: whether each body may touch another in the step, is on a spring or turns fast near another.
  /// Before prepare(), which leaves them out; none are free in steps for which this is not called.
  void find_contact_free_chains(const BulkBodies& bodies, const std::vector<char>& touches);
  /// Whether there are trees that may be free in a step.
  bool may_have_contact_free_chains() const;
  bool is_free(int body) const;
  /// The whole step of their bodies but for what end_bulk_step() does; accelerations by body, as in
  /// BulkWorld. After prepare().
  void advance_contact_free_chains(const std::vector<MotionRow>& accelerations, int substeps,
                                   BulkBodies& bodies, const Executor& executor);
  void solve(JointPass pass, const Executor& executor);
  /// After prepare(): `flies`, by body, tells which touch nothing; those of systems of which one does, or on
  /// which laws other than limits act, are no longer marked.
  void find_flying(const BulkBodies& bodies, std::vector<char>& flies);
  /// Of the systems of those that are left, but for contact-free chains: rates are what joints allow, before
  /// the first substep and after the last one (`are_displaced`), and the impulses of no substep.
  void solve_rates_of_flying(bool are_displaced, const Executor& executor);
  /// solve(places_anew), then, of systems that nothing holds which moves as it must, the displacements and
  /// solve(rates) at once, while they are in the cache.
  void solve_and_displace(BulkBodies& bodies, const Executor& executor);
  /// Whether that displaces the body in this step.
  bool displaces(int body) const;
  /// solve(rates) of the other systems, once all others are displaced.
  void solve_rates_of_driven(const Executor& executor);
  /// Notes what joints have done in the substep, ...
  void keep_impulses();
  /// ... and makes it that again for the joints for which is_wanted(joint): after trials.
  void take_back_impulses(const std::function<bool(int)>& is_wanted);
  /// Raises the inertia of what the impulses of the last solve hold far more tautly than those before, until
  /// the substep ends (taut_links.hpp).
  void hold_tauter();
  /// Raises the inertia with which contacts move the bodies that joints hold taut to that with which joints
  /// do.
  void raise_inertia(BulkBodies& bodies) const;
  /// Whether there are systems with loops.
  bool has_loops() const;
  /// Bound of the frequencies [rad/s] of the vibrations that the forces of the last substep hold in systems
  /// with loops: a chain that is taut between two ends swings across itself, which substeps must resolve.
  double fastest_vibration() const;
  /// Of the last substep [N s] and [N m s]: six a joint, in the order of the Model's joints: of its rows in
  /// their order, on body B. Joints of bodies that sleep keep what they have there.
  void read_impulses(const BulkBodies& bodies, std::vector<float>& impulses) const;
  /// How far the worst joint is off [m] (angles count at a lever of the larger arm, at least the length scale
  /// of the model) at the beginning of a step, and which it is (-1: none).
  std::pair<double, int> worst_error(const BulkBodies& bodies) const;

 private:
  struct Blocks;
  std::unique_ptr<Blocks> blocks_;
};

}  // namespace rigor
