#pragma once

#include "rigor/bulk/state/bulk_bodies.hpp"
#include "rigor/bulk/state/bulk_shape.hpp"
#include "rigor/geometry/shape/aabb.hpp"

#include <optional>
#include <vector>

namespace rigor {

/// Boxes along the axes of bodies that hold all of their shapes. Most pairs that come near each other with
/// the balls about them are parted by a face of one of these all along their ways.
class BodyBoxes {
 public:
  /// The box about all shapes of a body, in its frame; none: nothing is known of it, as of what is unbounded.
  void set_body(int body, const std::optional<Aabb>& box_B);

  /// How the centre of a body goes in a step, straight, and how far rotations move its points meanwhile [m].
  struct Way {
    Vec3 dp_W;
    double turned;
  };
  /// Whether a face of one of the boxes parts two bodies, which are where a step begins, all along their
  /// ways.
  bool are_parted(const BulkBodies& bodies, int body_A, int body_B, const Way& A, const Way& B) const;
  /// A box that a body does not leave, relative to where its centre is when a step begins; none if nothing is
  /// known of it.
  std::optional<Aabb> swept(const BulkBodies& bodies, int body, const Way& way) const;

 private:
  /// Of a body: from its centre, and half lengths; negative: nothing is known of it. In 32 bits, with the
  /// rounding added.
  struct Box {
    Vec3f center_B = Vec3f::Zero(), half = Vec3f::Constant(-1);
    bool is_known() const { return half.x() >= 0; }
  };
  std::vector<Box> boxes_;  ///< Of each body.
};

}  // namespace rigor
