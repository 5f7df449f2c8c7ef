#include "rigor/contact/time_of_impact.hpp"

#include "rigor/geometry/shape/convex_hull.hpp"
#include "rigor/model/body.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <memory>
#include <tuple>

namespace rigor::time_of_impact_test {
namespace {

Vec3 vec3(const nlohmann::json& j) {
  return Vec3(j[0], j[1], j[2]);
}

/// Body with one convex shape that moves at constant velocities.
Body moving_polytope(const nlohmann::json& j) {
  std::vector<Vec3> points;
  for (const nlohmann::json& vertex : j["vertices"]) points.push_back(vec3(vertex));
  const auto hull = std::make_shared<const ConvexHull>(std::get<ConvexHull>(make_convex_hull(points)));
  Body body;
  body.motion = MotionType::kinematic;
  BodyShape shape;
  shape.shape = Convex{hull};
  for (const Vec3& p : points) shape.radius = std::max(shape.radius, p.norm());
  body.bounding_radius = shape.radius;
  body.shapes = {{shape}};
  body.p_WB = vec3(j["x0"]);
  body.q_WB = Quat(j["q0"][0], j["q0"][1], j["q0"][2], j["q0"][3]).normalized();
  body.v_WB = vec3(j["v"]);
  body.w_WB = vec3(j["w"]);
  return body;
}

class TimeOfImpactCases : public testing::TestWithParam<std::tuple<ToiRefinement, ToiDistance>> {};

TEST_P(TimeOfImpactCases, ReferenceMotionsMeetWhenTheyShouldOrNotAtAll) {
  std::ifstream file(std::string(RIGOR_TEST_DATA) + "/toi.json");
  const nlohmann::json cases = nlohmann::json::parse(file);
  ToiOptions options;
  std::tie(options.refinement, options.distance) = GetParam();
  for (const nlohmann::json& c : cases["cases"]) {
    const Body A = moving_polytope(c["A"]), B = moving_polytope(c["B"]);
    const double t_max = c["t_max"];
    const TimeOfImpact found =
        find_time_of_impact(A, Motion::prescribed(A, 0), B, Motion::prescribed(B, 0), 0, t_max, options);
    EXPECT_EQ(found.is_contact, !c["toi"].is_null()) << c["name"];
    if (!found.is_contact || c["toi"].is_null()) continue;
    // The bracket is the time tolerance; distances carry rounding of some 1e-15 m, divided by the speed of
    // approach.
    EXPECT_NEAR(found.time, c["toi"].get<double>(), 2e-12 * std::max(1.0, t_max)) << c["name"];
    EXPECT_LE(found.bracket, 4e-12) << c["name"];
  }
}

INSTANTIATE_TEST_SUITE_P(AllRefinements, TimeOfImpactCases,
                         testing::Combine(testing::Values(ToiRefinement::conservative, ToiRefinement::ratio,
                                                          ToiRefinement::bisection),
                                          testing::Values(ToiDistance::gjk, ToiDistance::lin_canny)));

Body ball(double radius, const Vec3& x, const Vec3& v) {
  Body body;
  body.motion = MotionType::kinematic;
  BodyShape shape;
  shape.shape = Sphere{radius};
  shape.radius = body.bounding_radius = radius;
  body.shapes = {{shape}};
  body.p_WB = x;
  body.v_WB = v;
  return body;
}

TEST(TimeOfImpact, NothingTunnelsAtAnySpeed) {
  Body plate = ball(1, Vec3(1, 0, 0), Vec3::Zero());
  plate.bounding_radius = std::sqrt(2.0001);
  plate.shapes = {{BodyShape{.shape = Box{Vec3(0.01, 1, 1)}, .radius = plate.bounding_radius}}};
  for (const double speed : {1.0, 1e3, 1e6}) {
    const Body bullet = ball(0.05, Vec3::Zero(), Vec3(speed, 0, 0));
    const TimeOfImpact found = find_time_of_impact(plate, Motion::prescribed(plate, 0), bullet,
                                                   Motion::prescribed(bullet, 0), 0, 10, ToiOptions{});
    ASSERT_TRUE(found.is_contact) << speed;
    EXPECT_NEAR(found.time, 0.94 / speed, 2e-12) << speed;
  }
}

TEST(TimeOfImpact, BallsThatPartAfterAnImpactDoNotMeetAgain) {
  const Body a = ball(0.1, Vec3::Zero(), Vec3::Zero()), b = ball(0.1, Vec3(0.2, 0, 0), Vec3(1, 0.3, 0));
  const TimeOfImpact found =
      find_time_of_impact(a, Motion::prescribed(a, 0), b, Motion::prescribed(b, 0), 0, 10, ToiOptions{});
  EXPECT_FALSE(found.is_contact);
  EXPECT_EQ(found.time, 10);
}

}  // namespace
}  // namespace rigor::time_of_impact_test
