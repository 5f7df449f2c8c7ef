#pragma once

#include "rigor/sim/report/advance_report.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace rigor {

/// What a live run did since its last reset, in bounded memory: rows of the series (PageRun::last_row) and
/// events. Where there are too many rows, neighbours in time are joined two by two (joined_rows); of two
/// neighbouring events the one with the larger impulse stays.
class LiveHistory {
 public:
  static constexpr std::size_t most_rows = 1024, most_events = 1024;

  void clear();
  /// An output time and what happened since the last one.
  void add(std::vector<double> row, std::span<const MotionEvent> events);

  /// The last row and the last event may be those of fewer than the others.
  std::vector<std::vector<double>> rows() const;
  std::vector<MotionEvent> events() const;
  /// Events so far, also those that are not kept.
  std::uint64_t event_count() const { return event_count_; }
  /// Changes with everything that is added or cleared.
  std::uint64_t revision() const { return revision_; }

 private:
  void add_event(const MotionEvent& event);

  std::vector<std::vector<double>> rows_;
  std::vector<double> pending_;               ///< Fewer than rows_joined_ rows, joined.
  std::size_t joined_ = 0, rows_joined_ = 1;  ///< Rows in pending_, and in each of rows_.
  std::vector<MotionEvent> events_;
  MotionEvent candidate_{};                      ///< The strongest of the events that wait.
  std::size_t waiting_ = 0, events_joined_ = 1;  ///< Events that wait, and that each of events_ stands for.
  std::uint64_t event_count_ = 0, revision_ = 1;
};

/// The message of a history: all numbers little-endian, their order in docs/live.md.
/// origin: points are sent from here [m].
std::string live_history_bytes(const LiveHistory& history, std::uint32_t generation, const Vec3& origin);

}  // namespace rigor
