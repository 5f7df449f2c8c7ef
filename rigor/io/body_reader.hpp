#pragma once

#include "rigor/io/object_reader.hpp"
#include "rigor/io/shape_files.hpp"
#include "rigor/model/model_builder.hpp"

#include <cstddef>
#include <cstdint>

namespace rigor {

/// Reads the bodies of a scene into a builder.
class BodyReader {
 public:
  /// seed: of the jitter of repeated bodies.
  BodyReader(std::uint64_t seed, ShapeFiles& files, SceneErrors& errors, ModelBuilder& builder)
      : seed_(seed), files_(files), errors_(errors), builder_(builder) {}

  /// Adds the body, or the grid of bodies that `repeat` makes of it; index: of the body in the file.
  void read(const YamlNode& node, std::size_t index);

 private:
  void add_repeated(const ObjectReader& body, const BodyDescription& description);
  bool has_room(const ObjectReader& body, double count);

  std::uint64_t seed_;
  ShapeFiles& files_;
  SceneErrors& errors_;
  ModelBuilder& builder_;
  double body_count_ = 0;
};

}  // namespace rigor
