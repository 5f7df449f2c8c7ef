#pragma once

#include "rigor/contact/system/contact.hpp"
#include "rigor/model/state.hpp"

#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace rigor {

/// Sides of the ground that a body cannot come to, in a State. What slides towards the seam of two floors of
/// one height is nearest to the side of the second one, or to its edge. But where the contact of a body with
/// one piece of ground has a plane that the body lies on, and another piece lies below that plane as a whole,
/// what holds the body on the plane keeps it apart from that piece, too. Pieces are convex shapes of fixed
/// bodies, or of one body.
class GroundPlanes {
 public:
  /// All contacts that are near, whether they will touch or not. Holds references to model and State.
  GroundPlanes(const Model& model, const State& state, const std::vector<Contact>& near);

  /// The contact whose plane hides this one, if any.
  std::optional<Contact> plane_before(const Contact& side) const;
  /// Without those that are hidden.
  void take_out_hidden(std::vector<Contact>& contacts) const;

 private:
  const Model& model_;
  const State& state_;
  /// Contacts with the ground of each shape of a body.
  std::map<std::pair<int, int>, std::vector<Contact>> planes_;
};

}  // namespace rigor
