#pragma once

#include "rigor/bulk/matching/manifold_blocks.hpp"
#include "rigor/bulk/narrow_phase/manifold.hpp"
#include "rigor/bulk/narrow_phase/manifold_list.hpp"
#include "rigor/bulk/narrow_phase/narrow_phase.hpp"
#include "rigor/bulk/state/manifold_memories.hpp"
#include "rigor/bulk/state/shape_ranges.hpp"
#include "rigor/bulk/threads/executor.hpp"
#include "rigor/core/index.hpp"
#include "rigor/model/model.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace rigor {

/// The manifolds of a step with what belongs to them: their shapes, what is remembered of them, and the
/// friction and restitution of their materials.
class StepManifolds {
 public:
  explicit StepManifolds(const Model& model);

  /// After a body of the Model has changed: the materials of its shapes.
  void set_body(const Model& model, int body);
  /// After materials have changed.
  void set_surfaces(const Model& model);

  /// Takes the manifolds of a step, at its beginning. `memory` holds the contacts of the step before, in the
  /// order of keys. It must live until the next memory is written, the other lists until the next step.
  void match(const std::vector<ShapePair>& pairs, const ManifoldList& manifolds,
             const ManifoldMemories& memory, const Executor& executor);

  std::size_t size() const { return matches_.size(); }
  const ShapePair& pair(std::size_t i) const { return (*pairs_)[at(manifolds_->pair(i))]; }
  int body_A(std::size_t i) const { return pair(i).body_A; }
  int body_B(std::size_t i) const { return pair(i).body_B; }
  int part(std::size_t i) const { return manifolds_->part(i); }
  int point_count(std::size_t i) const { return manifolds_->point_count(i); }
  ManifoldView view(std::size_t i) const { return manifolds_->view(i); }
  const ManifoldSurface& surface(std::size_t i) const { return surfaces_[at(matches_[i].surface)]; }
  /// The memory of the step before, or none.
  ManifoldMemories::View memory(std::size_t i) const {
    const int number = matches_[i].memory;
    return number < 0 ? ManifoldMemories::View{} : memory_->view(at(number));
  }
  /// Energy that its springs held at the end of the step before [J].
  float energy(std::size_t i) const { return matches_[i].energy; }
  /// Whether it did not press at the end of the step before.
  bool is_new(std::size_t i) const { return matches_[i].is_new; }
  /// The shapes and the points of a manifold, without impulses.
  ManifoldMemory key(std::size_t i) const;

 private:
  struct Match {
    int memory = -1;                 ///< Index among the memories of the step before; -1 if there is none.
    float energy = 0;                ///< Energy of its springs [J].
    std::uint32_t surface : 31 = 0;  ///< Index among the surfaces.
    bool is_new : 1 = true;
  };
  void match_range(std::size_t begin, std::size_t end);
  int material_of(int body, int shape) const;

  ShapeRanges ranges_;
  std::vector<int> materials_;  ///< Material of each shape of all bodies.
  std::size_t material_count_ = 0;
  std::vector<ManifoldSurface> surfaces_;  ///< Surfaces of two materials, by first * count + second.
  const std::vector<ShapePair>* pairs_ = nullptr;
  const ManifoldList* manifolds_ = nullptr;
  const ManifoldMemories* memory_ = nullptr;  ///< Memories of the step before.
  std::vector<Match> matches_;                ///< One per manifold.
};

}  // namespace rigor
