#include "rigor/io/trajectory/audit_json.hpp"

#include "rigor/io/files/version.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <limits>
#include <sstream>

namespace rigor::audit_json_test {
namespace {

using Json = nlohmann::ordered_json;

Audit sample_audit() {
  Audit audit;
  audit.scene = "two \"balls\"";
  audit.sim_time = 0.1;
  audit.wall_time = 2;
  audit.report.steps = 3;
  audit.report.impacts = 4;
  audit.report.resting = 5;
  audit.report.separations = 6;
  audit.report.slip_to_stick = 7;
  audit.report.work = 8;
  audit.initial.kinetic = 1;
  audit.initial.potential = 2;
  audit.initial.elastic = 4;
  audit.final.kinetic = 0.5;
  audit.dissipated = 6.5;
  audit.report.max_penetration = 1e-9;
  audit.report.penetration_A = 1;
  audit.report.penetration_B = 0;
  audit.report.penetration_time = 0.25;
  audit.bodies = {{"a", Vec3(1, 2, 3), Quat(1, 0, 0, 0), Vec3::Zero(), Vec3::Zero()},
                  {"b", Vec3(1.0 / 3, 0, 0), Quat(0, 1, 0, 0), Vec3(4, 5, 6), Vec3(7, 8, 9)}};
  audit.warnings = {"be careful"};
  audit.violations = {"penetration is 1 m"};
  return audit;
}

std::vector<std::string> keys_of(const Json& object) {
  std::vector<std::string> keys;
  for (const auto& item : object.items()) keys.push_back(item.key());
  return keys;
}

TEST(AuditJson, KeysAreThoseOfTheContractInItsOrder) {
  const Json json = Json::parse(audit_json(sample_audit()));
  const std::vector<std::string> expected = {"rigor",
                                             "scene",
                                             "method",
                                             "complete",
                                             "end_time",
                                             "duration",
                                             "sim_time",
                                             "wall_time",
                                             "steps",
                                             "events",
                                             "energy",
                                             "linear_momentum_error",
                                             "angular_momentum_error",
                                             "penetration",
                                             "joint_drift",
                                             "toi_bracket",
                                             "solver",
                                             "warnings",
                                             "bodies"};
  EXPECT_EQ(keys_of(json), expected);
  EXPECT_EQ(keys_of(json["events"]),
            (std::vector<std::string>{"impacts", "resting", "separations", "slip_to_stick"}));
  EXPECT_EQ(keys_of(json["energy"]),
            (std::vector<std::string>{"initial", "final", "work", "motor_work", "dissipated", "friction_loss",
                                      "impact_loss", "elastic", "max_increase"}));
  EXPECT_EQ(keys_of(json["penetration"]),
            (std::vector<std::string>{"max", "bodies", "time", "of_thickness"}));
  EXPECT_EQ(keys_of(json["joint_drift"]), (std::vector<std::string>{"max", "joint", "projected"}));
  EXPECT_EQ(keys_of(json["solver"]),
            (std::vector<std::string>{"max_residual", "max_iterations", "fallbacks", "coarse_steps"}));
  EXPECT_EQ(keys_of(json["bodies"]["b"]),
            (std::vector<std::string>{"position", "orientation", "velocity", "angular_velocity"}));
}

TEST(AuditJson, JointsHaveTheirCoordinatesAndReactions) {
  Audit audit = sample_audit();
  audit.joints = {{"elbow", {0.5}, {-2}, Vec3(1, 2, 3), Vec3(4, 5, 6)}};
  audit.report.max_joint_drift = 1e-15;
  audit.report.drift_joint = 0;
  audit.report.max_joint_projection = 1e-9;
  const Json json = Json::parse(audit_json(audit));
  EXPECT_EQ(json["joint_drift"], (Json{{"max", 1e-15}, {"joint", "elbow"}, {"projected", 1e-9}}));
  EXPECT_EQ(json["joints"]["elbow"], (Json{{"coordinates", {0.5}},
                                           {"rates", {-2.0}},
                                           {"force", {1.0, 2.0, 3.0}},
                                           {"torque", {4.0, 5.0, 6.0}}}));
}

TEST(AuditJson, ValuesAreThoseOfTheAudit) {
  const Json json = Json::parse(audit_json(sample_audit()));
  EXPECT_EQ(json["rigor"], version);
  EXPECT_EQ(json["scene"], "two \"balls\"");
  EXPECT_EQ(json["method"]["impact"], "stronge");
  EXPECT_EQ(json["method"]["contact_tolerance"], 1e-6);
  EXPECT_EQ(json["events"]["slip_to_stick"], 7);
  EXPECT_EQ(json["energy"]["initial"], 7.0);
  EXPECT_EQ(json["penetration"]["bodies"], (Json{"b", "a"}));
  EXPECT_EQ(json["warnings"], (Json{"violated: penetration is 1 m", "be careful"}));
  EXPECT_EQ(json["bodies"]["b"]["position"][0].get<double>(), 1.0 / 3);
  EXPECT_EQ(json["bodies"]["b"]["orientation"], (Json{0.0, 1.0, 0.0, 0.0}));
}

TEST(AuditJson, NumbersHaveSeventeenDigitsAndNoNanAppears) {
  Audit audit = sample_audit();
  audit.max_increase = std::numeric_limits<double>::quiet_NaN();
  audit.dissipated = std::numeric_limits<double>::infinity();
  const std::string text = audit_json(audit);
  EXPECT_NE(text.find("0.10000000000000001"), std::string::npos);
  EXPECT_EQ(text.find("nan"), std::string::npos);
  EXPECT_EQ(text.find("inf"), std::string::npos);
  const Json json = Json::parse(text);
  EXPECT_TRUE(json["energy"]["max_increase"].is_null());
  EXPECT_TRUE(json["energy"]["dissipated"].is_null());
}

TEST(AuditJson, WithoutPenetrationBodiesAndTimeAreNull) {
  Audit audit = sample_audit();
  audit.report.penetration_A = audit.report.penetration_B = -1;
  const Json json = Json::parse(audit_json(audit));
  EXPECT_TRUE(json["penetration"]["bodies"].is_null());
  EXPECT_TRUE(json["penetration"]["time"].is_null());
}

TEST(Version, IsThatOfTheBuildFile) {
  std::ifstream file(RIGOR_SOURCE_DIR "/CMakeLists.txt");
  std::ostringstream text;
  text << file.rdbuf();
  EXPECT_NE(text.str().find("project(rigor VERSION " + std::string(version) + " "), std::string::npos);
}

TEST(AuditJson, OfARunThatWasHandedOverHasASpanForEachPart) {
  Audit audit = sample_audit();
  audit.method.scheme = Scheme::event_driven;
  EXPECT_FALSE(Json::parse(audit_json(audit)).contains("spans"));
  EXPECT_EQ(Json::parse(audit_json(audit))["method"]["scheme"], "event-driven");
  audit.step = 0.01;
  audit.spans = {
      {{.scheme = Scheme::event_driven, .end = 0.04, .rise = 1e-12, .end_cause = "events crowd"},
       1e-9,
       1e-6,
       1e-8},
      {{.scheme = Scheme::time_stepping, .begin = 0.04, .end = 0.1, .impacts = 2}, 1e-6, 1e-6, 1e-8}};
  const Json json = Json::parse(audit_json(audit));
  EXPECT_EQ(json["method"]["scheme"], "auto");
  EXPECT_TRUE(json["method"].contains("toi"));     // Of events,
  EXPECT_TRUE(json["method"].contains("solver"));  // and of steps.
  ASSERT_EQ(json["spans"].size(), 2u);
  const Json &first = json["spans"][0], &last = json["spans"][1];
  EXPECT_EQ(first["scheme"], "event-driven");
  EXPECT_EQ(first["impact_time_error"], 1e-12);
  EXPECT_EQ(first["energy_increase"]["max"], 1e-12);
  EXPECT_EQ(first["energy_increase"]["tolerance"], 1e-9);
  EXPECT_EQ(first["end_cause"], "events crowd");
  EXPECT_EQ(last["begin"], 0.04);
  EXPECT_EQ(last["impacts"], 2);
  EXPECT_EQ(last["impact_time_error"], 0.01);
  EXPECT_TRUE(last["end_cause"].is_null());
}

}  // namespace
}  // namespace rigor::audit_json_test
