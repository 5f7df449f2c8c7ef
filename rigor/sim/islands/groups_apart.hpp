#pragma once

#include "rigor/dynamics/environment.hpp"
#include "rigor/geometry/broad_phase/broad_phase.hpp"
#include "rigor/model/state.hpp"

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

/// The dynamic bodies of the State in groups that have nothing to do with each other until t_end [s] as long
/// as no body becomes faster than it is now by more than what gravity and steady forces add: joints, springs
/// and what a body may come near keep bodies together. tolerance: of contacts [m]. One group where a dynamic
/// body has no bounds.
std::vector<BodyGroup> groups_apart(const Model& model, const Environment& environment, const State& state,
                                    double t_end, double tolerance);

/// Those of these groups that are worth a thread: of several bodies, of which some move while something
/// besides gravity acts on them (is_held, of each body: something touches it). All others, which fly, lie
/// still or are alone, are one more. No groups if less than two are worth it, and never more than a few
/// dozen.
std::vector<BodyGroup> groups_worth_a_thread(const Model& model, const Environment& environment,
                                             const State& state, double t_end, double tolerance,
                                             const std::vector<bool>& is_held);

}  // namespace rigor
