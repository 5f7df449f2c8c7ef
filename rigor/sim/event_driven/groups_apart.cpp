#include "rigor/sim/event_driven/groups_apart.hpp"

#include "rigor/bulk/graph/disjoint_sets.hpp"
#include "rigor/core/index.hpp"

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

std::vector<BodyGroup> groups_apart(const Model& model, const Environment& environment, const State& state,
                                    double t_end, double tolerance) {
  const double h = t_end - state.t;
  std::vector<int> sets(at(model.body_count()));
  std::iota(sets.begin(), sets.end(), 0);
  int first = -1;
  bool is_bounded = true;
  BodyRanges ranges;
  for (int i = 0; i < model.body_count(); ++i) {
    if (!is_dynamic(model, i)) continue;
    if (first < 0) first = i;
    for (const int partner : environment.spring_partners(i)) join_sets(sets, i, partner);
    for (const int partner : environment.joint_partners(i)) join_sets(sets, i, partner);
    const Body& body = model.body(i);
    if (body.shapes.empty()) continue;
    is_bounded = is_bounded && std::isfinite(body.bounding_radius);

    // Impacts may turn its velocity any way.
    const Vec3 x = state.position(i);
    const double reach =
        body.bounding_radius + tolerance + 1e-12 * x.cwiseAbs().maxCoeff() +
        h * (state.linear_momentum(i).norm() / body.mass + h * environment.steady_acceleration(i).norm());
    ranges.push_back({i, Aabb{x, x}.grown(reach)});
  }
  for (int i = 0; i < model.body_count() && !is_bounded; ++i) {
    if (is_dynamic(model, i)) join_sets(sets, first, i);
  }
  return joined_where_they_meet(model, groups_of(model, std::move(sets)), ranges);
}

}  // namespace rigor
