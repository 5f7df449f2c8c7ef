#include "rigor/sim/witness/marked_body.hpp"

#include "rigor/geometry/rays/inner_points.hpp"

#include <algorithm>
#include <unordered_map>

namespace rigor {

MarkedBody::MarkedBody(const std::vector<BodyShape>& shapes, bool is_followed) {
  for (const BodyShape& shape : shapes) {
    first_marker.push_back(markers.size());
    for (const InnerPoint& inner : is_followed ? inner_points(shape.shape) : std::vector<InnerPoint>()) {
      Marker marker{shape.X_BS * inner.p_S, inner.clearance};
      // Rounding of the frame must not make the middle of a body a point that the rotation moves.
      if (marker.p_B.norm() <= 1e-9 * inner.clearance) marker.p_B.setZero();
      offset = std::max(offset, marker.p_B.norm());
      markers.push_back(marker);
    }
    enclosures.emplace_back(shape);
    turning = std::max(turning, enclosures.back().turning_radius());
  }
  first_marker.push_back(markers.size());
  turning = std::max(turning, offset);
}

namespace {

/// Whether any two bodies can touch.
bool can_anything_touch(const Model& model) {
  for (int a = 0; a < model.body_count(); ++a) {
    for (int b = a + 1; b < model.body_count(); ++b) {
      if (model.may_collide(a, b)) return true;
    }
  }
  return false;
}

}  // namespace

std::vector<std::shared_ptr<const MarkedBody>> mark_bodies(const Model& model) {
  std::vector<std::shared_ptr<const MarkedBody>> marked;
  // Of an arm whose links never touch nothing is to be followed.
  const bool are_followed = can_anything_touch(model);
  std::unordered_map<const std::vector<BodyShape>*, std::shared_ptr<const MarkedBody>> known;
  for (const Body& body : model.bodies()) {
    std::shared_ptr<const MarkedBody>& own = known[&body.shapes.all()];
    if (!own) own = std::make_shared<const MarkedBody>(body.shapes, are_followed);
    marked.push_back(own);
  }
  return marked;
}

}  // namespace rigor
