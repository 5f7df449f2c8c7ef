#include "rigor/sim/islands/overlap_search.hpp"

#include "rigor/contact/bounded_overlap.hpp"
#include "rigor/core/index.hpp"
#include "rigor/core/rounding.hpp"
#include "rigor/core/sorted_unique.hpp"
#include "rigor/geometry/distance/thickness.hpp"
#include "rigor/math/roots.hpp"
#include "rigor/math/rotation.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

namespace {

/// The contact of the same features among the others; where an edge crosses the valley between two faces of a
/// mesh there is one for each face, and the lower counts.
const Contact* find_same(const Contact& contact, std::span<const Contact> others) {
  const Contact* lowest = nullptr;
  for (const Contact& other : others) {
    if (other.key() == contact.key() && (lowest == nullptr || other.point.gap < lowest->point.gap))
      lowest = &other;
  }
  return lowest;
}

/// Instants of a step at which the pairs in contact are looked at.
class Instants {
 public:
  Instants(const Model& model, const Island& island, const IslandStep& step, double contact_tolerance,
           std::span<const double> thickness)
      : model_(model),
        island_(island),
        step_(step),
        contact_tolerance_(contact_tolerance),
        thickness_(thickness),
        motions_(at(model.body_count())) {}

  /// The next one after `theta`, not after `end` (parts of the step).
  double next(std::span<const std::pair<int, int>> pairs, double theta, double end) {
    const double t = island_.begin + theta * step_.h, t_end = island_.begin + end * step_.h;
    double step = t_end - t;
    for (const auto& [a, b] : pairs) {
      if (!(step > 0)) break;
      // Between two instants points may go this deep: far less than through.
      constexpr double share = 0.1;
      const double slack = std::max(0.5 * contact_tolerance_,
                                    std::min(share * std::min(thickness_[at(a)], thickness_[at(b)]), 1e3));
      step = std::min(step, bounded_overlap_step(model_.body(a), motion(a), model_.body(b), motion(b), t,
                                                 t + step, slack));
    }
    return t + step >= t_end ? end : std::max(theta + step / step_.h, std::nextafter(theta, end));
  }

 private:
  const Motion& motion(int body) {
    std::optional<Motion>& known = motions_[at(body)];
    if (known) return *known;
    const auto place = std::lower_bound(island_.bodies.begin(), island_.bodies.end(), body);
    const bool is_of_island = place != island_.bodies.end() && *place == body;
    known = is_of_island ? Motion::step(step_.dense[static_cast<std::size_t>(place - island_.bodies.begin())],
                                        island_.begin, step_.h)
                         : Motion::prescribed(model_.body(body), island_.begin);
    return *known;
  }

  const Model& model_;
  const Island& island_;
  const IslandStep& step_;
  double contact_tolerance_;
  std::span<const double> thickness_;
  std::vector<std::optional<Motion>> motions_;  ///< By body, made when they are asked for.
};

}  // namespace

OverlapSearch::OverlapSearch(const Model& model, const Method& method)
    : model_(model), contact_tolerance_(method.contact_tolerance), time_tolerance_(method.time_tolerance) {
  for (int i = 0; i < model.body_count(); ++i) {
    double thickness = kInfinity;
    for (const BodyShape& shape : model.body(i).shapes)
      thickness = std::min(thickness, thickness_of(shape.shape));
    thickness_.push_back(thickness);
  }
}

std::vector<OverlapSearch::Pair> OverlapSearch::pairs_of(const Island& island) const {
  std::vector<Pair> pairs;
  for (const Contact& contact : island.contacts) {
    if (!contact.stop) pairs.emplace_back(contact.body_A, contact.body_B);
  }
  return sorted_unique(std::move(pairs));
}

Pose OverlapSearch::pose_at(const Island& island, const IslandStep& step, int body, double theta) const {
  const auto place = std::lower_bound(island.bodies.begin(), island.bodies.end(), body);
  if (place == island.bodies.end() || *place != body)
    return prescribed_kinetics(model_.body(body), island.begin + theta * step.h).pose();
  const std::size_t i = static_cast<std::size_t>(place - island.bodies.begin());
  const BodyPhase phase = theta == 1 ? step.end[i] : step.dense[i].at(theta);
  return {rotation_matrix(phase.q), phase.x};
}

std::vector<Contact> OverlapSearch::contacts_at(const Island& island, const IslandStep& step,
                                                double theta) const {
  std::vector<Contact> contacts;
  for (const auto& [a, b] : pairs_of(island)) {
    const std::vector<Contact> found = find_contacts(model_, a, b, pose_at(island, step, a, theta),
                                                     pose_at(island, step, b, theta), contact_tolerance_);
    contacts.insert(contacts.end(), found.begin(), found.end());
  }
  return contacts;
}

/// Least gap above the lowest that each contact may have [m]: at active contacts half the tolerance below
/// zero, for errors of the step. Further points land a little below zero; where one is there as the step
/// begins, it has come back when it is as low again.
double OverlapSearch::margin(const Island& island, std::span<const Contact> now,
                             std::span<const Contact> at_start) const {
  const double landing = -0.01 * contact_tolerance_, rounding = 1e-5 * contact_tolerance_;
  double margin = kInfinity;
  for (const Contact& contact : now) {
    double lowest = find_same(contact, island.contacts) ? -0.5 * contact_tolerance_ : landing;
    if (const Contact* before = find_same(contact, at_start))
      lowest = std::min(lowest, before->point.gap - rounding);
    margin = std::min(margin, contact.point.gap - lowest);
  }
  return margin;
}

std::optional<double> OverlapSearch::find(const Island& island, const IslandStep& step, double end) const {
  const std::vector<Pair> pairs = pairs_of(island);
  if (pairs.empty()) return std::nullopt;
  const std::vector<Contact> at_start = contacts_at(island, step, 0);
  const auto overlap = [&](double theta) {
    return margin(island, contacts_at(island, step, theta), at_start);
  };

  // Instant by instant, at least the middle and the end.
  Instants instants(model_, island, step, contact_tolerance_, thickness_);
  for (double theta = 0; theta < end;) {
    const double probe = instants.next(pairs, theta, theta < 0.5 * end ? 0.5 * end : end);
    // What is a little too low already may stay so, but not go deeper. A motion that overflows has margins
    // that are no numbers.
    const double before = overlap(theta);
    const double level = before < 0 ? before - 0.01 * contact_tolerance_ : 0;
    const auto above_level = [&](double part) { return overlap(part) - level; };
    if (above_level(probe) < 0 && before >= level)
      return find_root_bisection(above_level, theta, probe, time_tolerance_ / step.h).hi;
    theta = probe;
  }
  return std::nullopt;
}

}  // namespace rigor
