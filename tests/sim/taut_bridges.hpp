#pragma once

#include "random_vectors.hpp"
#include "sim/time_stepping_scenes.hpp"

#include <Eigen/Geometry>

#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace rigor::test {

/// Planks in a row between two walls along x, their ends on a parabola.
struct PlankRow {
  int count;
  double pitch, sag, height;  ///< Length of a plank, depth of the parabola, z of the walls' hinges [m].
  Vec3 half_size;             ///< Of a plank [m].
};

/// Adds the planks, in hinges with each other and the walls. mass_of_next: of one plank after the other [kg];
/// nothing: that of its volume.
inline void add_hinged_planks(const PlankRow& row, const std::function<std::optional<double>()>& mass_of_next,
                              ModelBuilder& builder) {
  const auto knot = [&](int i) {
    const double part = i / static_cast<double>(row.count);
    return Vec3(i * row.pitch, 0, row.height - 4 * row.sag * part * (1 - part));
  };
  const auto name = [&](int i) { return i < 0 || i >= row.count ? "world" : "plank" + std::to_string(i); };
  for (int i = 0; i < row.count; ++i) {
    const Vec3 along = knot(i + 1) - knot(i);
    BodyDescription plank = stepping_body(name(i), Box{row.half_size}, 0.5 * (knot(i) + knot(i + 1)));
    plank.mass = mass_of_next();
    plank.q_WU = Eigen::AngleAxisd(std::atan2(-along.z(), along.x()), Vec3::UnitY());
    builder.add_body(plank);
  }
  for (int i = 0; i <= row.count; ++i) {
    ModelBuilder::JointDescription hinge;
    hinge.name = "hinge" + std::to_string(i);
    hinge.type = JointType::hinge;
    hinge.bodies = {name(i - 1), name(i)};
    hinge.anchors = {knot(i)};
    hinge.axis = Vec3::UnitY();
    builder.add_joint(hinge);
  }
}

/// Of random bridges.
struct TautBridges {
  int least_count = 5, most_count = 9;        ///< Of planks.
  double least_sag = 0.003, most_sag = 0.03;  ///< Share of the length.
  bool has_load = false;                      ///< Whether a ball falls on it.
};

/// A random bridge of planks in hinges between two walls.
inline std::shared_ptr<const Model> taut_bridge(Random& random, const TautBridges& of = {}) {
  const int count = static_cast<int>(random.uniform(of.least_count, of.most_count + 0.999));
  const double pitch = random.uniform(0.2, 0.6);
  const double sag = random.uniform(of.least_sag, of.most_sag) * count * pitch;
  ModelBuilder builder;
  builder.set_gravity(Vec3(0, 0, -9.81));
  builder.add_material({"m", 1000, 0.5, 0});
  add_hinged_planks(
      {count, pitch, sag, 0, Vec3(0.4 * pitch, 0.3, 0.02)}, [&] { return random.uniform(2, 20); }, builder);
  if (of.has_load) {
    const Vec3 above(random.uniform(0.2, 0.8) * count * pitch, 0, 0.25 + random.uniform(0, 1));
    BodyDescription load = stepping_body("load", Sphere{0.2}, above);
    load.mass = random.uniform(5, 30);
    builder.add_body(load);
  }
  return builder.build();
}

}  // namespace rigor::test
