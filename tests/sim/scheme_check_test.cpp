#include "rigor/sim/scheme_check.hpp"

#include "sim/time_stepping_scenes.hpp"

#include <gtest/gtest.h>

namespace rigor {
namespace {

TEST(SchemeCheck, TimeSteppingRefusesRollingAndTorsionalFriction) {
  Method method;
  EXPECT_TRUE(check_scheme(*test::stepping_cube(1, 1), method).empty());
  ModelBuilder builder = test::stepping_builder(0, 0.5, Vec3(0, 0, -9.81));
  Material rolling{"cork"};
  rolling.rolling_friction = 1e-3;
  builder.add_material(rolling);
  const std::shared_ptr<const Model> model = builder.build();
  EXPECT_TRUE(check_scheme(*model, method).empty());
  method.scheme = Scheme::time_stepping;
  EXPECT_TRUE(check_scheme(*test::stepping_cube(1, 1), method).empty());
  const std::vector<std::string> messages = check_scheme(*model, method);
  ASSERT_EQ(messages.size(), 1u);
  EXPECT_NE(messages[0].find("no rolling or torsional friction"), std::string::npos);
  EXPECT_NE(messages[0].find("'cork' and 'cork'"), std::string::npos);
}

}  // namespace
}  // namespace rigor
