#include "scene_parts.hpp"

#include "rigor/geometry/shape/convex_hull.hpp"
#include "rigor/math/rotation.hpp"

#include <cmath>

namespace rigor::bench {

namespace {

/// Hull of points at `radius` from the origin, in random directions.
Convex draw_hull(int points, double radius, SceneDraws& draws) {
  std::vector<Vec3> vertices;
  while (static_cast<int>(vertices.size()) < points) {
    const double x = draws.between(-1, 1), y = draws.between(-1, 1), z = draws.between(-1, 1);
    const Vec3 p(x, y, z);
    if (p.squaredNorm() > 1 || p.squaredNorm() < 0.01) continue;
    vertices.push_back(radius * p.normalized());
  }
  return {std::make_shared<const ConvexHull>(std::get<ConvexHull>(make_convex_hull(vertices)))};
}

}  // namespace

ModelBuilder scene_builder(const std::string& name) {
  ModelBuilder builder;
  builder.set_name(name);
  builder.set_gravity(Vec3(0, -9.81, 0));
  builder.add_material({"m", 1000, 0.5, 0});
  return builder;
}

ShapeDescription shape_at(const Shape& shape, const Vec3& p_US) {
  return {shape, p_US, Quat::Identity(), "m", ""};
}

void add_body(const std::string& name, const Shape& shape, const Vec3& p_W, const Quat& q_W,
              ModelBuilder& builder) {
  BodyDescription body;
  body.name = name;
  body.p_WU = p_W;
  body.q_WU = q_W;
  body.shapes.push_back(shape_at(shape, Vec3::Zero()));
  builder.add_body(body);
}

void add_fixed(const std::string& name, const Shape& shape, const Vec3& p_W, const Quat& q_W,
               ModelBuilder& builder) {
  BodyDescription body;
  body.name = name;
  body.motion = MotionType::fixed;
  body.p_WU = p_W;
  body.q_WU = q_W;
  body.shapes.push_back(shape_at(shape, Vec3::Zero()));
  builder.add_body(body);
}

void add_ground(ModelBuilder& builder) {
  add_fixed("ground", Box{Vec3(200, 1, 200)}, Vec3(0, -1, 0), Quat::Identity(), builder);
}

void add_walls(double half_width, double height, ModelBuilder& builder) {
  constexpr double t = 0.5;
  const double middle = half_width + t;
  const auto add = [&](const char* name, const Vec3& half, double x, double z) {
    add_fixed(name, Box{half}, Vec3(x, height / 2, z), Quat::Identity(), builder);
  };
  const Vec3 across(t, height / 2, half_width + 2 * t), along(half_width, height / 2, t);
  add("wall+x", across, middle, 0);
  add("wall-x", across, -middle, 0);
  add("wall+z", along, 0, middle);
  add("wall-z", along, 0, -middle);
}

/// Source: Shoemake, Uniform Random Rotations, Graphics Gems III, 1992.
Quat draw_rotation(SceneDraws& draws) {
  const double a = draws.unit();
  const double b = 2 * M_PI * draws.unit();
  const double c = 2 * M_PI * draws.unit();
  const double s = std::sqrt(1 - a), r = std::sqrt(a);
  return Quat(r * std::cos(c), s * std::sin(b), s * std::cos(b), r * std::sin(c));
}

std::vector<Convex> draw_hulls(double radius, SceneDraws& draws) {
  std::vector<Convex> hulls;
  for (int k = 0; k <= 10; ++k) hulls.push_back(draw_hull(20 + k, radius, draws));
  return hulls;
}

}  // namespace rigor::bench
