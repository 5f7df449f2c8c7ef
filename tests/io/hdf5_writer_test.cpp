#include "rigor/io/trajectory/hdf5_writer.hpp"

#include "io/trajectory_samples.hpp"
#include "rigor/core/input_error.hpp"
#include "rigor/io/files/file_error.hpp"
#include "rigor/io/trajectory/hdf5_reader.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <fstream>
#include <iterator>
#include <limits>
#include <random>

#include <sys/resource.h>
#include <sys/wait.h>

namespace rigor::hdf5_writer_test {
namespace {

/// Every row that the file holds is the row that was written.
void expect_rows(const StoredTrajectory& stored, std::size_t body_count, std::size_t joint_count = 0) {
  ASSERT_EQ(stored.joints.size(), joint_count);
  for (std::size_t k = 0; k < stored.time.size(); ++k) {
    const TrajectorySample row = sample_row(static_cast<int>(k), body_count, joint_count);
    const auto part = [k](const std::vector<double>& values, std::size_t width) {
      return std::vector<double>(values.data() + k * width, values.data() + (k + 1) * width);
    };
    ASSERT_EQ(stored.time[k], row.time);
    ASSERT_EQ(part(stored.position, 3 * body_count), row.position);
    ASSERT_EQ(part(stored.orientation, 4 * body_count), row.orientation);
    ASSERT_EQ(part(stored.velocity, 3 * body_count), row.velocity);
    ASSERT_EQ(part(stored.angular_velocity, 3 * body_count), row.angular_velocity);
    ASSERT_EQ(part(stored.joint_coordinate, 2 * joint_count), row.joint_coordinate);
    ASSERT_EQ(part(stored.joint_rate, 2 * joint_count), row.joint_rate);
    ASSERT_EQ(part(stored.joint_force, 3 * joint_count), row.joint_force);
    ASSERT_EQ(part(stored.joint_torque, 3 * joint_count), row.joint_torque);
    ASSERT_EQ(part(stored.energy, 3),
              (std::vector<double>{row.energy.kinetic, row.energy.potential, row.energy.elastic}));
  }
  for (std::size_t k = 0; k < stored.event_time.size(); ++k) {
    const MotionEvent event = sample_event(static_cast<int>(k));
    ASSERT_EQ(stored.event_time[k], event.time);
    ASSERT_EQ(stored.event_kind[k], static_cast<int>(event.kind));
    ASSERT_EQ(stored.event_bodies[2 * k + 1], event.body_B);
    ASSERT_EQ(Vec3::Map(&stored.event_point[3 * k]), event.p_W);
    ASSERT_EQ(Vec3::Map(&stored.event_impulse[3 * k]), event.j_W);
  }
}

void write_row(int k, std::size_t body_count, Hdf5Writer& writer, std::size_t joint_count = 0) {
  const MotionEvent event = sample_event(k);
  writer.write(sample_row(k, body_count, joint_count), {&event, 1});
}

TEST(Hdf5Writer, WhatIsReadIsWhatWasWritten) {
  const TemporaryFolder folder;
  const std::size_t n = 3;
  Hdf5Writer writer(folder / "run.h5", sample_header({"a", "ball[0,1]", "größe"}));
  for (int k = 0; k < 3000; ++k) write_row(k, n, writer);
  writer.close({});

  const StoredTrajectory stored = read_hdf5_trajectory(folder / "run.h5");
  EXPECT_EQ(stored.scene, "test");
  EXPECT_EQ(stored.scene_text, "rigor: 1\n");
  EXPECT_EQ(stored.bodies, (std::vector<std::string>{"a", "ball[0,1]", "größe"}));
  ASSERT_EQ(stored.time.size(), 3000u);
  ASSERT_EQ(stored.event_time.size(), 3000u);
  expect_rows(stored, n);
}

TEST(Hdf5Writer, WhatIsReadOfJointsIsWhatWasWritten) {
  const TemporaryFolder folder;
  Hdf5Writer writer(folder / "run.h5", jointed_header({"a", "b"}, {"elbow", "pin[0,1]", "höhe"}));
  for (int k = 0; k < 1000; ++k) write_row(k, 2, writer, 3);
  writer.close({});
  const StoredTrajectory stored = read_hdf5_trajectory(folder / "run.h5");
  EXPECT_EQ(stored.joints, (std::vector<std::string>{"elbow", "pin[0,1]", "höhe"}));
  EXPECT_EQ(stored.coordinate_joint, (std::vector<int>{0, 0, 1, 1, 2, 2}));
  ASSERT_EQ(stored.time.size(), 1000u);
  expect_rows(stored, 2, 3);
}

TEST(Hdf5Writer, JointsWithoutCoordinatesOrWithoutForcesLeaveThemOut) {
  const TemporaryFolder folder;
  TrajectoryHeader header = sample_header({"a"});
  header.joints = {{"weld", {}}, {"elbow", {"rad"}}};
  {
    Hdf5Writer writer(folder / "moves.h5", header);
    TrajectorySample sample = sample_row(0, 1);
    sample.joint_coordinate = {0.25};
    sample.joint_rate = {-2};
    writer.write(sample, {});
    writer.close({});
  }
  const StoredTrajectory moves = read_hdf5_trajectory(folder / "moves.h5");
  EXPECT_EQ(moves.coordinate_joint, (std::vector<int>{1}));
  EXPECT_EQ(moves.joint_coordinate, (std::vector<double>{0.25}));
  EXPECT_EQ(moves.joint_rate, (std::vector<double>{-2}));
  EXPECT_TRUE(moves.joint_force.empty());

  header.joints = {{"weld", {}}};
  header.has_joint_forces = true;
  {
    Hdf5Writer writer(folder / "holds.h5", header);
    TrajectorySample sample = sample_row(0, 1);
    sample.joint_force = {1, 2, 3};
    sample.joint_torque = {4, 5, 6};
    writer.write(sample, {});
    writer.close({});
  }
  const StoredTrajectory holds = read_hdf5_trajectory(folder / "holds.h5");
  EXPECT_EQ(holds.joints, (std::vector<std::string>{"weld"}));
  EXPECT_TRUE(holds.joint_coordinate.empty());
  EXPECT_EQ(holds.joint_force, (std::vector<double>{1, 2, 3}));
  EXPECT_EQ(holds.joint_torque, (std::vector<double>{4, 5, 6}));
}

TEST(Hdf5Writer, ASceneWithoutBodiesGivesTimesOnly) {
  const TemporaryFolder folder;
  Hdf5Writer writer(folder / "run.h5", sample_header({}));
  writer.write(sample_row(0, 0), {});
  writer.close({});
  const StoredTrajectory stored = read_hdf5_trajectory(folder / "run.h5");
  EXPECT_EQ(stored.time.size(), 1u);
  EXPECT_TRUE(stored.position.empty());
}

TEST(Hdf5Writer, AnUnclosedFileCanBeReadAtAnyTime) {
  const TemporaryFolder folder;
  Hdf5Writer writer(folder / "run.h5", sample_header({"a"}));
  for (int k = 0; k < 300; ++k) {
    write_row(k, 1, writer);
    writer.flush();
    // A copy is what another process sees.
    if (k % 29 != 0) continue;
    std::filesystem::copy_file(folder / "run.h5", folder / "copy.h5",
                               std::filesystem::copy_options::overwrite_existing);
    const StoredTrajectory stored = read_hdf5_trajectory(folder / "copy.h5");
    ASSERT_EQ(stored.time.size(), static_cast<std::size_t>(k + 1));
    expect_rows(stored, 1);
  }
}

/// Runs a process that writes and flushes row after row without a pause, and kills it after the time [µs].
void write_and_be_killed(const std::filesystem::path& path, std::size_t body_count, int microseconds) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < body_count; ++i) names.push_back("body" + std::to_string(i));
  const pid_t child = ::fork();
  if (child == 0) {
    Hdf5Writer writer(path, sample_header(names));
    writer.flush();
    std::ofstream(path.string() + ".open").put('1');
    for (int k = 0;; ++k) {
      write_row(k, body_count, writer);
      writer.flush();
    }
  }
  while (!std::filesystem::exists(path.string() + ".open")) ::usleep(100);
  ::usleep(static_cast<useconds_t>(microseconds));
  ::kill(child, SIGKILL);
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFSIGNALED(status));
}

TEST(Hdf5Writer, AFileWhoseWriterWasKilledCanBeOpenedAndHoldsWholeRows) {
  // Nearly all the time of the child goes into flushes, so nearly every kill hits one.
  std::mt19937 random(1);
  std::size_t rows = 0;
  for (int trial = 0; trial < 40; ++trial) {
    const TemporaryFolder folder;
    const std::size_t n = trial % 2 == 0 ? 1 : 50;
    write_and_be_killed(folder / "run.h5", n, static_cast<int>(random() % 20000));
    const StoredTrajectory stored = read_hdf5_trajectory(folder / "run.h5");
    ASSERT_EQ(stored.position.size(), stored.time.size() * n * 3);
    ASSERT_EQ(stored.energy.size(), stored.time.size() * 3);
    ASSERT_GE(stored.event_time.size(), stored.time.size());
    expect_rows(stored, n);
    rows += stored.time.size();
  }
  EXPECT_GT(rows, 40u);
}

TEST(Hdf5Writer, AFullDiskIsToldAndTheFileKeepsWhatItHeld) {
  const TemporaryFolder folder;
  const pid_t child = ::fork();
  if (child == 0) {
    // A limit of the file's size stands for a full disk.
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit = {400000, 400000};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    Hdf5Writer writer(folder / "run.h5", sample_header({"a"}));
    try {
      for (int k = 0; k < 100000; ++k) {
        write_row(k, 1, writer);
        writer.flush();
      }
      ::_exit(1);
    } catch (const FileError& error) {
      ::_exit(std::string(error.what()).find("File too large") != std::string::npos ? 0 : 2);
    }
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 0);
  const StoredTrajectory stored = read_hdf5_trajectory(folder / "run.h5");
  EXPECT_GT(stored.time.size(), 100u);
  expect_rows(stored, 1);
}

TEST(Hdf5Writer, APlaceThatCannotBeWrittenIsAFileError) {
  const TemporaryFolder folder;
  EXPECT_THROW(Hdf5Writer(folder / "missing/run.h5", sample_header({"a"})), FileError);
  EXPECT_THROW(Hdf5Writer(folder.path(), sample_header({"a"})), FileError);
}

std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Lengths of beginnings: from first, in steps, below end.
struct Lengths {
  std::uintmax_t step, first = 0, end = std::numeric_limits<std::uintmax_t>::max();
};
/// Reads the beginnings of the file of these lengths; returns in how many of them there were rows, and sees
/// that what is read is what was written and that the rest says why not.
int readable_beginnings(const std::filesystem::path& file, const Lengths& lengths, std::size_t body_count,
                        std::size_t joint_count = 0) {
  const std::filesystem::path cut = file.string() + ".cut";
  const std::string whole = bytes_of(file);
  int readable = 0;
  std::size_t most = 0;
  const std::uintmax_t end = std::min<std::uintmax_t>(lengths.end, whole.size());
  for (std::uintmax_t bytes = lengths.first; bytes < end; bytes += lengths.step) {
    std::ofstream(cut, std::ios::binary).write(whole.data(), static_cast<std::streamsize>(bytes));
    try {
      const StoredTrajectory stored = read_hdf5_trajectory(cut);
      ++readable;
      EXPECT_NE(stored.cut_off.find("it is cut off, " + std::to_string(bytes)), std::string::npos);
      EXPECT_GE(stored.time.size(), most) << "fewer rows of more bytes";
      EXPECT_EQ(stored.position.size(), 3 * body_count * stored.time.size());
      most = stored.time.size();
      expect_rows(stored, body_count, joint_count);
    } catch (const InputError& error) {
      EXPECT_EQ(std::string(error.what()).rfind("cannot read '", 0), 0u) << error.what();
      EXPECT_EQ(readable, 0) << error.what();
    }
  }
  EXPECT_GT(most, 0u);
  return readable;
}

TEST(Hdf5Reader, EveryBeginningOfAFileGivesItsWholeRowsOrSaysWhyNot) {
  const TemporaryFolder folder;
  Hdf5Writer writer(folder / "run.h5", sample_header({"a", "b"}));
  for (int k = 0; k < 600; ++k) {
    write_row(k, 2, writer);
    if (k % 50 == 0) writer.flush();
  }
  writer.close({});
  const std::uintmax_t size = std::filesystem::file_size(folder / "run.h5");
  // All lengths would take long: steps without a common factor with any alignment.
  EXPECT_GT(readable_beginnings(folder / "run.h5", {1597}, 2), static_cast<int>(size / 1597 / 4));
}

TEST(Hdf5Reader, EveryBeginningOfAFileWithJointsGivesItsWholeRowsOrSaysWhyNot) {
  const TemporaryFolder folder;
  Hdf5Writer writer(folder / "run.h5", jointed_header({"a"}, {"elbow", "knee", "hip"}));
  for (int k = 0; k < 600; ++k) {
    write_row(k, 1, writer, 3);
    if (k % 50 == 0) writer.flush();
  }
  writer.close({});
  const std::uintmax_t size = std::filesystem::file_size(folder / "run.h5");
  EXPECT_GT(readable_beginnings(folder / "run.h5", {1597}, 1, 3), static_cast<int>(size / 1597 / 4));
}

TEST(Hdf5Reader, EveryBeginningOfAnUnclosedFileTooGivesItsWholeRowsOrSaysWhyNot) {
  const TemporaryFolder folder;
  Hdf5Writer writer(folder / "run.h5", sample_header({"a"}));
  for (int k = 0; k < 200; ++k) write_row(k, 1, writer);
  writer.flush();
  std::filesystem::copy_file(folder / "run.h5", folder / "copy.h5");
  const std::uintmax_t size = std::filesystem::file_size(folder / "copy.h5");
  EXPECT_GT(readable_beginnings(folder / "copy.h5", {size / 60 + 1}, 1), 0);
}

TEST(Hdf5Reader, EveryByteWhereAShortFileBecomesReadableGivesItsRowsOrSaysWhyNot) {
  const TemporaryFolder folder;
  TrajectoryHeader header = sample_header({"a"});
  header.run.duration = 2 * header.run.output_interval;
  Hdf5Writer writer(folder / "run.h5", header);
  for (int k = 0; k < 3; ++k) write_row(k, 1, writer);
  writer.close({});
  const std::uintmax_t size = std::filesystem::file_size(folder / "run.h5"), step = 401;
  EXPECT_LT(size, 60000u) << "chunks are no longer than the run";
  const int readable = readable_beginnings(folder / "run.h5", {step}, 1);
  // Of the lengths in steps this is the first that could be read.
  const std::uintmax_t first = ((size - 1) / step - static_cast<std::uintmax_t>(readable) + 1) * step;
  EXPECT_GT(readable_beginnings(folder / "run.h5", {1, first - step, first + 1}, 1), 0);
  EXPECT_EQ(readable_beginnings(folder / "run.h5", {1, size - 150}, 1), 150);
}

TEST(Hdf5Reader, AFileWithoutItsFirstPartsSaysHowMuchIsMissing) {
  const TemporaryFolder folder;
  Hdf5Writer writer(folder / "run.h5", sample_header({"a"}));
  write_row(0, 1, writer);
  writer.close({});
  const std::string whole = bytes_of(folder / "run.h5");
  std::ofstream(folder / "cut.h5", std::ios::binary).write(whole.data(), 60);
  try {
    read_hdf5_trajectory(folder / "cut.h5");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(
        std::string(error.what()).find("it is cut off, 60 of " + std::to_string(whole.size()) + " bytes"),
        std::string::npos)
        << error.what();
  }
}

TEST(Hdf5Reader, RefusesWhatIsNoTrajectory) {
  const TemporaryFolder folder;
  std::ofstream(folder / "text.h5") << "not HDF5";
  EXPECT_THROW(read_hdf5_trajectory(folder / "text.h5"), InputError);
  EXPECT_THROW(read_hdf5_trajectory(folder / "missing.h5"), InputError);
}

}  // namespace
}  // namespace rigor::hdf5_writer_test
