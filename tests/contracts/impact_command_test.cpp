#include "contracts/program.hpp"
#include "rigor/math/types.hpp"
#include "solver/reference_data.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <sstream>

// rigor impact: what it computes, what it writes, what it refuses.

namespace rigor::impact_command_test {
namespace {

using Json = nlohmann::json;
using Arguments = std::vector<std::string>;

/// A box that falls on its corner, and one that lies flat; both touch the floor.
const std::string boxes = R"(rigor: 1
name: boxes
run: {duration: 1}
materials: [{name: wood, friction: 0.5, restitution: 0.9}]
bodies:
  - {name: floor, motion: static, shapes: [{type: plane, normal: [0, 0, 1], offset: 0, material: wood}]}
  - name: corner
    position: [0, 0, 0.143203232228]
    rpy: [-40 deg, 20 deg, -85 deg]
    velocity: [-1.5, 1.5, -3]
    angular_velocity: [10, 10, 5]
    mass: 1
    shapes: [{type: box, size: [0.4, 0.2, 0.04], material: wood}]
  - name: flat
    position: [2, 0, 0.1]
    velocity: [1, 0, -1]
    mass: 2
    shapes: [{type: box, size: [0.2, 0.2, 0.2], material: wood}]
  - name: far
    position: [4, 0, 1]
    mass: 1
    shapes: [{type: sphere, radius: 0.1, material: wood}]
  - name: deep
    position: [6, 0, 0.09]
    mass: 1
    shapes: [{type: sphere, radius: 0.1, material: wood}]
  - name: lift
    motion: kinematic
    position: [-3, 0, 0.5]
    velocity: [0, 0, 2]
    shapes: [{type: box, size: [1, 1, 1], material: wood}]
  - name: ball
    position: [-3, 0, 1.1]
    velocity: [1, 0, 0]
    mass: 0.5
    shapes: [{type: sphere, radius: 0.1, material: wood}]
)";

const std::string ball_K = "3.5,0,0,3.5,0,1";

std::string comma_list(const VecX& values) {
  std::ostringstream text;
  text.precision(17);
  for (Eigen::Index k = 0; k < values.size(); ++k) text << (k > 0 ? "," : "") << values[k];
  return text.str();
}
std::string exact(double value) {
  return comma_list(VecX::Constant(1, value));
}
Vec3 vec(const Json& values) {
  return reference::vector(values);
}

/// The result of a run that must succeed.
Json result_of(const ProgramFolder& folder, Arguments arguments) {
  arguments.insert(arguments.begin(), "impact");
  arguments.insert(arguments.end(), {"--json", "-"});
  const ProgramResult result = folder.run(arguments);
  EXPECT_EQ(result.code, 0) << result.error;
  return Json::parse(result.out);
}

/// Rows of a table, as texts.
std::vector<std::vector<std::string>> rows_of(const std::string& table) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream lines(table);
  for (std::string line; std::getline(lines, line);) {
    std::vector<std::string>& row = rows.emplace_back();
    for (std::size_t at = 0; at <= line.size();) {
      const std::size_t end = std::min(line.find(',', at), line.size());
      row.push_back(line.substr(at, end - at));
      at = end + 1;
    }
  }
  return rows;
}

// What it computes

TEST(ImpactCommand, GivesTheReferenceImpactsUnderEveryLaw) {
  const ProgramFolder folder;
  for (const Json& json : reference::read("impact.json")["cases"]) {
    SCOPED_TRACE(json["id"].get<std::string>());
    const Mat3 K = reference::matrix(json["K"]);
    const Vec6 numbers = (Vec6() << K(0, 0), K(0, 1), K(0, 2), K(1, 1), K(1, 2), K(2, 2)).finished();
    const Json result =
        result_of(folder, {"--K", comma_list(numbers), "--u", comma_list(reference::vector(json["u"])),
                           "--mu", exact(json["mu"].get<double>()), "--e", exact(json["e"].get<double>())});
    ASSERT_EQ(result["laws"].size(), 3u);
    for (const char* law : {"newton", "poisson", "stronge"}) {
      const Json &found = result["laws"][law], &expected = json[law];
      EXPECT_EQ(found["phases"], expected["phases"]);
      EXPECT_LT((vec(found["velocity"]) - vec(expected["u"])).norm(), 1e-12 * vec(json["u"]).norm());
      EXPECT_LT((vec(found["impulse"]) - vec(expected["lambda"])).norm(),
                1e-12 * vec(expected["lambda"]).norm());
      EXPECT_NEAR(found["energy_change"].get<double>(), expected["energy_change"].get<double>(), 1e-12);
      EXPECT_NEAR(found["work"].get<double>(), expected["work"].get<double>(), 1e-12);
      EXPECT_NEAR(found["compression"]["work"].get<double>(), expected["compression_work"].get<double>(),
                  1e-12);
    }
  }
}

TEST(ImpactCommand, TellsTheInvariantDirectionsAndWhetherSlipStays) {
  const ProgramFolder folder;
  for (const Json& json : reference::read("invariant_directions.json")["cases"]) {
    const Mat3 K = reference::matrix(json["K"]);
    if (K(0, 1) == 0 && K(0, 0) == K(1, 1) && K(0, 2) == 0 && K(1, 2) == 0) continue;
    const Json result = result_of(folder, {"--K", comma_list(K.reshaped()), "--u", "1,0,-1", "--mu",
                                           exact(json["mu"].get<double>()), "--e", "0.5"});
    SCOPED_TRACE(json["id"].get<std::string>());
    EXPECT_EQ(result["sticking"]["is_stable"], json["stable"]);
    EXPECT_NEAR(result["sticking"]["ratio"].get<double>(), json["stick_ratio"].get<double>(), 1e-12);
    const Json &found = result["invariant_directions"], &expected = json["directions"];
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t k = 0; k < found.size(); ++k) {
      EXPECT_NEAR(found[k]["angle"].get<double>(), expected[k]["theta"].get<double>(), 1e-12);
      EXPECT_EQ(found[k]["is_growing"].get<bool>(), expected[k]["radial_rate"].get<double>() > 0);
    }
  }
}

TEST(ImpactCommand, WarnsWhereNewtonsLawGainsEnergy) {
  const ProgramFolder folder;
  for (const Json& json : reference::read("impact.json")["cases"]) {
    const bool gains = json["newton"]["energy_change"].get<double>() > 0;
    const ProgramResult result =
        folder.run({"impact", "--K", comma_list(reference::matrix(json["K"]).reshaped()), "--u",
                    comma_list(reference::vector(json["u"])), "--mu", exact(json["mu"].get<double>()), "--e",
                    exact(json["e"].get<double>())});
    EXPECT_EQ(result.code, 0);
    EXPECT_EQ(result.error.find("warning: the law newton gains") != std::string::npos, gains) << result.error;
    EXPECT_EQ(line_count(result.error), gains ? 1u : 0u);
  }
}

TEST(ImpactCommand, TheTextSaysWhatHappensInWords) {
  // A ball that rolls off: K = diag(7/2, 7/2, 1)/m, energy ½ uᵀ K⁻¹ u = ½ (5/3.5 + 9).
  const ProgramFolder folder;
  const ProgramResult result =
      folder.run({"impact", "--K", ball_K, "--u", "2,1,-3", "--mu", "0.2", "--e", "0.8", "--law", "stronge"});
  EXPECT_EQ(result.code, 0);
  EXPECT_EQ(result.error, "");
  for (const char* part :
       {"condition   3.5\n", "velocity    [2, 1, -3] m/s before", "mu, e       0.2, 0.8\n",
        "sticking    stable: it needs friction 0 of the normal force, mu is 0.2",
        "slip keeps its direction, whatever it is", "Stronge\n", "[0, 0, 2.4] m/s after",
        "S|SK: slides, greatest compression, slides, sticks", "of the normal impulse: -4.5 J"}) {
    expect_contains(result.out, part);
  }
  expect_contains(result.out, "5.214285714285714 J at most can be lost");
}

TEST(ImpactCommand, TheCompliantLawGivesItsReference) {
  const ProgramFolder folder;
  for (const Json& json : reference::read("tangential_compliance.json")["cases"]) {
    const Json result =
        result_of(folder, {"--K", ball_K, "--u", exact(json["psi"].get<double>()) + ",0,-1", "--mu", "0.3",
                           "--e", "1", "--law", "compliant", "--stiffness-ratio", exact(1 / 1.21)});
    EXPECT_NEAR(result["laws"]["compliant"]["velocity"][0].get<double>(), json["slip"].get<double>(), 1e-10);
  }
}

TEST(ImpactCommand, TheAlgebraicLawWithFullRestitutionIsASuperball) {
  const ProgramFolder folder;
  const Json result = result_of(folder, {"--K", ball_K, "--u", "2,1,-3", "--mu", "5", "--e", "1", "--law",
                                         "chatterjee-ruina,stronge", "--et", "1"});
  const Json& law = result["laws"]["chatterjee-ruina"];
  EXPECT_LT((vec(law["velocity"]) - Vec3(-2, -1, 3)).norm(), 1e-14);
  EXPECT_NEAR(law["energy_change"].get<double>(), 0, 1e-14);
  EXPECT_EQ(law["share"].get<double>(), 2);
  EXPECT_FALSE(law["is_limited_by_friction"].get<bool>());
  EXPECT_TRUE(result["laws"].contains("stronge"));
}

TEST(ImpactCommand, FrictionMayBeInfiniteAndWhatPartsIsLeftAlone) {
  const ProgramFolder folder;
  const Json infinite = result_of(folder, {"--K", ball_K, "--u", "2,1,-3", "--mu", "inf", "--e", "0.5"});
  EXPECT_EQ(infinite["mu"], "inf");
  EXPECT_LT((vec(infinite["laws"]["stronge"]["velocity"]) - Vec3(0, 0, 1.5)).norm(), 1e-14);
  const ProgramResult parting =
      folder.run({"impact", "--K", ball_K, "--u", "2,1,3", "--mu", "0.2", "--e", "0.5"});
  EXPECT_EQ(parting.code, 0);
  expect_contains(parting.error, "warning: the bodies do not approach at this contact");
  expect_contains(parting.out, "phases      nothing: the bodies do not approach");
}

// Two bodies of a scene

TEST(ImpactCommand, OfASceneKeepsTheBalanceOfTheBodies) {
  const ProgramFolder folder;
  folder.write("boxes.yaml", boxes);
  const Json result = result_of(folder, {"boxes.yaml", "floor", "corner"});
  EXPECT_EQ(result["mu"].get<double>(), 0.5);
  EXPECT_EQ(result["e"].get<double>(), 0.9);
  const Json& scene = result["scene"];
  EXPECT_EQ(vec(scene["normal"]), Vec3(0, 0, 1));
  // Velocity of the corner, and K of a box of 1 kg, by hand.
  const Vec3 r = vec(scene["point"]) - Vec3(0, 0, 0.143203232228);
  const Vec3 u_W = Vec3(-1.5, 1.5, -3) + Vec3(10, 10, 5).cross(r);
  Mat3 C;
  C << vec(scene["tangent_1"]), vec(scene["tangent_2"]), vec(scene["normal"]);
  EXPECT_LT((C * vec(result["velocity"]) - u_W).norm(), 1e-12);
  const double before = scene["kinetic_energy"].get<double>();
  for (const auto& [law, found] : result["laws"].items()) {
    const Vec3 impulse_W = C * vec(found["impulse"]);
    EXPECT_LT((Vec3(-1.5, 1.5, -3) + impulse_W - vec(found["after"]["B"]["velocity"])).norm(), 1e-13);
    EXPECT_NEAR(found["after"]["kinetic_energy"].get<double>() - before, found["energy_change"].get<double>(),
                1e-12);
    const Vec3 after_W =
        vec(found["after"]["B"]["velocity"]) + vec(found["after"]["B"]["angular_velocity"]).cross(r);
    EXPECT_LT((C * vec(found["velocity"]) - after_W).norm(), 1e-12) << law;
  }
  // The other way round the normal turns, and nothing else that is seen from outside.
  const Json other = result_of(folder, {"boxes.yaml", "corner", "floor"});
  EXPECT_EQ(vec(other["scene"]["normal"]), Vec3(0, 0, -1));
  EXPECT_NEAR(other["laws"]["stronge"]["energy_change"].get<double>(),
              result["laws"]["stronge"]["energy_change"].get<double>(), 1e-13);
  EXPECT_LT((vec(other["laws"]["stronge"]["after"]["A"]["velocity"]) -
             vec(result["laws"]["stronge"]["after"]["B"]["velocity"]))
                .norm(),
            1e-12);
}

TEST(ImpactCommand, AMovingBodyDoesWork) {
  const ProgramFolder folder;
  folder.write("boxes.yaml", boxes);
  const Json result = result_of(folder, {"boxes.yaml", "lift", "ball", "--law", "stronge", "--mu", "0.1"});
  EXPECT_EQ(vec(result["velocity"])[2], -2);
  EXPECT_EQ(result["mu"].get<double>(), 0.1);
  const Json& law = result["laws"]["stronge"];
  const double gained =
      law["after"]["kinetic_energy"].get<double>() - result["scene"]["kinetic_energy"].get<double>();
  EXPECT_NEAR(gained, law["energy_change"].get<double>() + law["after"]["work_of_moving_body"].get<double>(),
              1e-13);
  // The ball leaves at e times the approach, beside the lift's own 2 m/s: impulse m (1 + e) 2.
  EXPECT_NEAR(law["after"]["B"]["velocity"][2].get<double>(), 2 + 0.9 * 2, 1e-13);
  EXPECT_NEAR(law["after"]["work_of_moving_body"].get<double>(), 0.5 * 1.9 * 2 * 2, 1e-13);
}

TEST(ImpactCommand, OneOfSeveralContactPointsIsChosen) {
  const ProgramFolder folder;
  folder.write("boxes.yaml", boxes);
  const ProgramResult asked = folder.run({"impact", "boxes.yaml", "floor", "flat"});
  EXPECT_EQ(asked.code, 2);
  expect_contains(asked.error,
                  "bodies 'floor' and 'flat' touch at 4 points; choose one with --contact N: 1 at [");
  expect_contains(asked.error, "4 at [");
  EXPECT_EQ(line_count(asked.error), 1u);
  std::vector<Vec3> points;
  for (const char* number : {"1", "2", "3", "4"}) {
    const Json result = result_of(folder, {"boxes.yaml", "floor", "flat", "--contact", number});
    EXPECT_EQ(result["scene"]["contacts"].get<int>(), 4);
    points.push_back(vec(result["scene"]["point"]));
    EXPECT_NEAR(std::abs(points.back().x() - 2), 0.1, 1e-12);
    EXPECT_NEAR(std::abs(points.back().y()), 0.1, 1e-12);
    for (std::size_t k = 0; k + 1 < points.size(); ++k) EXPECT_GT((points[k] - points.back()).norm(), 0.1);
  }
  const ProgramResult beyond = folder.run({"impact", "boxes.yaml", "floor", "flat", "--contact", "5"});
  EXPECT_EQ(beyond.code, 2);
  expect_contains(beyond.error, "--contact 5: bodies 'floor' and 'flat' touch at 4 points");
}

TEST(ImpactCommand, BodiesThatDoNotTouchAreRefused) {
  const ProgramFolder folder;
  folder.write("boxes.yaml", boxes);
  const ProgramResult far = folder.run({"impact", "boxes.yaml", "floor", "far"});
  EXPECT_EQ(far.code, 3);
  expect_contains(far.error,
                  "bodies 'floor' and 'far' do not touch at t = 0: they are farther apart than 1e-06 m");
  EXPECT_EQ(folder.run({"impact", "boxes.yaml", "floor", "far", "--tolerance", "0.95"}).code, 0);
  const ProgramResult deep = folder.run({"impact", "boxes.yaml", "floor", "deep"});
  EXPECT_EQ(deep.code, 3);
  expect_contains(deep.error, "overlap at t = 0 by 0.01 m, at most 1e-06 m is allowed");
  const ProgramResult still = folder.run({"impact", "boxes.yaml", "floor", "lift"});
  EXPECT_EQ(still.code, 3);
  expect_contains(still.error, "neither of the two bodies is dynamic");
}

// What it writes

TEST(ImpactCommand, TheTableFollowsTheImpact) {
  const ProgramFolder folder;
  const Mat3 K{{2.7, -0.33, 1.65}, {-0.33, 5.43, 2.04}, {1.65, 2.04, 3.88}};
  const Vec3 u(-3.32, -2.16, -5.32);
  const ProgramResult run = folder.run({"impact", "--K", comma_list(K.reshaped()), "--u", comma_list(u),
                                        "--mu", "0.5", "--e", "0.9", "--law", "all,chatterjee-ruina", "--et",
                                        "0", "--path", "path.csv", "--json", "out.json"});
  ASSERT_EQ(run.code, 0) << run.error;
  const Json result = Json::parse(folder.read("out.json"));
  const std::vector<std::vector<std::string>> rows = rows_of(folder.read("path.csv"));
  ASSERT_GT(rows.size(), 50u);
  EXPECT_EQ(rows[0], (Arguments{"law", "normal_impulse", "v_x", "v_y", "v_z", "impulse_x", "impulse_y",
                                "impulse_z", "work", "phase", "slip"}));
  std::string laws;
  for (std::size_t k = 1; k < rows.size(); ++k) {
    const std::vector<std::string>& row = rows[k];
    ASSERT_EQ(row.size(), 11u);
    const auto number = [&](std::size_t column) { return std::stod(row[column]); };
    const Vec3 v(number(2), number(3), number(4)), impulse(number(5), number(6), number(7));
    EXPECT_EQ(row[1], row[7]);
    EXPECT_LT((u + K * impulse - v).norm(), 1e-12);
    const bool is_first = rows[k - 1][0] != row[0];
    if (is_first) {
      laws += row[0] + " ";
      EXPECT_EQ(v, u);
    }
    const bool is_last = k + 1 == rows.size() || rows[k + 1][0] != row[0];
    if (is_last) {
      EXPECT_LT((vec(result["laws"][row[0]]["velocity"]) - v).norm(), 1e-12);
    }
    if (row[0] == "chatterjee-ruina") {
      EXPECT_EQ(row[9] + row[10], "");
      continue;
    }
    EXPECT_EQ(row[9], v.z() <= 1e-14 ? "compression" : "restitution");
    EXPECT_EQ(row[10], "slides");
    if (!is_first) {
      // Work is the integral of v_z, which is near to straight between two points.
      const double step = number(1) - std::stod(rows[k - 1][1]);
      const double mean = 0.5 * (number(4) + std::stod(rows[k - 1][4]));
      EXPECT_NEAR(number(8) - std::stod(rows[k - 1][8]), mean * step, 1e-3);
    }
  }
  EXPECT_EQ(laws, "newton poisson stronge chatterjee-ruina ");
}

TEST(ImpactCommand, TheFigureHasAPanelAndABarForEachLaw) {
  const ProgramFolder folder;
  const Arguments run = {
      "impact", "--K", "2.7,-0.33,1.65,5.43,2.04,3.88", "--u", "-3.32,-2.16,-5.32", "--mu", "0.5", "--e",
      "0.9",    "-o"};
  Arguments svg = run, png = run;
  svg.push_back("paths.svg");
  png.push_back("paths.png");
  const ProgramResult told = folder.run(svg);
  ASSERT_EQ(told.code, 0) << told.error;
  ASSERT_EQ(folder.run(png).code, 0);
  EXPECT_EQ(folder.read("paths.png").substr(1, 3), "PNG");
  const std::string text = folder.read("paths.svg");
  for (const char* law : {">Newton<", ">Poisson<", ">Stronge<"}) {
    const std::size_t panel = text.find(law);
    ASSERT_NE(panel, std::string::npos);
    EXPECT_NE(text.find(law, panel + 1), std::string::npos) << "no bar of " << law;
  }
  expect_contains(text, "v_x [m/s]");
  expect_contains(text, "Energy lost, of");
  // The same input gives the same bytes.
  ASSERT_EQ(folder.run(svg).code, 0);
  EXPECT_EQ(folder.read("paths.svg"), text);
}

TEST(ImpactCommand, EveryLawCanBeDrawnWhateverItsCourse) {
  const ProgramFolder folder;
  int number = 0;
  for (const Arguments& extra : {Arguments{"--u", "0,0,-1"}, Arguments{"--u", "1,0,-1"},
                                 Arguments{"--u", "1,2,1"}, Arguments{"--u", "1e-9,0,-1e9"}}) {
    const std::string name = "figure_" + std::to_string(++number) + ".svg";
    Arguments run = {"impact",
                     "--K",
                     ball_K,
                     "--mu",
                     "0.3",
                     "--e",
                     "0.5",
                     "--law",
                     "all,compliant,chatterjee-ruina",
                     "--stiffness-ratio",
                     "0.8",
                     "--et",
                     "0.5",
                     "-o",
                     name};
    run.insert(run.end(), extra.begin(), extra.end());
    const ProgramResult result = folder.run(run);
    EXPECT_EQ(result.code, 0) << result.error;
    EXPECT_EQ(folder.read(name).find("nan"), std::string::npos);
    expect_contains(folder.read(name), "Chatterjee-Ruina");
  }
}

// What it refuses

TEST(ImpactCommand, BadInputIsToldInOneLine) {
  const ProgramFolder folder;
  folder.write("boxes.yaml", boxes);
  struct Wrong {
    Arguments arguments;
    const char* message;
    int code = 2;
  };
  const Arguments u = {"--u", "1,0,-1"}, mu_e = {"--mu", "0.3", "--e", "0.5"};
  const auto with = [](Arguments a, const Arguments& b, const Arguments& c = {}) {
    a.insert(a.end(), b.begin(), b.end());
    a.insert(a.end(), c.begin(), c.end());
    return a;
  };
  const auto K = [&](const std::string& numbers) { return with({"--K", numbers}, u, mu_e); };
  const Arguments good = K(ball_K);
  const std::vector<Wrong> cases = {
      {{}, "give either --K and --u, or SCENE BODY_A BODY_B"},
      {{"--K", ball_K}, "give either --K and --u, or SCENE BODY_A BODY_B"},
      {with({"--K", ball_K}, u), "--K and --u need --mu and --e"},
      {K("1,2,3"), "--K: 3 numbers, must be 6 (K11,K12,K13,K22,K23,K33) or 9 (row by row)"},
      {K("1,0,x,1,0,1"), "--K '1,0,x,1,0,1': 'x' is not a number"},
      {K("1,0,,1,0,1"), "'' is not a number"},
      {K("1,0,nan,1,0,1"), "a value is nan, must be from -1e+30 to 1e+30"},
      {K("1,0,1e999,1,0,1"), "'1e999' is not a number"},
      {K("1,0,1e31,1,0,1"), "a value is 1e+31, must be from -1e+30 to 1e+30"},
      {K("1,0.1,0,0,1,0,0,0,1"), "--K: K must be symmetric: K[1][0] is 0, K[0][1] is 0.1"},
      {K("1,2,0,1,0,1"), "--K: K must be positive semidefinite; its smallest eigenvalue is -1"},
      {K("1,0,0,1,0,0"), "--K: K[2][2] is 0, must be > 0: the normal direction would be rigid"},
      {K("1e-40,0,0,1e-40,0,1e-40"), "must be at least 1e-30 1/kg"},
      {with({"--K", ball_K, "--u", "1,0"}, mu_e), "--u: 2 numbers, must be 3 (X,Y,Z)"},
      {with({"--K", ball_K, "--u", "1,0,inf"}, mu_e), "a value is inf, must be from -1e+30 to 1e+30"},
      {with({"--K", ball_K, "--mu", "-0.1", "--e", "0.5"}, u),
       "--mu is -0.1, must be from 0 to 1e+09, or inf"},
      {with({"--K", ball_K, "--mu", "nan", "--e", "0.5"}, u), "--mu is nan, must be from 0 to 1e+09, or inf"},
      {with({"--K", ball_K, "--mu", "rough", "--e", "0.5"}, u), "--mu: 'rough' is not a number or inf"},
      {with({"--K", ball_K, "--mu", "0.3", "--e", "1.1"}, u), "--e is 1.1, must be from 0 to 1"},
      {with({"--K", ball_K, "--mu", "0.3", "--e", "-0.1"}, u), "--e is -0.1, must be from 0 to 1"},
      {with({"--K", ball_K, "--mu", "0.3", "--e", "nan"}, u), "--e is nan, must be from 0 to 1"},
      {with(good, {"--law", "strong"}), "--law: unknown law 'strong'; did you mean 'stronge'?"},
      {with(good, {"--law", "newton,"}), "--law: unknown law ''"},
      {with(good, {"--law", "compliant"}), "--law compliant needs --stiffness-ratio"},
      {with(good, {"--law", "compliant", "--stiffness-ratio", "0"}),
       "--stiffness-ratio is 0, must be from 1e-06 to 1e+06"},
      {with(good, {"--stiffness-ratio", "1"}),
       "--stiffness-ratio belongs to --law compliant, which is not chosen"},
      {with(good, {"--law", "chatterjee-ruina"}), "--law chatterjee-ruina needs --et"},
      {with(good, {"--law", "chatterjee-ruina", "--et", "1.5"}), "--et is 1.5, must be from -1 to 1"},
      {with(good, {"--contact", "1"}), "--contact, --tolerance and --set need a scene"},
      {with(good, {"--contact", "0"}), "--contact"},
      {with(good, {"--path", "a.txt"}), "--path 'a.txt': its name must end in .csv"},
      {with(good, {"-o", "a.pdf"}), "output 'a.pdf': its name must end in .svg or .png"},
      {with(good, {"boxes.yaml", "floor", "flat"}), "a scene and --K or --u do not go together"},
      {{"boxes.yaml"}, "SCENE needs the names of two bodies"},
      {{"boxes.yaml", "floor", "flot"}, "the scene has no body 'flot'; did you mean"},
      {{"boxes.yaml", "flat", "flat"}, "BODY_A and BODY_B are the same body; give two"},
      {{"none.yaml", "floor", "flat"}, "none.yaml", 3},
      {with({"--K", "5,0,0,3.5,0,1", "--u", "1,1,-1", "--law", "compliant", "--stiffness-ratio", "1"}, mu_e),
       "the compliant law needs slip along a principal direction", 3},
      {with({"--K", "5,0,1,3.5,0,1", "--law", "compliant", "--stiffness-ratio", "1"}, u, mu_e),
       "the compliant law needs normal and tangential motion without coupling", 3},
      {with({"--K", "1e9,0,0,1e9,0,1", "--law", "compliant", "--stiffness-ratio", "1"}, u, mu_e),
       "at most 100 times as fast as the normal one; here the square root of M k_t/(K33 k_n) is 31622.8", 3},
      {with({"--K", "1,0,0,0,0,1", "--law", "chatterjee-ruina", "--et", "0"}, u, mu_e),
       "the law chatterjee-ruina needs K positive definite", 3},
      {with(good, {"--path", "no/folder/a.csv"}), "no/folder/a.csv", 5},
  };
  for (const Wrong& wrong : cases) {
    Arguments arguments = {"impact"};
    arguments.insert(arguments.end(), wrong.arguments.begin(), wrong.arguments.end());
    const ProgramResult result = folder.run(arguments);
    SCOPED_TRACE(testing::PrintToString(arguments));
    EXPECT_EQ(result.code, wrong.code);
    EXPECT_EQ(result.error.rfind("error: ", 0), 0u) << result.error;
    EXPECT_EQ(line_count(result.error), 1u) << result.error;
    expect_contains(result.error, wrong.message);
  }
}

}  // namespace
}  // namespace rigor::impact_command_test
