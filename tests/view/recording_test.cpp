#include "rigor/view/recording/recording.hpp"

#include "io/trajectory_samples.hpp"
#include "rigor/core/input_error.hpp"
#include "rigor/io/trajectory/hdf5_writer.hpp"
#include "rigor/view/3d/key_moments.hpp"
#include "rigor/view/3d/picture.hpp"
#include "view/view_scenes.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rigor::recording_test {
namespace {

/// A row whose orientations are some.
TrajectorySample possible_row(int k, std::size_t body_count, std::size_t joint_count = 0) {
  TrajectorySample sample = sample_row(k, body_count, joint_count);
  for (std::size_t i = 0; i < body_count; ++i)
    Vec4::Map(&sample.orientation[4 * i]) = Vec4(0.5, 0.5, -0.5, 0.5);
  return sample;
}

TEST(Recording, IsReadFromATrajectoryWithItsSceneAndOverrides) {
  const TemporaryFolder folder;
  TrajectoryHeader header = sample_header({"a", "b.c"});
  header.scene_text = "rigor: 1\nname: two\nbodies:\n" + two_balls;
  header.scene_file = "/no/such/folder/two.yaml";
  header.overrides = {"bodies.a.mass=7", "name=renamed"};
  Hdf5Writer writer(folder / "a.h5", header);
  for (int k = 0; k < 5; ++k) writer.write(possible_row(k, 2), {});
  writer.close({});
  const Recording recording = read_recording(folder / "a.h5");
  EXPECT_EQ(recording.name, "renamed");
  EXPECT_EQ(recording.model->body(0).mass, 7);
  EXPECT_EQ(recording.frame_count(), 5u);
  EXPECT_EQ(recording.motion.penetration.size(), 5u);
}

TEST(Recording, AMotionOfOtherBodiesOrWithoutTimesIsRefused) {
  const TemporaryFolder folder;
  TrajectoryHeader header = sample_header({"a", "other"});
  header.scene_text = "rigor: 1\nbodies:\n" + two_balls;
  {
    Hdf5Writer writer(folder / "other.h5", header);
    writer.write(possible_row(0, 2), {});
    writer.close({});
  }
  EXPECT_THROW(read_recording(folder / "other.h5"), InputError);
  header.bodies = {"a", "b.c"};
  Hdf5Writer(folder / "empty.h5", header).close({});
  EXPECT_THROW(read_recording(folder / "empty.h5"), InputError);
}

TEST(Recording, NumbersThatNoRunWritesAreRefused) {
  const TemporaryFolder folder;
  TrajectoryHeader header = sample_header({"a", "b.c"});
  header.scene_text = "rigor: 1\nbodies:\n" + two_balls;
  const auto refusal = [&](const auto& change) {
    TrajectorySample sample = possible_row(1, 2);
    MotionEvent event{MotionEvent::Kind::impact, 0.1, 0, 1};
    change(sample, event);
    Hdf5Writer writer(folder / "a.h5", header);
    writer.write(possible_row(0, 2), {});
    writer.write(sample, {&event, 1});
    writer.close({});
    try {
      read_recording(folder / "a.h5");
    } catch (const InputError& error) {
      const std::string text = error.what();
      return text.substr(text.find("a.h5': ") + 7);
    }
    return std::string();
  };
  EXPECT_EQ(refusal([](TrajectorySample&, MotionEvent&) {}), "");
  EXPECT_EQ(refusal([](TrajectorySample& s, MotionEvent&) { s.position[0] = std::nan(""); }),
            "a position in row 1 is nan");
  EXPECT_EQ(refusal([](TrajectorySample& s, MotionEvent&) { s.time = -1; }),
            "the time goes back after row 0");
  EXPECT_EQ(refusal([](TrajectorySample&, MotionEvent& e) { e.body_B = 2; }), "an event names body 2 of 2");
}

TEST(Recording, JointsAreThoseOfTheSceneOrNone) {
  const TemporaryFolder folder;
  TrajectoryHeader header = sample_header({"a", "b.c"});
  header.scene_text = "rigor: 1\nbodies:\n" + two_balls +
                      "joints:\n  - {name: pin, type: cylindrical, bodies: [a, b.c], anchor: [0, 0, 0], "
                      "axis: [1, 0, 0]}\n";
  header.has_joint_forces = true;
  const auto recording_with = [&](const std::vector<TrajectoryJoint>& joints, std::size_t count) {
    header.joints = joints;
    Hdf5Writer writer(folder / "a.h5", header);
    writer.write(possible_row(1, 2, count), {});
    writer.close({});
    return read_recording(folder / "a.h5");
  };
  EXPECT_EQ(recording_with({{"pin", {"m", "rad"}}}, 1).motion.joint_rate, sample_row(1, 2, 1).joint_rate);
  EXPECT_THROW(recording_with({{"other", {"m", "rad"}}}, 1), InputError);
  EXPECT_THROW(recording_with({{"pin", {"m", "rad", "rad", "rad"}}}, 2), InputError);
  // A file of Rigor 0.1.0.
  header.has_joint_forces = false;
  EXPECT_TRUE(recording_with({}, 0).motion.joints.empty());
}

TEST(Recording, TheNearestOutputTimeIsFound) {
  const Recording recording = made_up_recording(scene_of(two_balls), 11, 0.5);
  EXPECT_EQ(nearest_frame(recording, -3), 0u);
  EXPECT_EQ(nearest_frame(recording, 1.24), 2u);
  EXPECT_EQ(nearest_frame(recording, 1.26), 3u);
  EXPECT_EQ(nearest_frame(recording, 99), 10u);
  EXPECT_EQ(poses_at(recording, 3)[1].p, Vec3(1, 0, 3));
}

TEST(MotionRecorder, KeepsTheFirstAndTheLastTimeAndEvenStepsWithinItsMemory) {
  const Scene scene = scene_of(two_balls);
  const std::size_t most = 100 * 31 * sizeof(double);
  for (const int count : {1, 2, 50, 100, 101, 1000, 1001, 4096, 5000}) {
    MotionRecorder keeper(scene, most);
    for (int k = 0; k < count; ++k) {
      TrajectorySample sample = sample_row(k, 2);
      sample.time = k;
      const MotionEvent event = sample_event(k);
      keeper.write(sample, {&event, 1});
    }
    const StoredTrajectory& motion = keeper.recording().motion;
    ASSERT_FALSE(motion.time.empty());
    EXPECT_LE(motion.time.size(), 102u);
    EXPECT_EQ(motion.time.front(), 0);
    EXPECT_EQ(motion.time.back(), count - 1);
    EXPECT_EQ(motion.event_time.size(), static_cast<std::size_t>(count));
    ASSERT_EQ(motion.position.size(), 6 * motion.time.size());
    for (std::size_t i = 0; i < motion.time.size(); ++i) {
      if (i + 1 < motion.time.size()) {
        EXPECT_EQ(motion.time[i], motion.time[std::min<std::size_t>(1, i)] * static_cast<double>(i));
      }
      // Rows belong together.
      EXPECT_EQ(motion.position[6 * i], sample_row(static_cast<int>(motion.time[i]), 2).position[0]);
      EXPECT_EQ(motion.orientation[8 * i], sample_row(static_cast<int>(motion.time[i]), 2).orientation[0]);
    }
  }
}

// Key moments

std::vector<std::size_t> frames_of(const std::vector<KeyMoment>& moments) {
  std::vector<std::size_t> frames;
  for (const KeyMoment& moment : moments) frames.push_back(moment.frame);
  return frames;
}

TEST(KeyMoments, OfAQuietMotionAreSpreadEvenly) {
  const Recording recording = made_up_recording(scene_of(two_balls), 101, 0.01);
  EXPECT_EQ(frames_of(find_key_moments(recording, 5)), (std::vector<std::size_t>{0, 25, 50, 75, 100}));
  EXPECT_EQ(frames_of(find_key_moments(recording, 2)), (std::vector<std::size_t>{0, 100}));
  EXPECT_EQ(frames_of(find_key_moments(made_up_recording(scene_of(two_balls), 1, 1), 6)),
            (std::vector<std::size_t>{0}));
}

TEST(KeyMoments, AreTheHardestImpactsAndTheDeepestOverlap) {
  Recording recording = made_up_recording(scene_of(two_balls), 101, 0.01);
  for (int k = 1; k < 100; ++k)
    add_event(MotionEvent::Kind::impact, 0.01 * k, 0, 1, 1e-3 * k, recording.motion);
  add_event(MotionEvent::Kind::impact, 0.2, 0, 1, 9, recording.motion);
  add_event(MotionEvent::Kind::impact, 0.7, 1, -1, 8, recording.motion);
  recording.motion.penetration[40] = 2 * recording.contact_tolerance;
  const std::vector<KeyMoment> moments = find_key_moments(recording, 5);
  EXPECT_EQ(frames_of(moments), (std::vector<std::size_t>{0, 20, 40, 70, 100}));
  EXPECT_EQ(moments[0].what, "start");
  EXPECT_EQ(moments[1].what, "impact a – b.c, 9 N s");
  EXPECT_TRUE(moments[2].what.starts_with("overlap of "));
  EXPECT_EQ(moments[3].what, "impact b.c, 8 N s");
  EXPECT_EQ(moments[4].what, "end");
  // Less than the tolerance is no news.
  recording.motion.penetration[40] = 0.5 * recording.contact_tolerance;
  EXPECT_FALSE(find_key_moments(recording, 5)[2].what.starts_with("overlap"));
}

TEST(KeyMoments, AreNotNextToEachOther) {
  Recording recording = made_up_recording(scene_of(two_balls), 101, 0.01);
  add_event(MotionEvent::Kind::impact, 0.50, 0, 1, 9, recording.motion);
  add_event(MotionEvent::Kind::impact, 0.51, 0, 1, 8, recording.motion);
  add_event(MotionEvent::Kind::rest, 0.99, 0, -1, 0, recording.motion);
  const std::vector<KeyMoment> moments = find_key_moments(recording, 6);
  for (std::size_t i = 1; i < moments.size(); ++i) EXPECT_GE(moments[i].frame - moments[i - 1].frame, 4u);
  EXPECT_EQ(moments.size(), 6u);
}

// Pictures

TEST(PictureRenderer, PicturesHaveTheirSizeAndTheSameBitsAgain) {
  const Recording recording = made_up_recording(scene_of(two_balls), 11, 0.1);
  PictureRenderer renderer(recording, {}, {200, 100});
  const Image image = renderer.picture(3);
  EXPECT_EQ(image.width, 200);
  EXPECT_EQ(image.height, 100);
  EXPECT_EQ(PictureRenderer(recording, {}, {200, 100}).picture(3), image);
  EXPECT_NE(renderer.picture(4), image);
  // The legend is on the picture and not on the drawing.
  EXPECT_NE(renderer.draw(3), image);
}

TEST(PictureRenderer, ASheetHasAPictureForEachMoment) {
  const Recording recording = made_up_recording(scene_of(two_balls), 101, 0.01);
  PictureRenderer renderer(recording, {}, sheet_tile(700));
  for (std::size_t count = 2; count <= 6; ++count) {
    const std::vector<KeyMoment> moments = find_key_moments(recording, count);
    const Image sheet = renderer.sheet(moments);
    const PictureSize tile = sheet_tile(700);
    EXPECT_GE(sheet.width, sheet_columns(count) * tile.width);
    EXPECT_LE(sheet.width, 700);
    EXPECT_GE(sheet.height, static_cast<int>(count + 2) / 3 * tile.height);
  }
}

TEST(TimeText, HasAsManyDigitsAsTheOutputTimesNeed) {
  const Scene scene = scene_of(two_balls);
  EXPECT_EQ(time_text(made_up_recording(scene, 11, 0.1), 3), "t = 0.3 s");
  EXPECT_EQ(time_text(made_up_recording(scene, 11, 1e-4), 10), "t = 0.0010 s");
  EXPECT_EQ(time_text(made_up_recording(scene, 11, 5), 2), "t = 10 s");
  EXPECT_EQ(time_text(made_up_recording(scene, 1, 5), 0), "t = 0 s");
}

}  // namespace
}  // namespace rigor::recording_test
