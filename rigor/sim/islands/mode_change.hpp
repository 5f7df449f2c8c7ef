#pragma once

#include "rigor/sim/islands/contact_system_assembler.hpp"
#include "rigor/sim/islands/overlap_search.hpp"
#include "rigor/sim/method/method.hpp"

#include <optional>
#include <vector>

namespace rigor {

/// Why a step of an island must end early.
struct ModeChange {
  enum class Kind {
    slip_ends,    ///< A sliding contact comes to a stop.
    force_limit,  ///< A contact lets go, or a sticking one begins to slip.
    overlap,      ///< Further points of bodies in contact meet, or a joint meets a limit.
  };
  Kind kind;
  double h;               ///< Time since the island's begin [s].
  double slip_speed = 0;  ///< Kind slip_ends: |u_t| that the stopped contacts still have there [m/s].
};

/// The first time in the step at which the island's contact modes no longer hold, located on the dense
/// output; nothing if they hold to the end.
class ModeChangeSearch {
 public:
  ModeChangeSearch(const Model& model, const ContactSystemAssembler& assembler, const Method& method);

  std::optional<ModeChange> find(const Island& island, const IslandStep& step) const;
  /// Whether anything can end a step of the island early, so that its dense output is asked for.
  bool may_find(const Island& island) const;
  /// The first time at which further points of the bodies in contact meet or a joint meets a limit, and
  /// nothing else.
  std::optional<ModeChange> find_meeting(const Island& island, const IslandStep& step) const;
  /// How fast sliding contacts slip back at the end of the step, against the slip with which it began [m/s];
  /// of coordinates that are angles [rad/s].
  double reversed_slip(const Island& island, const IslandStep& step) const;

 private:
  struct Instant;
  /// The first time at which a joint meets a limit.
  std::optional<ModeChange> find_limit(const Island& island, const IslandStep& step) const;
  /// The first time before `end` (a part of the step) at which further points of the bodies in contact meet.
  std::optional<ModeChange> find_overlap(const Island& island, const IslandStep& step, double end) const;
  Instant at(const Island& island, const IslandStep& step, double theta) const;
  std::vector<Wrench> wrenches(const Island& island, const Instant& instant) const;
  /// The first time before `end` (a part of the step) at which a sliding contact stops.
  std::optional<ModeChange> find_slip_end(const Island& island, const IslandStep& step, double end) const;
  std::vector<double> slip_speeds(const Island& island, const IslandStep& step, double theta) const;
  double force_margin(const Island& island, const Instant& instant) const;
  double margin_of(const Island& island, const VecX& lambda) const;
  /// How far each limit that is no contact is away at a place of the step.
  std::vector<double> clearances(const Island& island, const IslandStep& step, double theta) const;
  bool modes_hold(const Island& island, const Instant& instant) const;

  const Model& model_;
  const ContactSystemAssembler& assembler_;
  OverlapSearch overlaps_;
  double contact_tolerance_, time_tolerance_, slip_tolerance_, direction_tolerance_, resting_velocity_;
  RestingChoice resting_;
};

}  // namespace rigor
