#include "rigor/sim/witness/passage_witness.hpp"

#include "rigor/core/index.hpp"
#include "rigor/core/rounding.hpp"
#include "rigor/math/rotation.hpp"
#include "rigor/sim/witness/step_path.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace rigor {

namespace {

Aabb centre_box(const BodyPath& path) {
  if (path.empty()) return {Vec3::Zero(), Vec3::Zero()};
  Aabb box{Vec3::Constant(kInfinity), Vec3::Constant(-kInfinity)};
  for (const PathPiece& piece : path) box = box.united(piece.centre_box(piece.begin(), piece.end()));
  return box;
}

bool are_finite(const std::vector<double>& values) {
  return Eigen::Map<const Eigen::ArrayXd>(values.data(), static_cast<Eigen::Index>(values.size()))
      .allFinite();
}

}  // namespace

PassageWitness::PassageWitness(std::shared_ptr<const Model> model)
    : model_(std::move(model)),
      marked_(mark_bodies(*model_)),
      follows_anything_(std::any_of(marked_.begin(), marked_.end(),
                                    [](const auto& body) { return !body->markers.empty(); })) {}

PassageWitness::PassageWitness(const PassageWitness& other)
    : model_(other.model_), marked_(other.marked_), follows_anything_(other.follows_anything_) {}

void PassageWitness::watch(std::span<const BodyPath> paths, AdvanceReport& report) {
  if (!follows_anything_) return;
  watch_boxes(paths);

  // The tree is made anew now and then: it gets worse the farther the boxes move.
  constexpr long refits = 64;
  if (watches_++ % refits == 0) {
    std::vector<BoxItem> items;
    for (std::size_t k = 0; k < solid_boxes_.size(); ++k)
      items.push_back({static_cast<int>(k), solid_boxes_[k]});
    tree_.clear();
    tree_.build(items);
  } else {
    tree_.refit(solid_boxes_);
  }

  // Each body's markers against the solids that they may meet.
  const auto path_of = [&](int body) -> const BodyPath& { return paths[at(body)]; };
  std::vector<int> near;
  for (int a = 0; a < model_->body_count(); ++a) {
    if (marked_[at(a)]->markers.empty()) continue;
    tree_.overlapping(marker_boxes_[at(a)], near);
    for (const int k : near) {
      const Solid& solid = solid_of_[at(k)];
      if (solid.body != a && model_->may_collide(a, solid.body)) enter(a, solid, path_of, report);
    }
  }
}

/// Boxes of bodies that may turn by any angle while their centres go along these paths.
void PassageWitness::watch_boxes(std::span<const BodyPath> paths) {
  const bool is_first = solid_of_.empty();
  marker_boxes_.clear();
  std::size_t solid = 0;
  for (int i = 0; i < model_->body_count(); ++i) {
    const Body& body = model_->body(i);
    const Aabb centres = centre_box(paths[at(i)]);
    marker_boxes_.push_back(centres.grown(marked_[at(i)]->offset));
    for (int k = 0; k < static_cast<int>(body.shapes.size()); ++k, ++solid) {
      if (is_first) {
        const Pose X_WB{rotation_matrix(body.q_WB), body.p_WB};
        solid_of_.push_back({i, k});
        solid_boxes_.push_back(axis_aligned_box(body.shapes[at(k)].shape, X_WB * body.shapes[at(k)].X_BS));
      }
      if (body.motion != MotionType::fixed) solid_boxes_[solid] = centres.grown(body.bounding_radius);
    }
  }
}

void PassageWitness::begin(const State& state) {
  if (!follows_anything_) return;
  if (!pairs_) {
    environment_ = std::make_unique<Environment>(*model_);
    moves_.emplace(*model_, *environment_, marked_);
    pairs_.emplace(model_, marked_);
  } else {
    for (int i = 0; i < model_->body_count(); ++i) {
      if (before_.position(i) != state.position(i) ||
          before_.orientation(i).coeffs() != state.orientation(i).coeffs())
        pairs_->forget(i);
    }
  }
  remember(state);
}

void PassageWitness::remember(const State& state) {
  before_.t = state.t;
  before_.x = state.x, before_.q = state.q, before_.P = state.P, before_.L = state.L;
}

bool PassageWitness::is_watched(int a, int b, std::span<const int> groups) const {
  if (!is_here_.empty() && !(is_here_[at(a)] && is_here_[at(b)])) return false;
  return groups.empty() || (groups[at(a)] >= 0 && groups[at(b)] >= 0 && groups[at(a)] != groups[at(b)]);
}

void PassageWitness::watch(const State& after, AdvanceReport& report, std::span<const int> groups) {
  if (!follows_anything_) return;
  // What is not finite stops the run by itself.
  if (!(after.t > before_.t) || !are_finite(after.x) || !are_finite(after.q) || !are_finite(after.P) ||
      !are_finite(after.L))
    return begin(after);

  // Paths are made of the few bodies that come near another.
  std::map<int, BodyPath> paths;
  const auto path_of = [&](int body) -> const BodyPath& {
    BodyPath& path = paths[body];
    if (path.empty()) path.push_back(step_path(*model_, *environment_, body, before_, after));
    return path;
  };
  // In the order of the bodies whose markers are followed.
  std::vector<std::pair<int, int>> ordered;
  for (const WatchedPairs::Pair& pair : pairs_->meeting(before_, after, moves_->between(before_, after))) {
    if (!is_watched(pair.a, pair.b, groups)) continue;
    if (!marked_[at(pair.a)]->markers.empty()) ordered.emplace_back(pair.a, pair.b);
    if (!marked_[at(pair.b)]->markers.empty()) ordered.emplace_back(pair.b, pair.a);
  }
  std::sort(ordered.begin(), ordered.end());
  for (const auto& [a, b] : ordered) {
    for (int k = 0; k < static_cast<int>(model_->body(b).shapes.size()); ++k)
      enter(a, {b, k}, path_of, report);
  }
  remember(after);
}

/// Enters whether a marker of body a enters this solid.
template <class Paths>
void PassageWitness::enter(int a, const Solid& solid, const Paths& path_of, AdvanceReport& report) const {
  const auto entry = entry_of(a, solid, path_of(a), path_of(solid.body));
  if (entry) report.note_passage(a, solid.body, *entry);
}

/// The first time at which a marker of body a enters a shape of another.
std::optional<double> PassageWitness::entry_of(int a, const Solid& solid, const BodyPath& of_a,
                                               const BodyPath& of_b) const {
  const Body& body = model_->body(solid.body);
  std::optional<double> first;
  // Where pieces of both overlap in time; both lists are in order.
  for (auto i = of_a.begin(), j = of_b.begin(); i != of_a.end() && j != of_b.end() && !first;) {
    const double begin = std::max(i->begin(), j->begin()), end = std::min(i->end(), j->end());
    for (const Marker& marker : marked_[at(a)]->markers) {
      if (!(end > begin)) break;
      const RelativeTrajectory trajectory(*i, marker, *j, body, body.shapes[at(solid.shape)]);
      if (const auto entry = trajectory.first_entry(begin, first ? *first : end)) first = entry;
    }
    i->end() < j->end() ? ++i : ++j;
  }
  return first;
}

}  // namespace rigor
