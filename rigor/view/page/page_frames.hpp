#pragma once

#include "rigor/model/state.hpp"
#include "rigor/view/page/page_block.hpp"

#include <array>
#include <cstdint>
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
/// body. The step of positions is 64 times finer where at most 64 bodies move, since that costs little there;
/// the step of contacts is 4 times coarser. Of more than a thousand bodies orientations and velocities are
/// stored no finer than one can see: the surface of the smallest body within twice the step of positions, and
/// 1/256.
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

/// Collects the motion of all bodies except fixed ones, quantised, and packs it in chunks of many frames
/// each. A chunk is self-contained: f64 speed step [m/s], f64 spin step [rad/s], u32 frames, u32 bodies; then
/// 13 columns for each body (append_column): x y z of the centre of mass in position steps from the origin;
/// index of the largest component of the quaternion and the three others; velocity x y z; angular velocity x
/// y z.
class PageFrames {
 public:
  PageFrames(const Model& model, const PageScale& scale);
  /// Adds one more frame; returns a chunk when it is full.
  std::optional<PageBlock> add(const State& state);
  int frame_count() const { return frame_count_; }
  /// Packs the frames since the last chunk, if there are any.
  std::optional<PageBlock> finish();

 private:
  struct BodyColumns {
    std::array<std::vector<std::int64_t>, 7> pose;
    std::array<std::vector<double>, 6> velocity;  ///< Quantised once the largest of the chunk is known.
  };
  const Model& model_;
  PageScale scale_;
  std::vector<int> moving_;  ///< Model indices.
  int chunk_size_;           ///< Frames.
  int frames_in_chunk_ = 0, frame_count_ = 0;
  std::vector<BodyColumns> columns_;
};

}  // namespace rigor
