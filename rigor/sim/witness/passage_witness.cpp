#include "rigor/sim/witness/passage_witness.hpp"

#include "rigor/core/index.hpp"
#include "rigor/core/rounding.hpp"
#include "rigor/geometry/rays/inner_points.hpp"
#include "rigor/math/rotation.hpp"
#include "rigor/sim/witness/step_way.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace rigor {

namespace {

Aabb centre_box(const BodyPath& path) {
  if (path.empty()) return {Vec3::Zero(), Vec3::Zero()};
  Aabb box{Vec3::Constant(kInfinity), Vec3::Constant(-kInfinity)};
  for (const PathPiece& piece : path) box = box.united(piece.centre_box(piece.begin(), piece.end()));
  return box;
}

/// Box of the centre of mass on its way, straight or in flight.
Aabb centre_box(const Vec3& from, const Vec3& to, double h, double acceleration) {
  return Aabb{from.cwiseMin(to), from.cwiseMax(to)}.grown(0.125 * h * h * acceleration);
}

Pose pose_in(const State& state, int body) {
  return {rotation_matrix(state.orientation(body)), state.position(body)};
}

bool is_finite(const State& state, int body) {
  return BodyPhase{state.position(body), state.orientation(body), state.linear_momentum(body),
                   state.angular_momentum(body)}
      .is_finite();
}

}  // namespace

PassageWitness::PassageWitness(std::shared_ptr<const Model> model)
    : model_(std::move(model)), environment_(*model_) {
  for (int i = 0; i < model_->body_count(); ++i) {
    add_markers(i);
    add_solids(i);
  }
  first_solid_.push_back(solid_of_.size());
  ways_.resize(markers_.size(), {Vec3::Zero(), Vec3::Zero()});
}

void PassageWitness::add_markers(int i) {
  std::vector<Marker> markers;
  double offset = 0;
  for (const BodyShape& shape : model_->body(i).shapes) {
    for (const InnerPoint& inner : inner_points(shape.shape)) {
      Marker marker{shape.X_BS * inner.p_S, inner.clearance};
      // Rounding of the frame must not make the middle of a body a point that the rotation moves.
      if (marker.p_B.norm() <= 1e-9 * inner.clearance) marker.p_B.setZero();
      offset = std::max(offset, marker.p_B.norm());
      markers.push_back(marker);
    }
  }
  markers_.push_back(std::move(markers));
  offset_.push_back(offset);
}

void PassageWitness::add_solids(int i) {
  const Body& body = model_->body(i);
  const Pose X_WB{rotation_matrix(body.q_WB), body.p_WB};
  first_solid_.push_back(solid_of_.size());
  for (int k = 0; k < static_cast<int>(body.shapes.size()); ++k) {
    const BodyShape& shape = body.shapes[at(k)];
    solid_of_.push_back({i, k});
    solids_.push_back(axis_aligned_box(shape.shape, X_WB * shape.X_BS));
  }
}

/// The boxes of a body that may turn by any angle while its centre goes this way.
void PassageWitness::box_freely(int i, const Aabb& centre_way) {
  const Body& body = model_->body(i);
  ways_[at(i)] = centre_way.grown(offset_[at(i)]);
  for (std::size_t k = first_solid_[at(i)]; k < first_solid_[at(i) + 1]; ++k) {
    if (body.motion != MotionType::fixed) solids_[k] = centre_way.grown(body.bounding_radius);
  }
}

/// The boxes of a body that turns by little: those at both ends, and between them the sagitta of its arc.
void PassageWitness::box_closely(int i, double turn, const State& before, const State& after) {
  const Body& body = model_->body(i);
  const Pose at_begin = pose_in(before, i), at_end = pose_in(after, i);
  for (const Marker& marker : markers_[at(i)]) {
    const Vec3 p = at_begin * marker.p_B, q = at_end * marker.p_B;
    ways_[at(i)] = ways_[at(i)].united({p.cwiseMin(q), p.cwiseMax(q)});
  }
  ways_[at(i)] = ways_[at(i)].grown(turn * turn * offset_[at(i)]);
  for (std::size_t k = first_solid_[at(i)]; k < first_solid_[at(i) + 1]; ++k) {
    if (body.motion == MotionType::fixed) break;
    const BodyShape& shape = body.shapes[at(solid_of_[k].shape)];
    solids_[k] = axis_aligned_box(shape.shape, at_begin * shape.X_BS)
                     .united(axis_aligned_box(shape.shape, at_end * shape.X_BS))
                     .grown(turn * turn * body.bounding_radius);
  }
}

void PassageWitness::watch(std::span<const BodyPath> paths, AdvanceReport& report) {
  for (int i = 0; i < model_->body_count(); ++i) box_freely(i, centre_box(paths[at(i)]));
  find([&](int body) -> const BodyPath& { return paths[at(body)]; }, report);
}

void PassageWitness::watch(const State& before, const State& after, AdvanceReport& report) {
  if (!(after.t > before.t)) return;
  constexpr double little = 0.5;  // [rad].
  const double h = after.t - before.t;
  for (int i = 0; i < model_->body_count(); ++i) {
    // What is not finite stops the run by itself.
    if (!is_finite(after, i)) return;
    const Body& body = model_->body(i);
    const double acceleration =
        body.motion == MotionType::dynamic ? environment_.steady_acceleration(i).norm() : 0;
    const Aabb way = centre_box(before.position(i), after.position(i), h, acceleration);
    const double turn = body.motion == MotionType::fixed ? 0 : step_turn(*model_, i, before, after);
    if (turn <= little && (std::isfinite(body.bounding_radius) || body.motion == MotionType::fixed)) {
      ways_[at(i)] = way;
      box_closely(i, turn, before, after);
    } else {
      box_freely(i, way);
    }
  }

  // Paths are made of the few bodies that come near another.
  std::vector<BodyPath> paths(at(model_->body_count()));
  const auto path_of = [&](int body) -> const BodyPath& {
    BodyPath& path = paths[at(body)];
    if (path.empty()) path.push_back(step_way(*model_, environment_, body, before, after));
    return path;
  };
  find(path_of, report);
}

/// Enters the passages of the markers whose boxes meet those of solids.
template <class Paths>
void PassageWitness::find(const Paths& path_of, AdvanceReport& report) {
  // The tree is made anew now and then: it gets worse the farther the boxes move.
  constexpr long refits = 64;
  if (watches_++ % refits == 0) {
    std::vector<BoxItem> items;
    for (std::size_t k = 0; k < solids_.size(); ++k) items.push_back({static_cast<int>(k), solids_[k]});
    tree_.clear();
    tree_.build(items);
  } else {
    tree_.refit(solids_);
  }

  // Each body's markers against the solids that they may meet.
  std::vector<int> near;
  for (int a = 0; a < model_->body_count(); ++a) {
    if (markers_[at(a)].empty()) continue;
    tree_.overlapping(ways_[at(a)], near);
    for (const int k : near) {
      const Solid& solid = solid_of_[at(k)];
      if (solid.body == a || !model_->may_collide(a, solid.body)) continue;
      const auto entry = entry_of(a, solid, path_of(a), path_of(solid.body));
      if (entry) report.note_passage(a, solid.body, *entry);
    }
  }
}

/// The first time at which a marker of body a enters a shape of another.
std::optional<double> PassageWitness::entry_of(int a, const Solid& solid, const BodyPath& of_a,
                                               const BodyPath& of_b) const {
  const Body& body = model_->body(solid.body);
  std::optional<double> first;
  // Where pieces of both overlap in time; both lists are in order.
  for (auto i = of_a.begin(), j = of_b.begin(); i != of_a.end() && j != of_b.end() && !first;) {
    const double begin = std::max(i->begin(), j->begin()), end = std::min(i->end(), j->end());
    for (const Marker& marker : markers_[at(a)]) {
      if (!(end > begin)) break;
      const Pursuit pursuit(*i, marker, *j, body, body.shapes[at(solid.shape)]);
      if (const auto entry = pursuit.first_entry(begin, first ? *first : end)) first = entry;
    }
    i->end() < j->end() ? ++i : ++j;
  }
  return first;
}

}  // namespace rigor
