#pragma once

#include "rigor/contact/system/contact.hpp"
#include "rigor/sim/islands/island.hpp"
#include "rigor/sim/method/method.hpp"

#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace rigor {

/// Looks at the pairs of bodies in contact along a step of their island: no predictor watches them, since
/// they touch already, so that this search alone sees where further points of them meet.
class OverlapSearch {
 public:
  OverlapSearch(const Model& model, const Method& method);

  /// The part of the step, at most `end`, at which further points of the bodies in contact have met; nothing
  /// if none does before `end`. Instants are so close together that no point of a body goes through another
  /// body between two of them (bounded_overlap_step), and closer where the gaps and their rates at two of
  /// them do not exclude that points met and parted between.
  std::optional<double> find(const Island& island, const IslandStep& step, double end) const;

 private:
  using Pair = std::pair<int, int>;
  struct Sample;
  class Looks;

  std::vector<Pair> pairs_of(const Island& island) const;
  Pose pose_at(const Island& island, const IslandStep& step, int body, double theta) const;
  std::vector<Contact> contacts_at(const Island& island, const IslandStep& step, std::span<const Pair> pairs,
                                   double theta) const;
  double lowest_gap(const Contact& contact, const Island& island, std::span<const Contact> at_start) const;

  static double lowest_between(const Sample& from, const Sample& to);
  std::optional<std::pair<double, double>> first_fall(const Looks& looks, const Sample& from,
                                                      const Sample& to, double level, int halvings) const;

  const Model& model_;
  double contact_tolerance_, time_tolerance_;
  std::vector<double> thickness_;  ///< Of each body [m].
};

}  // namespace rigor
