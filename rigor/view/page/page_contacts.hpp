#pragma once

#include "rigor/sim/audit/contact_snapshot.hpp"
#include "rigor/view/page/page_block.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace rigor {

struct PageScale;

/// One point for all neighbours in the list that are of the same two bodies: with the sum of their forces, in
/// the middle of these, the gap of the deepest and the mode of the one with the largest force.
std::vector<TouchingPoint> joined_by_pairs(const std::vector<TouchingPoint>& points);

/// Collects the contacts of each frame and packs them in chunks. A chunk is self-contained: f64 force step
/// [N], f64 gap step [m], f64 place step [m], f64 normal step, u32 frames; then columns of varints, one after
/// the other: for each frame the number of contacts; for each contact the first body minus that of the
/// previous contact in the frame, the second body minus the first, and eleven numbers: mode
/// (TouchingPoint::Mode), gap, point, normal, force. These numbers are stored as differences from the same
/// contact (the k-th of its pair) in the previous frame, where it existed; point and normal as differences
/// from linear extrapolation, where it existed in the two previous frames.
///
/// Crowds are stored no finer than is shown of them: points to 1/16 of the smallest body's radius, gaps to
/// 1/128 of it, normals to 1/32, forces to 1/64 of what all but a fiftieth of the contacts stay below; and
/// only what carries a force, whose force is not known, or that lies deeper than a thirty-second of that
/// radius.
class PageContacts {
 public:
  /// If a frame has more contacts, the first ones are kept.
  static constexpr std::size_t most_in_frame = 20000;
  /// A frame with more contacts, or of more than a thousand bodies, is a crowd: each pair of bodies has one
  /// (joined_by_pairs).
  static constexpr std::size_t most_single = 2000;

  /// contact_tolerance [m]: gaps are quantised to a sixteenth of it.
  PageContacts(const PageScale& scale, double contact_tolerance);
  /// Adds the contacts of one more frame; returns a chunk when it is full.
  std::optional<PageBlock> add(const std::vector<TouchingPoint>& points);
  /// Packs the frames since the last chunk, if there are any.
  std::optional<PageBlock> finish();

 private:
  static constexpr std::size_t numbers = 11;
  using Numbers = std::array<std::int64_t, numbers>;
  using Name = std::tuple<int, int, int>;  ///< The two bodies and the index of the contact among theirs.
  using Frame = std::vector<std::pair<Name, Numbers>>;  ///< In the order of the names.
  /// Sizes of the steps of a chunk.
  struct Steps {
    double force, gap, place, normal;
  };
  Steps steps_of_chunk() const;
  std::vector<TouchingPoint> crowd_of(const std::vector<TouchingPoint>& all) const;
  Numbers numbers_of(const TouchingPoint& point, const Steps& steps) const;
  static void put_in_order(Frame& frame);
  class Lookup;
  static Numbers expected(const Name& name, Lookup& last, Lookup& before);

  Vec3 origin_;
  double place_step_, gap_step_, body_radius_;
  bool is_crowd_of_bodies_;
  bool is_crowded_ = false;                         ///< A frame of the chunk is a crowd.
  std::vector<std::vector<TouchingPoint>> frames_;  ///< Frames of the chunk that is being filled.
  std::size_t count_ = 0;                           ///< Number of contacts in them.
};

}  // namespace rigor
