#include "rigor/view/3d/key_moments.hpp"

#include "rigor/core/index.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace rigor {

namespace {

constexpr int impact = static_cast<int>(MotionEvent::Kind::impact);
constexpr int rest = static_cast<int>(MotionEvent::Kind::rest);
constexpr int slip_to_stick = static_cast<int>(MotionEvent::Kind::slip_to_stick);

/// Collects moments that are far enough apart from each other.
class Choice {
 public:
  Choice(const Recording& recording, std::size_t most)
      : recording_(recording),
        most_(most),
        gap_((recording.motion.time.back() - recording.motion.time.front()) /
             (4 * static_cast<double>(most))) {}

  bool is_full() const { return moments_.size() >= most_; }
  /// Adds a moment unless it is too close to another; whether it was added.
  bool add(std::size_t frame, std::string what) {
    const double t = time(frame);
    const bool is_near = std::any_of(moments_.begin(), moments_.end(), [&](const KeyMoment& moment) {
      return moment.frame == frame || std::abs(time(moment.frame) - t) < gap_;
    });
    if (is_full() || is_near) return false;
    const auto after = std::find_if(moments_.begin(), moments_.end(),
                                    [&](const KeyMoment& moment) { return moment.frame > frame; });
    moments_.insert(after, {frame, std::move(what)});
    return true;
  }
  /// Adds the middle of the longest span between two moments; false if there is nothing in between.
  bool add_in_longest_span() {
    std::size_t longest = 0;
    for (std::size_t i = 1; i + 1 < moments_.size(); ++i) {
      if (span(i) > span(longest)) longest = i;
    }
    if (moments_.size() < 2) return false;
    return add(nearest_frame(recording_, time(moments_[longest].frame) + 0.5 * span(longest)), "");
  }
  std::vector<KeyMoment> moments() && { return std::move(moments_); }

 private:
  double time(std::size_t frame) const { return recording_.motion.time[frame]; }
  double span(std::size_t i) const { return time(moments_[i + 1].frame) - time(moments_[i].frame); }

  const Recording& recording_;
  std::size_t most_;
  double gap_;  ///< [s].
  std::vector<KeyMoment> moments_;
};

std::string bodies_text(const StoredTrajectory& motion, std::size_t event) {
  std::string text;
  for (const int body : {motion.event_bodies[2 * event], motion.event_bodies[2 * event + 1]}) {
    if (body < 0 || body >= static_cast<int>(motion.bodies.size())) continue;
    text += fmt::format("{}{}", text.empty() ? "" : " – ", motion.bodies[at(body)]);
  }
  return text;
}

void add_deepest_overlap(const Recording& recording, Choice& choice) {
  const std::vector<double>& depth = recording.motion.penetration;
  const auto deepest = std::max_element(depth.begin(), depth.end());
  if (deepest == depth.end() || !(*deepest > recording.contact_tolerance)) return;
  choice.add(at(deepest - depth.begin()), fmt::format("overlap of {:.2g} m", *deepest));
}

void add_hardest_impacts(const Recording& recording, std::size_t most, Choice& choice) {
  const StoredTrajectory& motion = recording.motion;
  const auto impulse = [&](std::size_t event) { return Vec3::Map(&motion.event_impulse[3 * event]).norm(); };
  std::vector<std::size_t> impacts;
  for (std::size_t i = 0; i < motion.event_time.size(); ++i) {
    if (motion.event_kind[i] == impact) impacts.push_back(i);
  }
  std::stable_sort(impacts.begin(), impacts.end(),
                   [&](std::size_t a, std::size_t b) { return impulse(a) > impulse(b); });
  std::size_t taken = 0;
  for (const std::size_t event : impacts) {
    if (taken == most || choice.is_full()) return;
    taken += choice.add(nearest_frame(recording, motion.event_time[event]),
                        fmt::format("impact {}, {:.3g} N s", bodies_text(motion, event), impulse(event)));
  }
}

void add_first(const Recording& recording, int kind, const char* what, Choice& choice) {
  const StoredTrajectory& motion = recording.motion;
  const auto found = std::find(motion.event_kind.begin(), motion.event_kind.end(), kind);
  if (found == motion.event_kind.end()) return;
  const std::size_t event = at(found - motion.event_kind.begin());
  choice.add(nearest_frame(recording, motion.event_time[event]),
             fmt::format("{} {}", bodies_text(motion, event), what));
}

}  // namespace

std::vector<KeyMoment> find_key_moments(const Recording& recording, std::size_t most) {
  Choice choice(recording, most);
  choice.add(0, "start");
  choice.add(recording.frame_count() - 1, "end");
  add_deepest_overlap(recording, choice);
  add_hardest_impacts(recording, most / 2, choice);
  add_first(recording, rest, "comes to rest", choice);
  add_first(recording, slip_to_stick, "sticks", choice);
  while (!choice.is_full() && choice.add_in_longest_span()) continue;
  return std::move(choice).moments();
}

}  // namespace rigor
