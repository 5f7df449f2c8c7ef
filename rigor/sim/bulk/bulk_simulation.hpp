#pragma once

#include "rigor/bulk/bulk_world.hpp"
#include "rigor/core/index.hpp"
#include "rigor/model/scene_queries.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace rigor {

/// Many bodies, for an application that runs step by step and acts on them while they move
/// (docs/bulk_api.md). Bodies are the Model's, by index (Model::find_body has them by name); all positions
/// and vectors are in W, poses are those of the user's frames L, as in scene files.
///
/// The motion depends on the State and on the calls since then, and on nothing else: neither on the number of
/// threads nor on queries. A broken precondition (an index that does not exist, a force on a body that is not
/// dynamic) ends the program with a message, as everywhere in the C++ interface.
class BulkSimulation {
 public:
  struct Options {
    double step = 1.0 / 60;  ///< Of each step [s], > 0.
    int substeps = 6;        ///< Per step, >= 1.
    int threads = 1;         ///< >= 1.
    bool sleeping = true;    ///< Whether bodies at rest are left alone.
    /// Whether step() reports impacts, work and the error of momentum, for an audit; contacts(), hits() and
    /// events() do not need it.
    bool measures = false;
  };

  /// Starts from the Model's own initial state.
  explicit BulkSimulation(std::shared_ptr<const Model> model);
  BulkSimulation(std::shared_ptr<const Model> model, const Options& options);
  ~BulkSimulation();
  BulkSimulation(const BulkSimulation&) = delete;
  BulkSimulation& operator=(const BulkSimulation&) = delete;

  /// Advances by one step.
  BulkStepReport step();
  double time() const { return world_->time(); }  ///< [s].
  const Model& model() const { return *model_; }
  /// All that is needed to continue bit for bit from between two steps, without the forces given for the next
  /// one.
  State state() const;
  void set_state(const State& state);

  // Where bodies are.
  Pose pose(int body) const;
  Vec3 velocity(int body) const;          ///< Of the centre of mass [m/s].
  Vec3 angular_velocity(int body) const;  ///< [rad/s].
  bool is_asleep(int body) const { return world_->is_asleep(body); }

  // Loads on dynamic bodies; each wakes its body.
  /// A force during the next step, at the centre of mass or at a point [N], [m]; several forces add up.
  void apply_force(int body, const Vec3& f_W);
  void apply_force(int body, const Vec3& f_W, const Vec3& p_W);
  void apply_torque(int body, const Vec3& tau_W);  ///< [N m].
  /// Impulses act at once [N s], [N m s].
  void apply_impulse(int body, const Vec3& j_W);
  void apply_impulse(int body, const Vec3& j_W, const Vec3& p_W);
  void apply_angular_impulse(int body, const Vec3& l_W);
  void wake(int body) { world_->wake(body); }

  /// Where a kinematic body without velocity and path is to be at the end of the next step. It moves there at
  /// constant velocity, carries and pushes what it touches, and then stays.
  void move_to(int body, const Pose& X_WU);
  /// Puts a body there at once, through whatever is in between; its velocities stay. For dynamic bodies, and
  /// for kinematic ones as in move_to().
  void set_pose(int body, const Pose& X_WU);
  void set_velocity(int body, const Vec3& v_W, const Vec3& w_W);  ///< Of a dynamic body.

  /// Continues with another Model: bodies and joints of the same names are the same (carried_state). Body
  /// indices are those of the new Model from now on; forces and targets of the next step are forgotten.
  void set_model(std::shared_ptr<const Model> model);
  /// See PairFinder::set_contact_filter.
  void set_contact_filter(std::function<bool(int, int)> may_touch);

  // Events of the last step.
  /// The contacts that touched or nearly did, with their impulses over the step, in the order of bodies.
  std::vector<BulkContact> contacts() const { return world_->contacts(); }
  /// Contacts that began in it at no less than this speed of approach [m/s].
  std::vector<BulkContact> hits(double least_speed) const { return find_hits(contacts(), least_speed); }
  /// Pairs of shapes that began to press on each other, or ceased to.
  std::vector<ContactEvent> events() const;

  /// Rays, moving shapes, nearest bodies and overlaps for the bodies as they are now; valid until the next
  /// step or change.
  const SceneQueries& queries() const;

 private:
  void start(const State& state);
  Vec3 centre(int body) const { return world_->bodies().x[at(body)]; }

  std::shared_ptr<const Model> model_;
  Options options_;
  std::function<bool(int, int)> may_touch_;
  std::unique_ptr<BulkWorld> world_;
  State template_;           ///< The parts of a State that the world does not hold.
  ManifoldMemories before_;  ///< Contacts at the beginning of the last step.
  mutable std::unique_ptr<SceneQueries> queries_;
  mutable bool is_asked_ = false;  ///< Whether the queries are up to date.
};

}  // namespace rigor
