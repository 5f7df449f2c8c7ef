#pragma once

#include "rigor/bulk/state/manifold_memories.hpp"
#include "rigor/core/index.hpp"
#include "rigor/model/model.hpp"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace rigor {

/// Towers that the springs of contacts cannot hold upright: a column whose joints have the bending stiffness
/// k buckles under its own weight if it is higher than 7.84^(1/3) times (k a² / (m g a))^(1/3) of its bodies
/// (Greenhill, Determination of the greatest height consistent with stability that a vertical pole or mast
/// can be made, Proc. Cambridge Phil. Soc. 4, 1881). Cubes of the side a on springs of the frequency ω buckle
/// from (ω² a / g)^(1/3) of them on (docs/theory/bulk.md, section 3).
class SlenderTowers {
 public:
  explicit SlenderTowers(const Model& model);

  /// After gravity of the Model has changed; after a body has.
  void set_gravity(const Model& model);
  void set_body(const Model& model, int body);

  /// Whether there may be any: bodies that were pressed, by what stands still, with more than two thirds of
  /// the weight that buckles, at the end of the step before; in the first step, of which nothing is known,
  /// all bodies. substep [s].
  bool may_be_there(const ManifoldMemories& memory, double substep);
  /// What the tower of which this body is the lowest weighs at least if it is slender [kg]; infinite if the
  /// body was not pressed so.
  double least_mass(int body) const {
    return least_mass_.empty() ? std::numeric_limits<double>::infinity() : least_mass_[at(body)];
  }

 private:
  double slender_mass(std::size_t body, float cube) const;
  void drop_others(const ManifoldMemories& memory, double substep);

  std::vector<std::uint8_t> is_dynamic_;  ///< Bytes, which are read faster than bits.
  std::vector<float> weight_;             ///< [N].
  std::vector<float> size_;               ///< Radius about the centre of mass [m].
  double gravity_ = 0;                    ///< [m/s²].
  std::vector<double> least_mass_;        ///< Empty if it is infinite for all.
};

}  // namespace rigor
