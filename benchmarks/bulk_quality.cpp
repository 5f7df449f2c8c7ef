// Independent judgement of scenes of many bodies.

#include "bulk_quality.hpp"

#include "rigor/geometry/broad_phase/box_pairs.hpp"
#include "rigor/geometry/distance/distance.hpp"
#include "rigor/geometry/shape/support.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace rigor::bench {

namespace {

Pose pose_of(const State& state, int body) {
  return {state.orientation(body).toRotationMatrix(), state.position(body)};
}

struct PlacedShape {
  int body;
  const Shape* shape;
  Pose X_WS;
};

std::vector<PlacedShape> placed_shapes(const Model& model, const State& state) {
  std::vector<PlacedShape> shapes;
  for (int i = 0; i < model.body_count(); ++i) {
    const Pose X_WB = pose_of(state, i);
    for (const BodyShape& part : model.body(i).shapes) shapes.push_back({i, &part.shape, X_WB * part.X_BS});
  }
  return shapes;
}

/// The deepest overlap of every pair of bodies that overlap [m].
std::map<std::pair<int, int>, double> overlaps_of(const Model& model, const State& state) {
  const std::vector<PlacedShape> shapes = placed_shapes(model, state);
  std::vector<Aabb> boxes;
  for (const PlacedShape& placed : shapes) boxes.push_back(axis_aligned_box(*placed.shape, placed.X_WS));
  std::map<std::pair<int, int>, double> depths;
  for (const auto& [i, j] : overlapping_pairs(boxes)) {
    const PlacedShape& a = shapes[static_cast<std::size_t>(i)];
    const PlacedShape& b = shapes[static_cast<std::size_t>(j)];
    if (a.body == b.body || !model.may_collide(a.body, b.body)) continue;
    const double depth = -signed_distance(*a.shape, a.X_WS, *b.shape, b.X_WS).distance;
    if (depth <= 0) continue;
    double& deepest = depths[std::minmax(a.body, b.body)];
    deepest = std::max(deepest, depth);
  }
  return depths;
}

void note_overlaps(const Model& model, const State& state, BulkFigures& figures) {
  double sum = 0;
  for (const auto& [bodies, depth] : overlaps_of(model, state)) {
    ++figures.touching_pairs;
    if (depth > 0.01) ++figures.deep_pairs;
    figures.max_overlap = std::max(figures.max_overlap, depth);
    sum += depth;
  }
  if (figures.touching_pairs > 0) figures.mean_overlap = sum / figures.touching_pairs;
}

/// 1/2 P·v + 1/2 L·ω - m g·x.
double energy_of(const Body& body, const Vec3& g_W, const State& state, int i) {
  const Vec3 P = state.linear_momentum(i);
  const Vec3 L_B = state.orientation(i).conjugate() * state.angular_momentum(i);
  return 0.5 * P.squaredNorm() / body.mass + 0.5 * L_B.dot(L_B.cwiseQuotient(body.moments)) -
         body.mass * g_W.dot(state.position(i));
}

void note_motion(const Model& model, const State& start, const State& state, BulkFigures& figures) {
  const Vec3 down = model.g_W().normalized();
  double sum = 0;
  int count = 0;
  for (int i = 0; i < model.body_count(); ++i) {
    const Body& body = model.body(i);
    if (body.motion != MotionType::dynamic) continue;
    ++count;
    sum += (state.linear_momentum(i) / body.mass).squaredNorm();
    const Vec3 way = state.position(i) - start.position(i);
    figures.drift_down = std::max(figures.drift_down, std::abs(way.dot(down)));
    figures.drift_across = std::max(figures.drift_across, (way - way.dot(down) * down).norm());
    figures.energy += energy_of(body, model.g_W(), state, i);
  }
  if (count > 0) figures.rms_speed = std::sqrt(sum / count);
}

/// How many bodies have fallen out of the scene, if something stands still in it.
int count_lost(const Model& model, const State& state) {
  const Vec3 up = -model.g_W().normalized();
  double lowest = std::numeric_limits<double>::infinity();
  for (int i = 0; i < model.body_count(); ++i) {
    if (model.body(i).motion == MotionType::dynamic) continue;
    for (const BodyShape& part : model.body(i).shapes) {
      const Pose X_WS = pose_of(state, i) * part.X_BS;
      lowest = std::min(lowest, up.dot(X_WS * support_point(part.shape, X_WS.R.transpose() * -up)));
    }
  }
  int lost = 0;
  for (int i = 0; i < model.body_count(); ++i)
    lost += model.body(i).motion == MotionType::dynamic && up.dot(state.position(i)) < lowest;
  return lost;
}

/// Of joints that hold a point: balls and hinges.
double joint_anchor_error(const Model& model, const State& state) {
  double worst = 0;
  for (const Joint& joint : model.joints()) {
    if (joint.type != JointType::ball && joint.type != JointType::hinge) continue;
    const Vec3 p_WF = joint.body_A == world_body ? joint.X_AF.p : pose_of(state, joint.body_A) * joint.X_AF.p;
    const Vec3 p_WK = joint.body_B == world_body ? joint.X_BK.p : pose_of(state, joint.body_B) * joint.X_BK.p;
    worst = std::max(worst, (p_WK - p_WF).norm());
  }
  return worst;
}

bool is_finite(const State& state) {
  const auto all_finite = [](const std::vector<double>& numbers) {
    return std::all_of(numbers.begin(), numbers.end(), [](double x) { return std::isfinite(x); });
  };
  return all_finite(state.x) && all_finite(state.q) && all_finite(state.P) && all_finite(state.L);
}

}  // namespace

BulkFigures bulk_figures(const Model& model, const State& start, const State& state) {
  BulkFigures figures;
  figures.is_finite = is_finite(state);
  if (!figures.is_finite) return figures;
  note_overlaps(model, state, figures);
  note_motion(model, start, state, figures);
  figures.lost_bodies = count_lost(model, state);
  figures.joint_error = joint_anchor_error(model, state);
  return figures;
}

BulkJudge::BulkJudge(const Model& model) : model_(model), start_(make_initial_state(model)) {
  BulkFigures figures;
  note_motion(model, start_, start_, figures);
  start_energy_ = figures.energy;
  for (const Body& body : model.bodies()) reference_energy_ += body.mass * model.g_W().norm() * 5;
}

void BulkJudge::look(const State& state) {
  const BulkFigures figures = bulk_figures(model_, start_, state);
  quality_.end = figures;
  quality_.is_finite = quality_.is_finite && figures.is_finite;
  quality_.stands = quality_.is_finite && figures.drift_down < 1;
  if (!figures.is_finite) return;
  quality_.max_overlap = std::max(quality_.max_overlap, figures.max_overlap);
  quality_.max_joint_error = std::max(quality_.max_joint_error, figures.joint_error);
  quality_.energy_change = (figures.energy - start_energy_) / reference_energy_;
  has_touched_ = has_touched_ || figures.touching_pairs > 0;
  if (has_touched_) return;
  quality_.free_energy_change = quality_.energy_change;
  quality_.free_time = state.t;
}

}  // namespace rigor::bench
