#pragma once

#include "rigor/io/scene/object_reader.hpp"
#include "rigor/model/model_builder.hpp"

#include <cstddef>
#include <set>
#include <string>

namespace rigor {

/// Names of the bodies that the joints of a scene refer to; those of repeated bodies without their indices.
std::set<std::string> jointed_names(const ObjectReader& scene);

/// Reads the joints of a scene into a builder.
class JointReader {
 public:
  JointReader(SceneErrors& errors, ModelBuilder& builder)
      : errors_(errors), builder_(builder), errors_before_(errors.count()) {}

  /// Adds the joint, or the grid of joints that `repeat` makes of it; index: position of the joint in the
  /// file. A joint that cannot be read is reported and skipped.
  void read(const YamlNode& node, std::size_t index);

 private:
  void add(const ObjectReader& joint, const ModelBuilder::JointDescription& description);
  bool has_room(const ObjectReader& joint, double count);

  SceneErrors& errors_;
  ModelBuilder& builder_;
  std::size_t errors_before_;
  double joint_count_ = 0;
};

}  // namespace rigor
