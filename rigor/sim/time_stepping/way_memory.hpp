#pragma once

#include "rigor/contact/system/contact.hpp"
#include "rigor/sim/islands/cluster.hpp"

#include <array>
#include <map>
#include <utility>
#include <vector>

namespace rigor {

/// What the tries of one step have shown of pairs of bodies. Of a pair whose bodies both move in this try as
/// they did in an earlier one it holds, bit for bit: other parts of the scene may have changed, or bodies
/// that come farther than was thought have let the same contacts stand.
class WayMemory {
 public:
  using Pair = std::pair<int, int>;

  /// Another step begins.
  void clear();
  /// Another try moves the bodies in h [s], from `struck`, after the impacts at the beginning, to `end`.
  /// Bodies that are not in the clusters move as they do in all tries of the step.
  void note(const Cluster& struck, const Cluster& end, double h);

  /// When the pair meets on its way, as find() says where that is not known [s].
  template <class Find>
  double meeting(const Pair& pair, const Find& find) {
    return known(meetings_, pair, find);
  }
  /// How long the pair goes no deeper into each other than it may [s].
  template <class Find>
  double clear_until(const Pair& pair, const Find& find) {
    return known(clear_until_, pair, find);
  }
  /// The contacts of the pair at the end.
  template <class Find>
  const std::vector<Contact>& contacts_at_end(const Pair& pair, const Find& find) {
    return known(at_end_, pair, find);
  }

 private:
  /// Of each body of a pair: the number of its way.
  using Numbers = std::array<long, 2>;
  template <class Value>
  struct Known {
    Numbers ways{0, 0};
    Value value{};
  };
  template <class Value>
  using Findings = std::map<Pair, Known<Value>>;

  template <class Value, class Find>
  const Value& known(Findings<Value>& findings, const Pair& pair, const Find& find) {
    const Numbers ways{number_of(pair.first), number_of(pair.second)};
    Known<Value>& finding = findings[pair];
    if (finding.ways == ways) return finding.value;
    finding.value = find();
    finding.ways = ways;
    return finding.value;
  }
  long number_of(int body) const;

  Cluster struck_, end_;         ///< Of the try before.
  double h_ = 0;                 ///< [s].
  std::map<int, long> numbers_;  ///< Of the ways of bodies that are not the first ones they have in h.
  Findings<double> meetings_, clear_until_;
  Findings<std::vector<Contact>> at_end_;
};

}  // namespace rigor
