// Independent judgement of scenes of many bodies.

#include "bulk_quality.hpp"

#include "rigor/core/index.hpp"
#include "rigor/geometry/broad_phase/box_pairs.hpp"
#include "rigor/geometry/distance/distance.hpp"
#include "rigor/geometry/shape/support.hpp"
#include "rigor/math/rotation.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace rigor::bench {

namespace {

Pose pose_of(const BulkPoses& poses, int body) {
  return {poses.q[at(body)].toRotationMatrix(), poses.x[at(body)]};
}

struct PlacedShape {
  int body;
  const Shape* shape;
  Pose X_WS;
};

std::vector<PlacedShape> placed_shapes(const Model& model, const BulkPoses& poses) {
  std::vector<PlacedShape> shapes;
  for (int i = 0; i < model.body_count(); ++i) {
    const Pose X_WB = pose_of(poses, i);
    for (const BodyShape& part : model.body(i).shapes) shapes.push_back({i, &part.shape, X_WB * part.X_BS});
  }
  return shapes;
}

/// The deepest overlap of every pair of bodies that overlap [m].
std::map<std::pair<int, int>, double> overlaps_of(const Model& model, const BulkPoses& poses) {
  const std::vector<PlacedShape> shapes = placed_shapes(model, poses);
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

void note_overlaps(const Model& model, const BulkPoses& poses, BulkFigures& figures) {
  double sum = 0;
  for (const auto& [bodies, depth] : overlaps_of(model, poses)) {
    ++figures.touching_pairs;
    if (depth > 0.01) ++figures.deep_pairs;
    figures.max_overlap = std::max(figures.max_overlap, depth);
    sum += depth;
  }
  if (figures.touching_pairs > 0) figures.mean_overlap = sum / figures.touching_pairs;
}

/// A body's velocities over the time between two looks: its centre's in W, and its own about its axes.
struct MeanVelocity {
  Vec3 v_W, w_B;  ///< [m/s], [rad/s].
};
MeanVelocity velocity_of(const BulkPoses& before, const BulkPoses& now, int body) {
  const std::size_t i = at(body);
  const double h = now.t - before.t;
  return {(now.x[i] - before.x[i]) / h, rotation_log(before.q[i].conjugate() * now.q[i]) / h};
}

/// m v²/2 + w·I w/2 - m g·x.
double energy_of(const Body& body, const Vec3& g_W, const MeanVelocity& V, const Vec3& p_W) {
  return 0.5 * body.mass * V.v_W.squaredNorm() + 0.5 * V.w_B.dot(body.moments.cwiseProduct(V.w_B)) -
         body.mass * g_W.dot(p_W);
}

/// The horizontal normal of the upright plane near which all dynamic bodies begin; zero if there is none.
Vec3 normal_of_plane(const Model& model, const BulkPoses& start) {
  const Vec3 up = -model.g_W().normalized();
  const Vec3 first = up.unitOrthogonal(), second = up.cross(first);
  Eigen::Matrix<double, 2, Eigen::Dynamic> flat(2, model.body_count());
  Eigen::Index count = 0;
  for (int i = 0; i < model.body_count(); ++i) {
    if (model.body(i).motion != MotionType::dynamic) continue;
    flat.col(count++) << first.dot(start.x[at(i)]), second.dot(start.x[at(i)]);
  }
  if (count == 0) return Vec3::Zero();
  flat.conservativeResize(2, count);
  // Principal axes of the places seen from above: a wall is a thousand times as long as it is thick there.
  flat.colwise() -= flat.rowwise().mean().eval();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> spread(flat * flat.transpose());
  if (spread.eigenvalues()[0] > 1e-6 * spread.eigenvalues()[1]) return Vec3::Zero();
  return spread.eigenvectors()(0, 0) * first + spread.eigenvectors()(1, 0) * second;
}

void note_drift(const Model& model, const BulkPoses& start, const BulkPoses& now, BulkFigures& figures) {
  const Vec3 down = model.g_W().normalized(), out = normal_of_plane(model, start);
  for (int i = 0; i < model.body_count(); ++i) {
    if (model.body(i).motion != MotionType::dynamic) continue;
    const Vec3 path = now.x[at(i)] - start.x[at(i)];
    figures.drift_down = std::max(figures.drift_down, std::abs(path.dot(down)));
    figures.drift_across = std::max(figures.drift_across, (path - path.dot(down) * down).norm());
    figures.drift_out = std::max(figures.drift_out, std::abs(path.dot(out)));
  }
}

void note_motion(const Model& model, const BulkPoses& before, const BulkPoses& now, BulkFigures& figures) {
  double sum = 0;
  int count = 0;
  for (int i = 0; i < model.body_count(); ++i) {
    const Body& body = model.body(i);
    if (body.motion != MotionType::dynamic) continue;
    ++count;
    const MeanVelocity V = velocity_of(before, now, i);
    sum += V.v_W.squaredNorm();
    figures.energy += energy_of(body, model.g_W(), V, 0.5 * (before.x[at(i)] + now.x[at(i)]));
  }
  if (count > 0) figures.rms_speed = std::sqrt(sum / count);
}

/// How many bodies have fallen out of the scene, if something stands still in it.
int count_lost(const Model& model, const BulkPoses& poses) {
  const Vec3 up = -model.g_W().normalized();
  double lowest = std::numeric_limits<double>::infinity();
  for (int i = 0; i < model.body_count(); ++i) {
    if (model.body(i).motion == MotionType::dynamic) continue;
    for (const BodyShape& part : model.body(i).shapes) {
      const Pose X_WS = pose_of(poses, i) * part.X_BS;
      lowest = std::min(lowest, up.dot(X_WS * support_point(part.shape, X_WS.R.transpose() * -up)));
    }
  }
  int lost = 0;
  for (int i = 0; i < model.body_count(); ++i)
    lost += model.body(i).motion == MotionType::dynamic && up.dot(poses.x[at(i)]) < lowest;
  return lost;
}

Pose placed(const Pose& X_BF, int body, const BulkPoses& poses) {
  return body == world_body ? X_BF : pose_of(poses, body) * X_BF;
}

/// Of joints that hold a point: balls and hinges, which hold two, on their axis z.
double joint_anchor_error(const Model& model, const BulkPoses& poses) {
  constexpr double along = 0.1;
  double worst = 0;
  for (const Joint& joint : model.joints()) {
    if (joint.type != JointType::ball && joint.type != JointType::hinge) continue;
    const Pose X_WF = placed(joint.X_AF, joint.body_A, poses), X_WK = placed(joint.X_BK, joint.body_B, poses);
    worst = std::max(worst, (X_WK.p - X_WF.p).norm());
    if (joint.type == JointType::ball) continue;
    const Vec3 on_axis(0, 0, along);
    worst = std::max(worst, (X_WK * on_axis - X_WF * on_axis).norm());
  }
  return worst;
}

bool is_finite(const BulkPoses& poses) {
  return std::all_of(poses.x.begin(), poses.x.end(), [](const Vec3& x) { return x.allFinite(); }) &&
         std::all_of(poses.q.begin(), poses.q.end(), [](const Quat& q) { return q.coeffs().allFinite(); });
}

}  // namespace

BulkPoses poses_of(const State& state) {
  BulkPoses poses;
  poses.t = state.t;
  for (int i = 0; i < state.body_count(); ++i) {
    poses.x.push_back(state.position(i));
    poses.q.push_back(state.orientation(i));
  }
  return poses;
}

BulkFigures bulk_figures(const Model& model, const BulkPoses& start, const BulkPoses& before,
                         const BulkPoses& now) {
  BulkFigures figures;
  figures.is_finite = is_finite(now);
  if (!figures.is_finite) return figures;
  note_overlaps(model, now, figures);
  note_drift(model, start, now, figures);
  note_motion(model, before, now, figures);
  figures.lost_bodies = count_lost(model, now);
  figures.joint_error = joint_anchor_error(model, now);
  return figures;
}

BulkJudge::BulkJudge(const Model& model) : model_(model), start_(poses_of(make_initial_state(model))) {
  double highest = 0;
  for (int i = 0; i < model.body_count(); ++i) {
    const Body& body = model.body(i);
    if (body.motion != MotionType::dynamic) continue;
    highest = std::max(highest, -start_.x[at(i)].dot(model.g_W().normalized()));
    const MeanVelocity V = {body.v_WB, body.q_WB.conjugate() * body.w_WB};
    start_energy_ += energy_of(body, model.g_W(), V, start_.x[at(i)]);
    reference_energy_ += body.mass * model.g_W().norm() * 5;
  }
  // The overlaps of a high column add up without its falling.
  fall_ = std::max(1.0, 0.02 * highest);
}

void BulkJudge::look(const BulkPoses& before, const BulkPoses& now) {
  const BulkFigures figures = bulk_figures(model_, start_, before, now);
  quality_.end = figures;
  quality_.is_finite = quality_.is_finite && figures.is_finite;
  quality_.stands = quality_.is_finite && figures.drift_down < fall_;
  if (!figures.is_finite) return;
  quality_.max_overlap = std::max(quality_.max_overlap, figures.max_overlap);
  quality_.max_joint_error = std::max(quality_.max_joint_error, figures.joint_error);
  quality_.max_drift_out = std::max(quality_.max_drift_out, figures.drift_out);
  quality_.energy_change = (figures.energy - start_energy_) / reference_energy_;
  has_touched_ = has_touched_ || figures.touching_pairs > 0;
  if (has_touched_) return;
  quality_.free_energy_change = quality_.energy_change;
  quality_.free_time = now.t;
}

}  // namespace rigor::bench
