#include "rigor/sim/event_driven/trajectories.hpp"

#include "rigor/core/interrupt.hpp"
#include "rigor/core/rounding.hpp"
#include "rigor/geometry/motion/separation_bound.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rigor {

Trajectories::Trajectories(const Model& model, const ToiOptions& options, BroadPhaseMethod method)
    : model_(model),
      options_(options),
      tracks_(at(model.body_count())),
      boxes_(make_broad_phase(method)),
      is_followed_(at(model.body_count()), true) {
  for (int i = 0; i < model.body_count(); ++i) {
    double radius = 0;
    for (const BodyShape& shape : model.body(i).shapes) {
      radius = std::max(radius, turning_radius(shape.shape, shape.X_BS, shape.radius));
    }
    turning_radii_.push_back(radius);
    if (!is_bounded(i) && !model.body(i).shapes.empty()) unbounded_.push_back(i);
  }
}

bool Trajectories::is_bounded(int body) const {
  return std::isfinite(model_.body(body).bounding_radius);
}

/// Whether its windows have boxes.
bool Trajectories::has_box(int body) const {
  return is_bounded(body) && !model_.body(body).shapes.empty();
}

void Trajectories::follow_only(const std::vector<bool>& is_followed) {
  is_followed_ = is_followed;
  for (int body = 0; body < model_.body_count(); ++body) {
    if (!is_followed_[at(body)]) boxes_->remove(body);
  }
}

void Trajectories::begin_ranges(double t, double t_end, bool has_windows) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  ranges_.assign(tracks_.size(), {Vec3::Constant(infinite), Vec3::Constant(-infinite)});
  ranges_begin_ = t;
  ranges_end_ = t_end;
  for (int body = 0; body < model_.body_count() && has_windows; ++body) {
    if (is_followed_[at(body)]) extend_range(body);
  }
}

/// Where the body comes in its present window.
void Trajectories::extend_range(int body) {
  const Track& track = tracks_[at(body)];
  const double begin = std::max(track.window_begin, ranges_begin_),
               end = std::min(track.window_end, ranges_end_);
  if (!has_box(body) || end < begin) return;
  ranges_[at(body)] = ranges_[at(body)].united(box_of(body, begin, end).grown(margin(body, begin)));
}

void Trajectories::set_motion(int body, const Motion& motion, double t) {
  Track& track = tracks_[at(body)];
  if (t > track.followed && !paths_.empty()) {
    paths_[at(body)].emplace_back(track.followed, t, track.motion);
    track.followed = t;
    ++piece_count_;
  }
  track.motion = motion;
  track.window_begin = t;
  ++track.version;
}

void Trajectories::begin_paths(double t) {
  paths_.assign(tracks_.size(), {});
  piece_count_ = 0;
  for (Track& track : tracks_) track.followed = t;
}

std::vector<BodyPath> Trajectories::take_paths(double t) {
  for (std::size_t body = 0; body < tracks_.size(); ++body) {
    if (is_followed_[body] && t > tracks_[body].followed)
      paths_[body].emplace_back(tracks_[body].followed, t, tracks_[body].motion);
  }
  std::vector<BodyPath> paths = std::move(paths_);
  begin_paths(t);
  return paths;
}

void Trajectories::clear_lasting_contacts(int body) {
  std::erase_if(lasting_, [body](const std::pair<int, int>& pair) {
    return pair.first == body || pair.second == body;
  });
}

/// Time in which a body in flight moves by about twice its diameter: long enough to be rare, short enough for
/// a small box.
double Trajectories::window_length(int body, double t) const {
  const Motion& motion = tracks_[at(body)].motion;
  if (!motion.is_ballistic()) return motion.end() - t;
  const double radius = model_.body(body).bounding_radius;
  const double speed = motion.velocity(t).norm() + std::sqrt(radius * motion.acceleration().norm()) +
                       turning_radii_[at(body)] * motion.max_angular_speed();
  if (speed == 0) return std::numeric_limits<double>::infinity();
  return 4 * (radius > 0 && std::isfinite(radius) ? radius : model_.length_scale()) / speed;
}

Aabb Trajectories::box_of(int body, double ta, double tb) const {
  const Motion& motion = tracks_[at(body)].motion;
  const Body& of_body = model_.body(body);
  if (motion.max_angular_speed() > 0 && turning_radii_[at(body)] > 0)
    return motion.path_box(ta, tb).grown(of_body.bounding_radius);

  // A body that does not rotate has a tight box that moves along.
  Aabb tight{Vec3::Constant(std::numeric_limits<double>::infinity()),
             Vec3::Constant(-std::numeric_limits<double>::infinity())};
  const Pose X_WB = motion.sample(ta).X_WB;
  for (const BodyShape& shape : of_body.shapes)
    tight = tight.united(axis_aligned_box(shape.shape, X_WB * shape.X_BS));
  const Aabb path = motion.path_box(ta, tb);
  return {path.lower + (tight.lower - X_WB.p), path.upper + (tight.upper - X_WB.p)};
}

/// By how much a box is larger than where the body comes from t on [m].
double Trajectories::margin(int body, double t) const {
  const double rounding = 1e-12 * tracks_[at(body)].motion.position(t).cwiseAbs().maxCoeff();
  return options_.contact_tolerance + rounding;
}

double Trajectories::window_end(int body, double t) const {
  const Motion& motion = tracks_[at(body)].motion;

  // Bodies without a box are watched as long as their motion lasts.
  const bool is_tracked = has_box(body);
  // Not so short, however small and fast the body is, that a run would be of windows only.
  constexpr double least = 1e5;  // In units of the time tolerance.
  const double shortest = std::max(least * options_.time_tolerance, 8 * kEpsilon * std::abs(t));
  return is_tracked ? std::min(motion.end(), t + std::max(window_length(body, t), shortest)) : motion.end();
}

void Trajectories::begin_window(int body, double t, EventQueue& queue) {
  Track& track = tracks_[at(body)];
  ++track.version;
  track.window_begin = t;
  track.window_end = window_end(body, t);
  if (has_box(body)) {
    const double box_end = std::isinf(track.window_end) ? t : track.window_end;
    track.box = box_of(body, t, box_end).grown(margin(body, t));
    boxes_->set(body, track.box);
    if (!ranges_.empty()) extend_range(body);
  }
  // The end of a step is its island's event; all other ends are the window's own.
  if (std::isfinite(track.window_end) && track.motion.is_ballistic()) {
    queue.push({track.window_end, QueuedEvent::Kind::window_end, body, -1, track.version, 0, 0});
  }
}

bool Trajectories::is_still(int body) const {
  const Track& track = tracks_[at(body)];
  const Motion& motion = track.motion;
  return motion.is_ballistic() && motion.max_angular_speed() == 0 && motion.acceleration().isZero(0) &&
         motion.velocity(track.window_begin).isZero(0);
}

bool Trajectories::can_meet(int a, int b) const {
  if (!model_.may_collide(a, b) || has_lasting_contact(a, b)) return false;
  return !(is_still(a) && is_still(b));
}

void Trajectories::predict_pair(int a, int b, double from, EventQueue& queue) {
  if (a > b) std::swap(a, b);
  if (!can_meet(a, b)) return;
  const Track& A = tracks_[at(a)];
  const Track& B = tracks_[at(b)];

  // The common span of both windows, from where the pair is proven free.
  const double t0 = std::max({A.window_begin, B.window_begin, from});
  const double t1 = std::min(A.window_end, B.window_end);
  if (!(t1 > t0)) return;

  // The first contact in it; a search that is not finished waits in the queue.
  const TimeOfImpact found =
      find_time_of_impact(model_.body(a), A.motion, model_.body(b), B.motion, t0, t1, options_);
  distance_queries_ += found.evaluations;
  if (found.is_contact) {
    queue.push({found.time, QueuedEvent::Kind::contact, a, b, A.version, B.version, found.bracket});
  } else if (found.time < t1) {
    queue.push({found.time, QueuedEvent::Kind::search, a, b, A.version, B.version, 0});
  }
}

void Trajectories::predict_pairs(const std::vector<int>& bodies, EventQueue& queue) {
  std::set<std::pair<int, int>> done;
  for (const int body : bodies) {
    for (const int other : candidates(body)) {
      const bool is_shared = bodies.size() > 1 && !done.insert(std::minmax(body, other)).second;
      if (other != body && !is_shared) predict_pair(body, other, tracks_[at(body)].window_begin, queue);
    }
  }
}

void Trajectories::predict(const std::vector<int>& bodies, double t, EventQueue& queue) {
  for (const int body : bodies) begin_window(body, t, queue);
  predict_pairs(bodies, queue);
}

void Trajectories::restore(const std::vector<int>& bodies, double t, EventQueue& queue) {
  for (const int body : bodies) {
    // The windows since the motion began, as they came to be; after millions of them a new one will do.
    constexpr long most_windows = 3000000;
    double begin = tracks_[at(body)].motion.begin();
    long count = 0;
    for (double end = window_end(body, begin); end < t && count < most_windows; ++count) {
      poll_interrupt();
      begin = end;
      end = window_end(body, begin);
    }
    begin_window(body, count < most_windows ? begin : t, queue);
  }
}

void Trajectories::predict_among(const std::vector<int>& bodies, EventQueue& queue) {
  std::vector<bool> is_among(tracks_.size(), false);
  for (const int body : bodies) is_among[at(body)] = true;
  for (const int body : bodies) {
    for (const int other : candidates(body)) {
      if (other > body && is_among[at(other)])
        predict_pair(body, other, tracks_[at(body)].window_begin, queue);
    }
  }
}

/// Bodies whose windows meet that of this one.
std::vector<int> Trajectories::candidates(int body) const {
  std::vector<int> near;
  if (model_.body(body).shapes.empty()) return near;
  if (is_bounded(body)) {
    boxes_->overlapping(tracks_[at(body)].box, near);
    near.insert(near.end(), unbounded_.begin(), unbounded_.end());
  } else {
    for (int other = 0; other < model_.body_count(); ++other) {
      if (is_followed_[at(other)]) near.push_back(other);
    }
  }
  return near;
}

bool Trajectories::is_current(const QueuedEvent& event) const {
  if (event.kind == QueuedEvent::Kind::step_end) return true;
  if (tracks_[at(event.a)].version != event.stamp_a) return false;
  return event.b < 0 || tracks_[at(event.b)].version == event.stamp_b;
}

std::vector<int> Trajectories::neighbours(int body, double t, double tolerance) const {
  std::vector<int> near;
  if (model_.body(body).shapes.empty()) return near;
  if (is_bounded(body)) {
    boxes_->overlapping(box_of(body, t, t).grown(tolerance), near);
    near.insert(near.end(), unbounded_.begin(), unbounded_.end());
    std::sort(near.begin(), near.end());
  } else {
    for (int other = 0; other < model_.body_count(); ++other) {
      if (is_followed_[at(other)]) near.push_back(other);
    }
  }
  std::erase_if(near, [&](int other) { return other == body || !model_.may_collide(body, other); });
  return near;
}

}  // namespace rigor
