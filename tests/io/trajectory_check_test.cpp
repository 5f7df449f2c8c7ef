#include "rigor/io/trajectory/trajectory_check.hpp"

#include "io/trajectory_samples.hpp"
#include "rigor/core/input_error.hpp"
#include "rigor/io/trajectory/hdf5_writer.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <random>

namespace rigor::trajectory_check_test {
namespace {

StoredTrajectory good() {
  StoredTrajectory stored;
  stored.bodies = {"a", "b"};
  stored.time = {0, 1};
  stored.position.assign(12, 0.5);
  stored.orientation = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0.6, 0.8, 0.5, 0.5, 0.5, -0.5};
  stored.velocity.assign(12, -1);
  stored.angular_velocity.assign(12, 2);
  stored.energy.assign(6, 3);
  stored.penetration = {0, std::nan("")};
  stored.event_time = {0.5};
  stored.event_kind = {0};
  stored.event_bodies = {0, -1};
  stored.event_point.assign(3, 0);
  stored.event_impulse.assign(3, 1);
  return stored;
}

std::string error_of(void (*change)(StoredTrajectory&)) {
  StoredTrajectory stored = good();
  change(stored);
  return trajectory_error(stored);
}

TEST(TrajectoryCheck, EveryNumberIsLookedAt) {
  EXPECT_EQ(error_of([](StoredTrajectory&) {}), "");
  EXPECT_EQ(error_of([](StoredTrajectory& s) { s.time[1] = -1; }), "the time goes back after row 0");
  EXPECT_EQ(error_of([](StoredTrajectory& s) { s.time[1] = std::nan(""); }), "the time in row 1 is nan");
  EXPECT_EQ(error_of([](StoredTrajectory& s) { s.position[7] = 1e200; }), "a position in row 1 is 1e+200");
  EXPECT_EQ(error_of([](StoredTrajectory& s) { s.orientation[0] = 0.9; }),
            "an orientation in row 0 is not a unit quaternion");
  EXPECT_EQ(error_of([](StoredTrajectory& s) { s.velocity[0] = -std::numeric_limits<double>::infinity(); }),
            "a velocity in row 0 is -inf");
  EXPECT_EQ(error_of([](StoredTrajectory& s) { s.angular_velocity[11] = std::nan(""); }),
            "an angular velocity in row 1 is nan");
  EXPECT_EQ(error_of([](StoredTrajectory& s) { s.energy[4] = std::nan(""); }), "an energy in row 1 is nan");
  EXPECT_EQ(error_of([](StoredTrajectory& s) { s.event_kind[0] = 4; }),
            "an event is of kind 4, which there is not");
  EXPECT_EQ(error_of([](StoredTrajectory& s) { s.event_bodies[0] = 2; }), "an event names body 2 of 2");
  EXPECT_EQ(error_of([](StoredTrajectory& s) { s.event_impulse[0] = std::nan(""); }),
            "the impulse of an event in row 0 is nan");
}

TEST(TrajectoryCheck, ARunThatDidNotReachItsEndSaysHowFarItCame) {
  const TemporaryFolder folder;
  TrajectoryHeader header = sample_header({"a"});
  header.run.duration = 2;
  const auto ended = [&](int rows) {
    Hdf5Writer writer(folder / "run.h5", header);
    for (int k = 0; k < rows; ++k) writer.write(sample_row(k, 1), {});
    writer.close({});
    const std::string text = read_hdf5_trajectory(folder / "run.h5").ended_early;
    return text.substr(0, text.find('\'')) +
           text.substr(text.rfind('\'') == std::string::npos ? 0 : text.rfind('\'') + 1);
  };
  EXPECT_EQ(ended(21), "");
  EXPECT_EQ(ended(13), ": the run ended at t = 1.2 s of 2 s");
}

TEST(TrajectoryCheck, AFileThatClaimsToHaveBeenHugeTakesNoMemoryForIt) {
  const TemporaryFolder folder;
  {
    Hdf5Writer writer(folder / "a.h5", sample_header({"a"}));
    writer.write(sample_row(0, 1), {});
    writer.close({});
  }
  std::ifstream file(folder / "a.h5", std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(file), {}};
  // The address of the end of the file, in the superblock: 2^29.
  const std::string address("\0\0\0\x20\0\0\0\0", 8);
  bytes.replace(28, 8, address);
  std::ofstream(folder / "b.h5", std::ios::binary) << bytes;
  try {
    read_hdf5_trajectory(folder / "b.h5");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("of 536870912 bytes are left"), std::string::npos)
        << error.what();
  }
}

TEST(TrajectoryCheck, ChangedBytesOfAFileAreReadOrRefused) {
  const TemporaryFolder folder;
  {
    Hdf5Writer writer(folder / "a.h5", jointed_header({"a", "b"}, {"j"}));
    for (int k = 0; k < 20; ++k) {
      const MotionEvent event = sample_event(k);
      writer.write(sample_row(k, 2, 1), {&event, 1});
    }
    writer.close({});
  }
  std::ifstream file(folder / "a.h5", std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  std::mt19937_64 engine(1);
  int refused = 0;
  for (int i = 0; i < 300; ++i) {
    std::string changed = bytes;
    for (std::uint64_t k = 1 + engine() % 4; k > 0; --k)
      changed[engine() % changed.size()] = static_cast<char>(engine());
    if (i % 10 == 0) changed.resize(engine() % changed.size());
    std::ofstream(folder / "b.h5", std::ios::binary) << changed;
    try {
      trajectory_error(read_hdf5_trajectory(folder / "b.h5"));
    } catch (const InputError&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 20);
}

}  // namespace
}  // namespace rigor::trajectory_check_test
