#pragma once

#include "rigor/model/model.hpp"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace rigor::bench {

/// Names of the scenes of many bodies, in the order of the table.
std::vector<std::string> bulk_scene_names();
/// The scene of that name: y is up, density 1000 kg/m³, friction 0.5, no restitution, no drag. Nothing if
/// there is none.
std::shared_ptr<const Model> make_bulk_scene(const std::string& name);

/// Whether the bodies of that scene stand on each other from the start, and should for ever.
bool begins_standing(const std::string& name);

enum class Grain { sphere, hull };
/// A scene of so many bodies, > 9: grains of 0.25 m radius that fill a hopper over a floor, nearly touching;
/// a square silo whose slopes of 45 degrees leave a third of its width open. An InputError if these are more
/// than a Model may have.
std::shared_ptr<const Model> make_hopper(int count, Grain grain);

/// The linear congruential generator that the scenes are defined with.
class SceneDraws {
 public:
  /// In [0, 1).
  double unit() {
    seed_ = seed_ * 1664525u + 1013904223u;
    return static_cast<double>(seed_ >> 8) / 16777216.0;
  }
  /// In [a, b).
  double between(double a, double b) { return a + (b - a) * unit(); }

 private:
  std::uint32_t seed_ = 12345;
};

}  // namespace rigor::bench
