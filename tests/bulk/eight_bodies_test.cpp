// What is done to eight bodies at a time has the bits of what is done to one.

#include "rigor/bulk/bulk_bodies.hpp"
#include "rigor/bulk/shape_places.hpp"
#include "rigor/math/rotation.hpp"
#include "rigor/model/model_builder.hpp"

#include "random_vectors.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>

namespace rigor::eight_bodies_test {
namespace {

using test::Random;

struct Crowd {
  std::shared_ptr<const Model> model;
  BulkBodies bodies;
};

/// Spheres, capsules and boxes that move.
Crowd random_crowd(int count, double speed, Random& random) {
  const Shape shapes[] = {Sphere{0.3}, Capsule{0.1, 0.2}, Box{Vec3(0.2, 0.3, 0.4)}};
  ModelBuilder builder;
  for (int i = 0; i < count; ++i) {
    BodyDescription body;
    body.name = "b" + std::to_string(i);
    body.p_WL = 3 * random.vector();
    body.q_WL = rotation_exp(3 * random.vector());
    body.shapes = {{.shape = shapes[i % 3]}};
    body.density = 1000;
    builder.add_body(body);
  }
  Crowd crowd{builder.build(), {}};
  crowd.bodies = read_bulk_bodies(*crowd.model, make_initial_state(*crowd.model));
  for (MotionRecord& motion : crowd.bodies.motion) {
    const Vec3 v = random.vector(), w = speed * random.vector();
    for (int k = 0; k < 3; ++k) {
      motion.v[k] = static_cast<float>(v[k]);
      motion.w[k] = static_cast<float>(w[k]);
    }
  }
  return crowd;
}

TEST(EightBodies, HaveThePlacesAndBoxesOfOne) {
  Random random(5);
  for (int trial = 0; trial < 40; ++trial) {
    const Crowd crowd = random_crowd(9, trial % 2 == 0 ? 1 : 200, random);
    std::vector<ShapeBound> bounds;
    std::array<const ShapeBound*, 8> of_eight;
    for (int i = 0; i < 9; ++i) bounds.push_back(make_shape_bound(crowd.model->body(i).shapes[0]));
    for (std::size_t i = 0; i < 8; ++i) of_eight[i] = &bounds[i + 1];
    const Vec3 origin(0.5, -1, 2);
    ShapePlace places[8];
    FloatBox boxes[8];
    sweep_eight_shapes(of_eight, crowd.bodies, 1, {origin, 0.02F, 0.003F}, places, boxes);
    for (int i = 0; i < 8; ++i) {
      const SweptShape one =
          sweep_shape(*of_eight[static_cast<std::size_t>(i)], crowd.bodies, i + 1, origin, 0.02F, 0.003F);
      for (int k = 0; k < 3; ++k) {
        EXPECT_EQ(places[i].center[k], one.place.center[k]);
        EXPECT_EQ(places[i].u[k], one.place.u[k]);
        EXPECT_EQ(places[i].w[k], one.place.w[k]);
        EXPECT_EQ(boxes[i].lower[k], one.box.lower[k]);
        EXPECT_EQ(boxes[i].upper[k], one.box.upper[k]);
      }
      EXPECT_EQ(places[i].slack, one.place.slack);
      EXPECT_EQ(places[i].bound, of_eight[static_cast<std::size_t>(i)]);
    }
  }
}

TEST(OrientationNow, IsExactForNearAndFarTurns) {
  Random random(6);
  Crowd crowd = random_crowd(1, 1, random);
  for (const double size : {1e-5, 0.1, 0.57, 0.58, 1.0, 9.0}) {  // The series is for up to 1 rad: 0.577 each.
    for (int trial = 0; trial < 20; ++trial) {
      Vec3 dr = trial == 0 ? Vec3::Constant(size) : Vec3(size * random.vector());
      for (int k = 0; k < 3; ++k) {
        dr[k] = std::ldexp(std::round(std::ldexp(dr[k], 20)), -20);  // Has no more than 24 bits.
        crowd.bodies.motion[0].dr[k] = static_cast<float>(dr[k]);
      }
      const Quat exact = rotation_exp(dr) * crowd.bodies.q[0];
      EXPECT_LT((orientation_now(0, crowd.bodies).coeffs() - exact.coeffs()).norm(),
                2e-15);  // Some roundings.
    }
  }
}

}  // namespace
}  // namespace rigor::eight_bodies_test
