#include "rigor/geometry/distance/distance.hpp"
#include "rigor/geometry/mesh_penetration/mesh_penetration.hpp"
#include "rigor/sim/islands/joint_projection.hpp"
#include "rigor/sim/pairs/near_pairs.hpp"
#include "rigor/sim/simulation.hpp"

#include <limits>

namespace rigor {

namespace {

/// The deepest overlap of two bodies, with its normal from A to B.
struct Deepest {
  double depth = -std::numeric_limits<double>::infinity();
  Vec3 n_W = Vec3::UnitZ();
};

/// Signed distance of two shapes; the depth of overlapping solids is that of their full interiors. Meshes
/// that overlap by no more than the tolerance are not decomposed for it.
DistanceResult overlap_of(const Shape& a, const Pose& X_WA, const Shape& b, const Pose& X_WB,
                          double tolerance) {
  DistanceResult found = signed_distance(a, X_WA, b, X_WB);
  if (found.distance > 0 || !are_solid(a, b)) return found;
  const bool is_deep = found.distance < -tolerance || share_inside(a, X_WA, b, X_WB, tolerance);
  return is_deep ? solid_distance(a, X_WA, b, X_WB) : found;
}

Deepest deepest_overlap(const Model& model, const State& state, std::pair<int, int> bodies,
                        double tolerance) {
  const auto [a, b] = bodies;
  Deepest deepest;
  const Pose X_WA = pose_of(state, a), X_WB = pose_of(state, b);
  for (const BodyShape& shape_a : model.body(a).shapes) {
    for (const BodyShape& shape_b : model.body(b).shapes) {
      const DistanceResult found =
          overlap_of(shape_a.shape, X_WA * shape_a.X_BS, shape_b.shape, X_WB * shape_b.X_BS, tolerance);
      if (-found.distance > deepest.depth) deepest = {-found.distance, found.n_W};
    }
  }
  return deepest;
}

/// Moves all bodies back to where their joints hold.
void project_joints(const Model& model, const JointProjection& joints, State& state) {
  std::vector<int> bodies;
  std::vector<BodyPhase> phases;
  for (int i = 0; i < model.body_count(); ++i) {
    if (model.body(i).motion != MotionType::dynamic) continue;
    bodies.push_back(i);
    phases.push_back(
        {state.position(i), state.orientation(i), state.linear_momentum(i), state.angular_momentum(i)});
  }
  AdvanceReport ignored;
  joints.project_positions(state.t, bodies, phases, ignored);
  for (std::size_t k = 0; k < bodies.size(); ++k)
    state.set_body(bodies[k], phases[k].x, phases[k].q, phases[k].P, phases[k].L);
}

}  // namespace

std::vector<Overlap> find_overlaps(const Model& model, const State& state, double tolerance) {
  std::vector<Overlap> overlaps;
  for (const auto& [a, b] : near_pairs(model, state, 0)) {
    const double depth = deepest_overlap(model, state, {a, b}, tolerance).depth;
    if (depth > tolerance) overlaps.push_back({a, b, depth});
  }
  return overlaps;
}

std::vector<Overlap> apply_separation(const Model& model, double tolerance, State& state) {
  constexpr int most_rounds = 2000;
  const Environment environment(model);
  const ContactSystemAssembler assembler(model, environment);
  const JointProjection joints(model, assembler);
  const auto inverse_mass = [&](int body) {
    return model.body(body).motion == MotionType::dynamic ? 1 / model.body(body).mass : 0.0;
  };
  const auto move = [&](int body, const Vec3& d) {
    if (model.body(body).motion != MotionType::dynamic) return;
    state.set_body(body, state.position(body) + d, state.orientation(body), state.linear_momentum(body),
                   state.angular_momentum(body));
  };
  for (int round = 0; round < most_rounds; ++round) {
    bool is_apart = true;
    for (const auto& [a, b] : near_pairs(model, state, 0)) {
      const Deepest deepest = deepest_overlap(model, state, {a, b}, tolerance);
      if (deepest.depth <= 0) continue;
      is_apart = is_apart && deepest.depth <= 0.5 * tolerance;
      // A little more than the depth, so that the number of rounds is finite.
      const double share = (deepest.depth + 0.25 * tolerance) / (inverse_mass(a) + inverse_mass(b));
      move(a, -share * inverse_mass(a) * deepest.n_W);
      move(b, share * inverse_mass(b) * deepest.n_W);
    }
    // What joints hold comes along, and may be in the way of others in the next round.
    if (!model.joints().empty()) project_joints(model, joints, state);
    if (is_apart) break;
  }
  return find_overlaps(model, state, tolerance);
}

}  // namespace rigor
