#include "bulk/same_bits.hpp"
#include "geometry/random_pairs.hpp"
#include "rigor/bulk/narrow_phase/narrow_phase.hpp"
#include "rigor/model/model_builder.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

namespace rigor::narrow_phase_hints_test {
namespace {

using test::are_same_bits;
using test::Draw;

/// Bodies of one shape each that move.
struct Crowd {
  std::shared_ptr<const Model> model;
  BulkBodies bodies;

  Crowd(const std::vector<Shape>& shapes, const std::vector<Pose>& poses) {
    ModelBuilder builder;
    for (std::size_t k = 0; k < shapes.size(); ++k) {
      BodyDescription body;
      body.name = std::to_string(k);
      body.motion = MotionType::kinematic;
      body.shapes.emplace_back().shape = shapes[k];
      builder.add_body(body);
      bodies.x.push_back(poses[k].p);
      bodies.q.emplace_back(poses[k].R);
    }
    model = builder.build();
    bodies.motion.resize(shapes.size());
    bodies.inertia.resize(shapes.size());
  }
  /// All pairs but for some: which they are changes from step to step.
  std::vector<ShapePair> pairs(Draw& draw, float margin) const {
    std::vector<ShapePair> pairs;
    for (int a = 0; a < bodies.count(); ++a)
      for (int b = a + 1; b < bodies.count(); ++b)
        if (draw.uniform(0, 1) < 0.95) pairs.push_back({a, b, 0, 0, margin});
    return pairs;
  }
};

/// One that has seen all steps before answers as one that sees this one first. Returns how many manifolds
/// there were.
std::size_t expect_same_as_fresh(NarrowPhase& old, const Crowd& crowd, const std::vector<ShapePair>& pairs,
                                 int threads, const std::string& where) {
  ManifoldList found, expected;
  old.find_manifolds(crowd.bodies, pairs, Executor(threads), found);
  NarrowPhase fresh(*crowd.model);
  fresh.find_manifolds(crowd.bodies, pairs, Executor(1), expected);
  EXPECT_EQ(found.size(), expected.size()) << where;
  for (std::size_t k = 0; k < std::min(found.size(), expected.size()); ++k) {
    if (are_same_bits(found[k], expected[k])) continue;
    const ShapePair& pair = pairs[static_cast<std::size_t>(expected[k].pair)];
    ADD_FAILURE() << where << " bodies " << pair.body_A << " and " << pair.body_B;
    break;
  }
  return expected.size();
}

TEST(NarrowPhaseHints, WhatWasSeenBeforeChangesNoBit) {
  Draw draw(1);
  // Metres and radians a step: at rest, rolling, tumbling.
  for (const double motion : {1e-6, 1e-3, 0.02, 0.1}) {
    constexpr int kinds[] = {7, 6, 1, 7, 2, 0, 7, 6};
    std::vector<Shape> shapes;
    std::vector<Pose> poses;
    for (int k = 0; k < 32; ++k) {
      shapes.push_back(draw.shape(kinds[k % 8]));
      poses.push_back(draw.pose(1.1));
    }
    Crowd crowd(shapes, poses);
    NarrowPhase narrow_phase(*crowd.model);
    std::size_t count = 0;
    for (int step = 0; step < 40; ++step) {
      const std::string where = std::to_string(motion) + " step " + std::to_string(step);
      count += expect_same_as_fresh(narrow_phase, crowd, crowd.pairs(draw, 0.05f), 1 + step % 2, where);
      for (std::size_t k = 0; k < crowd.bodies.x.size(); ++k) {
        crowd.bodies.x[k] += motion * draw.direction();
        crowd.bodies.q[k] = (rotation_exp(motion * draw.direction()) * crowd.bodies.q[k]).normalized();
      }
    }
    EXPECT_GT(count, 2000u);
  }
}

/// The hull of a box.
Shape block(const Vec3& half) {
  std::vector<Vec3> points;
  for (int k = 0; k < 8; ++k)
    points.push_back(half.cwiseProduct(Vec3((k & 1) * 2 - 1, (k & 2) - 1, (k & 4) / 2 - 1)));
  return Convex{std::make_shared<const ConvexHull>(std::get<ConvexHull>(make_convex_hull(points)))};
}

/// Nearly coincident normals, edges and corners: blocks at multiples of their sizes, turned by right angles,
/// some of them by little.
TEST(NarrowPhaseHints, ParallelFacesAndEdgesGiveTheSameBitsToo) {
  Draw draw(2);
  const Vec3 sizes[] = {Vec3(0.5, 0.5, 0.5), Vec3(0.5, 0.25, 0.5), Vec3(1, 0.5, 0.125)};
  for (const double motion : {0.0, 1e-7, 1e-5, 1e-3}) {
    for (int round = 0; round < 6; ++round) {
      std::vector<Shape> shapes;
      std::vector<Pose> poses;
      for (int k = 0; k < 20; ++k) {
        const Vec3& half = sizes[k % 3];
        shapes.push_back(k % 4 == 3 ? Shape(Box{half}) : block(half));
        const auto turn = [&](int axis) {
          const double angle = std::floor(draw.uniform(0, 4)) * 0.5 * std::numbers::pi;
          return Quat(Eigen::AngleAxisd(angle, Vec3::Unit(axis)));
        };
        Vec3 p;
        for (int c = 0; c < 3; ++c) p[c] = 0.25 * std::floor(draw.uniform(-5, 6));
        poses.push_back({(turn(0) * turn(2)).toRotationMatrix(), p});
      }
      Crowd crowd(shapes, poses);
      const BulkBodies start = crowd.bodies;
      NarrowPhase narrow_phase(*crowd.model);
      for (int step = 0; step < 12; ++step) {
        const std::string where = std::to_string(motion) + " round " + std::to_string(round);
        expect_same_as_fresh(narrow_phase, crowd, crowd.pairs(draw, 0.01f), 1, where);
        for (std::size_t k = 0; k < crowd.bodies.x.size(); ++k) {
          crowd.bodies.x[k] = start.x[k] + motion * draw.direction();
          crowd.bodies.q[k] = (rotation_exp(motion * draw.direction()) * start.q[k]).normalized();
        }
      }
    }
  }
}

/// Pairs whose gap is about the margin: whether they have a manifold does not depend on what was before.
TEST(NarrowPhaseHints, AtTheMarginTheAnswerIsTheSame) {
  Draw draw(3);
  for (int round = 0; round < 40; ++round) {
    Crowd crowd({draw.hull(24), round % 2 == 0 ? draw.hull(24) : Shape(Box{draw.sizes()})},
                {draw.pose(0.2), draw.pose(0.2)});
    NarrowPhase narrow_phase(*crowd.model);
    const Vec3 way = draw.direction();
    // To where the manifold ends, by halving, and then about it by parts of the rounding.
    double near = 0, far = 5;
    const Vec3 from = crowd.bodies.x[0];
    const auto touches = [&](double distance) {
      crowd.bodies.x[1] = from + distance * way;
      return expect_same_as_fresh(narrow_phase, crowd, {{0, 1, 0, 0, 0.01f}}, 1, "halving") > 0;
    };
    for (int k = 0; k < 40; ++k) (touches(0.5 * (near + far)) ? near : far) = 0.5 * (near + far);
    for (int k = 0; k < 60; ++k) touches(near + 1e-4 * std::pow(10, -0.1 * k) * (k % 2 == 0 ? 1 : -1));
  }
}

}  // namespace
}  // namespace rigor::narrow_phase_hints_test
