#pragma once

#include "rigor/core/index.hpp"
#include "rigor/model/body.hpp"
#include "rigor/model/drives.hpp"
#include "rigor/model/force.hpp"
#include "rigor/model/joint.hpp"
#include "rigor/model/material.hpp"

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace rigor {

struct ModelChanges;

/// A scene as the engine sees it: checked once, constant during a simulation, shared by any number of
/// steppers.
class Model {
 public:
  /// Of the scene.
  const std::string& name() const { return name_; }
  const Vec3& g_W() const { return g_W_; }  ///< Gravity [m/s²].
  /// All bodies, in the order of the scene.
  const std::vector<Body>& bodies() const { return bodies_; }
  /// The i-th body.
  const Body& body(int i) const { return bodies_[at(i)]; }
  /// Number of bodies.
  int body_count() const { return static_cast<int>(bodies_.size()); }
  /// All materials.
  const std::vector<Material>& materials() const { return materials_; }
  /// All forces but those of drives().
  const std::vector<Force>& forces() const { return forces_; }
  /// All joints, in the order of the scene.
  const std::vector<Joint>& joints() const { return joints_; }
  /// The i-th joint.
  const Joint& joint(int i) const { return joints_[at(i)]; }
  /// Motors and forces that are functions of the time. The motors of `joints()` are what these are at t = 0.
  const Drives& drives() const { return drives_; }
  /// Whether a motor acts on a coordinate of the i-th joint.
  bool has_motor(int i) const;
  /// Bodies that the i-th joint holds, without the world; for a gear those of both its joints. Ascending.
  std::vector<int> bodies_of_joint(int i) const;

  /// Index of the named body, or nothing.
  std::optional<int> find_body(const std::string& name) const;
  /// Coefficients of two materials by index.
  PairCoefficients coefficients(int material_a, int material_b) const;
  /// Whether two bodies can touch at all: at least one dynamic, groups and masks agree, both have shapes, and
  /// nothing excludes the pair.
  bool may_collide(int a, int b) const;
  /// Pairs of body indices that never collide, whatever their groups; sorted, the lower index first.
  const std::vector<std::pair<int, int>>& excluded_pairs() const { return excluded_pairs_; }
  /// Length of the scene [m]: the largest bounding radius of a bounded body, 1 if there is none. Tolerances
  /// scale with it.
  double length_scale() const { return length_scale_; }

 private:
  friend class ModelBuilder;
  friend class ModelEditor;
  friend std::shared_ptr<const Model> changed_model(const Model& model, const ModelChanges& changes);
  Model() = default;

  std::string name_;
  Vec3 g_W_ = Vec3::Zero();
  std::vector<Body> bodies_;
  std::vector<int> by_name_;  ///< Bodies in the order of their names.
  std::vector<Material> materials_;
  std::map<std::pair<int, int>, PairCoefficients> pair_overrides_;  ///< Key: lower index first.
  std::vector<std::pair<int, int>> excluded_pairs_;                 ///< Sorted; lower index first.
  std::vector<Force> forces_;
  std::vector<Joint> joints_;
  double length_scale_ = 1;
  Drives drives_;
};

}  // namespace rigor
