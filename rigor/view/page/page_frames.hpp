#pragma once

#include "rigor/model/state.hpp"
#include "rigor/view/page/page_block.hpp"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace rigor {

/// The resolution with which a page stores positions.
struct PageScale {
  Vec3 origin;    ///< Middle of the bodies that move, at the start [m]; stored positions count from it.
  double extent;  ///< Diagonal of the box around them [m].
  double position_step;           ///< [m]; stored coordinates are off by half of it at most.
  double contact_step;            ///< [m]; the same for contact points, which are dots on the screen.
  double body_radius;             ///< Of the smallest moving body that has a size; else the extent [m].
  bool is_crowd = false;          ///< More than a thousand bodies move.
  int orientation_parts = 32767;  ///< Components of quaternions up to 1/√2 are stored in so many steps.
  int velocity_parts = 4096;      ///< The largest velocity of a chunk is stored in at least so many steps.
};
/// The steps are powers of two, at most 2e-5 of the extent (an error of 1e-5) and 2e-3 of the smallest moving
/// body. The step of positions is 64 times finer where at most 16 bodies move, since that costs little there;
/// the step of contacts is 4 times coarser. More than a thousand bodies are stored no finer than one can see:
/// positions to 2e-3 of the radius of the smallest body, orientations so that its surface is within twice the
/// step of positions, velocities to 1/256.
PageScale page_scale(const Model& model, const State& start);

/// A unit quaternion by its three smaller components, each in ±parts for ±1/√2.
struct PackedQuaternion {
  int largest;  ///< Index of the omitted component in w x y z; it is positive.
  std::array<std::int64_t, 3> others;
};
PackedQuaternion packed(const Quat& q, int parts = 32767);
/// Largest angle between an orientation and its packed form [rad], with 32767 parts; with fewer it grows in
/// proportion.
inline constexpr double packing_error = 8e-5;
inline double packing_error_of(int parts) {
  return packing_error * 32767 / parts;
}

/// What a page needs of a State: the time and the phases of all bodies.
std::shared_ptr<const State> phases_of(const State& state);

/// The motion of some bodies at successive output times.
struct FrameChunk {
  const Model& model;
  PageScale scale;
  std::vector<int> moving;                             ///< Model indices.
  std::vector<std::shared_ptr<const State>> states{};  ///< See phases_of.
};

/// Packs a chunk. It is self-contained: f64 speed step [m/s], f64 spin step [rad/s], f64 travel, f64 turn;
/// u32 order of the columns of velocities and of angular velocities (ColumnOrder), frames, bodies. Then
/// columns of varints: v x y z of each body, then w x y z of each (append_column); then, of each body, x y z
/// of the centre of mass in position steps from the origin; then, of each body, index of the largest
/// component of the quaternion (ColumnOrder::constant) and the three others.
///
/// Positions and orientations are residuals of what the velocities V, W (in steps) at both ends of an
/// interval make of the last pose: x + (travel (V_last + V) + 2¹⁵) / 2¹⁶, rounded down, and exp(turn (W_last
/// + W)) q, see predicted_orientation. The first ones of a chunk are whole.
PageBlock packed_frames(const FrameChunk& chunk);

/// exp(a) q for half a rotation vector a and q as w x y z: by its series to a⁶, which is enough for
/// residuals; q itself for |a| >= 2. The viewer does the same operations in the same order, so that both
/// round alike.
std::array<double, 4> predicted_orientation(const std::array<double, 4>& q, const std::array<double, 3>& a);

/// Collects the motion of all bodies except fixed ones in chunks of many frames.
class PageFrames {
 public:
  /// model must outlive what add and finish return.
  PageFrames(const Model& model, const PageScale& scale);
  /// Adds one more frame; returns a chunk when it is full.
  std::optional<PagePacking> add(std::shared_ptr<const State> phases);
  int frame_count() const { return frame_count_; }
  /// The frames since the last chunk, if there are any.
  std::optional<PagePacking> finish();

 private:
  FrameChunk chunk_;
  std::size_t chunk_size_;  ///< Frames.
  int frame_count_ = 0;
};

}  // namespace rigor
