#pragma once

#include "rigor/bulk/gyroscopic/gyroscopic_terms.hpp"
#include "rigor/bulk/half_kicks.hpp"
#include "rigor/bulk/joints/bulk_joints.hpp"
#include "rigor/math/rotation.hpp"
#include "rigor/model/model_builder.hpp"

#include "random_vectors.hpp"

#include <array>
#include <memory>
#include <numeric>
#include <string>
#include <vector>

namespace rigor::tests {

/// A body of the given mass and moments.
inline BodyDescription bulk_body(const std::string& name, const Vec3& p_WU, double mass,
                                 const Vec3& moments) {
  BodyDescription body;
  body.name = name;
  body.p_WU = p_WU;
  body.inertia = GivenInertia{.mass = mass, .moments = moments};
  return body;
}

/// Rods of 1 kg and 0.5 m, end to end along x from the origin, where ball joints hold the first to the world
/// and each to the next.
inline std::shared_ptr<const Model> rod_chain(int count, const Vec3& g_W, int chains = 1) {
  ModelBuilder builder;
  builder.set_gravity(g_W);
  for (int c = 0; c < chains; ++c) {
    for (int i = 0; i < count; ++i) {
      const std::string name = std::to_string(c) + "_" + std::to_string(i);
      const Vec3 center(0.25 + 0.5 * i, c, 0);
      builder.add_body(bulk_body(name, center, 1, Vec3(0.001, 0.0208333, 0.0208333)));
      ModelBuilder::JointDescription joint;
      joint.name = "j" + name;
      joint.type = JointType::ball;
      joint.bodies = {i == 0 ? "world" : std::to_string(c) + "_" + std::to_string(i - 1), name};
      joint.anchors = {Vec3(0.5 * i, c, 0)};
      builder.add_joint(joint);
    }
  }
  return builder.build();
}

/// Joints at work without contacts.
struct JointRun {
  explicit JointRun(std::shared_ptr<const Model> scene, LaneTarget target = best_lane_target())
      : model(std::move(scene)),
        bodies(read_bulk_bodies(*model, make_initial_state(*model))),
        joints(*model, target),
        gyroscopic_terms(*model, target) {}

  std::vector<float> impulses() const {
    std::vector<float> result;
    joints.read_impulses(bodies, result);
    return result;
  }

  /// A step in which forces act before the displacements of substeps, or (flies) in their middle, as on what
  /// touches nothing in a BulkWorld.
  void step(double H, int substeps, bool flies = false) {
    const Executor executor(1);
    const float h = static_cast<float>(H / substeps);
    begin_bulk_step(*model, executor, bodies);
    joints.prepare(bodies, H / substeps, executor);
    std::vector<int> who(bodies.x.size());
    std::iota(who.begin(), who.end(), 0);
    gyroscopic_terms.prepare(bodies, who, executor);
    std::vector<MotionRow> accelerations(who.size(), MotionRow{});
    for (const int i : who) {
      for (int k = 0; bodies.is_dynamic(i) && k < 3; ++k)
        accelerations[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)] =
            static_cast<float>(model->g_W()[k]);
    }
    HalfKicks half_kicks;
    const HalfKicks::Kick kick{h, accelerations, gyroscopic_terms, turns};
    if (flies) {
      half_kicks.find(who, std::vector<char>(who.size(), 0), bodies, joints);
      half_kicks.begin(kick, joints, executor, bodies);
    }
    for (int s = 0; s < substeps; ++s) {
      gyroscopic_terms.find_changes(h, bodies, executor, turns);
      for (std::size_t i = 0; i < who.size(); ++i) {
        MotionRecord& motion = bodies.motion[i];
        for (std::size_t k = 0; k < 3; ++k) {
          motion.v[k] += h * accelerations[i][k];
          if (bodies.is_dynamic(who[i])) motion.w[k] += turns[i][4 + k];
        }
      }
      joints.solve(JointPass::places, executor);
      for (MotionRecord& motion : bodies.motion) {
        for (int k = 0; k < 3; ++k) motion.dp[k] += h * motion.v[k];
        turn_further(h, motion);
      }
      joints.solve(JointPass::rates, executor);
    }
    if (flies) half_kicks.end(kick, joints, executor, bodies);
    end_bulk_step(executor, bodies);
  }
  void run(double time, double H, int substeps, bool flies = false) {
    for (int i = 0; i < std::lround(time / H); ++i) step(H, substeps, flies);
  }

  Vec3 velocity(int body) const { return vector(bodies.motion[static_cast<std::size_t>(body)].v); }
  Vec3 spin(int body) const { return vector(bodies.motion[static_cast<std::size_t>(body)].w); }
  void set(int body, const Vec3& v, const Vec3& w) {
    for (int k = 0; k < 3; ++k) {
      bodies.motion[static_cast<std::size_t>(body)].v[k] = static_cast<float>(v[k]);
      bodies.motion[static_cast<std::size_t>(body)].w[k] = static_cast<float>(w[k]);
    }
  }
  double error() const { return joints.worst_error(bodies).first; }

  /// Kinetic energy and that of the weight [J].
  double energy() const {
    double sum = 0;
    for (int i = 0; i < bodies.count(); ++i) {
      const Body& body = model->body(i);
      if (body.motion != MotionType::dynamic) continue;
      const Vec3 w_B = bodies.q[static_cast<std::size_t>(i)].conjugate() * spin(i);
      sum += 0.5 * body.mass * velocity(i).squaredNorm() +
             0.5 * w_B.dot(Vec3(body.moments.cwiseProduct(w_B))) -
             body.mass * model->g_W().dot(bodies.x[static_cast<std::size_t>(i)]);
    }
    return sum;
  }

  std::shared_ptr<const Model> model;
  BulkBodies bodies;
  BulkJoints joints;
  GyroscopicTerms gyroscopic_terms;
  std::vector<std::array<float, kLaneCount>> turns;

 private:
  static Vec3 vector(const float* p) { return Vec3(p[0], p[1], p[2]); }
};

}  // namespace rigor::tests
