#pragma once

#include "rigor/sim/audit/contact_snapshot.hpp"
#include "rigor/view/page/page_block.hpp"
#include "rigor/view/page/page_frames.hpp"

#include <memory>
#include <optional>
#include <vector>

namespace rigor {

/// One point for all neighbours in the list that are of the same two bodies: with the sum of their forces, in
/// the middle of these, the gap of the deepest and the mode of the one with the largest force.
std::vector<TouchingPoint> joined_by_pairs(const std::vector<TouchingPoint>& points);

/// The contacts of successive frames as they came.
struct ContactChunk {
  const Model& model;
  PageScale scale;
  double gap_step;  ///< [m].
  struct Frame {
    std::vector<TouchingPoint> points;
    std::shared_ptr<const State> state;  ///< See phases_of (page_frames.hpp).
  };
  std::vector<Frame> frames{};
};

/// Packs a chunk. It is self-contained: f64 force step [N], f64 gap step [m], f64 place step [m], f64 normal
/// step, u32 order (ColumnOrder), u32 frames; then columns of varints, one after the other: of each frame how
/// many contacts are new; how many of the last frame's stay, go, stay, ... until all are counted; of each new
/// contact its first body minus that of the new one before it in the frame (0 before the first), and the
/// second body minus the first. Contacts of a frame are in the order of their bodies; those of one pair stand
/// in the order of their numbering, and the last ones go first. Then eleven numbers of each contact: mode
/// (TouchingPoint::Mode), gap, point, normal, force. Points count from the middle of the centres of mass of
/// those of its two bodies that are not fixed, as PageFrames stores them, rounded half up to steps of places;
/// where the order is constant, normals from the direction between these centres, if both bodies move.
/// All numbers are stored as differences from the same contact in the previous frame, where it existed; point
/// and normal, where the order is linear, from linear extrapolation where it existed in the two previous
/// frames.
///
/// Crowds are stored no finer than is shown of them: points to 1/16 of the smallest body's radius, gaps to
/// 1/128 of it, normals to 1/32, forces to 1/32 of what all but a fiftieth of the contacts stay below; and
/// only what carries a force, whose force is not known, or that lies deeper than a thirty-second of that
/// radius.
PageBlock packed_contacts(const ContactChunk& chunk);

/// Collects the contacts of each frame in chunks.
class PageContacts {
 public:
  /// If a frame has more contacts, the first ones are kept.
  static constexpr std::size_t most_in_frame = 20000;
  /// A frame with more contacts, or of more than a thousand bodies, is a crowd: each pair of bodies has one
  /// (joined_by_pairs).
  static constexpr std::size_t most_single = 2000;

  /// contact_tolerance [m]: gaps are quantised to a sixteenth of it. model must outlive what add and finish
  /// return.
  PageContacts(const Model& model, const PageScale& scale, double contact_tolerance);
  /// Adds the contacts of one more frame; returns a chunk when it is full.
  std::optional<PagePacking> add(std::vector<TouchingPoint> points, std::shared_ptr<const State> phases);
  /// The frames since the last chunk, if there are any.
  std::optional<PagePacking> finish();

 private:
  ContactChunk chunk_;
  std::size_t count_ = 0;  ///< Number of contacts in the chunk.
};

}  // namespace rigor
