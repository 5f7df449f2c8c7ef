#include "rigor/sim/islands/groups_apart.hpp"

#include "rigor/bulk/graph/disjoint_sets.hpp"
#include "rigor/core/index.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace rigor {

namespace {

bool is_dynamic(const Model& model, int body) {
  return model.body(body).motion == MotionType::dynamic;
}

/// Sets of bodies as groups of dynamic ones.
std::vector<BodyGroup> groups_of(const Model& model, std::vector<int> sets) {
  std::vector<BodyGroup> groups;
  std::vector<int> group_of(sets.size(), -1);
  for (int body = 0; body < model.body_count(); ++body) {
    if (!is_dynamic(model, body)) continue;
    int& group = group_of[at(find_root(sets, body))];
    if (group < 0) {
      group = static_cast<int>(groups.size());
      groups.emplace_back();
    }
    groups[at(group)].push_back(body);
  }
  return groups;
}

/// The groups as at most so many, the largest first to those that have fewest bodies yet.
std::vector<BodyGroup> dealt_out(std::vector<BodyGroup> groups, std::size_t most) {
  if (groups.size() <= most) return groups;
  std::stable_sort(groups.begin(), groups.end(),
                   [](const BodyGroup& a, const BodyGroup& b) { return a.size() > b.size(); });
  std::vector<BodyGroup> hands(most);
  for (const BodyGroup& group : groups) {
    BodyGroup& smallest =
        *std::min_element(hands.begin(), hands.end(),
                          [](const BodyGroup& a, const BodyGroup& b) { return a.size() < b.size(); });
    smallest.insert(smallest.end(), group.begin(), group.end());
  }
  for (BodyGroup& hand : hands) std::sort(hand.begin(), hand.end());
  return hands;
}

}  // namespace

std::vector<BodyGroup> joined_where_they_meet(const Model& model, std::vector<BodyGroup> groups,
                                              const BodyRanges& ranges) {
  std::vector<int> sets(at(model.body_count()));
  std::iota(sets.begin(), sets.end(), 0);
  for (const BodyGroup& group : groups) {
    for (const int body : group) join_sets(sets, group.front(), body);
  }
  const std::unique_ptr<BroadPhase> boxes = make_broad_phase(BroadPhaseMethod::tree);
  std::vector<int> near;
  for (const BoxItem& range : ranges) {
    // Those that came before.
    boxes->overlapping(range.box, near);
    for (const int other : near) {
      if (find_root(sets, range.id) != find_root(sets, other) && model.may_collide(range.id, other))
        join_sets(sets, range.id, other);
    }
    boxes->set(range.id, range.box);
  }
  return groups_of(model, std::move(sets));
}

BodyRanges foreseen_ranges(const Model& model, const Environment& environment, const State& state,
                           double t_end, double tolerance) {
  const double h = t_end - state.t;
  BodyRanges ranges;
  for (int i = 0; i < model.body_count(); ++i) {
    const Body& body = model.body(i);
    if (!is_dynamic(model, i) || body.shapes.empty()) continue;

    // Impacts may turn its velocity any way.
    const Vec3 x = state.position(i);
    const double reach =
        body.bounding_radius + tolerance + 1e-12 * x.cwiseAbs().maxCoeff() +
        h * (state.linear_momentum(i).norm() / body.mass + h * environment.steady_acceleration(i).norm());
    ranges.push_back({i, Aabb{x, x}.grown(reach)});
  }
  return ranges;
}

std::vector<BodyGroup> groups_apart(const Model& model, const Environment& environment,
                                    const BodyRanges& ranges) {
  std::vector<int> sets(at(model.body_count()));
  std::iota(sets.begin(), sets.end(), 0);
  for (int i = 0; i < model.body_count(); ++i) {
    if (!is_dynamic(model, i)) continue;
    for (const int partner : environment.spring_partners(i)) join_sets(sets, i, partner);
    for (const int partner : environment.joint_partners(i)) join_sets(sets, i, partner);
  }
  const bool is_bounded = std::all_of(ranges.begin(), ranges.end(), [&](const BoxItem& range) {
    return std::isfinite(model.body(range.id).bounding_radius);
  });
  if (!is_bounded) {
    for (int i = 0; i < model.body_count(); ++i)
      if (is_dynamic(model, i)) join_sets(sets, ranges.front().id, i);
  }
  return joined_where_they_meet(model, groups_of(model, std::move(sets)), ranges);
}

std::vector<BodyGroup> groups_worth_a_thread(const Model& model, const Environment& environment,
                                             const State& state, const WorthOfGroups& worth) {
  // What only flies or lies still, as in a gas, is not worth asking who comes near whom.
  std::vector<bool> is_busy(at(model.body_count()));
  int busy = 0;
  for (int i = 0; i < model.body_count(); ++i) {
    const bool moves = !state.linear_momentum(i).isZero(0) || !state.angular_momentum(i).isZero(0);
    is_busy[at(i)] = is_dynamic(model, i) && (environment.is_forced(i) || (worth.is_held[at(i)] && moves));
    busy += is_busy[at(i)] ? 1 : 0;
  }
  if (busy < 2) return {};

  std::vector<BodyGroup> groups;
  BodyGroup others;
  for (BodyGroup& group : groups_apart(model, environment, worth.foreseen())) {
    const bool is_alone = group.size() == 1;
    if (!is_alone && std::any_of(group.begin(), group.end(), [&](int body) { return is_busy[at(body)]; })) {
      groups.push_back(std::move(group));
    } else {
      others.insert(others.end(), group.begin(), group.end());
    }
  }
  if (groups.size() < 2) return {};
  groups = dealt_out(std::move(groups), worth.most);
  std::sort(others.begin(), others.end());
  if (!others.empty()) groups.push_back(std::move(others));
  return groups;
}

}  // namespace rigor
