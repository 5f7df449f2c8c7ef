#include "rigor/sim/witness/marked_body.hpp"

#include "rigor/geometry/rays/inner_points.hpp"

#include <algorithm>
#include <unordered_map>

namespace rigor {

MarkedBody::MarkedBody(const std::vector<BodyShape>& shapes) {
  for (const BodyShape& shape : shapes) {
    first_marker.push_back(markers.size());
    for (const InnerPoint& inner : inner_points(shape.shape)) {
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

std::vector<std::shared_ptr<const MarkedBody>> mark_bodies(const Model& model) {
  std::vector<std::shared_ptr<const MarkedBody>> marked;
  std::unordered_map<const std::vector<BodyShape>*, std::shared_ptr<const MarkedBody>> known;
  for (const Body& body : model.bodies()) {
    std::shared_ptr<const MarkedBody>& own = known[&body.shapes.all()];
    if (!own) own = std::make_shared<const MarkedBody>(body.shapes);
    marked.push_back(own);
  }
  return marked;
}

}  // namespace rigor
