#pragma once

#include "rigor/io/scene/object_reader.hpp"
#include "rigor/io/scene/shape_files.hpp"
#include "rigor/model/model_builder.hpp"

#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <utility>

namespace rigor {

/// What the rest of a scene says about its bodies.
struct BodySurroundings {
  std::uint64_t seed;                   ///< Seed of the jitter of repeated bodies.
  std::set<std::string> jointed_names;  ///< Bodies that joints refer to: these may have no shapes.
};

/// Reads the bodies of a scene into a builder.
class BodyReader {
 public:
  BodyReader(BodySurroundings surroundings, ShapeFiles& files, SceneErrors& errors, ModelBuilder& builder)
      : surroundings_(std::move(surroundings)), files_(files), errors_(errors), builder_(builder) {}

  /// Adds the body, or the grid of bodies that `repeat` makes of it; index: position of the body in the file.
  void read(const YamlNode& node, std::size_t index);

 private:
  void add_repeated(const ObjectReader& body, const BodyDescription& description);
  void warn_of_unused(const ObjectReader& body, const BodyDescription& description) const;
  bool has_room(const ObjectReader& body, double count);

  BodySurroundings surroundings_;
  ShapeFiles& files_;
  SceneErrors& errors_;
  ModelBuilder& builder_;
  double body_count_ = 0;
};

}  // namespace rigor
