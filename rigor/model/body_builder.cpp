#include "rigor/model/body_builder.hpp"

#include "rigor/core/index.hpp"
#include "rigor/core/quoted.hpp"
#include "rigor/core/suggestion.hpp"
#include "rigor/geometry/decomposition/make_mesh.hpp"
#include "rigor/geometry/distance/thickness.hpp"
#include "rigor/geometry/mesh/triangle_tree.hpp"
#include "rigor/geometry/shape/aabb.hpp"
#include "rigor/geometry/shape/support.hpp"
#include "rigor/math/rotation.hpp"
#include "rigor/model/body_mass.hpp"
#include "rigor/model/limits.hpp"
#include "rigor/model/state.hpp"

#include <algorithm>
#include <limits>
#include <numbers>

namespace rigor {

namespace {

std::vector<std::string> names_of(const MaterialTable& materials) {
  std::vector<std::string> names;
  for (const auto& [name, index] : materials.index) names.push_back(name);
  return names;
}

/// Index of the shape's material; the default one, and a message, if no material has that name.
int find_material(const ShapeDescription& shape, const MaterialTable& materials,
                  const std::string& shape_name, Findings& findings) {
  if (shape.material.empty()) return 0;
  const auto found = materials.index.find(shape.material);
  if (found != materials.index.end()) return found->second;
  findings.add(shape_name + ": unknown material " + quoted_text(shape.material) +
               suggestion(shape.material, names_of(materials)));
  return 0;
}

/// Whether two successive orientations are so nearly half a turn apart that the sense of the rotation between
/// them is undetermined.
bool is_half_turn(const Quat& a, const Quat& b) {
  return rotation_angle_between(a.normalized(), b.normalized()) > std::numbers::pi - 1e-6;
}

void check_path(const BodyDescription& body, Findings& findings) {
  if (body.path.empty()) return;
  findings.require(body.motion == MotionType::kinematic, "only a kinematic body has a 'path'");
  // A path says where the body is at every time, so that nothing else may.
  const bool has_start = !body.p_WU.isZero(0) || !body.q_WU.isApprox(Quat::Identity(), 0);
  findings.require(!has_start && body.velocity.isZero(0) && body.angular_velocity.isZero(0),
                   "its path gives position and velocities, so they may not be given as well");
  for (std::size_t i = 0; i < body.path.size(); ++i) {
    const PathPoint& point = body.path[i];
    const std::string name = "path point " + std::to_string(i);
    bool is_good = findings.check(name + ": time", point.time, limits::time, "s");
    is_good &= findings.check(name + ": position", point.p_WU, limits::position, "m");
    is_good &= findings.check(name + ": orientation", point.q_WU);
    if (!is_good || i == 0) continue;
    const PathPoint& before = body.path[i - 1];
    // Between two points the motion must be determined: time goes forwards, and the rotation has one sense.
    findings.require(point.time > before.time, name + ": time is " + number_text(point.time) +
                                                   " s, must be > " + number_text(before.time) +
                                                   " s, the time of the point before");
    findings.require(
        !is_half_turn(before.q_WU, point.q_WU),
        name + ": it is half a turn from the point before, which may go either way; put a point between");
  }
}

void check_numbers(const BodyDescription& body, Findings& findings) {
  findings.check("position", body.p_WU, limits::position, "m");
  findings.check("orientation", body.q_WU);
  findings.check("velocity", body.velocity, limits::speed, "m/s");
  findings.check("angular_velocity", body.angular_velocity, limits::angular_speed, "rad/s");
  findings.check("linear_drag", body.linear_drag, limits::coefficient, "kg/s");
  findings.check("angular_drag", body.angular_drag, limits::coefficient, "kg m²/s");
  findings.check("gravity_scale", body.gravity_scale, limits::gravity_scale, "");
  findings.check("linear_damping", body.linear_damping, limits::coefficient, "1/s");
  findings.check("angular_damping", body.angular_damping, limits::coefficient, "1/s");
  const bool is_moving = !body.velocity.isZero(0) || !body.angular_velocity.isZero(0);
  findings.require(body.motion != MotionType::fixed || !is_moving,
                   "a static body does not move, but a velocity is given; make it kinematic");
  check_path(body, findings);
}

/// Shapes on the user's frame, checked; X_BS still is X_US.
std::vector<BodyShape> make_shapes(const BodyDescription& body, const MaterialTable& materials,
                                   ShapeMemory& memory, Findings& findings) {
  std::vector<BodyShape> shapes;
  for (const ShapeDescription& shape : body.shapes) {
    const std::string type = shape.type_name.empty() ? shape_type_name(shape.shape) : shape.type_name;
    const std::string name = "shape " + std::to_string(shapes.size()) + " (" + type + ")";
    check_shape(shape.shape, body.motion == MotionType::dynamic, name, memory, findings);
    findings.check(name + ": position", shape.p_US, limits::position, "m");
    findings.check(name + ": orientation", shape.q_US);
    if (!shape.color.empty() && !is_color(shape.color))
      findings.add(name + ": color is " + quoted_text(shape.color) + ", must be '#rgb' or '#rrggbb'");
    const int material = find_material(shape, materials, name, findings);
    BodyShape placed;
    placed.shape = shape.shape;
    placed.X_BS = {rotation_matrix(shape.q_US), shape.p_US};
    placed.material = material;
    placed.color = shape.color;
    shapes.push_back(std::move(placed));
  }
  return shapes;
}

/// The width by which overlaps of a shape are judged [m]; infinite if it has none. Rods and discs that stand
/// for lines and circles, thinner than 1e-5 of their size, count as that thick.
double judged_width(const BodyShape& shape) {
  constexpr double thinnest = 1e-5;
  const double width = smallest_width(shape.shape);
  return width > 0 ? std::max(width, thinnest * 2 * shape.radius) : std::numeric_limits<double>::infinity();
}

/// Computes radii about each shape's origin and the body's, its thickness, and the trees of meshes that have
/// none yet.
void complete_shapes(std::vector<BodyShape>& shapes, Body& body) {
  body.bounding_radius = 0;
  for (BodyShape& shape : shapes) {
    Mesh* const mesh = std::get_if<Mesh>(&shape.shape);
    if (mesh && !mesh->tree) *mesh = make_mesh(mesh->mesh);
    shape.radius = radius_about(shape.shape, Vec3::Zero());
    body.thickness = std::min(body.thickness, judged_width(shape));
    const Vec3 p_SB = shape.X_BS.inverse().p;
    body.bounding_radius = std::max(body.bounding_radius, radius_about(shape.shape, p_SB));
  }
}

/// Moves everything from the user's frame U to the body frame B.
void use_body_frame(const BodyMass& mass, const BodyDescription& description, std::vector<BodyShape>& shapes,
                    Body& body) {
  body.mass = mass.mass;
  body.moments = mass.moments;
  body.X_BU = mass.X_UB.inverse();
  for (BodyShape& shape : shapes) shape.X_BS = body.X_BU * shape.X_BS;
  // The centre of mass and the principal axes in W; no product where the axes agree, so that a written
  // orientation is kept to the last bit.
  const bool axes_agree = mass.X_UB.R.isIdentity(0);
  const Quat q_WU = body.q_WB;
  body.p_WB = description.p_WU + rotation_matrix(q_WU) * mass.X_UB.p;
  if (!axes_agree) body.q_WB = (q_WU * quaternion_of(mass.X_UB.R)).normalized();
}

}  // namespace

Body make_body(const BodyDescription& description, const std::string& where, const MaterialTable& materials,
               ShapeMemory& memory, std::vector<std::string>& messages) {
  const std::size_t messages_before = messages.size();
  Findings findings(where, "body " + quoted_text(description.name), messages);
  findings.check_name(description.name);
  findings.require(description.name != "world", "the name 'world' means the world itself, choose another");
  check_numbers(description, findings);

  Body body;
  body.name = description.name;
  body.motion = description.motion;
  body.group = description.group;
  body.mask = description.mask;
  body.linear_drag = description.linear_drag;
  body.angular_drag = description.angular_drag;
  body.gravity_scale = description.gravity_scale;
  body.linear_damping = description.linear_damping;
  body.angular_damping = description.angular_damping;
  std::vector<BodyShape> shapes = make_shapes(description, materials, memory, findings);
  body.p_WB = description.p_WU;
  body.q_WB = description.q_WU.normalized();
  body.v_WB = description.velocity;
  body.w_WB = description.angular_velocity;
  body.path = description.path;
  for (PathPoint& point : body.path) point.q_WU.normalize();
  if (messages.size() > messages_before) return body;

  if (body.motion == MotionType::dynamic) {
    std::vector<double> densities;
    densities.reserve(shapes.size());
    for (const BodyShape& shape : shapes) {
      densities.push_back(materials.materials[at(shape.material)].density);
    }
    const std::optional<BodyMass> mass = body_mass(description, densities, memory, findings);
    if (!mass) return body;
    use_body_frame(*mass, description, shapes, body);
  } else if (!body.path.empty()) {
    const PrescribedMotion start = prescribed_motion(body, 0);
    body.p_WB = start.p_WB;
    body.q_WB = start.q_WB;
    body.v_WB = start.v_WB;
    body.w_WB = start.w_WB;
  }
  complete_shapes(shapes, body);
  body.shapes = std::move(shapes);
  return body;
}

}  // namespace rigor
