#include "rigor/view/3d/drawn_joints.hpp"

#include "rigor/core/index.hpp"
#include "rigor/math/rotation.hpp"
#include "rigor/model/force.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace rigor {

namespace {

/// Ratios of the radius of a rod to the longer arm of its joint, and of the ball at its end to that radius.
constexpr double slenderness = 0.012, ball_to_rod = 1.9;
/// The radius of a rod is at most this part of its length.
constexpr double most_thickness = 0.2;
constexpr double line_slenderness = 0.006;

Color rod_color() {
  return color_from_hex("#78808c");
}
Color ball_color() {
  return color_from_hex("#3c4450");
}
Color spring_color() {
  return color_from_hex("#b0762a");
}

/// The anchor of a joint on one of its bodies.
struct Side {
  int body;
  Vec3 p_BP;  ///< In the body frame B [m].
};
std::array<Side, 2> sides_of(const Joint& joint) {
  return {Side{joint.body_A, joint.X_AF.p}, Side{joint.body_B, joint.X_BK.p}};
}

bool can_move(const Model& model, int body) {
  return body != world_body && model.body(body).motion != MotionType::fixed;
}

/// Length of the rod on this side; 0 where none is drawn.
double arm(const Model& model, const Side& side) {
  return can_move(model, side.body) ? side.p_BP.norm() : 0;
}

DrawnShape joint_part(const Model& model, int body, const Shape& shape, const Pose& X_BS) {
  DrawnShape part;
  part.body = body;
  part.can_move = true;
  part.is_joint = true;
  part.shape = shape;
  part.X_US = model.body(body).X_BU.inverse() * X_BS;
  part.box = axis_aligned_box(shape, Pose{});
  part.color = ball_color();
  return part;
}

void add_rod(const Model& model, const Side& side, double radius, DrawnScene& scene) {
  const double length = arm(model, side);
  if (length == 0) return;
  const Cylinder rod{std::min(radius, most_thickness * length), length / 2};
  const Pose X_BS{frame_with_z(side.p_BP / length), side.p_BP / 2};
  DrawnShape part = joint_part(model, side.body, rod, X_BS);
  part.surface = std::make_shared<const Surface>(make_surface(rod));
  part.radius = std::hypot(rod.radius, rod.half_length);
  part.color = rod_color();
  scene.shapes.push_back(std::move(part));
}

/// Rods and ball of a joint that has an anchor.
void add_joint(const Model& model, const Joint& joint, DrawnScene& scene) {
  const std::array<Side, 2> sides = sides_of(joint);
  const double radius = slenderness * std::max(arm(model, sides[0]), arm(model, sides[1]));
  for (const Side& side : sides) add_rod(model, side, radius, scene);
  if (radius == 0 || joint_traits(joint.type).drawing != JointDrawing::rods_and_ball) return;
  const Side& side = can_move(model, sides[0].body) ? sides[0] : sides[1];
  const double ball_radius = ball_to_rod * radius;
  DrawnShape ball = joint_part(model, side.body, Sphere{ball_radius}, Pose{Mat3::Identity(), side.p_BP});
  ball.radius = ball_radius;
  scene.shapes.push_back(std::move(ball));
}

/// A line between points given in the body frames (W for the world).
DrawnLine line_between(const Model& model, const std::array<Side, 2>& sides, const Color& color) {
  DrawnLine line;
  std::array<Vec3, 2> p_W;
  for (std::size_t i = 0; i < 2; ++i) {
    const auto& [body, p_BP] = sides[i];
    line.bodies[i] = body;
    line.points[i] = p_W[i] = p_BP;
    if (body == world_body) continue;
    line.points[i] = model.body(body).X_BU.inverse() * p_BP;
    p_W[i] = rotation_matrix(model.body(body).q_WB) * p_BP + model.body(body).p_WB;
  }
  const double length = (p_W[1] - p_W[0]).norm();
  line.radius = line_slenderness * (length > 0 ? length : model.length_scale());
  line.color = color;
  return line;
}

}  // namespace

std::vector<double> joint_reaches(const Model& model) {
  std::vector<double> reaches(at(model.body_count()));
  for (const Joint& joint : model.joints()) {
    for (const Side& side : sides_of(joint)) {
      if (side.body == world_body) continue;
      double& reach = reaches[at(side.body)];
      reach = std::max(reach, side.p_BP.norm());
    }
  }
  return reaches;
}

void add_joints(const Model& model, DrawnScene& scene) {
  for (const Joint& joint : model.joints()) {
    const JointDrawing drawing = joint_traits(joint.type).drawing;
    if (drawing == JointDrawing::nothing) continue;
    add_joint(model, joint, scene);
    if (drawing == JointDrawing::rods_and_line) {
      scene.lines.push_back(line_between(model, sides_of(joint), rod_color()));
    }
  }
  for (const Force& force : model.forces()) {
    if (const Spring* const spring = std::get_if<Spring>(&force)) {
      const std::array<Side, 2> sides = {Side{spring->body_A, spring->p_AP},
                                         Side{spring->body_B, spring->p_BQ}};
      scene.lines.push_back(line_between(model, sides, spring_color()));
    }
  }
}

}  // namespace rigor
