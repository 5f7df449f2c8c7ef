#pragma once

#include "rigor/view/recording/recording.hpp"

#include <string>
#include <vector>

namespace rigor {

/// An output time that is worth a picture, and what it shows.
struct KeyMoment {
  std::size_t frame;
  std::string what;  ///< "start", "impact ball – floor, 1.2 N s", ...; may be empty.
};

/// At most `most` (≥ 2) moments in chronological order:
///   the start and the end;
///   the deepest overlap, if it is more than the contact tolerance;
///   the impacts with the largest impulses, at most half of all pictures;
///   the first body that comes to rest, and the first that sticks after it slid;
///   then, repeatedly, the middle of the longest span without a picture.
/// A moment nearer than 1/(4 most) of the run to one that was chosen before it is left out.
std::vector<KeyMoment> find_key_moments(const Recording& recording, std::size_t most);

}  // namespace rigor
