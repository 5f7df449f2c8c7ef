#include "studies.hpp"

#include "rigor/core/input_error.hpp"
#include "rigor/io/files/file_error.hpp"
#include "rigor/io/files/flow_text.hpp"
#include "rigor/io/scene/scene_reader.hpp"
#include "rigor/math/rotation.hpp"
#include "rigor/sim/simulation.hpp"
#include "rigor/study/answer/run_page.hpp"
#include "rigor/study/answer/study_drawing.hpp"
#include "rigor/study/answer/study_page.hpp"
#include "rigor/study/answer/study_plot.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <filesystem>
#include <random>
#include <string>

// What is made of the runs of a study: files, figures, pages, and runs once more.
namespace rigor::answers_test {
namespace {

using studies::finished;

const std::string slides = R"yaml(rigor_study: 1
name: slides
scene: ../ramp_slide.yaml
kind: sweep
repeats: 2
vary_seed: true
set:
  run: {duration: 2, step: 0.01, output_interval: 0.5}
  world.gravity: [0, 0, -9.81]
  expect: []
parameters:
  - {name: mu, key: materials.wood.friction, values: [0.3, -1, 0.7]}
  - {name: v, range: [0.5, 3]}
assign:
  bodies.block.velocity: [v, 0, 0]
outcomes:
  - {name: distance, value: body.block.position.x}
)yaml";

std::string temporary(const std::string& name) {
  const std::string path = testing::TempDir() + "rigor_" + name;
  std::filesystem::remove_all(path);
  return path;
}

// Each run, with what it puts into the scene as texts of --set, gives the same bits as in the study.
TEST(Answers, ARunOnceMoreHasTheSameBits) {
  const auto study = finished(slides);
  for (std::uint64_t run = 0; run < study->run_count(); ++run) {
    if (study->rows().status(run) != RunStatus::done) continue;
    const Scene scene = read_scene(study->plan().scene, study->overrides_of(study->task_of(run, {})));
    const RunResult result =
        run_simulation(scene.model, scene.method, scene.run, std::nullopt,
                       [](const State&, const AdvanceReport&, const Auditor&) { return true; });
    const int block = scene.model->find_body("block").value();
    const Pose user = Pose{rotation_matrix(result.state.orientation(block)), result.state.position(block)} *
                      scene.model->body(block).X_BU;
    EXPECT_EQ(user.p.x(), study->rows().value(run, 0)) << run;
  }
  EXPECT_THROW(finished(slides)->task_of(6, {}), InputError);
}

std::string random_text(std::mt19937& engine) {
  constexpr std::string_view letters = "ab 1.5-e+:,[]{}#&*!|>'\"%@`\\\n\ttrue~";
  std::string text;
  for (unsigned length = engine() % 8; length > 0; --length) text += letters[engine() % letters.size()];
  return text;
}

YamlNode::Pointer random_tree(std::mt19937& engine, int depth) {
  const auto node = std::make_shared<YamlNode>();
  const unsigned kind = depth > 0 ? engine() % 4 : engine() % 2;
  if (kind < 2) {
    node->kind = YamlNode::Kind::scalar;
    node->is_quoted = kind == 0;
    node->text = node->is_quoted ? random_text(engine)
                                 : fmt::format("{:.17g}", static_cast<double>(engine()) / 4294967296.0 - 0.5);
    return node;
  }
  node->kind = kind == 2 ? YamlNode::Kind::list : YamlNode::Kind::map;
  for (unsigned count = engine() % 4; count > 0; --count)
    node->entries.push_back(
        {kind == 3 ? random_text(engine) + std::to_string(count) : "", 0, 0, random_tree(engine, depth - 1)});
  return node;
}

void expect_same(const YamlNode& a, const YamlNode& b) {
  ASSERT_EQ(a.kind, b.kind);
  EXPECT_EQ(a.text, b.text);
  EXPECT_EQ(a.is_quoted, b.is_quoted);
  ASSERT_EQ(a.entries.size(), b.entries.size());
  for (std::size_t i = 0; i < a.entries.size(); ++i) {
    EXPECT_EQ(a.entries[i].key, b.entries[i].key);
    expect_same(*a.entries[i].value, *b.entries[i].value);
  }
}

TEST(Answers, AValueOnOneLineIsReadAsTheSame) {
  std::mt19937 engine(1);
  for (int i = 0; i < 500; ++i) {
    const YamlNode::Pointer tree = random_tree(engine, 3);
    const std::string text = flow_text(*tree);
    EXPECT_EQ(text.find('\n'), std::string::npos) << text;
    SCOPED_TRACE(text);
    expect_same(*tree, *parse_yaml(text, 0, YamlSources{{"line"}}, false));
  }
}

TEST(Answers, Hdf5HasTheRunsThatCountAndPlotsThem) {
  const auto study = finished(slides);
  const std::string path = temporary("runs.h5");
  write_study(*study, path);
  EXPECT_TRUE(is_study_file(path));
  EXPECT_FALSE(is_study_file(std::string(RIGOR_SOURCE_DIR) + "/README.md"));
  const StudyColumns columns = read_study_columns(path);
  EXPECT_EQ(columns.names, (std::vector<std::string>{"mu", "v", "distance"}));
  EXPECT_EQ(columns.runs, (std::vector<std::uint64_t>{0, 1, 4, 5}));
  for (std::size_t i = 0; i < columns.runs.size(); ++i) {
    EXPECT_EQ(columns.values[1][i], study->parameters_of(columns.runs[i])[1]);
    EXPECT_EQ(columns.values[2][i], study->rows().value(columns.runs[i], 0));
  }
  for (const char* const key : {"distance", "distance:v", "distance:mu", "matrix", "parallel"})
    EXPECT_GT(study_plot(columns, {key}).strokes.size(), 4u) << key;
  EXPECT_GT(study_plot(columns, {}).height, 500);
  EXPECT_THROW(study_plot(columns, {"distance:nu"}), InputError);
}

TEST(Answers, SeedsOfRunsAreInTheTable) {
  const auto study = finished(slides);
  const std::string csv = study_csv(*study);
  EXPECT_NE(csv.find("run,status,run.seed,mu,v,distance,reason\n"), std::string::npos);
  EXPECT_NE(csv.find(fmt::format("0,done,{},", run_seed(study->plan(), 0))), std::string::npos);
  EXPECT_NE(run_seed(study->plan(), 0), run_seed(study->plan(), 1));
  const std::string path = temporary("runs.csv");
  write_study(*study, path);
  EXPECT_EQ(std::filesystem::file_size(path), csv.size());
}

TEST(Answers, ParallelCoordinatesHaveALineARunAndBreakAtWhatIsUnknown) {
  const auto lines = [](double last) {
    return parallel_drawing({"a", "b", "c"}, {{1, 2, 3}, {2, 2, last}, {0, 1, 5}}, 2).strokes.size();
  };
  EXPECT_EQ(lines(1), 3u + 3u);
  // The third run has no two known values side by side.
  EXPECT_EQ(lines(std::nan("")), 2u + 3u);
}

/// The data of a page for its script.
nlohmann::json data_of(const std::string& page) {
  const std::string begin = "id=\"study-data\">";
  const std::size_t from = page.find(begin) + begin.size();
  return nlohmann::json::parse(page.substr(from, page.find("</script>", from) - from));
}

TEST(Answers, ThePageHasTheRunsForItsScript) {
  std::string text = slides;
  text.replace(text.find("name: slides"), 12, "name: \"</script><b>\"");
  const auto study = finished(text);
  const std::string page = study_page(*study, {"kept_runs", {}, {}});
  const nlohmann::json data = data_of(page);
  EXPECT_EQ(data["name"], "</script><b>");
  EXPECT_EQ(page.find("<b>"), std::string::npos);
  EXPECT_EQ(data["total"], 6);
  EXPECT_EQ(data["kept"], "kept_runs");
  EXPECT_EQ(data["main"], "distance");
  EXPECT_EQ(data["statuses"][data["status"][2].get<std::size_t>()], "refused");
  EXPECT_TRUE(data["reasons"].contains("2"));
  ASSERT_EQ(data["columns"].size(), 3u);
  EXPECT_EQ(data["columns"][1]["values"][4], study->parameters_of(4)[1]);
  EXPECT_TRUE(data["columns"][2]["values"][2].is_null());
  EXPECT_NE(page.find(std::string(study_script().substr(0, 60))), std::string::npos);
  const std::string served = study_page(*study, {{}, "script-src 'self'", "/study.js"});
  EXPECT_NE(served.find("<script src=\"/study.js\">"), std::string::npos);
  EXPECT_TRUE(data_of(served)["kept"].is_null());
}

TEST(Answers, RunsAreReplayedOnPagesOfTheirOwn) {
  const auto study = finished(slides);
  const std::string page = run_page(*study, study->known_task(1), {{}, "/viewer.js"}, {});
  EXPECT_NE(page.find("<title>slides, run 1"), std::string::npos);
  EXPECT_NE(page.find("data-kind=\"frames\""), std::string::npos);
  EXPECT_EQ(page.find("data-run=\"1\""), std::string::npos);
  const std::string folder = temporary("kept");
  EXPECT_TRUE(keep_run_pages(*study, folder, 2, {}));
  int pages = 0;
  for (const auto& file : std::filesystem::directory_iterator(folder))
    pages += file.file_size() > 100000 ? 1 : 0;
  // Two of six are refused.
  EXPECT_EQ(pages, 4);
  EXPECT_FALSE(std::filesystem::exists(folder + "/run_2.html"));
}

TEST(Answers, OfChaosBothNeighboursAreReplayed) {
  std::string text = slides;
  text.replace(text.find("kind: sweep\nrepeats: 2"), 22, "kind: chaos\nruns: 1\nperturb: v");
  text.replace(text.find("[0.3, -1, 0.7]"), 14, "[0.5]");
  const auto study = finished(text);
  const std::string page = run_page(*study, study->known_task(0), {{}, "/viewer.js"}, {});
  EXPECT_NE(page.find("data-run=\"0\""), std::string::npos);
  EXPECT_NE(page.find("data-run=\"1\""), std::string::npos);
}

/// A study of 1e8 runs of 3,000 numbers: 2.4 TB.
std::string huge() {
  std::string text =
      "rigor_study: 1\nkind: monte-carlo\nruns: 100000000\nparameters: [{name: x, range: [0, "
      "1]}]\noutcomes:\n";
  for (int i = 0; i < 3000; ++i) text += fmt::format("  - {{name: y{}, formula: x}}\n", i);
  return text;
}

TEST(Answers, WhatHasNoRoomIsToldBeforeAnythingRuns) {
  Study study(parse_study(huge(), testing::TempDir() + "huge.yaml"));
  EXPECT_THROW(study.estimate_cost({}), FileError);
  EXPECT_EQ(study.rows().count(), 0u);
  const std::string journal = temporary("huge.journal");
  EXPECT_THROW(study.estimate_cost(journal), FileError);
  EXPECT_FALSE(std::filesystem::exists(journal));
  EXPECT_GT(study_file_bytes(study.plan(), study.most_runs(), "runs.csv"), 1e12);
  EXPECT_GT(study_file_bytes(study.plan(), study.most_runs(), "runs.h5"), 1e12);
}

TEST(Answers, NumbersOfRunsBeyondTheLimitAreRefusedForEveryKind) {
  const auto refused = [](const std::string& more, const std::string& parameters) {
    const std::string text =
        "rigor_study: 1\n" + more + "parameters: [" + parameters + "]\noutcomes: [{name: y, formula: a}]\n";
    try {
      const Study study(parse_study(text, "many.yaml"));
      return std::string("accepted");
    } catch (const InputError& error) {
      return error.messages().front();
    }
  };
  const std::string list = "{name: a, range: [0, 1], count: 100000000}",
                    interval = "{name: a, range: [0, 1]}";
  EXPECT_NE(refused("kind: monte-carlo\nruns: 1000000000000\n", interval).find("must be from 1 to 1e+08"),
            std::string::npos);
  EXPECT_EQ(refused("kind: sweep\n", list), "accepted");
  for (const std::string& text :
       {refused("kind: sweep\nrepeats: 10000\n", list),
        refused("kind: sweep\n", list + ", {name: b, range: [0, 1], count: 10000}"),
        refused("kind: bisection\nsearch: b\ncondition: y > 0\n", list + ", {name: b, range: [0, 1]}"),
        refused("kind: minimise\nruns: 100000000\nrepeats: 100000000\nstarts: 10000\n", interval),
        refused("kind: sensitivity\nruns: 100000000\n", interval),
        refused("kind: morris\nruns: 100000000\n", interval)})
    EXPECT_NE(text.find("runs, must be at most 1e+08"), std::string::npos) << text;
}

// A list of a range and a count is not kept: each value is made when it is asked for.
TEST(Answers, EvenListsAreMadeOnDemand) {
  const StudyPlan plan = parse_study(
      "rigor_study: 1\nkind: sweep\nparameters: [{name: a, range: [2, 8], count: 100000000}, {name: b, "
      "range: [1, 1e6], "
      "count: 7, log: true}]\noutcomes: [{name: y, formula: a}]\n",
      "even.yaml");
  EXPECT_TRUE(plan.parameters[0].values.empty());
  EXPECT_EQ(plan.parameters[0].value_at(0), 2);
  EXPECT_EQ(plan.parameters[0].value_at(99999999), 8);
  EXPECT_DOUBLE_EQ(plan.parameters[0].value_at(50000000), 2 + 6.0 * 50000000 / 99999999);
  EXPECT_NEAR(plan.parameters[1].value_at(4), 1e4, 1e-10);
  EXPECT_EQ(plan.parameters[1].value_at(6), 1e6);
}

// A ball that falls from h meets the floor with √(2 g h), and leaves it with e times that; its n-th impact
// comes after a fall and n - 1 flights. Outputs are far apart: values at events do not come from them.
TEST(Outcomes, AreTakenJustAfterEvents) {
  std::mt19937 engine(3);
  const auto between = [&](double low, double high) {
    return low + (high - low) * (static_cast<double>(engine()) / 4294967296.0);
  };
  for (int ball = 0; ball < 20; ++ball) {
    const double h = between(0.2, 2), e = between(0.5, 1), x = between(-2, 2);
    const int n = 1 + static_cast<int>(engine() % 3);
    const auto study = finished(fmt::format(
        "rigor_study: 1\nscene: ../bouncing_ball.yaml\nkind: sweep\n"
        "set: {{run: {{duration: 6, step: 0.5, output_interval: 6}}, expect: [], method.scheme: "
        "event-driven}}\n"
        "parameters:\n  - {{name: e, key: materials.rubber.restitution, values: [{:.17g}]}}\n"
        "  - {{name: x, key: bodies.ball.velocity.0, values: [{:.17g}]}}\n"
        "assign: {{bodies.ball.position: [0, 0, {:.17g}]}}\noutcomes:\n"
        "  - {{name: v, value: body.ball.velocity.z, event: impact, number: {}, bodies: [ball, floor]}}\n"
        "  - {{name: p, value: body.ball.position.x, event: impact, number: {}}}\n"
        "  - {{name: k, value: energy.kinetic, event: impact, number: {}}}\n"
        "  - {{name: never, value: energy.kinetic, event: impact, number: 100000, else: -1}}\n",
        e, x, 0.1 + h, n, n, n));
    const double g = 9.81, v = std::sqrt(2 * g * h) * std::pow(e, n);
    double t = std::sqrt(2 * h / g), fall = t;
    for (int i = 1; i < n; ++i) t += 2 * fall * std::pow(e, i);
    // Some roundings of quantities of order 1 to 10 in each flight.
    EXPECT_NEAR(study->rows().value(0, 0), v, 1e-12 * std::sqrt(2 * g * h));
    EXPECT_NEAR(study->rows().value(0, 1), x * t, 1e-12);
    EXPECT_NEAR(study->rows().value(0, 2), 0.5 * (v * v + x * x), 1e-11);
    EXPECT_EQ(study->rows().value(0, 3), -1);
  }
}

}  // namespace
}  // namespace rigor::answers_test
