#pragma once

#include "rigor/sim/report/advance_report.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace rigor {

/// What a live run did since its last reset, in bounded memory: rows of the series (PageRun::last_row) and
/// events. When there are too many rows, those that follow each other are merged in pairs (joined_rows); of
/// two successive events the one with the larger impulse stays.
class LiveHistory {
 public:
  static constexpr std::size_t most_rows = 1024, most_events = 1024;

  void clear();
  /// Forgets what came after this time [s], the first number of each row.
  void forget_after(double t);
  /// An output time and what happened since the last one.
  void add(std::vector<double> row, std::span<const MotionEvent> events);

  /// The rows and events that are kept; the last one of each may stand for fewer than the others.
  std::vector<std::vector<double>> rows() const;
  std::vector<MotionEvent> events() const;
  /// Number of events so far, including those that were dropped.
  std::uint64_t event_count() const { return event_count_; }
  /// Increases with everything that is added or cleared.
  std::uint64_t revision() const { return revision_; }

 private:
  void add_event(const MotionEvent& event);

  std::vector<std::vector<double>> rows_;
  std::vector<double> pending_;               ///< Merger of fewer than rows_joined_ rows.
  std::size_t joined_ = 0, rows_joined_ = 1;  ///< Number of rows merged in pending_, and in each of rows_.
  std::vector<MotionEvent> events_;
  MotionEvent candidate_{};                      ///< The strongest of the waiting events.
  std::size_t waiting_ = 0, events_joined_ = 1;  ///< Waiting events, and events behind each of events_.
  std::uint64_t event_count_ = 0, revision_ = 1;
};

/// The message of a history: all numbers are little-endian, in the order of docs/live.md.
/// origin: points are sent relative to it [m].
std::string live_history_bytes(const LiveHistory& history, std::uint32_t generation, const Vec3& origin);

}  // namespace rigor
