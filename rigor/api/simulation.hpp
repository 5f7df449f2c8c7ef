#pragma once

#include "rigor/api/references.hpp"
#include "rigor/api/simulation_stopped.hpp"
#include "rigor/io/scene/scene_reader.hpp"
#include "rigor/model/scene_queries.hpp"
#include "rigor/sim/audit/audit.hpp"
#include "rigor/sim/audit/contact_snapshot.hpp"

#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace rigor {

/// n rows of numbers, one for each body, one after another in memory.
template <int columns>
using Rows = Eigen::Matrix<double, Eigen::Dynamic, columns, Eigen::RowMajor>;

/// A scene that runs step by step, in every scheme, while a program looks at it and acts on it (docs/cpp.md).
///
/// Bodies and joints are named by handle or by name; numbers are in SI units and in W unless said otherwise.
/// Poses are those of the user's frame of a body, as in scene files; velocities those of its centre of mass.
/// The motion is a function of the scene and of the calls that change something: same calls, same bits,
/// whether or not somebody looks, on any number of threads.
///
/// Errors: what the caller got wrong (a name, a number, something the scheme cannot do) is an InputError that
/// says what is allowed, and nothing has changed; an engine that cannot go on is a SimulationStopped. Nothing
/// ends the process. One object is used by one thread at a time.
class Simulation {
 public:
  /// Starts at t = 0. Throws InputError if the scheme refuses the scene, or if bodies overlap; with
  /// `separate` these are pushed apart.
  explicit Simulation(Scene scene, bool separate = false);
  /// The same of a scene that was built in code: method and run.step as in scene files.
  explicit Simulation(std::shared_ptr<const Model> model, const Method& method = {}, double step = 0.01);
  ~Simulation();
  /// What has been moved from can be assigned to and destroyed only.
  Simulation(Simulation&& other) noexcept;
  /// Likewise.
  Simulation& operator=(Simulation&& other) noexcept;

  /// An independent copy that continues with the same bits, with the same controller but without an
  /// interrupt.
  Simulation clone() const;

  // Time.
  double time() const;         ///< [s].
  double step_length() const;  ///< H, `run.step` of the scene [s].
  /// Advances by H, to the next multiple of H if the time is one.
  void step();
  /// Advances to t >= time() [s]; schemes of fixed steps divide the way into equal steps of at most H. Forces
  /// that were applied act all the way, and end with it.
  void advance_to(double t);
  /// Returns to t = 0 with new books; motors and materials stay as they are set.
  void reset();
  /// Asked at every event or step: true ends advance_to() with Interrupted, everything as it was at the last
  /// control instant.
  void set_interrupt(std::function<bool()> interrupt);

  // Who is there.
  /// The scene as it was given.
  const Scene& scene() const;
  /// The scene with what has been set since.
  const Model& model() const;
  /// Number of bodies.
  int body_count() const;
  /// Number of joints.
  int joint_count() const;
  /// The handle of a name. Throws InputError with the nearest name.
  BodyHandle body(std::string_view name) const;
  /// Likewise.
  JointHandle joint(std::string_view name) const;
  /// The name of a handle.
  const std::string& name(BodyHandle body) const;
  /// Likewise.
  const std::string& name(JointHandle joint) const;

  // Where bodies are.
  /// Of the user's frame, [m].
  Pose pose(const BodyReference& body) const;
  Vec3 position(const BodyReference& body) const;          ///< Origin of the user's frame [m].
  Quat orientation(const BodyReference& body) const;       ///< Of that frame.
  Vec3 velocity(const BodyReference& body) const;          ///< Of the centre of mass [m/s].
  Vec3 angular_velocity(const BodyReference& body) const;  ///< [rad/s].
  /// In the substep scheme; elsewhere nobody sleeps.
  bool is_asleep(const BodyReference& body) const;
  /// The same of all bodies, a row each in the order of the scene; valid until something changes.
  const Rows<3>& positions() const;
  const Rows<4>& orientations() const;  ///< w, x, y, z.
  /// Of the centres of mass [m/s].
  const Rows<3>& velocities() const;
  /// In W [rad/s].
  const Rows<3>& angular_velocities() const;

  // What acts until the end of the next step() or advance_to(), or, called by a controller, until the next
  // control instant. Several add up. On dynamic bodies.
  void apply_force(const BodyReference& body, const Vec3& f_W);  ///< At the centre of mass [N].
  /// At a point p_W [m]; its moment about the centre of mass is that of now, and stays.
  void apply_force(const BodyReference& body, const Vec3& f_W, const Vec3& p_W);
  void apply_torque(const BodyReference& body, const Vec3& tau_W);  ///< [N m].

  // What acts at once.
  void apply_impulse(const BodyReference& body, const Vec3& j_W);  ///< [N s].
  /// At a point p_W [m].
  void apply_impulse(const BodyReference& body, const Vec3& j_W, const Vec3& p_W);
  void apply_angular_impulse(const BodyReference& body, const Vec3& l_W);  ///< [N m s].
  /// A dynamic body is there at once, through whatever is between, and keeps its velocities; a kinematic one
  /// stays there.
  void set_pose(const BodyReference& body, const Pose& X_WU);
  /// Of the centre of mass [m/s], [rad/s]; a kinematic body goes on so until something else is set.
  void set_velocity(const BodyReference& body, const Vec3& v_W, const Vec3& w_W);
  /// Takes a kinematic body to that pose in `duration` > 0 [s], at constant velocities, where it then stays.
  void move_to(const BodyReference& body, const Pose& X_WU, double duration);

  // What stays until it is set again. `coordinate` is one of the joint's (docs/scene.md), from 0.
  /// A motor that holds a rate [rad/s] or [m/s], as far as its force [N m] or [N] goes.
  void set_motor_velocity(const JointReference& joint, double velocity,
                          double max_force = std::numeric_limits<double>::infinity(), int coordinate = 0);
  /// A motor that gives a torque [N m] or a force [N] on the joint's second body against the first.
  /// Coordinates whose axis is fixed in both bodies: hinges, sliders, cylindrical joints, screws.
  void set_motor_effort(const JointReference& joint, double effort, int coordinate = 0);
  /// A motor that draws the coordinate to `target` [rad] or [m]: -stiffness (coordinate - target) -
  /// damping (rate), at most max_force [N m] or [N]. Whether the limit is reached is judged at each step.
  void set_motor_position(const JointReference& joint, double target, double stiffness, double damping,
                          int coordinate = 0, double max_force = std::numeric_limits<double>::infinity());
  /// The laws of the scene hold again.
  void release_motor(const JointReference& joint, int coordinate = 0);
  void set_gravity(const Vec3& g_W);  ///< [m/s²].
  /// Coulomb's coefficient of a material, at least 0.
  void set_friction(std::string_view material, double friction);
  /// Of a material, from 0 to 1.
  void set_restitution(std::string_view material, double restitution);

  /// A controller: called at every multiple of `period` [s] before the motion goes on (0: of H). It may look
  /// at everything and apply and set everything, but not advance, restore or reset. An empty one ends it.
  using Controller = std::function<void(Simulation& simulation)>;
  /// Period in s, at least 0.
  void set_controller(Controller controller, double period = 0);

  // What was felt and heard.
  /// Points that touch with the forces by which the scheme has moved the bodies: in schemes of fixed steps
  /// the impulses of the last step by its length, in event-driven ones what acts now. Single collisions are
  /// events with their impulses. Where the scheme has moved nothing yet, or something was put elsewhere
  /// since: what rest and friction require; the substep scheme has none then.
  std::vector<TouchingPoint> contacts() const;
  /// Coordinates, rates, reactions and motor efforts of a joint, of all joints; and without the forces, which
  /// are costly.
  JointReaction joint_forces(const JointReference& joint) const;
  /// Of all joints.
  std::vector<JointReaction> joint_forces() const;
  /// Of one joint, without the forces.
  JointReaction joint_motion(const JointReference& joint) const;
  /// Of all joints, without the forces.
  std::vector<JointReaction> joint_motions() const;
  /// Impacts, rests, separations, slips that end: since the last call. The newest million of them.
  std::vector<MotionEvent> take_events();
  /// Rays, pushed shapes, nearest bodies, overlaps, for the bodies as they are; valid until something
  /// changes.
  const SceneQueries& queries() const;
  /// How far the run so far can be trusted. Work of forces, motors and of everything that was set is in it.
  Audit audit() const;
  double energy() const;  ///< Mechanical energy now, without the potential of forces that are applied [J].

  /// All there is but controller and interrupt; restore() continues with the same bits in any simulation of
  /// the same scene. Throws InputError for bytes that are none of it, and changes nothing then.
  std::string save() const;
  /// Continues from the bytes of save().
  void restore(std::string_view bytes);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace rigor
