// Scenes that stand, as long as nobody touches them.

#include "wall_scenes.hpp"
#include "scene_parts.hpp"

#include <fmt/format.h>

namespace rigor::bench {

namespace {

/// A place near `p_W`, on the same height.
Vec3 moved(const Vec3& p_W, double jitter, SceneDraws& draws) {
  const double x = draws.between(-jitter, jitter), z = draws.between(-jitter, jitter);
  return p_W + Vec3(x, 0, z);
}

/// Bricks of 0.5 x 0.25 x 0.25 m in the plane z = 0; every other row begins and ends with half a brick.
void add_bricks(double jitter, ModelBuilder& builder) {
  constexpr int rows = 40, columns = 60;
  constexpr double length = 0.5, height = 0.25;
  const Vec3 half(0.5 * length, 0.5 * height, 0.125), quarter(0.25 * length, 0.5 * height, 0.125);
  SceneDraws draws;
  for (int i = 0; i < rows; ++i) {
    const bool is_shifted = i % 2 == 1;
    const int bricks = is_shifted ? columns + 1 : columns;
    for (int j = 0; j < bricks; ++j) {
      const bool is_first = is_shifted && j == 0, is_last = is_shifted && j == columns;
      double x = length * (j + 0.5 - 0.5 * columns) - (is_shifted ? 0.5 * length : 0);
      if (is_first) x += 0.25 * length;
      if (is_last) x -= 0.25 * length;
      add_body(fmt::format("brick{},{}", i, j), Box{is_first || is_last ? quarter : half},
               moved(Vec3(x, height * (i + 0.5), 0), jitter, draws), Quat::Identity(), builder);
    }
  }
}

}  // namespace

std::shared_ptr<const Model> make_wall(double jitter) {
  ModelBuilder builder = scene_builder("wall");
  add_ground(builder);
  add_bricks(jitter, builder);
  return builder.build();
}

std::shared_ptr<const Model> make_hit_wall() {
  ModelBuilder builder = scene_builder("hit_wall");
  add_ground(builder);
  add_bricks(0, builder);
  BodyDescription ball;
  ball.name = "ball";
  ball.p_WU = Vec3(0.3, 4, -12);
  ball.velocity = Vec3(0, 2, 20);
  ball.shapes.push_back(shape_at(Sphere{1}, Vec3::Zero()));
  builder.add_body(ball);
  return builder.build();
}

std::shared_ptr<const Model> make_column(int cubes, double jitter) {
  ModelBuilder builder = scene_builder("column");
  SceneDraws draws;
  add_ground(builder);
  for (int i = 0; i < cubes; ++i)
    add_body(fmt::format("box{}", i), Box{Vec3(0.5, 0.5, 0.5)}, moved(Vec3(0, 0.5 + i, 0), jitter, draws),
             Quat::Identity(), builder);
  return builder.build();
}

}  // namespace rigor::bench
