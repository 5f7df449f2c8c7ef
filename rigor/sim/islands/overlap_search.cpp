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

/// How often the part between two instants is halved for points that may have met and parted there.
constexpr int most_halvings = 20;

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
                                                std::span<const Pair> pairs, double theta) const {
  std::vector<Contact> contacts;
  for (const auto& [a, b] : pairs) {
    const std::vector<Contact> found = find_contacts(model_, a, b, pose_at(island, step, a, theta),
                                                     pose_at(island, step, b, theta), contact_tolerance_);
    contacts.insert(contacts.end(), found.begin(), found.end());
  }
  return contacts;
}

/// How low the gap of a contact may be [m]: at active contacts half the tolerance below zero, for errors of
/// the step. Further points land a little below zero; where one is there as the step begins, it has come back
/// when it is as low again.
double OverlapSearch::lowest_gap(const Contact& contact, const Island& island,
                                 std::span<const Contact> at_start) const {
  const double landing = -0.01 * contact_tolerance_, rounding = 1e-5 * contact_tolerance_;
  const double lowest = find_same(contact, island.contacts) ? -0.5 * contact_tolerance_ : landing;
  const Contact* before = find_same(contact, at_start);
  return before ? std::min(lowest, before->point.gap - rounding) : lowest;
}

/// The pairs in contact at a place of the step.
struct OverlapSearch::Sample {
  double theta;                   ///< Part of the step.
  std::vector<Contact> contacts;  ///< Closer than the tolerance.
  std::vector<double> clearance;  ///< Of each contact: its gap above the lowest it may have [m].
  std::vector<double> rate;       ///< Of each clearance, per part of the step [m].
  double margin = kInfinity;      ///< The least clearance [m].
};

namespace {

/// The least value that a convex function may have between two places that are `apart`, from its value and
/// rate at either: where the tangents meet.
double lowest_of_tangents(double first, double first_rate, double last, double last_rate, double apart) {
  if (!(first_rate < 0 && last_rate > 0)) return std::min(first, last);
  const double until = (last - first - last_rate * apart) / (first_rate - last_rate);
  return first + first_rate * std::clamp(until, 0.0, apart);
}

}  // namespace

/// Looks at the pairs of an island at places of its step.
class OverlapSearch::Looks {
 public:
  Looks(const OverlapSearch& search, const Island& island, const IslandStep& step, std::vector<Pair> pairs)
      : search_(search),
        island_(island),
        step_(step),
        pairs_(std::move(pairs)),
        at_start_(search.contacts_at(island, step, pairs_, 0)) {}

  /// The least clearance of these pairs.
  double margin(double theta, std::span<const Pair> pairs) const { return gaps_at(theta, pairs).margin; }
  Sample sample(double theta) const;
  /// The pairs that are lower than `level` at a place.
  std::vector<Pair> pairs_below(double level, double theta) const;

 private:
  Sample gaps_at(double theta, std::span<const Pair> pairs) const;

  const OverlapSearch& search_;
  const Island& island_;
  const IslandStep& step_;
  std::vector<Pair> pairs_;
  std::vector<Contact> at_start_;
};

OverlapSearch::Sample OverlapSearch::Looks::gaps_at(double theta, std::span<const Pair> pairs) const {
  const bool is_known = theta == 0 && pairs.size() == pairs_.size();
  Sample sample{theta, is_known ? at_start_ : search_.contacts_at(island_, step_, pairs, theta), {}, {}};
  for (const Contact& contact : sample.contacts) {
    sample.clearance.push_back(contact.point.gap - search_.lowest_gap(contact, island_, at_start_));
    sample.margin = std::min(sample.margin, sample.clearance.back());
  }
  return sample;
}

OverlapSearch::Sample OverlapSearch::Looks::sample(double theta) const {
  Sample sample = gaps_at(theta, pairs_);
  // The rate of a distance is that of the material points that are closest now, by differences of the poses.
  constexpr double difference = 1e-6;
  const double other = theta + difference <= 1 ? theta + difference : theta - difference;
  const auto velocity = [&](int body, const Vec3& p_W) -> Vec3 {
    const Vec3 p_B = search_.pose_at(island_, step_, body, theta).inverse() * p_W;
    return (search_.pose_at(island_, step_, body, other) * p_B - p_W) / (other - theta);
  };
  for (const Contact& contact : sample.contacts) {
    const ContactPoint& point = contact.point;
    sample.rate.push_back(
        point.n_W.dot(velocity(contact.body_B, point.p_WB) - velocity(contact.body_A, point.p_WA)));
  }
  return sample;
}

std::vector<OverlapSearch::Pair> OverlapSearch::Looks::pairs_below(double level, double theta) const {
  const Sample sample = gaps_at(theta, pairs_);
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < sample.contacts.size(); ++i) {
    if (!(sample.clearance[i] >= level))
      pairs.emplace_back(sample.contacts[i].body_A, sample.contacts[i].body_B);
  }
  return sorted_unique(std::move(pairs));
}

/// The least clearance that any contact may have between two places, if gaps are convex there. A contact that
/// is listed at one of them alone may fall all the way to the other, or have risen all the way from it.
double OverlapSearch::lowest_between(const Sample& from, const Sample& to) {
  const double apart = to.theta - from.theta;
  double lowest = std::min(from.margin, to.margin);
  for (std::size_t i = 0; i < from.contacts.size(); ++i) {
    const Contact* const same = find_same(from.contacts[i], to.contacts);
    if (same == nullptr) {
      lowest = std::min(lowest, from.clearance[i] + std::min(0.0, from.rate[i]) * apart);
    } else {
      const std::size_t k = static_cast<std::size_t>(same - to.contacts.data());
      lowest = std::min(
          lowest, lowest_of_tangents(from.clearance[i], from.rate[i], to.clearance[k], to.rate[k], apart));
    }
  }
  for (std::size_t k = 0; k < to.contacts.size(); ++k) {
    if (find_same(to.contacts[k], from.contacts) == nullptr)
      lowest = std::min(lowest, to.clearance[k] - std::max(0.0, to.rate[k]) * apart);
  }
  return lowest;
}

/// The first two places, one after the other, between which the margin falls below `level`, of all between
/// `from` and `to`; nothing if it stays above as far as gaps and rates tell.
std::optional<std::pair<double, double>> OverlapSearch::first_fall(const Looks& looks, const Sample& from,
                                                                   const Sample& to, double level,
                                                                   int halvings) const {
  if (to.margin < level) return std::pair{from.theta, to.theta};
  // What meets and parts between two places may go a part of the tolerance deep.
  const double deepest = level - 0.25 * contact_tolerance_;
  if (halvings == 0 || lowest_between(from, to) >= deepest) return std::nullopt;
  const Sample middle = looks.sample(0.5 * (from.theta + to.theta));
  if (const auto fall = first_fall(looks, from, middle, level, halvings - 1)) return fall;
  return first_fall(looks, middle, to, level, halvings - 1);
}

std::optional<double> OverlapSearch::find(const Island& island, const IslandStep& step, double end) const {
  const std::vector<Pair> pairs = pairs_of(island);
  if (pairs.empty()) return std::nullopt;
  const Looks looks(*this, island, step, pairs);

  // Instant by instant, at least the middle and the end.
  Instants instants(model_, island, step, contact_tolerance_, thickness_);
  for (Sample from = looks.sample(0); from.theta < end;) {
    const double theta = from.theta;
    Sample probe = looks.sample(instants.next(pairs, theta, theta < 0.5 * end ? 0.5 * end : end));
    // What is a little too low already may stay so, but not go deeper. A motion that overflows has margins
    // that are no numbers.
    const double level = from.margin < 0 ? from.margin - 0.01 * contact_tolerance_ : 0;
    if (const auto fall = first_fall(looks, from, probe, level, most_halvings)) {
      // The instant is that of the pairs that have fallen.
      const std::vector<Pair> fallen = looks.pairs_below(level, fall->second);
      const auto above_level = [&](double part) { return looks.margin(part, fallen) - level; };
      return find_root_bisection(above_level, fall->first, fall->second, time_tolerance_ / step.h).hi;
    }
    from = std::move(probe);
  }
  return std::nullopt;
}

}  // namespace rigor
