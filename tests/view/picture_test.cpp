#include "rigor/view/3d/picture.hpp"

#include "view/view_scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace rigor::picture_test {
namespace {

bool is_same_pixel(const Image& a, int xa, const Image& b, int xb, int y) {
  return std::equal(a.pixel(xa, y), a.pixel(xa, y) + 3, b.pixel(xb, y));
}

TEST(Photographer, TheLegendStandsWhereItCoversNoBody) {
  const std::string small_balls =
      "  - {name: a, mass: 1, shapes: [{type: sphere, radius: 0.3}]}\n"
      "  - {name: b, mass: 1, shapes: [{type: sphere, radius: 0.3}]}\n";
  Recording recording = made_up_recording(scene_of(small_balls), 1, 1);
  const CameraWishes wishes{Vec3(0, -10, 0), Vec3(0, 0, 0), {}};
  // At the left and the right edge, below the name and below the time, then in the lower left corner as well.
  for (const Vec3& second : {Vec3(4.4, 0, 2), Vec3(-4.4, 0, -2.2)}) {
    recording.motion.position = {-4.4, 0, 2, second.x(), second.y(), second.z()};
    Photographer photographer(recording, wishes, {640, 360});
    const Image bare = photographer.draw(0), labelled = photographer.picture(0);
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

}  // namespace
}  // namespace rigor::picture_test
