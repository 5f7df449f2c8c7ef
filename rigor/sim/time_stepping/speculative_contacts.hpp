#pragma once

#include "rigor/contact/system/contact.hpp"

#include <map>
#include <set>
#include <utility>
#include <vector>

namespace rigor {

/// What the tries of one step have shown of it so far: the next try begins with it.
struct SpeculativeContacts {
  using Pair = std::pair<int, int>;

  double h = 0;                 ///< Of the step that is tried next [s].
  std::vector<double> reaches;  ///< How far the points of each body may come in h [m].
  /// Pairs that met on the way or overlapped at its end, and the contacts that they had there, as they are at
  /// the beginning of the step.
  std::map<Pair, std::vector<Contact>> met = {};
  /// Those of them that no try has shown yet, but a guess of the motion.
  std::set<Pair> foreseen = {};
  std::set<Pair> met_at_once = {};  ///< Pairs that meet at the beginning, though they do not touch yet.

  /// A try shows better what the pair does.
  void take_back_foreseen(const Pair& pair) {
    if (foreseen.erase(pair) > 0) met.erase(pair);
  }
  /// Takes a shorter step, which reaches less far.
  void shorten(double shorter) {
    for (double& reach : reaches) reach *= shorter / h;
    h = shorter;
  }
};

}  // namespace rigor
