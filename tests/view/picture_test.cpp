#include "rigor/view/3d/picture.hpp"

#include "random_vectors.hpp"
#include "view/view_scenes.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace rigor::picture_test {
namespace {

bool is_same_pixel(const Image& a, int xa, const Image& b, int xb, int y) {
  return std::equal(a.pixel(xa, y), a.pixel(xa, y) + 3, b.pixel(xb, y));
}

TEST(PictureRenderer, TheLegendStandsWhereItCoversNoBody) {
  const std::string small_balls =
      "  - {name: a, mass: 1, shapes: [{type: sphere, radius: 0.3}]}\n"
      "  - {name: b, mass: 1, shapes: [{type: sphere, radius: 0.3}]}\n";
  Recording recording = made_up_recording(scene_of(small_balls), 1, 1);
  const CameraOptions wishes{Vec3(0, -10, 0), Vec3(0, 0, 0), {}};
  // At the left and the right edge, below the name and below the time, then in the lower left corner as well.
  for (const Vec3& second : {Vec3(4.4, 0, 2), Vec3(-4.4, 0, -2.2)}) {
    recording.motion.position = {-4.4, 0, 2, second.x(), second.y(), second.z()};
    PictureRenderer renderer(recording, wishes, {640, 360});
    const Image bare = renderer.draw(0), labelled = renderer.picture(0);
    constexpr int below_name = 30;
    int covered = 0, hidden = 0;
    for (int y = below_name; y < bare.height; ++y) {
      for (int x = 0; x < bare.width; ++x) {
        if (is_same_pixel(bare, x, labelled, x, y)) continue;
        ++covered;
        // Without a ground the background is the same along a row; its middle is free.
        if (!is_same_pixel(bare, x, bare, bare.width / 2, y)) ++hidden;
      }
    }
    EXPECT_GT(covered, 500) << "there is a legend";
    EXPECT_EQ(hidden, 0) << "pixels of bodies under it";
  }
}

/// Height of a ball of the radius about p_W in the picture [px]; 0 if its centre is outside.
double height_in_picture(const Camera& camera, const Vec3& p_W, double radius, const PictureSize& size) {
  const Projection projection(camera, size.width, size.height);
  const Vec3 p_K = projection.X_KW() * p_W;
  if (p_K.z() <= 0) return 0;
  const PicturePoint seen = projection.project(p_K);
  const bool is_inside = seen.x > 0 && seen.x < size.width && seen.y > 0 && seen.y < size.height;
  return is_inside ? 2 * projection.focal_length() * radius * seen.nearness : 0;
}

/// A small body that flies farther than one picture can show is on each picture of a sheet all the same.
TEST(PictureRenderer, MomentsOnASheetShowWhatHasFlownOff) {
  test::Random random(3);
  constexpr PictureSize size{466, 262};
  for (int k = 0; k < 40; ++k) {
    SCOPED_TRACE(k);
    const double radius = std::pow(10, random.uniform(-3, -1)),
                 far = radius * std::pow(10, random.uniform(0, 5));
    Recording recording = made_up_recording(
        scene_of(fmt::format("  - {{name: a, mass: 1, shapes: [{{type: sphere, radius: {}}}]}}\n", radius)),
        5, 1);
    std::vector<Vec3> places;
    for (int i = 0; i < 5; ++i) places.push_back(i * far * random.vector());
    recording.motion.position.clear();
    for (const Vec3& p : places)
      recording.motion.position.insert(recording.motion.position.end(), {p.x(), p.y(), p.z()});

    const PictureRenderer renderer(recording, {}, size);
    for (std::size_t i = 0; i < 5; ++i) {
      const double height = height_in_picture(renderer.camera_of_moment(i), places[i], radius, size);
      EXPECT_GE(height, 1) << "moment " << i;
      // What the common camera shows is taken with it, so that places can be compared.
      if (height_in_picture(renderer.camera(), places[i], radius, size) >= 1) {
        EXPECT_EQ(renderer.camera_of_moment(i).eye, renderer.camera().eye);
      }
    }
    // Where the user placed the camera it stays.
    const PictureRenderer placed(recording, {Vec3(0, -far, 0), Vec3::Zero(), {}}, size);
    for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(placed.camera_of_moment(i).eye, Vec3(0, -far, 0));
  }
}

}  // namespace
}  // namespace rigor::picture_test
