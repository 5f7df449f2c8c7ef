#pragma once

#include "rigor/dynamics/environment.hpp"
#include "rigor/geometry/broad_phase/broad_phase.hpp"
#include "rigor/model/state.hpp"

#include <cstddef>
#include <functional>
#include <vector>

namespace rigor {

/// Dynamic bodies, ascending.
using BodyGroup = std::vector<int>;

/// What a body can reach: boxes, by body, of the dynamic bodies that have one.
using BodyRanges = std::vector<BoxItem>;

/// Joins groups of bodies whose ranges meet and that may collide, until no two do. A body without a range
/// meets nothing. The groups come in the order of their first bodies.
std::vector<BodyGroup> joined_where_they_meet(const Model& model, std::vector<BodyGroup> groups,
                                              const BodyRanges& ranges);

/// Where the dynamic bodies of the State may come until t_end [s] as long as none becomes faster than it is
/// now by more than what steady forces add, whatever impacts turn it to. tolerance: of contacts [m].
BodyRanges foreseen_ranges(const Model& model, const Environment& environment, const State& state,
                           double t_end, double tolerance);

/// The dynamic bodies in groups that have nothing to do with each other as long as they stay in these ranges:
/// joints, springs and what a body may come near keep bodies together. One group where a dynamic body has no
/// bounds.
std::vector<BodyGroup> groups_apart(const Model& model, const Environment& environment,
                                    const BodyRanges& ranges);

/// Which groups of the State's bodies are worth a thread.
struct WorthOfGroups {
  std::vector<bool> is_held;             ///< Of each body: something touches it.
  std::function<BodyRanges()> foreseen;  ///< Where bodies may come: asked if there may be two groups.
  std::size_t most;                      ///< More are dealt out to as many, since each costs something.
};
/// Those of several bodies, of which some move while something besides gravity acts on them. All others,
/// which fly, lie still or are alone, are one more. No groups if less than two are worth it.
std::vector<BodyGroup> groups_worth_a_thread(const Model& model, const Environment& environment,
                                             const State& state, const WorthOfGroups& worth);

}  // namespace rigor
