#pragma once

#include "rigor/core/index.hpp"
#include "rigor/model/body_shapes.hpp"
#include "rigor/model/model.hpp"
#include "rigor/sim/witness/enclosure.hpp"

#include <memory>
#include <span>
#include <vector>

namespace rigor {

/// A point well inside a shape, on its body.
struct Marker {
  Vec3 p_B;          ///< [m].
  double clearance;  ///< InnerPoint::clearance [m].
};

/// What the witness knows of the shapes of a body.
struct MarkedBody {
  /// is_followed: it has markers; else enclosures alone.
  explicit MarkedBody(const std::vector<BodyShape>& shapes, bool is_followed = true);
  /// Those of one shape.
  std::span<const Marker> markers_of(int shape) const {
    return std::span(markers).subspan(first_marker[at(shape)],
                                      first_marker[at(shape) + 1] - first_marker[at(shape)]);
  }

  std::vector<Marker> markers;            ///< Of all shapes, one shape after the other.
  std::vector<std::size_t> first_marker;  ///< Of each shape, and one more at the end.
  std::vector<Enclosure> enclosures;      ///< One of each shape.
  double offset = 0;                      ///< Of the farthest marker from the origin of B [m].
  double turning = 0;  ///< Rotations by θ move no marker and no enclosure by more than θ times this [m].
};

/// The marked bodies of a Model; those with the same shapes are the same. Without marks if no two of them can
/// touch.
std::vector<std::shared_ptr<const MarkedBody>> mark_bodies(const Model& model);

}  // namespace rigor
