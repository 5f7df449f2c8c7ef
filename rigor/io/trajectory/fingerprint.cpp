#include "rigor/io/trajectory/fingerprint.hpp"

#include "rigor/geometry/shape/shape_data.hpp"
#include "rigor/geometry/shape/triangle_mesh.hpp"

#include <bit>
#include <string_view>

namespace rigor {

namespace {

/// Source: Fowler, Noll, Vo and Eastlake, The FNV Non-Cryptographic Hash Algorithm (64-bit FNV-1a).
class Hash {
 public:
  std::uint64_t value() const { return value_; }

  void add(std::uint64_t number) {
    for (int shift = 0; shift < 64; shift += 8) add_byte(static_cast<unsigned char>(number >> shift));
  }
  void add(int number) { add(static_cast<std::uint64_t>(number)); }
  void add(double number) { add(std::bit_cast<std::uint64_t>(number)); }
  void add(std::string_view text) {
    add(static_cast<std::uint64_t>(text.size()));
    for (const char c : text) add_byte(static_cast<unsigned char>(c));
  }
  void add(const Vec3& v) { add(v.x()), add(v.y()), add(v.z()); }
  void add(const Quat& q) { add(q.w()), add(q.x()), add(q.y()), add(q.z()); }
  void add(const Pose& X) { add(Vec3(X.R.col(0))), add(Vec3(X.R.col(1))), add(Vec3(X.R.col(2))), add(X.p); }

  void add(const Shape& shape) {
    add(static_cast<int>(shape.index()));
    const ShapeData data = shape_data(shape);
    for (const double number : data.numbers()) add(number);
    const Mesh* const mesh = std::get_if<Mesh>(&shape);
    if (mesh == nullptr) return;
    for (const auto& triangle : mesh->mesh->triangles) add(triangle[0]), add(triangle[1]), add(triangle[2]);
  }

  void add(const ConstantForce& f) {
    add(f.body), add(f.f), add(f.p_BP), add(static_cast<int>(f.frame_is_body));
  }
  void add(const ConstantTorque& f) { add(f.body), add(f.tau), add(static_cast<int>(f.frame_is_body)); }
  void add(const Spring& f) {
    add(f.body_A), add(f.body_B), add(f.p_AP), add(f.p_BQ), add(f.stiffness), add(f.damping), add(f.length);
  }
  void add(const Drag& f) { add(f.body), add(f.linear), add(f.angular); }
  void add(const Force& force) {
    add(static_cast<int>(force.index()));
    std::visit([this](const auto& f) { add(f); }, force);
  }

  void add(const JointAxis& axis) {
    add(axis.lower), add(axis.upper), add(axis.restitution), add(axis.stiffness), add(axis.rest);
    add(axis.damping), add(axis.friction), add(static_cast<int>(axis.motor.has_value()));
    if (axis.motor) add(axis.motor->velocity), add(axis.motor->max_force);
  }
  void add(const Joint& joint) {
    add(std::string_view(joint.name)), add(static_cast<int>(joint.type)), add(joint.body_A),
        add(joint.body_B);
    // A gear's number has stood behind the joints that it ties since the first checkpoints.
    const bool is_gear = joint.type == JointType::gear;
    add(joint.X_AF), add(joint.X_BK), add(is_gear ? 0.0 : joint.parameter), add(joint.length);
    add(joint.first_joint), add(joint.second_joint), add(is_gear ? joint.parameter : 0.0);
    for (const JointAxis& axis : joint.axes) add(axis);
  }

  void add(const TimeFunction& function) {
    add(static_cast<int>(function.law().index()));
    if (const double* const constant = std::get_if<double>(&function.law())) add(*constant);
    if (const auto* const sine = std::get_if<TimeFunction::Sine>(&function.law()))
      add(sine->mean), add(sine->amplitude), add(sine->frequency), add(sine->phase);
    if (const auto* const table = std::get_if<TimeFunction::Table>(&function.law())) {
      for (const auto& [time, value] : table->points) add(time), add(value);
    }
    if (const auto* const formula = std::get_if<TimeFunction::Formula>(&function.law()))
      add(std::string_view(formula->text));
  }
  void add(const Drives& drives) {
    for (const JointDrive& drive : drives.joints) {
      add(drive.joint), add(drive.coordinate), add(static_cast<int>(drive.kind)), add(drive.aim);
      add(drive.stiffness), add(drive.damping), add(drive.max_force);
    }
    for (const ForceDrive& drive : drives.forces) add(drive.force), add(drive.factor);
  }

  void add(const Body& body) {
    add(std::string_view(body.name)), add(static_cast<int>(body.motion)), add(body.mass), add(body.moments);
    add(body.X_BU);
    for (const BodyShape& shape : body.shapes) add(shape.shape), add(shape.X_BS), add(shape.material);
    add(std::uint64_t{body.group}), add(std::uint64_t{body.mask}), add(body.linear_drag),
        add(body.angular_drag);
    add(body.gravity_scale), add(body.linear_damping), add(body.angular_damping);
    add(body.p_WB), add(body.q_WB), add(body.v_WB), add(body.w_WB);
    for (const PathPoint& point : body.path) add(point.time), add(point.p_WU), add(point.q_WU);
  }

 private:
  void add_byte(unsigned char byte) { value_ = (value_ ^ byte) * 1099511628211ull; }

  std::uint64_t value_ = 14695981039346656037ull;
};

}  // namespace

std::uint64_t fingerprint(const Model& model, const Method& method, double step) {
  Hash hash;
  hash.add(model.g_W());
  for (const Body& body : model.bodies()) hash.add(body);
  const int materials = static_cast<int>(model.materials().size());
  for (int a = 0; a < materials; ++a) {
    for (int b = a; b < materials; ++b) {
      const PairCoefficients pair = model.coefficients(a, b);
      hash.add(pair.friction), hash.add(pair.restitution), hash.add(pair.tangential_restitution);
      hash.add(pair.rolling_friction), hash.add(pair.torsional_friction);
      hash.add(pair.sticking_friction());
    }
  }
  for (const Force& force : model.forces()) hash.add(force);
  for (const Joint& joint : model.joints()) hash.add(joint);
  hash.add(model.drives());
  for (const auto& [a, b] : model.excluded_pairs()) hash.add(a), hash.add(b);
  for (const std::string& key : method_choice_keys()) hash.add(std::string_view(method_choice(method, key)));
  for (const MethodNumber& number : method_numbers()) hash.add(method.*number.member);
  hash.add(step);
  return hash.value();
}

}  // namespace rigor
