#pragma once

#include "rigor/sim/audit/contact_snapshot.hpp"
#include "rigor/view/page/page_block.hpp"

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

namespace rigor {

struct PageScale;

/// Collects the contacts of each frame and packs them in chunks. A chunk stands by itself: f64 force step
/// [N], f64 gap step [m], f64 place step [m], u32 frames; then columns of varints, one whole after the other:
/// of each frame the number of contacts; of each contact the first body less that of the contact before it in
/// the frame, the second body less the first, and eleven numbers: mode (TouchingPoint::Mode), gap, point,
/// normal in 1/1024, force. Of these numbers there is what differs from the same contact (the k-th of its
/// pair) in the frame before, where there was one; of point and normal from going on in a straight line,
/// where it was in the two frames before.
class PageContacts {
 public:
  /// Of more contacts in a frame the first ones are kept.
  static constexpr std::size_t most_in_frame = 20000;

  /// contact_tolerance [m]: gaps are told to a sixteenth of it.
  PageContacts(const PageScale& scale, double contact_tolerance);
  /// The contacts of one more frame. Gives a chunk when it is full.
  std::optional<PageBlock> add(const std::vector<TouchingPoint>& points);
  /// The frames since the last chunk, if there are any.
  std::optional<PageBlock> finish();

 private:
  static constexpr std::size_t numbers = 11;
  using Numbers = std::array<std::int64_t, numbers>;
  using Name = std::tuple<int, int, int>;  ///< Bodies and which of their contacts.
  using Frame = std::map<Name, Numbers>;
  Numbers numbers_of(const TouchingPoint& point, double force_step) const;
  static Numbers expected(const Name& name, const Frame& last, const Frame& before);

  Vec3 origin_;
  double place_step_, gap_step_;
  std::vector<std::vector<TouchingPoint>> frames_;  ///< Of the chunk that is being filled.
  std::size_t count_ = 0;                           ///< Contacts in them.
};

}  // namespace rigor
