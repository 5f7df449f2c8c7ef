#pragma once

#include <span>

namespace rigor {

/// What of a Model was changed in place since a part of the solver last looked at it.
struct ChangedBodies {
  std::span<const int> bodies;  ///< That came, went or became others; ascending.
  bool are_ties_new = false;    ///< Whether joints or springs came, went or changed.
};

}  // namespace rigor
