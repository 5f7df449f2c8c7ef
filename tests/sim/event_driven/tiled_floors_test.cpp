// What slides over the seams of floors of one height slides on: it meets the edge of the next floor, and does
// not strike its side.

#include "random_vectors.hpp"
#include "sim/time_stepping_scenes.hpp"

#include "rigor/geometry/shape/convex_hull.hpp"
#include "rigor/sim/audit/audit.hpp"
#include "rigor/sim/make_stepper.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace rigor::tiled_floors_test {
namespace {

std::vector<double> borders(test::Random& random) {
  std::vector<double> borders{-2, 2};
  const int count = static_cast<int>(random.uniform(1, 5.99));
  for (int i = 0; i < count; ++i) borders.push_back(random.uniform(-1.5, 1.5));
  std::ranges::sort(borders);
  return borders;
}

/// Floors of random lengths and widths side by side, their tops at z = 0.
void add_tiles(test::Random& random, ModelBuilder& builder) {
  const std::vector<double> x = borders(random), y = borders(random);
  for (std::size_t i = 1; i < x.size(); ++i) {
    for (std::size_t k = 1; k < y.size(); ++k) {
      const Vec3 half(0.5 * (x[i] - x[i - 1]), 0.5 * (y[k] - y[k - 1]), random.uniform(0.1, 0.3));
      BodyDescription tile =
          test::stepping_body("tile" + std::to_string(i) + "," + std::to_string(k), Box{half},
                              Vec3(0.5 * (x[i] + x[i - 1]), 0.5 * (y[k] + y[k - 1]), -half.z()));
      tile.motion = MotionType::fixed, tile.mass = {};
      builder.add_body(tile);
    }
  }
}

/// A shape that stands on a flat side, and the height of its middle above that [m].
std::pair<Shape, double> standing_shape(test::Random& random) {
  const double r = random.uniform(0.05, 0.2), h = random.uniform(0.05, 0.2);
  switch (static_cast<int>(random.uniform(0, 3.99))) {
    case 0:
      return {Box{Vec3(r, random.uniform(0.05, 0.2), h)}, h};
    case 1:
      return {Cylinder{r, h}, h};
    case 2:
      return {Convex{std::make_shared<const ConvexHull>(make_box_hull(Vec3(r, h, h)))}, h};
    default:
      return {Cone{r, h}, h};
  }
}

// Without friction the centre goes straight on and the spin stays, however often a border is crossed.
TEST(TiledFloors, AreSlidOverAsOneFloor) {
  test::Random random(3);
  for (int k = 0; k < 24; ++k) {
    SCOPED_TRACE(k);
    ModelBuilder builder;
    builder.set_gravity(Vec3(0, 0, -9.81));
    builder.add_material({"m", 1000, 0, k % 2 == 0 ? 0.5 : 0.0});
    add_tiles(random, builder);
    const auto [shape, height] = standing_shape(random);
    BodyDescription slider =
        test::stepping_body("slider", shape, Vec3(random.uniform(-1, 0), random.uniform(-1, 0), height));
    slider.q_WU = Eigen::AngleAxisd(random.uniform(0, 6), Vec3::UnitZ());
    slider.velocity = Vec3(random.uniform(0.3, 1.5), random.uniform(-0.5, 1), 0);
    slider.angular_velocity = Vec3(0, 0, random.uniform(-3, 3));
    builder.add_body(slider);

    const std::shared_ptr<const Model> model = builder.build();
    const int body = model->body_count() - 1;
    Method method;
    method.scheme = Scheme::event_driven;
    State state = make_initial_state(*model);
    const Vec3 begin = state.position(body);
    Auditor auditor(model, method, state);
    auditor.observe(state, make_stepper(model, method, 0.01)->advance(state, 0.6));
    EXPECT_TRUE(auditor.audit(state).violations.empty());

    EXPECT_LT((state.position(body) - begin - 0.6 * slider.velocity).norm(), 1e-6);
    EXPECT_LT((linear_velocity(*model, state, body) - slider.velocity).norm(), 1e-6);
    EXPECT_LT((angular_velocity(*model, state, body) - slider.angular_velocity).norm(), 1e-5);
  }
}

}  // namespace
}  // namespace rigor::tiled_floors_test
