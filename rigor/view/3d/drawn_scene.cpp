#include "rigor/view/3d/drawn_scene.hpp"

#include "rigor/core/index.hpp"
#include "rigor/geometry/shape/shape_data.hpp"
#include "rigor/geometry/shape/support.hpp"
#include "rigor/view/3d/bowl.hpp"
#include "rigor/view/3d/drawn_joints.hpp"
#include "rigor/view/3d/shape_colors.hpp"

#include <array>
#include <map>
#include <utility>

namespace rigor {

namespace {

class SurfaceCache {
 public:
  std::shared_ptr<const Surface> surface(const Shape& shape) {
    const ShapeData data = shape_data(shape);
    std::shared_ptr<const Surface>& kept =
        data.shared != nullptr ? by_data_[data.shared] : by_numbers_[{shape.index(), data.own}];
    if (!kept) kept = std::make_shared<const Surface>(make_surface(shape));
    return kept->vertices.empty() ? nullptr : kept;
  }

 private:
  std::map<std::pair<std::size_t, std::array<double, 4>>, std::shared_ptr<const Surface>> by_numbers_;
  // Only looked up, never iterated: the order of pointers does not matter.
  std::map<const void*, std::shared_ptr<const Surface>> by_data_;
};

/// The solid box with these principal moments of inertia: I_x = m (b² + c²) / 12 of the sides a, b, c and so
/// on, so that a² = 6 (I_y + I_z - I_x) / m. A side of no length is drawn as a hundredth of the longest.
BodyShape inertia_box(const Body& body) {
  const Vec3& I = body.moments;
  const Vec3 squares = 6 / body.mass * (Vec3::Constant(I.sum()) - 2 * I);
  Vec3 half = 0.5 * squares.cwiseMax(0).cwiseSqrt();
  half = half.cwiseMax(0.01 * half.maxCoeff());
  return {Box{half}, Pose{}, 0, half.norm(), ""};
}

/// The shapes drawn for a body whose joints reach this far from its centre of mass.
std::vector<BodyShape> drawn_shapes(const Body& body, double reach) {
  constexpr double least_part = 0.05;
  if (!body.shapes.empty() || body.motion != MotionType::dynamic || !(body.moments.maxCoeff() > 0))
    return body.shapes;
  const BodyShape box = inertia_box(body);
  const double least_radius = least_part * reach;
  if (box.radius >= least_radius) return {box};
  return {BodyShape{Sphere{least_radius}, Pose{}, 0, least_radius, ""}};
}

}  // namespace

std::array<Vec3, 2> DrawnLine::ends(std::span<const Pose> X_WU) const {
  std::array<Vec3, 2> p_W = points;
  for (std::size_t i = 0; i < 2; ++i) {
    if (bodies[i] != world_body) p_W[i] = X_WU[at(bodies[i])] * points[i];
  }
  return p_W;
}

/// Radius of the ball around the origin of S that contains the drawing [m].
double form_radius(const BodyShape& shape, const Shape& form) {
  return std::holds_alternative<Cavity>(shape.shape) ? radius_about(form, Vec3::Zero()) : shape.radius;
}

DrawnScene make_drawn_scene(const Model& model) {
  DrawnScene scene;
  scene.body_count = model.body_count();
  if (model.g_W().norm() > 0) scene.up = -model.g_W().normalized();
  SurfaceCache cache;
  const ShapeColors colors(model);
  const std::vector<double> reaches = joint_reaches(model);
  for (int i = 0; i < model.body_count(); ++i) {
    const Body& body = model.body(i);
    const Pose X_UB = body.X_BU.inverse();
    for (const BodyShape& shape : drawn_shapes(body, reaches[at(i)])) {
      const Shape form = drawn_form(shape.shape);
      scene.shapes.push_back({i, body.motion != MotionType::fixed, form, X_UB * shape.X_BS,
                              cache.surface(form), axis_aligned_box(form, Pose{}), form_radius(shape, form),
                              colors.of(i, shape)});
    }
  }
  add_joints(model, scene);
  return scene;
}

}  // namespace rigor
