#include "rigor/io/scene/scene_reader.hpp"
#include "rigor/model/scene_queries.hpp"

#include "contracts/program.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

// The example of docs/queries.md compiles, does what it says, and is the one on the page.

namespace rigor::queries_docs_test {
namespace {

TEST(QueriesDocs, TheExampleInCxxIsThisOne) {
  const int robot = 1;
  const Vec3 gripper(0, 0, 2);
  const Shape tool = Box{Vec3(0.05, 0.05, 0.05)};
  const Pose X_WTool{Mat3::Identity(), Vec3(0, 0, 0.8)};
  Vec3 placed = Vec3::Zero();
  std::vector<double> distances;
  const auto place = [&](const Vec3& p_W, const Vec3&) { placed = p_W; };
  const auto report = [&](int, double distance) { distances.push_back(distance); };

  const Scene scene = read_scene(std::string(RIGOR_SOURCE_DIR) + "/scenes/bouncing_ball.yaml");
  const SceneQueries queries(*scene.model, make_initial_state(*scene.model));

  // Where does a ray from the gripper first meet something that is not the robot?
  const Ray ray{gripper, Vec3(0, 0, -1)};
  const std::optional<BodyRayHit> hit = queries.first_hit(ray, [&](int body) { return body != robot; });
  if (hit) place(hit->hit.p_W, hit->hit.n_W);

  // How far can the tool be pushed before it touches?
  const std::optional<BodyCastHit> stop = queries.cast({&tool, X_WTool, Vec3(0, 0, -0.5)});
  const double free_way = 0.5 * (stop ? stop->hit.fraction : 1);

  // Which three bodies are closest to it, and how close?
  for (const NearBody& near : queries.nearest(tool, X_WTool, 3)) report(near.on.body, near.distance);

  // The ball (taken for the robot here) is passed by, the floor is met; the floor is 0.75 m below the tool,
  // the ball 0.15 m above.
  ASSERT_TRUE(hit);
  EXPECT_EQ(placed, Vec3::Zero());
  EXPECT_EQ(free_way, 0.5);
  ASSERT_EQ(distances.size(), 2u);
  EXPECT_NEAR(distances[0], 0.15, 1e-15);
  EXPECT_NEAR(distances[1], 0.75, 1e-15);

  const std::string source_text =
      text_of(std::string(RIGOR_SOURCE_DIR) + "/tests/contracts/queries_docs_test.cpp");
  const std::string page = text_of(std::string(RIGOR_SOURCE_DIR) + "/docs/queries.md");
  const std::size_t begin = page.find("const SceneQueries queries"), end = page.find("```", begin);
  ASSERT_NE(begin, std::string::npos);
  std::istringstream lines(page.substr(begin, end - begin));
  for (std::string line; std::getline(lines, line);) {
    EXPECT_NE(source_text.find(line), std::string::npos) << line;
  }
}

}  // namespace
}  // namespace rigor::queries_docs_test
