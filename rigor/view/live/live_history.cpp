#include "rigor/view/live/live_history.hpp"

#include "rigor/view/page/page_block.hpp"
#include "rigor/view/page/page_run.hpp"

#include <utility>

namespace rigor {

namespace {

constexpr std::uint32_t history_kind = 3;

/// Merges neighbours in pairs; a last one without a neighbour stays as it is.
template <typename Value, typename Join>
void halve(std::vector<Value>& values, Join join) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < values.size(); i += 2)
    values[kept++] = i + 1 < values.size() ? join(values[i], values[i + 1]) : values[i];
  values.resize(kept);
}

const MotionEvent& stronger(const MotionEvent& a, const MotionEvent& b) {
  return b.j_W.norm() > a.j_W.norm() ? b : a;
}

}  // namespace

void LiveHistory::clear() {
  const std::uint64_t revision = revision_ + 1;
  *this = {};
  revision_ = revision;
}

void LiveHistory::forget_after(double t) {
  ++revision_;
  std::erase_if(rows_, [t](const std::vector<double>& row) { return row[0] > t; });
  if (joined_ > 0 && pending_[0] > t) joined_ = 0;
  const auto is_later = [t](const MotionEvent& event) { return event.time > t; };
  event_count_ -= std::erase_if(events_, is_later);
  if (waiting_ == 0 || !is_later(candidate_)) return;
  waiting_ = 0;
  --event_count_;
}

void LiveHistory::add(std::vector<double> row, std::span<const MotionEvent> events) {
  ++revision_;
  pending_ = joined_ > 0 ? joined_rows(pending_, row) : std::move(row);
  if (++joined_ == rows_joined_) {
    rows_.push_back(std::exchange(pending_, {}));
    joined_ = 0;
  }
  if (rows_.size() == most_rows) {
    halve(rows_, joined_rows);
    rows_joined_ *= 2;
  }
  for (const MotionEvent& event : events) add_event(event);
}

void LiveHistory::add_event(const MotionEvent& event) {
  ++event_count_;
  candidate_ = waiting_ > 0 ? stronger(candidate_, event) : event;
  if (++waiting_ < events_joined_) return;
  waiting_ = 0;
  events_.push_back(candidate_);
  if (events_.size() < most_events) return;
  halve(events_, stronger);
  events_joined_ *= 2;
}

std::vector<std::vector<double>> LiveHistory::rows() const {
  std::vector<std::vector<double>> rows = rows_;
  if (joined_ > 0) rows.push_back(pending_);
  return rows;
}

std::vector<MotionEvent> LiveHistory::events() const {
  std::vector<MotionEvent> events = events_;
  if (waiting_ > 0) events.push_back(candidate_);
  return events;
}

std::string live_history_bytes(const LiveHistory& history, std::uint32_t generation, const Vec3& origin) {
  const std::vector<std::vector<double>> rows = history.rows();
  const std::vector<MotionEvent> events = history.events();
  const std::size_t series = rows.empty() ? 0 : rows[0].size();
  std::string bytes;
  for (const std::size_t number :
       {std::size_t{history_kind}, std::size_t{generation}, series, rows.size(), events.size()})
    append_u32(static_cast<std::uint32_t>(number), bytes);
  append_f64(static_cast<double>(history.event_count()), bytes);
  for (const std::vector<double>& row : rows) {
    for (const double value : row) append_f64(value, bytes);
  }
  for (const MotionEvent& event : events) {
    append_f64(event.time, bytes);
    append_u32(static_cast<std::uint32_t>(event.kind), bytes);
    append_u32(static_cast<std::uint32_t>(event.body_A), bytes);
    append_u32(static_cast<std::uint32_t>(event.body_B), bytes);
    for (const double x : Vec3(event.p_W - origin)) append_f32(static_cast<float>(x), bytes);
    for (const double j : event.j_W) append_f32(static_cast<float>(j), bytes);
  }
  return bytes;
}

}  // namespace rigor
