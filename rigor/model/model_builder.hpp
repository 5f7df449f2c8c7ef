#pragma once

#include "rigor/model/joint.hpp"
#include "rigor/model/model.hpp"

#include <memory>
#include <string>
#include <vector>

namespace rigor {

/// Mass and inertia given by the user, about the user's frame U.
struct GivenInertia {
  double mass;                   ///< [kg].
  Vec3 center = Vec3::Zero();    ///< Centre of mass in U [m].
  Vec3 moments = Vec3::Zero();   ///< Ixx, Iyy, Izz about the centre of mass, axes of L [kg m²].
  Vec3 products = Vec3::Zero();  ///< Ixy, Ixz, Iyz: elements of the tensor (so -∫xy dm) [kg m²].
};

/// A shape as the user places it.
struct ShapeDescription {
  /// In a frame of its own.
  Shape shape;
  /// Where that lies in the body [m].
  Vec3 p_US = Vec3::Zero();
  /// How it is turned there.
  Quat q_US = Quat::Identity();
  std::string material;  ///< Name; empty: the default material.
  /// "#rgb" or "#rrggbb"; empty for the default.
  std::string color;
  std::string type_name{};  ///< For messages, as the user calls the type; empty: shape_type_name.
};

/// A body as the user describes it; L is the user's frame of the body.
struct BodyDescription {
  /// Unique in the scene.
  std::string name;
  /// What moves it.
  MotionType motion = MotionType::dynamic;
  /// Origin of its frame at t = 0 [m].
  Vec3 p_WU = Vec3::Zero();
  /// Of that frame.
  Quat q_WU = Quat::Identity();
  Vec3 velocity = Vec3::Zero();          ///< Of the centre of mass, in W [m/s].
  Vec3 angular_velocity = Vec3::Zero();  ///< In W [rad/s].
  std::optional<double> mass;            ///< [kg]: shapes' inertia scaled to this mass.
  std::optional<double> density;         ///< [kg/m³]: for all shapes, instead of the materials'.
  /// Missing: that of the shapes [kg m²].
  std::optional<GivenInertia> inertia;
  /// What it consists of, rigidly.
  std::vector<ShapeDescription> shapes;
  /// Which group it is of, as a bit.
  std::uint32_t group = 1;
  /// Which groups it collides with.
  std::uint32_t mask = 65535;
  /// Force -c v [kg/s].
  double linear_drag = 0;
  /// Torque -c ω [kg m²/s].
  double angular_drag = 0;
  double gravity_scale = 1;    ///< Times gravity.
  double linear_damping = 0;   ///< Rate at which momentum decays [1/s].
  double angular_damping = 0;  ///< The same of angular momentum [1/s].
  /// Kinematic only: where it goes.
  std::vector<PathPoint> path;
};

struct BodyTable;

/// Collects the parts of a scene, checks them all and builds the Model. Every add_... takes what the user
/// wrote; nothing is checked before build(), which reports all errors in one InputError.
///
/// `where` of each add_... is put in front of its messages ("scene.yaml:12:5: "); empty for scenes built in
/// C++.
class ModelBuilder {
 public:
  ModelBuilder();
  /// An independent copy.
  ModelBuilder(const ModelBuilder& other);
  /// Takes the parts over.
  ModelBuilder(ModelBuilder&& other) noexcept;
  /// Likewise.
  ModelBuilder& operator=(ModelBuilder other) noexcept;
  ~ModelBuilder();

  /// Of the scene.
  void set_name(std::string name);
  /// [m/s²]; zero unless it is set.
  void set_gravity(const Vec3& g_W, std::string where = {});
  /// A material, which shapes name.
  void add_material(Material material, std::string where = {});
  /// Coefficients of two materials, in place of what follows from each.
  void set_pair(const std::string& material_a, const std::string& material_b, PairCoefficients coefficients,
                std::string where = {});
  /// A body.
  void add_body(BodyDescription body, std::string where = {});
  /// Removes a body with the joints, gears of these joints, forces and exclusions that name it. False if no
  /// body has that name.
  bool remove_body(const std::string& name);
  /// Two bodies that do not touch each other.
  void exclude_pair(const std::string& body_a, const std::string& body_b, std::string where = {});
  /// Forces name their bodies; "world" is the world. Points are in the user's frames L of the bodies.
  struct ForceDescription {
    /// Which force.
    enum class Type { constant, torque, spring, drag };
    Type type;                        ///< Says which of the rest is read.
    std::vector<std::string> bodies;  ///< One, or two for a spring.
    std::vector<Vec3> points;         ///< In the bodies' frames L [m]; missing ones are the origin of L
                                      ///< (constant: the centre of mass).
    Vec3 vector = Vec3::Zero();       ///< Force or torque.
    bool frame_is_body = false;       ///< vector is given in U and rotates with the body.
    double stiffness = 0;             ///< Of a spring [N/m].
    double damping = 0;               ///< Of a spring [N s/m].
    double linear = 0;                ///< Of drag [kg/s].
    double angular = 0;               ///< Of drag [kg m²/s].
    std::optional<double> length;     ///< Missing: the distance at t = 0.
    /// constant, torque: what the vector is multiplied by, as a function of the time.
    std::optional<TimeFunction> factor;
  };
  /// A force.
  void add_force(ForceDescription force, std::string where = {});
  /// Joints name their bodies ("world" is the world) or, gears, two joints. Anchors and axes are in W at t =
  /// 0. The bodies of a joint do not touch each other unless `collide` says so.
  struct JointDescription {
    /// Unique among the joints.
    std::string name;
    /// Which motions it leaves.
    JointType type = JointType::fixed;
    std::vector<std::string> bodies;  ///< A and B; none for a gear.
    std::vector<Vec3> anchors;        ///< One [m]; two (on A, on B) for a distance joint. Where they are
                                      ///< optional, the default is the centre of mass of B (of A if B is
                                      ///< not dynamic).
    Vec3 axis = Vec3::UnitZ();        ///< z of the joint's frame, of any length.
    std::optional<Vec3> second_axis;  ///< x of that frame: the axis on B, or a direction (JointAxes).
    std::vector<std::string> joints;  ///< Gear: the first and the second.
    double parameter = 0;             ///< Of the type (JointTraits): a screw's pitch [m], a gear's ratio.
    std::vector<JointAxis> axes;      ///< Missing ones are free.
    std::vector<JointDrive> drives;   ///< Motors that are functions of the time or servos; joint is ignored.
    bool collide = false;             ///< Whether its bodies can touch each other.
  };
  /// A joint.
  void add_joint(JointDescription joint, std::string where = {});

  /// The Model, or an InputError with every message. Mass properties are computed here (exact closed forms,
  /// Mirtich's integrals for meshes, parallel axes, principal frame).
  std::shared_ptr<const Model> build() const;
  /// Every message of the InputError that build() would throw, in the order in which the parts were added.
  std::vector<std::string> check() const;

 private:
  struct Parts;
  Model assemble(std::vector<std::string>& messages) const;
  void add_joints(const BodyTable& bodies, std::vector<std::string>& messages, Model& model) const;
  std::unique_ptr<Parts> parts_;
};

}  // namespace rigor
