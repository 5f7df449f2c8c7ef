#pragma once

#include "rigor/bulk/state/bulk_bodies.hpp"
#include "rigor/core/index.hpp"
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
  /// The boxes are where bodies are now: at the beginning of a step.
  void place(const BulkBodies& bodies);

  /// How the centre of a body goes in a step, straight, and how far rotations move its points meanwhile [m].
  struct Way {
    Vec3 dp_W;
    double turned;
  };
  /// Whether a face of one of the boxes parts two bodies all along their ways. `between`: from the centre of
  /// A to that of B at the beginning.
  bool are_parted(int body_A, int body_B, const Vec3& between_W, const Way& A, const Way& B) const;
  /// A box that a body does not leave, relative to where its centre was; none if nothing is known of it.
  std::optional<Aabb> swept(int body, const Way& way) const;

 private:
  /// Of a body, without room: nothing is known of it.
  struct Box {
    Vec3 center_B = Vec3::Zero(), half = Vec3::Constant(-1);  ///< From the body's centre, and half lengths.
    bool is_known() const { return half.x() >= 0; }
  };
  struct Placed {
    Mat3 R_WB;
    Vec3 center_W;  ///< From the body's centre.
  };
  std::vector<Box> boxes_;      ///< Of each body.
  std::vector<Placed> placed_;  ///< Likewise.
};

}  // namespace rigor
