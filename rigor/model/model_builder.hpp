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
  Shape shape;
  Vec3 p_US = Vec3::Zero();
  Quat q_US = Quat::Identity();
  std::string material;  ///< Name; empty: the default material.
  std::string color;
  std::string type_name{};  ///< For messages, as the user calls the type; empty: shape_type_name.
};

/// A body as the user describes it; L is the user's frame of the body.
struct BodyDescription {
  std::string name;
  MotionType motion = MotionType::dynamic;
  Vec3 p_WU = Vec3::Zero();
  Quat q_WU = Quat::Identity();
  Vec3 velocity = Vec3::Zero();          ///< Of the centre of mass, in W [m/s].
  Vec3 angular_velocity = Vec3::Zero();  ///< In W [rad/s].
  std::optional<double> mass;            ///< [kg]: shapes' inertia scaled to this mass.
  std::optional<double> density;         ///< [kg/m³]: for all shapes, instead of the materials'.
  std::optional<GivenInertia> inertia;
  std::vector<ShapeDescription> shapes;
  std::uint32_t group = 1;
  std::uint32_t mask = 65535;
  double linear_drag = 0;
  double angular_drag = 0;
  double gravity_scale = 1;    ///< Times gravity.
  double linear_damping = 0;   ///< Rate at which momentum decays [1/s].
  double angular_damping = 0;  ///< The same of angular momentum [1/s].
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
  ModelBuilder(const ModelBuilder& other);
  ModelBuilder(ModelBuilder&& other) noexcept;
  ModelBuilder& operator=(ModelBuilder other) noexcept;
  ~ModelBuilder();

  void set_name(std::string name);
  void set_gravity(const Vec3& g_W, std::string where = {});
  void add_material(Material material, std::string where = {});
  void set_pair(const std::string& material_a, const std::string& material_b, PairCoefficients coefficients,
                std::string where = {});
  void add_body(BodyDescription body, std::string where = {});
  /// Removes a body with the joints, gears of these joints, forces and exclusions that name it. False if no
  /// body has that name.
  bool remove_body(const std::string& name);
  void exclude_pair(const std::string& body_a, const std::string& body_b, std::string where = {});
  /// Forces name their bodies; "world" is the world. Points are in the user's frames L of the bodies.
  struct ForceDescription {
    enum class Type { constant, torque, spring, drag } type;
    std::vector<std::string> bodies;  ///< One, or two for a spring.
    std::vector<Vec3> points;         ///< In the bodies' frames L [m]; missing ones are the origin of L
                                      ///< (constant: the centre of mass).
    Vec3 vector = Vec3::Zero();       ///< Force or torque.
    bool frame_is_body = false;       ///< vector is given in U and rotates with the body.
    double stiffness = 0, damping = 0, linear = 0, angular = 0;
    std::optional<double> length;  ///< Missing: the distance at t = 0.
  };
  void add_force(ForceDescription force, std::string where = {});
  /// Joints name their bodies ("world" is the world) or, gears, two joints. Anchors and axes are in W at t =
  /// 0. The bodies of a joint do not touch each other unless `collide` says so.
  struct JointDescription {
    std::string name;
    JointType type = JointType::fixed;
    std::vector<std::string> bodies;  ///< A and B; none for a gear.
    std::vector<Vec3> anchors;        ///< One [m]; two (on A, on B) for a distance joint. Where they are
                                      ///< optional, the default is the centre of mass of B (of A if B is
                                      ///< not dynamic).
    Vec3 axis = Vec3::UnitZ();        ///< z of the joint's frame, of any length.
    std::optional<Vec3> second_axis;  ///< x of that frame: the axis on B, or a direction (JointAxes).
    double pitch = 0;                 ///< Screw [m].
    std::vector<std::string> joints;  ///< Gear: the first and the second.
    double ratio = 0;                 ///< Gear.
    std::vector<JointAxis> axes;      ///< Missing ones are free.
    bool collide = false;             ///< Whether its bodies can touch each other.
  };
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
