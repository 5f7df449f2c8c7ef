#pragma once

#include "rigor/bulk/bulk_world.hpp"
#include "rigor/core/index.hpp"
#include "rigor/model/model_editor.hpp"
#include "rigor/model/scene_queries.hpp"
#include "rigor/sim/bulk/bulk_arrays.hpp"
#include "rigor/sim/bulk/bulk_handles.hpp"
#include "rigor/sim/bulk/bulk_joint_readings.hpp"
#include "rigor/sim/bulk/bulk_sensors.hpp"

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

namespace rigor {

/// Many bodies, for an application that runs step by step and acts on them while they move
/// (docs/bulk_api.md). All positions and vectors are in W, poses are those of the user's frames L, as in
/// scene files.
///
/// Bodies, joints, materials and sensors that come and go are named by handles: a call with a wrong one
/// returns what is wrong (BulkStatus) or nothing (std::optional), and changes nothing. Bodies of a scene that
/// stays may be named by their index in the Model too; there a broken precondition (an index that does not
/// exist, a force on a body that is not dynamic) ends the program with a message, as everywhere in the C++
/// interface. Wrong descriptions are an InputError, after which all is as before.
///
/// The motion depends on the State and on the calls since then, and on nothing else: neither on the number of
/// threads nor on queries.
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
  const Model& model() const {
    settle_joints();
    return *model_;
  }
  /// All that is needed to continue bit for bit from between two steps, without the forces given for the next
  /// one.
  State state() const;
  void set_state(const State& state);

  // Where bodies are.
  Pose pose(int body) const;
  Vec3 velocity(int body) const;          ///< Of the centre of mass [m/s].
  Vec3 angular_velocity(int body) const;  ///< [rad/s].
  bool is_asleep(int body) const {
    settle_joints();
    return world_->is_asleep(body);
  }

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

  // Bodies, joints and materials that come, go and change between two steps. None of it makes a new world:
  // what it costs depends on what it concerns, but for lists that a step goes through anyway.
  /// The handle of a body of the Model by its index or its name; one that names nothing if there is none.
  BodyId body(int index) const { return body_ids_.id_of(index); }
  BodyId find_body(std::string_view name) const;
  /// All bodies that are there, by index.
  std::vector<BodyId> bodies() const { return body_ids_.all(); }
  bool is_there(const BodyId& body) const { return body_ids_.place_of(body).has_value(); }
  /// Its index in model(), as long as it is there.
  std::optional<int> index_of(const BodyId& body) const { return body_ids_.place_of(body); }
  /// A body as it is described, from now on; of the same name as none that is there (without a name it is
  /// called by its place). A kinematic body that has a velocity is at its place now; times of a path are
  /// those of time().
  BodyId add_body(const BodyDescription& description);
  /// Removes it with its joints, their gears, and forces of the scene on it. What touched it wakes.
  BulkStatus remove_body(const BodyId& body);
  /// Another body in its place, with its handle, name, pose, velocities and joints.
  BulkStatus replace_body(const BodyId& body, const BodyDescription& description);
  /// With whom it collides, from the next step on.
  BulkStatus set_filter(const BodyId& body, std::uint32_t group, std::uint32_t mask);
  /// Whether two bodies never collide, whatever their groups.
  BulkStatus exclude_pair(const BodyId& a, const BodyId& b, bool is_excluded = true);

  JointId joint(int index) const;
  JointId find_joint(std::string_view name) const;
  std::optional<int> index_of(const JointId& joint) const;
  /// A joint between two bodies (world_end: the world) as they are now: anchors and axes are in W now, and
  /// its coordinates begin at 0. The bodies of the description are not read. Nothing if a handle is wrong.
  std::optional<JointId> add_joint(const ModelBuilder::JointDescription& description, const BodyId& a,
                                   const BodyId& b);
  /// A gear between two joints; nothing if a handle is wrong.
  std::optional<JointId> add_gear(const ModelBuilder::JointDescription& description, const JointId& first,
                                  const JointId& second);
  BulkStatus remove_joint(const JointId& joint);
  /// Limits, motor, spring, damper and dry friction along a coordinate.
  BulkStatus set_axis(const JointId& joint, int coordinate, const JointAxis& laws);
  BulkStatus set_motor(const JointId& joint, int coordinate, const std::optional<JointMotor>& motor);
  /// Where a joint stands now, and what it did in the last substep of the last step; nothing if the handle is
  /// wrong.
  std::optional<JointReading> read_joint(const JointId& joint) const;

  MaterialId find_material(std::string_view name) const;
  MaterialId add_material(const Material& material);
  /// Another material of the same name. Densities count for bodies that come later.
  BulkStatus set_material(const MaterialId& material, const Material& to);
  BulkStatus set_pair(const MaterialId& a, const MaterialId& b, const PairCoefficients& coefficients);
  /// Not that of a shape that is there, nor the default one.
  BulkStatus remove_material(const MaterialId& material);
  void set_gravity(const Vec3& g_W);  ///< [m/s²].

  // The calls above for bodies by their handles.
  std::optional<Pose> pose(const BodyId& body) const;
  std::optional<Vec3> velocity(const BodyId& body) const;
  std::optional<Vec3> angular_velocity(const BodyId& body) const;
  std::optional<bool> is_asleep(const BodyId& body) const;
  BulkStatus apply_force(const BodyId& body, const Vec3& f_W);
  BulkStatus apply_force(const BodyId& body, const Vec3& f_W, const Vec3& p_W);
  BulkStatus apply_torque(const BodyId& body, const Vec3& tau_W);
  BulkStatus apply_impulse(const BodyId& body, const Vec3& j_W);
  BulkStatus apply_impulse(const BodyId& body, const Vec3& j_W, const Vec3& p_W);
  BulkStatus apply_angular_impulse(const BodyId& body, const Vec3& l_W);
  BulkStatus wake(const BodyId& body);
  BulkStatus move_to(const BodyId& body, const Pose& X_WU);
  BulkStatus set_pose(const BodyId& body, const Pose& X_WU);
  BulkStatus set_velocity(const BodyId& body, const Vec3& v_W, const Vec3& w_W);

  // All at once.
  BodyArrays body_arrays() const;
  ContactArrays contact_arrays() const;
  ContactLoads contact_loads() const;
  JointArrays joint_arrays() const;

  // Sensors: after each step they know whom they overlap.
  /// A sensor; a handle that names nothing if its body is not there.
  SensorId add_sensor(const SensorDescription& description);
  BulkStatus remove_sensor(const SensorId& sensor);
  /// Bodies that overlapped it at the end of the last step; nothing if the handle is wrong.
  std::optional<std::vector<BodyId>> overlaps(const SensorId& sensor) const;
  /// What began and ended in the last step, by sensor, ends first.
  const std::vector<SensorEvent>& sensor_events() const { return sensors_.events(); }

  /// Continues with another Model: bodies and joints of the same names are the same (carried_state). Body
  /// indices are those of the new Model from now on, and handles name nothing more; forces and targets of the
  /// next step are forgotten.
  void set_model(std::shared_ptr<const Model> model);
  /// See PairFinder::set_contact_filter.
  void set_contact_filter(std::function<bool(int, int)> may_touch);

  // Events of the last step.
  /// The contacts that touched or nearly did, with their impulses over the step, in the order of bodies, but
  /// for those of bodies that have come, gone or become others since then.
  std::vector<BulkContact> contacts() const;
  /// Contacts that began in it at no less than this speed of approach [m/s].
  std::vector<BulkContact> hits(double least_speed) const { return find_hits(contacts(), least_speed); }
  /// Pairs of shapes that began to press on each other, or ceased to; without those of such bodies.
  std::vector<ContactEvent> events() const;

  /// Rays, moving shapes, nearest bodies and overlaps for the bodies as they are now; valid until the next
  /// step or change.
  const SceneQueries& queries() const;

 private:
  void start(const State& state);
  Vec3 centre(int body) const { return world_->bodies().x[at(body)]; }
  void name_all();
  void begin_edit();
  void make_room_for_one();
  void begin_anew(int places);
  void retire_leaving_joints();
  void settle_joints() const;
  JointId name_joint();
  std::optional<int> unsettled_index_of(const JointId& joint) const;
  JointReading reading_of(int joint) const;
  void has_changed(int place);
  /// Whether a body came, went or became another since the last step.
  bool is_new(int place) const { return at(place) < changed_.size() && changed_[at(place)] != 0; }
  template <class Act>
  BulkStatus act_on(const BodyId& body, const std::array<Vec3, 2>& numbers, const Act& act);
  template <class Act>
  BulkStatus lead(const BodyId& body, const Pose& X_WU, bool is_dynamic_too, const Act& act);

  std::shared_ptr<const Model> model_;
  Options options_;
  std::function<bool(int, int)> may_touch_;
  std::unique_ptr<BulkWorld> world_;
  std::unique_ptr<ModelEditor> editor_;  ///< From the first change on: then model_ is its own.
  long removed_ = 0;                     ///< Bodies that went since the world was made.
  HandleTable<BodyKind> body_ids_;
  HandleTable<JointKind> joint_ids_;
  mutable std::vector<int> joint_places_;  ///< Of the joints of the Model, by index.
  HandleTable<MaterialKind> material_ids_;
  BulkSensors sensors_;
  std::vector<char> changed_;  ///< See is_new(); by place, empty if none is.
  std::optional<std::vector<BulkContact>>
      kept_contacts_;          ///< Of the last step, if this world did not take it.
  std::vector<Vec3> centers_;  ///< Of the bodies at the beginning of the last step [m].
  State template_;             ///< The parts of a State that the world does not hold.
  ManifoldMemories before_;    ///< Contacts at the beginning of the last step.
  mutable std::unique_ptr<SceneQueries> queries_;
  mutable bool is_asked_ = false;  ///< Whether the queries are up to date.
};

}  // namespace rigor
