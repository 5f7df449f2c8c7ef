#include "rigor/io/files/output_file.hpp"

#include "io/trajectory_samples.hpp"
#include "rigor/io/files/file_error.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <set>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

namespace rigor::output_file_test {
namespace {

std::set<std::string> names_in(const TemporaryFolder& folder) {
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path()))
    names.insert(entry.path().filename().string());
  return names;
}

void put(const std::filesystem::path& path) {
  std::ofstream(path) << "part";
}

TEST(OutputFile, WhatAKilledProcessLeftGoesWithTheNextWrite) {
  const TemporaryFolder folder;
  for (const char* const name : {"run.cp.123-0.tmp", "run.cp.99999-7.tmp", "run.cp.4711.tmp"})
    put(folder / name);
  write_atomically(folder / "run.cp", "new");
  EXPECT_EQ(names_in(folder), std::set<std::string>{"run.cp"});
  put(folder / "run.cp.123-0.tmp");
  check_can_write(folder / "run.cp");
  EXPECT_EQ(names_in(folder), std::set<std::string>{"run.cp"});
}

TEST(OutputFile, NothingElseGoes) {
  const TemporaryFolder folder;
  const std::set<std::string> others = {"run.cp.notes.tmp", "run.cp.tmp", "other.cp.1-0.tmp", "run.cp.1-0",
                                        "xrun.cp.1-0.tmp"};
  for (const std::string& name : others) put(folder / name);
  std::filesystem::create_directory(folder / "run.cp.2-0.tmp");
  std::filesystem::create_symlink("run.cp.notes.tmp", folder / "run.cp.3-0.tmp");
  write_atomically(folder / "run.cp", "new");
  for (const std::string& name : others) EXPECT_TRUE(std::filesystem::exists(folder / name)) << name;
  EXPECT_TRUE(std::filesystem::exists(folder / "run.cp.2-0.tmp"));
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "run.cp.3-0.tmp"));
}

TEST(OutputFile, AFileThatAProcessIsWritingStays) {
  const TemporaryFolder folder;
  put(folder / "run.cp.1-0.tmp");
  const int other = ::open((folder / "run.cp.1-0.tmp").c_str(), O_WRONLY);
  ASSERT_EQ(::flock(other, LOCK_EX), 0);
  write_atomically(folder / "run.cp", "new");
  EXPECT_TRUE(std::filesystem::exists(folder / "run.cp.1-0.tmp"));
  ::close(other);
  write_atomically(folder / "run.cp", "new");
  EXPECT_EQ(names_in(folder), std::set<std::string>{"run.cp"});
}

TEST(OutputFile, ALinkThatSomebodyPlacedIsNotWrittenThrough) {
  // The first name that a process takes for its file, as a link to a file of the user.
  const TemporaryFolder folder;
  put(folder / "treasure");
  const std::string name = "run.cp." + std::to_string(::getpid()) + "-0.tmp";
  std::filesystem::create_symlink("treasure", folder / name);
  write_atomically(folder / "run.cp", "new");
  std::ifstream treasure(folder / "treasure"), run(folder / "run.cp");
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(treasure), {}), "part");
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(run), {}), "new");
}

}  // namespace
}  // namespace rigor::output_file_test
