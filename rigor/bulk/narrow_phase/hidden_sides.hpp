#pragma once

#include "rigor/bulk/narrow_phase/manifold_list.hpp"
#include "rigor/bulk/narrow_phase/narrow_phase.hpp"
#include "rigor/bulk/state/bulk_bodies.hpp"
#include "rigor/model/model.hpp"

#include <vector>

namespace rigor {

/// Takes out the manifolds with sides of the ground that a body cannot come to. On a floor of several boxes
/// the nearest points of what slides towards a seam lie on the side of the next box, or at its edge: as a
/// contact that would stop it there. But where the contact of a body with one piece of ground has a plane
/// that the body lies on, and another piece lies below that plane as a whole, what holds the body on the
/// plane keeps it apart from that piece, too. Pieces are convex shapes of fixed bodies, or of one body.
class HiddenSides {
 public:
  void take_out(const Model& model, const BulkBodies& bodies, const std::vector<ShapePair>& pairs,
                ManifoldList& manifolds);

 private:
  std::vector<int> last_;    ///< Of each body the last of its manifolds with the ground, -1: none.
  std::vector<int> before_;  ///< Of each manifold the one before it with the same body, -1: none.
  std::vector<char> is_hidden_;
};

}  // namespace rigor
