#pragma once

#include "rigor/view/page/page_frames.hpp"

#include <vector>

/// Reads back the motion that a page holds, in the way rigor/view/page/page_frames.hpp says.
namespace rigor::test {

struct ReadFrames {
  std::vector<std::vector<Vec3>> x, v, w;  ///< By frame, then body.
  std::vector<std::vector<Quat>> q;
  double speed_step = 0, spin_step = 0;  ///< The largest of all chunks.
};
/// The motion of these chunks, which follow one another.
ReadFrames read_frames(const std::vector<PageBlock>& chunks, const PageScale& scale);

}  // namespace rigor::test
