#include "rigor/view/3d/sight_lines.hpp"

#include "random_vectors.hpp"
#include "rigor/view/3d/picture.hpp"
#include "view/view_scenes.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace rigor::sight_lines_test {
namespace {

std::string text_of(const Vec3& v) {
  return fmt::format("[{}, {}, {}]", v.x(), v.y(), v.z());
}

std::string ball_text(double radius) {
  return fmt::format("  - {{name: ball, mass: 1, shapes: [{{type: sphere, radius: {}, color: \"#f00\"}}]}}\n",
                     radius);
}

/// An upright wall, square to the level part of a direction.
std::string wall_text(const Vec3& middle, const Vec3& along, double side) {
  return fmt::format(
      "  - {{name: wall, motion: static, position: {}, rpy: [0, 0, {}], shapes: [{{type: box, size: [{}, {}, "
      "{}], color: "
      "\"#00f\"}}]}}\n",
      text_of(middle), std::atan2(along.y(), along.x()), 0.02 * side, side, side);
}

/// Whether the segment meets the upright wall: the same question answered by its plane, in the wall's own
/// axes.
bool crosses(const Vec3& from, const Vec3& to, const Vec3& middle, const Vec3& along, double side) {
  const Vec3 x = Vec3(along.x(), along.y(), 0).normalized(), y = Vec3::UnitZ().cross(x);
  const Vec3 a = from - middle, b = to - middle;
  if (a.dot(x) * b.dot(x) > 0) return false;
  const Vec3 p = a + a.dot(x) / (a.dot(x) - b.dot(x)) * (b - a);
  return std::abs(p.dot(y)) < 0.5 * side && std::abs(p.z()) < 0.5 * side;
}

TEST(SightLines, TheHiddenPartIsThatOfBallsBehindAWall) {
  test::Random random(11);
  for (int k = 0; k < 30; ++k) {
    SCOPED_TRACE(k);
    const Vec3 middle = 0.3 * random.vector(), along = Vec3(1, random.number(), 0),
               eye(-5, random.number(), random.number());
    const double side = random.uniform(0.5, 3);
    const Scene scene = scene_of(ball_text(0.01) + wall_text(middle, along, side));
    const DrawnScene drawn = make_drawn_scene(*scene.model);
    // The ball at twenty moments, the wall at its place.
    const Pose wall = start_poses(*scene.model)[1];
    std::vector<Pose> poses;
    int hidden = 0;
    for (int i = 0; i < 20; ++i) {
      const Vec3 p = Vec3(3, 0, 0) + 2 * random.vector();
      poses.push_back({Mat3::Identity(), p});
      poses.push_back(wall);
      hidden += crosses(eye, p, middle, along, side) ? 1 : 0;
    }
    const SightLines lines(drawn, poses);
    // A line just at the wall's edge may go either way: the wall has a thickness, and the ball a size.
    EXPECT_NEAR(lines.hidden_part(eye), hidden / 20.0, 0.051);
    EXPECT_EQ(lines.hiding(eye).size(), lines.hidden_part(eye) > 0 ? 1u : 0u);
  }
}

/// The motion of one ball through these places, its radius 0.1 m, beside what else stands there.
Recording flight(const std::string& standing, const std::vector<Vec3>& places) {
  const Scene scene = scene_of(ball_text(0.1) + standing);
  Recording recording = made_up_recording(scene, static_cast<int>(places.size()), 1.0 / 30);
  const std::size_t n = static_cast<std::size_t>(scene.model->body_count());
  const std::vector<Pose> start = start_poses(*scene.model);
  for (std::size_t k = 0; k < places.size(); ++k) {
    for (std::size_t i = 0; i < n; ++i) {
      const Vec3& p = i == 0 ? places[k] : start[i].p;
      const Quat q(start[i].R);
      for (std::size_t c = 0; c < 3; ++c)
        recording.motion.position[3 * (k * n + i) + c] = p[static_cast<Eigen::Index>(c)];
      const double own[4] = {q.w(), q.x(), q.y(), q.z()};
      for (std::size_t c = 0; c < 4; ++c) recording.motion.orientation[4 * (k * n + i) + c] = own[c];
    }
  }
  return recording;
}

TEST(PictureRenderer, NeverLooksFromBehindAWallThatItCanGoRound) {
  test::Random random(5);
  for (int k = 0; k < 30; ++k) {
    SCOPED_TRACE(k);
    const Vec3 velocity = Vec3(random.number(), random.number(), 0.2 * random.number()).normalized();
    std::vector<Vec3> places;
    for (int i = 0; i < 12; ++i) places.push_back(0.1 * i * velocity);
    const Vec3 middle = 0.5 * (places.front() + places.back());
    const Recording free = flight("", places);
    const Vec3 eye = PictureRenderer(free, {}, {320, 180}).camera().eye;
    // A wall in the way of that camera, large enough to hide the flight from there.
    const Vec3 along = (middle - eye).normalized(), at_wall = middle - 0.9 * along;
    const Recording walled = flight(wall_text(at_wall, along, 2.4), places);
    const Camera camera = PictureRenderer(walled, {}, {320, 180}).camera();
    for (const Vec3& p : places) {
      EXPECT_TRUE(crosses(eye, p, at_wall, along, 2.4));
      EXPECT_FALSE(crosses(camera.eye, p, at_wall, along, 2.4));
    }
  }
}

TEST(PictureRenderer, AWallBetweenTheUsersEyeAndABallIsGlass) {
  const CameraOptions wishes{Vec3(-4, 0, 0), Vec3(0, 0, 0), {}, {}};
  const PictureSize size{160, 90};
  const auto middle = [&](const std::string& standing, const Vec3& place) {
    const Recording recording = flight(standing, {place});
    const Image image = PictureRenderer(recording, wishes, size).draw(0);
    return std::array<int, 3>{image.pixel(80, 45)[0], image.pixel(80, 45)[1], image.pixel(80, 45)[2]};
  };
  const std::string wall = wall_text(Vec3(-1, 0, 0), Vec3::UnitX(), 1);
  const auto through = middle(wall, Vec3(0, 0, 0)), before = middle(wall, Vec3(-2, 0, 0)),
             beside = middle(wall, Vec3(0, 1.2, 0));
  // Red shows through blue glass; a ball in front of the wall, or one that it does not hide, leaves it as it
  // is.
  EXPECT_GT(through[0], 2 * through[1]);
  EXPECT_GT(through[0], 100);
  EXPECT_GT(before[0], 100);
  EXPECT_LT(beside[0], 30);
  EXPECT_GT(beside[2], 60);
}

/// A film follows what flies off: it is seen in each picture, and no camera jumps.
TEST(PictureRenderer, AFilmFollowsABallThatFliesOff) {
  constexpr PictureSize size{320, 180};
  test::Random random(8);
  for (int k = 0; k < 10; ++k) {
    SCOPED_TRACE(k);
    const double speed = std::pow(10, random.uniform(0, 3));
    const Vec3 way = random.vector().normalized();
    std::vector<Vec3> places;
    std::vector<std::size_t> frames;
    for (std::size_t i = 0; i < 120; ++i) {
      places.push_back(static_cast<double>(i) / 30 * speed * way);
      frames.push_back(i);
    }
    const Recording recording = flight("", places);
    const PictureRenderer renderer(recording, {}, size);
    const std::vector<Camera> cameras = renderer.cameras_of_film(frames);
    ASSERT_EQ(cameras.size(), frames.size());
    int seen = 0;
    for (std::size_t i = 0; i < cameras.size(); ++i) {
      const Projection projection(cameras[i], size.width, size.height);
      const Vec3 p_K = projection.X_KW() * places[i];
      const PicturePoint at = projection.project(p_K);
      const bool is_inside = p_K.z() > 0 && at.x > 0 && at.x < size.width && at.y > 0 && at.y < size.height;
      seen += is_inside && 2 * projection.focal_length() * 0.1 * at.nearness >= 1 ? 1 : 0;
    }
    // A pan goes evenly, by equal factors of the distance a picture, and begins and ends gently: with at
    // most 1.5 times that speed.
    const auto distance = [](const Camera& camera) { return (camera.eye - camera.target).norm(); };
    double nearest = distance(renderer.camera()), farthest = nearest;
    for (const Camera& camera : cameras)
      nearest = std::min(nearest, distance(camera)), farthest = std::max(farthest, distance(camera));
    const double fastest = 1.5 / 31 * std::log(farthest / nearest) + 1e-9;
    for (std::size_t i = 1; i < cameras.size(); ++i)
      EXPECT_LE(std::abs(std::log(distance(cameras[i]) / distance(cameras[i - 1]))), fastest)
          << "picture " << i;
    EXPECT_GE(seen, 112) << "of 120; during a pan it may be beside the picture";
  }
}

}  // namespace
}  // namespace rigor::sight_lines_test
