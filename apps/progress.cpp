#include "apps/progress.hpp"

#include "apps/terminal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

namespace rigor {

namespace {

/// "2:05" or "1:02:05", or "-" if it is not known.
std::string duration_text(double seconds) {
  constexpr double most = 1e7;
  if (!(seconds >= 0 && seconds < most)) return "-";
  const long total = std::lround(seconds);
  const long hours = total / 3600, minutes = total / 60 % 60, rest = total % 60;
  return hours > 0 ? fmt::format("{}:{:02}:{:02}", hours, minutes, rest)
                   : fmt::format("{}:{:02}", minutes, rest);
}

/// The first parts, with commas, as many as fit into `width` characters.
std::string joined_within(const std::vector<std::string>& parts, int width) {
  std::string text;
  for (const std::string& part : parts) {
    const std::string_view separator = text.empty() ? "" : ", ";
    if (static_cast<int>(text.size() + separator.size() + part.size()) > width) break;
    text.append(separator).append(part);
  }
  return text;
}

}  // namespace

std::string progress_text(const Progress& progress, int width) {
  constexpr int narrowest_bar = 5, widest_bar = 20;
  constexpr double slow = 120;  // [s].
  const double span = progress.end - progress.start, done = progress.time - progress.start;
  const double share = span > 0 ? std::clamp(done / span, 0.0, 1.0) : 1.0;
  const double speed = progress.elapsed > 0 ? done / progress.elapsed : 0;
  const std::string times = fmt::format("{}{:.6g}/{:.6g} s ", progress.label, progress.time, progress.end);
  const double left = speed > 0 ? (span - done) / speed : -1;
  // What does not fit the line is left out whole, the least important first: no number is ever cut.
  std::vector<std::string> parts = {fmt::format("{:.3g}x real time", speed), "ETA " + duration_text(left),
                                    fmt::format("{} impacts", progress.impacts),
                                    fmt::format("{} at rest", progress.resting)};
  if (std::isfinite(progress.energy_drift))
    parts.push_back(fmt::format("energy drift {:.1g} J", progress.energy_drift));
  if (left > slow && !progress.advice.empty()) parts.push_back(progress.advice);
  const std::string rest = joined_within(parts, width - static_cast<int>(times.size()));
  // The bar takes the space that the numbers leave.
  const int room = width - static_cast<int>(times.size() + rest.size()) - 3;
  const int bar = room < narrowest_bar ? 0 : std::min(room, widest_bar);
  const int filled = static_cast<int>(share * bar);
  std::string text = times;
  if (bar > 0) text += fmt::format("[{:#<{}}{:.<{}}] ", "", filled, "", bar - filled);
  text += rest;
  if (static_cast<int>(text.size()) <= width) return text;
  const std::string percent = fmt::format("{:.0f} %", 100 * share);
  return static_cast<int>(percent.size()) <= width ? percent : std::string();
}

std::string progress_text(const CuttingProgress& progress, int width) {
  constexpr int widest_bar = 20;
  const double share = static_cast<double>(progress.pieces) / std::max(1, progress.most_pieces);
  const int filled = static_cast<int>(std::clamp(share, 0.0, 1.0) * widest_bar);
  std::vector<std::string> parts = {fmt::format("{} [{:#<{}}{:.<{}}] {} pieces", progress.label, "", filled,
                                                "", widest_bar - filled, progress.pieces)};
  if (std::isfinite(progress.excess))
    parts.push_back(fmt::format("the worst stands out {:.3g} m", progress.excess));
  const std::string text = joined_within(parts, width);
  return text.empty() ? joined_within({fmt::format("{} pieces", progress.pieces)}, width) : text;
}

ProgressLine::ProgressLine(bool is_wanted) : is_shown_(is_wanted && is_terminal(stderr)) {}

bool ProgressLine::is_due() {
  if (!is_shown_) return false;
  constexpr std::chrono::milliseconds pause(100);
  const std::chrono::steady_clock::time_point now = std::chrono::steady_clock::now();
  if (is_dirty_ && now - last_ < pause) return false;
  last_ = now;
  return true;
}

void ProgressLine::show(const std::string& text) {
  is_dirty_ = true;
  fmt::print(stderr, "\r{}\x1b[K", text);
  std::fflush(stderr);
}

void ProgressLine::update(const Progress& progress) {
  if (is_due()) show(progress_text(progress, terminal_width(stderr) - 1));
}

void ProgressLine::update(const CuttingProgress& progress) {
  if (is_due()) show(progress_text(progress, terminal_width(stderr) - 1));
}

void ProgressLine::clear() {
  if (!is_dirty_) return;
  is_dirty_ = false;
  fmt::print(stderr, "\r\x1b[K");
  std::fflush(stderr);
}

}  // namespace rigor
