#include "io/trajectory_samples.hpp"
#include "rigor/io/trajectory/csv_writer.hpp"
#include "rigor/io/trajectory/hdf5_reader.hpp"
#include "rigor/io/trajectory/json_writer.hpp"
#include "rigor/model/model_builder.hpp"
#include "rigor/sim/audit/contact_snapshot.hpp"
#include "rigor/sim/event_driven/event_driven_stepper.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <sstream>

/// What joints do, from the model to the files that are text; for HDF5 see hdf5_writer_test.cpp.
namespace rigor::joint_motion_test {
namespace {

using JointDescription = ModelBuilder::JointDescription;

/// 2 kg, moments (1, 2, 3) kg m².
BodyDescription block(const std::string& name, const Vec3& x) {
  BodyDescription body;
  body.name = name;
  body.p_WU = x;
  body.inertia = GivenInertia{2, Vec3::Zero(), Vec3(1, 2, 3), Vec3::Zero()};
  return body;
}

JointDescription joint_of(JointType type, const std::string& name, const std::vector<std::string>& bodies,
                          const Vec3& anchor) {
  JointDescription joint;
  joint.name = name;
  joint.type = type;
  joint.bodies = bodies;
  joint.anchors = {anchor};
  joint.axis = Vec3::UnitY();
  joint.axes.resize(static_cast<std::size_t>(coordinate_count(type)));
  return joint;
}

/// So many blocks in a row without gravity, each on a cylindrical joint of its own along y.
std::shared_ptr<const Model> row_of_blocks(int count) {
  ModelBuilder builder;
  builder.set_gravity(Vec3::Zero());
  for (int i = 0; i < count; ++i) {
    const std::string number = std::to_string(i);
    BodyDescription body = block("block" + number, Vec3(10.0 * i, 0, 0));
    body.velocity = Vec3(0, i, 0);
    body.angular_velocity = Vec3(0, -0.5 * i, 0);
    builder.add_body(body);
    builder.add_joint(joint_of(JointType::cylindrical, "joint" + number, {"world", "block" + number},
                               Vec3(10.0 * i, 0, 0)));
  }
  return builder.build();
}

std::vector<std::string> lines_of(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);) lines.push_back(line);
  return lines;
}

// The numbers

TEST(JointMotion, OfAPendulumIsItsRateAndTheForcesThatHoldIt) {
  constexpr double g = 9.81, m = 2, I = 2, l = 1, w = 3;
  ModelBuilder builder;
  builder.set_gravity(Vec3(0, 0, -g));
  BodyDescription body = block("bob", Vec3(l, 0, 0));
  body.angular_velocity = Vec3(0, w, 0);
  body.velocity = Vec3(0, 0, -w * l);
  builder.add_body(body);
  builder.add_joint(joint_of(JointType::hinge, "elbow", {"world", "bob"}, Vec3::Zero()));
  const std::shared_ptr<const Model> model = builder.build();
  ASSERT_TRUE(has_joint_forces(*model));

  TrajectorySample sample;
  add_joint_motion(*model, Method{}, make_initial_state(*model), sample);
  // All numbers are of the size 1 to 100, and few sums make them.
  constexpr double rounding = 1e-12;
  ASSERT_EQ(sample.joint_coordinate.size(), 1u);
  EXPECT_NEAR(sample.joint_coordinate[0], 0, rounding);
  EXPECT_NEAR(sample.joint_rate.at(0), w, rounding);
  // Level pendulum: gravity turns it with α = m g l / (m l² + I), which leaves the hinge this share of the
  // weight; the way round asks for m w² l towards the hinge.
  ASSERT_EQ(sample.joint_force.size(), 3u);
  EXPECT_NEAR(sample.joint_force[0], -m * w * w * l, rounding);
  EXPECT_NEAR(sample.joint_force[1], 0, rounding);
  EXPECT_NEAR(sample.joint_force[2], m * g * I / (m * l * l + I), rounding);
  ASSERT_EQ(sample.joint_torque.size(), 3u);
  for (const double torque : sample.joint_torque) EXPECT_NEAR(torque, 0, rounding);
}

TEST(JointMotion, OfTwoHundredJointsHasForcesAndOfMoreOnlyCoordinates) {
  for (const int count : {200, 201}) {
    const std::shared_ptr<const Model> model = row_of_blocks(count);
    State state = make_initial_state(*model);
    EventDrivenStepper stepper(model, Method{}, 0.01);
    ASSERT_EQ(stepper.advance(state, 0.125).reason, StopReason::reached_end);
    TrajectorySample sample;
    add_joint_motion(*model, Method{}, state, sample);
    const std::size_t n = static_cast<std::size_t>(count);
    EXPECT_EQ(has_joint_forces(*model), count == 200);
    EXPECT_EQ(sample.joint_force.size(), count == 200 ? 3 * n : 0u);
    EXPECT_EQ(sample.joint_torque.size(), count == 200 ? 3 * n : 0u);
    ASSERT_EQ(sample.joint_coordinate.size(), 2 * n);
    ASSERT_EQ(sample.joint_rate.size(), 2 * n);
    for (int i = 0; i < count; ++i) {
      const std::size_t k = 2 * static_cast<std::size_t>(i);
      // Uniform motion; the angle stays in [-π, π] while its size is below that.
      EXPECT_NEAR(sample.joint_coordinate[k], 0.125 * i, 1e-9);
      EXPECT_NEAR(sample.joint_rate[k], i, 1e-9);
      if (0.0625 * i < 3) {
        EXPECT_NEAR(sample.joint_coordinate[k + 1], -0.0625 * i, 1e-9);
      }
      EXPECT_NEAR(sample.joint_rate[k + 1], -0.5 * i, 1e-9);
    }
  }
}

TEST(JointMotion, WithoutForcesIsThatOfTheWholeSnapshot) {
  ModelBuilder builder;
  builder.set_gravity(Vec3(0, 0, -9.81));
  builder.add_body(block("a", Vec3(1, 0, 0)));
  builder.add_body(block("b", Vec3(2, 0, 0)));
  builder.add_joint(joint_of(JointType::hinge, "upper", {"world", "a"}, Vec3::Zero()));
  builder.add_joint(joint_of(JointType::ball, "lower", {"a", "b"}, Vec3(1.5, 0, 0)));
  builder.add_joint(joint_of(JointType::fixed, "weld", {"a", "b"}, Vec3(1.5, 0, 0)));
  const std::shared_ptr<const Model> model = builder.build();
  State state = make_initial_state(*model);
  EventDrivenStepper stepper(model, Method{}, 0.01);
  ASSERT_EQ(stepper.advance(state, 0.3).reason, StopReason::reached_end);
  const std::vector<JointReaction> whole = joint_snapshot(*model, Method{}, state),
                                   cheap = joint_motions(*model, state);
  ASSERT_EQ(cheap.size(), 3u);
  for (std::size_t j = 0; j < 3; ++j) {
    EXPECT_EQ(cheap[j].joint, whole[j].joint);
    EXPECT_LT((cheap[j].p_W - whole[j].p_W).norm(), 1e-14);
    ASSERT_EQ(cheap[j].coordinates.size(), j < 2 ? 1u : 0u);
    ASSERT_EQ(whole[j].coordinates.size(), j < 2 ? 1u : 0u);
    if (j == 2) continue;
    EXPECT_NEAR(cheap[j].coordinates[0], whole[j].coordinates[0], 1e-14);
    EXPECT_NEAR(cheap[j].rates[0], whole[j].rates[0], 1e-13);
  }
  EXPECT_GT(std::abs(cheap[0].coordinates[0]), 0.1) << "it moved";
}

// The files

TEST(JointMotion, HasColumnsWithUnitsBetweenBodiesAndEnergies) {
  TrajectoryHeader header = sample_header({"ball"});
  header.joints = {{"elbow", {"rad"}}, {"pin[0,1]", {"m", "rad"}}, {"weld", {}}};
  header.has_joint_forces = true;
  const std::vector<std::string> columns = csv_columns(header);
  const std::vector<std::string> of_joints(columns.begin() + 14, columns.end() - 3);
  const auto with_forces = [](std::vector<std::string> titles, const std::string& joint) {
    for (const char* axis : {"x", "y", "z"}) titles.push_back(joint + ".force." + axis + " [N]");
    for (const char* axis : {"x", "y", "z"}) titles.push_back(joint + ".torque." + axis + " [N m]");
    return titles;
  };
  std::vector<std::string> expected = with_forces({"elbow.coordinate [rad]", "elbow.rate [rad/s]"}, "elbow");
  for (const std::string& title : with_forces({"pin[0,1].coordinate[0] [m]", "pin[0,1].coordinate[1] [rad]",
                                               "pin[0,1].rate[0] [m/s]", "pin[0,1].rate[1] [rad/s]"},
                                              "pin[0,1]"))
    expected.push_back(title);
  for (const std::string& title : with_forces({}, "weld")) expected.push_back(title);
  EXPECT_EQ(of_joints, expected);
  EXPECT_EQ(columns.back(), "elastic_energy [J]");

  header.has_joint_forces = false;
  EXPECT_EQ(csv_columns(header).size(), 14 + 2 + 4 + 3u);
}

TEST(JointMotion, HasTheForcesOfMotorsInEveryFormat) {
  // A motor of 2 N m turns a wheel of 4 kg m²; a second hinge has none.
  ModelBuilder builder;
  builder.set_gravity(Vec3::Zero());
  for (const char* name : {"wheel", "other"}) {
    BodyDescription body;
    body.name = name;
    body.p_WU = Vec3(name[0] == 'w' ? 0 : 2, 0, 0);
    body.inertia = GivenInertia{1, Vec3::Zero(), Vec3::Constant(4), Vec3::Zero()};
    builder.add_body(body);
    ModelBuilder::JointDescription hinge;
    hinge.name = std::string("axle of ") + name;
    hinge.type = JointType::hinge;
    hinge.bodies = {"world", name};
    hinge.anchors = {body.p_WU};
    JointAxis axis;
    if (name[0] == 'w') axis.motor = JointMotor{100, 2};
    hinge.axes = {axis};
    builder.add_joint(hinge);
  }
  const std::shared_ptr<const Model> model = builder.build();
  ASSERT_TRUE(has_efforts(*model));
  TrajectorySample sample = make_sample(*model, make_initial_state(*model), {});
  add_joint_motion(*model, Method{}, make_initial_state(*model), sample);
  ASSERT_EQ(sample.joint_effort.size(), 2u);
  EXPECT_NEAR(sample.joint_effort[0], 2, 1e-12);
  EXPECT_EQ(sample.joint_effort[1], 0);

  TrajectoryHeader header = sample_header({"wheel", "other"});
  header.joints = trajectory_joints(*model);
  header.has_joint_forces = header.has_efforts = true;
  const std::vector<std::string> columns = csv_columns(header);
  EXPECT_EQ(columns.at(1 + 2 * 13 + 2), "axle of wheel.effort [N m]");
  const TemporaryFolder folder;
  for (const char* file : {"run.csv", "run.h5", "run.json"}) {
    const auto writer = make_trajectory_writer(folder / file, header);
    writer->write(sample, {});
    writer->close({});
  }
  EXPECT_EQ(read_hdf5_trajectory(folder / "run.h5").joint_effort, sample.joint_effort);
  std::ifstream file(folder / "run.json");
  EXPECT_EQ(nlohmann::json::parse(file)["trajectory"][0]["joints"]["effort"],
            nlohmann::json({{sample.joint_effort[0]}, {0.0}}));
  std::istringstream fields(lines_of(folder / "run.csv").at(1));
  std::string field;
  for (int k = 0; k <= 1 + 2 * 13 + 2; ++k) std::getline(fields, field, ',');
  EXPECT_EQ(std::stod(field), sample.joint_effort[0]);
}

TEST(JointMotion, IsInTheRowsOfACsvFileInTheOrderOfTheColumns) {
  const TemporaryFolder folder;
  const TrajectoryHeader header = jointed_header({"a"}, {"elbow", "knee"});
  CsvWriter writer(folder / "run.csv", header);
  const TrajectorySample row = sample_row(3, 1, 2);
  writer.write(row, {});
  writer.close({});
  std::istringstream fields(lines_of(folder / "run.csv").at(1));
  std::vector<double> numbers;
  for (std::string field; std::getline(fields, field, ',');) numbers.push_back(std::stod(field));
  ASSERT_EQ(numbers.size(), csv_columns(header).size());
  for (std::size_t joint = 0; joint < 2; ++joint) {
    const double* const of_joint = &numbers[14 + 10 * joint];
    for (std::size_t k = 0; k < 2; ++k) {
      EXPECT_EQ(of_joint[k], row.joint_coordinate[2 * joint + k]);
      EXPECT_EQ(of_joint[2 + k], row.joint_rate[2 * joint + k]);
    }
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(of_joint[4 + k], row.joint_force[3 * joint + k]);
      EXPECT_EQ(of_joint[7 + k], row.joint_torque[3 * joint + k]);
    }
  }
  EXPECT_EQ(numbers[34], row.energy.kinetic);
}

TEST(JointMotion, IsAnObjectOfEachLineOfAJsonFile) {
  const TemporaryFolder folder;
  TrajectoryHeader header = sample_header({"a"});
  header.joints = {{"weld", {}}, {"elbow", {"rad"}}};
  header.has_joint_forces = true;
  TrajectorySample sample = sample_row(0, 1);
  sample.joint_coordinate = {0.25};
  sample.joint_rate = {-2};
  sample.joint_force = {1, 2, 3, 4, 5, 6};
  sample.joint_torque = {7, 8, 9, 10, 11, 12};
  JsonWriter writer(folder / "run.json", header);
  writer.write(sample, {});
  writer.close({});
  std::ifstream file(folder / "run.json");
  const nlohmann::json json = nlohmann::json::parse(file);
  EXPECT_EQ(json.at("joints"), nlohmann::json::parse(R"(["weld", "elbow"])"));
  EXPECT_EQ(json.at("trajectory").at(0).at("joints"),
            nlohmann::json::parse(R"({"coordinate": [[], [0.25]], "rate": [[], [-2]],
                                      "force": [[1, 2, 3], [4, 5, 6]],
                                      "torque": [[7, 8, 9], [10, 11, 12]]})"));
}

TEST(JointMotion, IsNotMentionedInJsonFilesOfScenesWithoutJoints) {
  const TemporaryFolder folder;
  JsonWriter writer(folder / "run.json", sample_header({"a"}));
  writer.write(sample_row(0, 1), {});
  writer.close({});
  for (const std::string& line : lines_of(folder / "run.json"))
    EXPECT_EQ(line.find("joints\":"), std::string::npos) << line;
}

}  // namespace
}  // namespace rigor::joint_motion_test
