#include "rigor/io/trajectory/csv_writer.hpp"

#include "io/trajectory_samples.hpp"
#include "rigor/io/files/file_error.hpp"

#include <gtest/gtest.h>

#include <charconv>
#include <fstream>
#include <sstream>

namespace rigor::csv_writer_test {
namespace {

std::vector<std::string> lines_of(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);) lines.push_back(line);
  return lines;
}

std::vector<double> numbers_of(const std::string& line) {
  std::vector<double> numbers;
  std::istringstream fields(line);
  for (std::string field; std::getline(fields, field, ',');) {
    double number = 0;
    const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), number);
    EXPECT_TRUE(error == std::errc() && end == field.data() + field.size()) << field;
    numbers.push_back(number);
  }
  return numbers;
}

TEST(CsvWriter, HeaderNamesEveryColumnWithItsUnit) {
  const TemporaryFolder folder;
  CsvWriter writer(folder / "run.csv", sample_header({"ball"}));
  writer.close({});
  ASSERT_EQ(lines_of(folder / "run.csv").size(), 1u);
  EXPECT_EQ(lines_of(folder / "run.csv")[0],
            "time [s],ball.position.x [m],ball.position.y [m],ball.position.z "
            "[m],ball.orientation.w,ball.orientation.x,"
            "ball.orientation.y,ball.orientation.z,ball.velocity.x [m/s],ball.velocity.y "
            "[m/s],ball.velocity.z [m/s],"
            "ball.angular_velocity.x [rad/s],ball.angular_velocity.y [rad/s],ball.angular_velocity.z [rad/s],"
            "kinetic_energy [J],potential_energy [J],elastic_energy [J]");
}

TEST(CsvWriter, NamesWithCommasAndQuotesAreQuoted) {
  const TemporaryFolder folder;
  CsvWriter writer(folder / "run.csv", sample_header({"a[0,1]\""}));
  writer.close({});
  EXPECT_NE(lines_of(folder / "run.csv")[0].find(R"(,"a[0,1]"".position.x [m]",)"), std::string::npos);
}

TEST(CsvWriter, EveryNumberReadsBackAsTheSameDouble) {
  const TemporaryFolder folder;
  CsvWriter writer(folder / "run.csv", sample_header({"a", "b"}));
  for (int k = 0; k < 50; ++k) writer.write(sample_row(k, 2), {});
  writer.close({});
  const std::vector<std::string> lines = lines_of(folder / "run.csv");
  ASSERT_EQ(lines.size(), 51u);
  for (int k = 0; k < 50; ++k) {
    const TrajectorySample row = sample_row(k, 2);
    const std::vector<double> numbers = numbers_of(lines[static_cast<std::size_t>(k) + 1]);
    ASSERT_EQ(numbers.size(), 1 + 2 * 13 + 3u);
    EXPECT_EQ(numbers[0], row.time);
    for (std::size_t body = 0; body < 2; ++body) {
      const double* const of_body = &numbers[1 + 13 * body];
      for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(of_body[i], row.position[3 * body + i]);
        EXPECT_EQ(of_body[7 + i], row.velocity[3 * body + i]);
        EXPECT_EQ(of_body[10 + i], row.angular_velocity[3 * body + i]);
      }
      for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(of_body[3 + i], row.orientation[4 * body + i]);
    }
    EXPECT_EQ(numbers[27], row.energy.kinetic);
    EXPECT_EQ(numbers[28], row.energy.potential);
    EXPECT_EQ(numbers[29], row.energy.elastic);
  }
}

TEST(CsvWriter, FirstRowIsInTheFileBeforeItIsClosed) {
  const TemporaryFolder folder;
  CsvWriter writer(folder / "run.csv", sample_header({"a"}));
  writer.write(sample_row(0, 1), {});
  EXPECT_EQ(lines_of(folder / "run.csv").size(), 2u);
}

TEST(CsvWriter, PlacesThatCannotBeWrittenAreFileErrors) {
  const TemporaryFolder folder;
  EXPECT_THROW(CsvWriter(folder / "missing/run.csv", sample_header({"a"})), FileError);
  EXPECT_THROW(CsvWriter(folder.path(), sample_header({"a"})), FileError);
}

TEST(CsvWriter, AFullDiskIsAFileErrorThatNamesTheFile) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "needs /dev/full";
  try {
    CsvWriter writer("/dev/full", sample_header({"a"}));
    writer.close({});
    FAIL();
  } catch (const FileError& error) {
    EXPECT_STREQ(error.what(), "cannot write '/dev/full': No space left on device");
  }
}

}  // namespace
}  // namespace rigor::csv_writer_test
