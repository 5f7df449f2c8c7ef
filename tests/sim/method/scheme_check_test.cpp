#include "rigor/sim/method/scheme_check.hpp"

#include "rigor/sim/method/scheme_choice.hpp"
#include "sim/time_stepping_scenes.hpp"

#include <gtest/gtest.h>

namespace rigor::scheme_check_test {
namespace {

std::shared_ptr<const Model> model_with(const Material& material) {
  ModelBuilder builder = test::stepping_builder(0, 0.5, Vec3(0, 0, -9.81));
  builder.add_material(material);
  return builder.build();
}

Method method_of(Scheme scheme) {
  Method method;
  method.scheme = scheme;
  return method;
}

TEST(SchemeCheck, RollingAndTorsionalFrictionNeedTheExactSolverAndCone) {
  Material cork{"cork"};
  cork.rolling_friction = 1e-3;
  const std::shared_ptr<const Model> model = model_with(cork);
  EXPECT_TRUE(check_scheme(*model, method_of(Scheme::event_driven)).empty());
  Method method = method_of(Scheme::time_stepping);
  EXPECT_TRUE(check_scheme(*model, method).empty());
  method.solver = SolverMethod::pgs;
  EXPECT_EQ(check_scheme(*model, method),
            std::vector<std::string>{
                "scheme 'time-stepping' with solver 'pgs' has no rolling or torsional friction "
                "(materials 'cork' and 'cork'); solvers that have it: exact"});
  EXPECT_TRUE(check_scheme(*test::stepping_cube(1, 1), method).empty());
  method = method_of(Scheme::time_stepping);
  method.cone = ConeMethod::pyramid;
  ASSERT_EQ(check_scheme(*model, method).size(), 1u);
  EXPECT_NE(check_scheme(*model, method)[0].find("with cone 'pyramid'"), std::string::npos);
}

TEST(SchemeCheck, StaticFrictionNeedsTimeSteppingAndAutoTakesIt) {
  Material resin{"resin"};
  resin.static_friction = 0.6;
  const std::shared_ptr<const Model> model = model_with(resin);
  for (const Scheme scheme : {Scheme::event_driven, Scheme::penalty, Scheme::impulse_based, Scheme::hybrid}) {
    const std::vector<std::string> messages = check_scheme(*model, method_of(scheme));
    ASSERT_EQ(messages.size(), 1u);
    EXPECT_NE(messages[0].find("no static_friction above it"), std::string::npos) << messages[0];
    EXPECT_NE(messages[0].find("schemes that have it: time-stepping"), std::string::npos) << messages[0];
  }
  EXPECT_TRUE(check_scheme(*model, method_of(Scheme::time_stepping)).empty());
  EXPECT_EQ(resolve_scheme(*model, method_of(Scheme::automatic)).method.scheme, Scheme::time_stepping);
  // As large as that of sliding it changes nothing.
  resin.static_friction = 0.5;
  EXPECT_TRUE(check_scheme(*model_with(resin), method_of(Scheme::event_driven)).empty());
}

}  // namespace
}  // namespace rigor::scheme_check_test
