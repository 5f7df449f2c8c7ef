#include "studies.hpp"

#include "rigor/core/input_error.hpp"
#include "rigor/io/scene/scene_reader.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace rigor::scene_study_test {
namespace {

const std::string scene = R"yaml(rigor: 1
run: {duration: 1, step: 0.01, output_interval: 0.5}
world: {gravity: [0, 0, -9.81]}
bodies:
  - {name: ball, position: [0, 0, 9], mass: 1, shapes: [{type: sphere, radius: 0.1}]}
)yaml";
const std::string questions = R"yaml(kind: sweep
parameters: [{name: v, key: "bodies.ball.velocity.2", values: [-1, 0, 2]}]
set: {bodies.ball.velocity: [0, 0, 0]}
outcomes: [{name: height, value: body.ball.position.z}]
)yaml";

/// The lines, two columns further in.
std::string indented(const std::string& lines) {
  std::string result = "  ";
  for (const char c : lines) result += c == '\n' ? std::string("\n  ") : std::string(1, c);
  return result.substr(0, result.size() - 2);
}

std::filesystem::path written(const std::string& name, const std::string& text) {
  const std::filesystem::path path = std::filesystem::path(testing::TempDir()) / name;
  std::ofstream(path) << text;
  return path;
}

std::string rows_of(const std::filesystem::path& path) {
  Study study(read_study(path));
  const std::unique_ptr<WorkerPool> pool = make_thread_pool([&] { return study.make_executor(); }, 1);
  EXPECT_TRUE(study.run(*pool, {}));
  EXPECT_EQ(study.run_count(), 3u);
  return study_csv(study);
}

std::string refusal_of(const std::string& text) {
  try {
    const Study study(read_study(written("rigor_refused_study.yaml", text)));
    return "";
  } catch (const InputError& error) {
    return std::string(error.messages().front());
  }
}

TEST(StudyInScene, GivesTheRowsOfTheSameStudyInAFileOfItsOwn) {
  written("rigor_scene.yaml", scene);
  const std::filesystem::path apart =
      written("rigor_apart.yaml", "rigor_study: 1\nscene: rigor_scene.yaml\n" + questions);
  const std::filesystem::path within = written("rigor_within.yaml", scene + "study:\n" + indented(questions));
  EXPECT_EQ(rows_of(within), rows_of(apart));
  // z = 9 + v t - g t^2 / 2, at 1 s.
  Study study(read_study(within));
  const std::unique_ptr<WorkerPool> pool = make_thread_pool([&] { return study.make_executor(); }, 1);
  ASSERT_TRUE(study.run(*pool, {}));
  EXPECT_NEAR(study.rows().value(2, 0), 9 + 2 - 0.5 * 9.81, 1e-12);
  EXPECT_TRUE(is_scene_with_study(within));
  EXPECT_FALSE(is_scene_with_study(apart));
  EXPECT_EQ(read_scene(within).model->body_count(), 1);
}

TEST(StudyInScene, ItsMistakesAreToldWithTheLinesOfTheScene) {
  EXPECT_NE(refusal_of(scene).find("rigor_refused_study.yaml:1:1: the scene has no 'study'"),
            std::string::npos);
  EXPECT_NE(refusal_of(scene + "study:\n" + indented("kind: sweap" + questions.substr(11)))
                .find("rigor_refused_study.yaml:7:9: the study: unknown kind 'sweap'"),
            std::string::npos);
  EXPECT_NE(refusal_of(scene + "study:\n  scene: a.yaml\n" + indented(questions)).find("unknown key 'scene'"),
            std::string::npos);
  EXPECT_THROW(parse_scene(scene + "study: 5\n", "s.yaml", "."), InputError);
  EXPECT_NE(refusal_of(scene + "study: 5\n").find("must be a mapping"), std::string::npos);
}

}  // namespace
}  // namespace rigor::scene_study_test
