// The scenes of many bodies, made of the same numbers for every engine.

#include "bulk_scenes.hpp"
#include "scene_parts.hpp"
#include "shape_scenes.hpp"
#include "wall_scenes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace rigor::bench {

namespace {

std::shared_ptr<const Model> make_pyramid(int rows, double pitch) {
  ModelBuilder builder = scene_builder("pyramid");
  add_ground(builder);
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < rows - i; ++j) {
      const Vec3 p_W(pitch * (j - 0.5 * (rows - i - 1)), 0.5 + i, 0);
      add_body(fmt::format("box{},{}", i, j), Box{Vec3(0.5, 0.5, 0.5)}, p_W, Quat::Identity(), builder);
    }
  }
  return builder.build();
}

std::shared_ptr<const Model> make_spheres() {
  ModelBuilder builder = scene_builder("spheres");
  SceneDraws draws;
  add_ground(builder);
  add_walls(6, 20, builder);
  for (int n = 0; n < 1000; ++n) {
    const int i = n % 10, j = n / 10 % 10, k = n / 100;
    const double x = draws.between(-0.02, 0.02);
    const double z = draws.between(-0.02, 0.02);
    const Vec3 p_W(1.05 * (i - 4.5) + x, 1 + 1.05 * k, 1.05 * (j - 4.5) + z);
    add_body(fmt::format("ball{}", n), Sphere{0.5}, p_W, Quat::Identity(), builder);
  }
  return builder.build();
}

std::shared_ptr<const Model> make_rain() {
  ModelBuilder builder = scene_builder("rain");
  SceneDraws draws;
  add_ground(builder);
  add_walls(18, 16, builder);
  const std::array<Vec3, 3> halves = {Vec3(0.5, 0.5, 0.5), Vec3(0.6, 0.3, 0.4), Vec3(0.3, 0.3, 0.7)};
  for (int n = 0; n < 8000; ++n) {
    const int i = n % 20, j = n / 20 % 20, k = n / 400;
    const double x = draws.between(-0.1, 0.1);
    const double z = draws.between(-0.1, 0.1);
    const Quat q_W = draw_rotation(draws);
    const Vec3 p_W(1.7 * (i - 9.5) + x, 1 + 1.7 * k, 1.7 * (j - 9.5) + z);
    add_body(fmt::format("box{}", n), Box{halves[static_cast<std::size_t>(n % 3)]}, p_W, q_W, builder);
  }
  return builder.build();
}

std::shared_ptr<const Model> make_towers() {
  ModelBuilder builder = scene_builder("towers");
  add_ground(builder);
  for (int t = 0; t < 20; ++t) {
    for (int i = 0; i < 10; ++i) {
      const int row = t / 5;
      const Vec3 p_W(4.0 * (t % 5 - 2), 0.5 + i, 4 * (row - 1.5));
      add_body(fmt::format("box{},{}", t, i), Box{Vec3(0.5, 0.5, 0.5)}, p_W, Quat::Identity(), builder);
    }
  }
  return builder.build();
}

std::shared_ptr<const Model> make_chains() {
  ModelBuilder builder = scene_builder("chains");
  SceneDraws draws;
  add_ground(builder);
  for (int c = 0; c < 100; ++c) {
    const double angle = draws.between(-0.05, 0.05);
    const Vec3 along(std::cos(angle), 0, std::sin(angle)), start(0, 12, c - 49.5);
    const Quat q_W = Quat::FromTwoVectors(Vec3::UnitZ(), along);
    std::string previous = fmt::format("anchor{}", c);
    add_fixed(previous, Sphere{0.05}, start, Quat::Identity(), builder);
    for (int i = 0; i < 20; ++i) {
      const std::string name = fmt::format("link{},{}", c, i);
      add_body(name, Capsule{0.1, 0.2}, start + (0.25 + 0.5 * i) * along, q_W, builder);
      ModelBuilder::JointDescription joint;
      joint.name = fmt::format("joint{},{}", c, i);
      joint.type = JointType::ball;
      joint.bodies = {previous, name};
      joint.anchors = {start + 0.5 * i * along};
      builder.add_joint(joint);
      previous = name;
    }
  }
  return builder.build();
}

/// A hollow cube of half width 7 m that turns about z.
void add_drum(ModelBuilder& builder) {
  constexpr double w = 7, t = 0.5;
  BodyDescription drum;
  drum.name = "drum";
  drum.motion = MotionType::kinematic;
  drum.p_WU = Vec3(0, 8, 0);
  drum.angular_velocity = Vec3(0, 0, 0.6);
  for (const double sign : {1.0, -1.0}) {
    drum.shapes.push_back(shape_at(Box{Vec3(t, w + 2 * t, w + 2 * t)}, Vec3(sign * (w + t), 0, 0)));
    drum.shapes.push_back(shape_at(Box{Vec3(w, t, w + 2 * t)}, Vec3(0, sign * (w + t), 0)));
    drum.shapes.push_back(shape_at(Box{Vec3(w, w, t)}, Vec3(0, 0, sign * (w + t))));
  }
  builder.add_body(drum);
}

std::shared_ptr<const Model> make_hulls() {
  ModelBuilder builder = scene_builder("hulls");
  SceneDraws draws;
  const std::vector<Convex> hulls = draw_hulls(0.5, draws);
  add_drum(builder);
  for (int n = 0; n < 1000; ++n) {
    const int i = n % 10, j = n / 10 % 10, k = n / 100;
    BodyDescription body;
    body.name = fmt::format("hull{}", n);
    body.p_WU = Vec3(1.1 * (i - 4.5), 8 + 1.1 * (k - 4.5), 1.1 * (j - 4.5));
    body.q_WU = draw_rotation(draws);
    const double wx = draws.between(-5, 5), wy = draws.between(-5, 5), wz = draws.between(-5, 5);
    body.angular_velocity = Vec3(wx, wy, wz);
    body.shapes.push_back(shape_at(hulls[static_cast<std::size_t>(n) % hulls.size()], Vec3::Zero()));
    builder.add_body(body);
  }
  return builder.build();
}

/// Walls of half thickness 1/2 m around the silo and under it, and a floor as far below as the silo is wide.
void add_hopper(double half_width, double half_opening, double height, ModelBuilder& builder) {
  const double w = half_width, slope = std::sqrt(0.5) * (w - half_opening);
  add_fixed("floor", Box{Vec3(10 * w, 1, 10 * w)}, Vec3(0, -2 * w - 1, 0), Quat::Identity(), builder);
  for (int side = 0; side < 4; ++side) {
    const Quat turn(Eigen::AngleAxisd(0.5 * M_PI * side, Vec3::UnitY()));
    const Quat tilt(Eigen::AngleAxisd(0.25 * M_PI, Vec3::UnitZ()));
    const double middle = 0.5 * (w + half_opening);
    const Vec3 on_slope(middle, middle - half_opening, 0);
    const Vec3 p_W = turn * (on_slope - tilt * Vec3(0, 0.5, 0));
    add_fixed(fmt::format("slope{}", side), Box{Vec3(slope, 0.5, w + 1)}, p_W, turn * tilt, builder);
    const Vec3 wall(w + 0.5, w - half_opening + 0.5 * height, 0);
    add_fixed(fmt::format("wall{}", side), Box{Vec3(0.5, 0.5 * height, w + 1)}, turn * wall, turn, builder);
  }
}

/// Grains of 0.25 m over the opening of the hopper, nearly touching.
constexpr double grain_radius = 0.25, grain_pitch = 0.51;

/// Half the widths of a hopper for so many grains, and of its opening.
struct HopperSize {
  explicit HopperSize(int grains) : half_width(0.5 * grain_pitch * std::cbrt(grains) + 1) {}
  double half_width;
  double half_opening = half_width / 3;
};

void fill_hopper(int grains, Grain grain, const HopperSize& size, ModelBuilder& builder) {
  constexpr double radius = grain_radius, pitch = grain_pitch, jitter = 0.004;
  SceneDraws draws;
  const std::vector<Convex> hulls = draw_hulls(radius, draws);
  add_hopper(size.half_width, size.half_opening, 4 * size.half_width, builder);
  // A grain whose centre is this far from a slope, along x, does not touch it.
  const double clearance = std::sqrt(2.0) * (radius + jitter);
  int made = 0;
  for (int layer = 0; made < grains; ++layer) {
    const double y = radius + pitch * layer;
    const double reach = std::min(size.half_opening + y, size.half_width) - clearance;
    const int n = static_cast<int>(std::floor(2 * reach / pitch)) + 1;
    for (int cell = 0; cell < n * n && made < grains; ++cell, ++made) {
      const double x = pitch * (cell % n - 0.5 * (n - 1)) + draws.between(-jitter, jitter);
      const double z = pitch * (cell / n - 0.5 * (n - 1)) + draws.between(-jitter, jitter);
      const bool is_ball = grain == Grain::sphere;
      const Shape shape =
          is_ball ? Shape(Sphere{radius}) : Shape(hulls[static_cast<std::size_t>(made) % hulls.size()]);
      const Quat q_W = is_ball ? Quat::Identity() : draw_rotation(draws);
      add_body(fmt::format("g{}", made), shape, Vec3(x, y, z), q_W, builder);
    }
  }
}

/// Balls in a hopper, and a pen under its opening into which they run.
std::shared_ptr<const Model> make_hourglass() {
  constexpr int balls = 20000;
  const HopperSize size(balls);
  ModelBuilder builder = scene_builder("hourglass");
  const double w = size.half_width;
  for (int side = 0; side < 4; ++side) {
    const Quat turn(Eigen::AngleAxisd(0.5 * M_PI * side, Vec3::UnitY()));
    add_fixed(fmt::format("pen{}", side), Box{Vec3(0.5, w, w + 1)}, turn * Vec3(w + 0.5, -w, 0), turn,
              builder);
  }
  fill_hopper(balls, Grain::sphere, size, builder);
  return builder.build();
}

struct NamedScene {
  const char* name;
  std::function<std::shared_ptr<const Model>()> make;
};

const std::vector<NamedScene>& bulk_scenes() {
  static const std::vector<NamedScene> scenes = {{"a_pyr20", [] { return make_pyramid(20, 1); }},
                                                 {"a2_pyr20gap", [] { return make_pyramid(20, 1.05); }},
                                                 {"b_pyr100", [] { return make_pyramid(100, 1); }},
                                                 {"b2_pyr100gap", [] { return make_pyramid(100, 1.05); }},
                                                 {"c_spheres", make_spheres},
                                                 {"d_rain8000", make_rain},
                                                 {"e_towers", make_towers},
                                                 {"f_chains", make_chains},
                                                 {"g_hulls", make_hulls},
                                                 {"terrain", make_terrain},
                                                 {"cylinders", make_cylinders},
                                                 {"ellipsoids", make_ellipsoids},
                                                 {"round_mesh", make_round_on_mesh},
                                                 {"dolls", make_dolls},
                                                 {"bin", make_bin},
                                                 {"hourglass", make_hourglass},
                                                 {"wall", [] { return make_wall(0); }},
                                                 {"wall_1mm", [] { return make_wall(1e-3); }},
                                                 {"hit_wall", make_hit_wall},
                                                 {"column200", [] { return make_column(200, 0); }}};
  return scenes;
}

}  // namespace

std::vector<std::string> bulk_scene_names() {
  std::vector<std::string> names;
  for (const NamedScene& scene : bulk_scenes()) names.push_back(scene.name);
  return names;
}

std::shared_ptr<const Model> make_bulk_scene(const std::string& name) {
  for (const NamedScene& scene : bulk_scenes()) {
    if (scene.name == name) return scene.make();
  }
  return nullptr;
}

bool begins_standing(const std::string& name) {
  const std::array<const char*, 8> standing = {"a_pyr20",  "a2_pyr20gap", "b_pyr100", "b2_pyr100gap",
                                               "e_towers", "wall",        "wall_1mm", "column200"};
  return std::find(standing.begin(), standing.end(), name) != standing.end();
}

std::shared_ptr<const Model> make_hopper(int count, Grain grain) {
  ModelBuilder builder = scene_builder("hopper");
  // All but the floor, the slopes and the walls.
  fill_hopper(count - 9, grain, HopperSize(count), builder);
  return builder.build();
}

}  // namespace rigor::bench
