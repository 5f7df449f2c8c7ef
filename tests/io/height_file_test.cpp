#include "rigor/io/mesh/height_file.hpp"
#include "rigor/core/input_error.hpp"
#include "rigor/geometry/mass/mass_properties.hpp"
#include "rigor/io/scene/scene_reader.hpp"
#include "rigor/model/limits.hpp"

#include <gtest/gtest.h>
#include <filesystem>
#include <fstream>
#include <string>
#include <variant>

namespace rigor::height_file_test {
namespace {

std::string message_of(const std::string& text) {
  try {
    parse_heights(text, "h.csv");
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

/// An empty folder of the test's own.
std::filesystem::path new_folder() {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "height_files";
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  return folder;
}

TEST(HeightFile, HasItsLinesAsRows) {
  const HeightRows rows = {{0, 0.5, -1}, {1e-3, 2, 3}};
  EXPECT_EQ(parse_heights("0,0.5,-1\n1e-3,2,3\n", "h.csv"), rows);
  EXPECT_EQ(parse_heights(" 0 , 0.5,\t-1\r\n\r\n1e-3,+2,3", "h.csv"), rows);
}

TEST(HeightFile, TellsLineAndColumnOfWhatIsWrong) {
  EXPECT_EQ(message_of("0,1\n2, x\n"), "h.csv:2:4: 'x' is not a number");
  EXPECT_EQ(message_of("x,y\n0,1\n"), "h.csv:1:1: 'x' is not a number");
  EXPECT_EQ(message_of("0,1\n2,0x3\n"), "h.csv:2:3: '0x3' is not a number; numbers are decimal");
  EXPECT_EQ(message_of("0 1\n"), "h.csv:1:1: '0 1' is not a number");
  EXPECT_EQ(message_of("0,,1\n"), "h.csv:1:3: nothing between commas, must be a number (m)");
  EXPECT_EQ(message_of("0,1,\n"), "h.csv:1:5: nothing between commas, must be a number (m)");
  EXPECT_EQ(message_of("0,1\n\n2,nan\n"), "h.csv:3:3: the height is nan m, must be from -1e+09 to 1e+09 m");
  EXPECT_EQ(message_of("0,inf\n"), "h.csv:1:3: the height is inf m, must be from -1e+09 to 1e+09 m");
  EXPECT_EQ(message_of("\n0,1\n2,3,4\n"),
            "h.csv:3:1: the row has 3 numbers, must have 2 as the one in line 2");
  EXPECT_EQ(message_of(" \n\n"), "h.csv: the file is empty, must have rows of numbers between commas");
  EXPECT_EQ(message_of(""), "h.csv: the file is empty, must have rows of numbers between commas");
}

TEST(HeightFile, RefusesMoreHeightsThanAllowed) {
  std::string row = "0";
  for (int i = 1; i < 1000; ++i) row += ",0";
  row += "\n";
  std::string text;
  for (int i = 0; i < 1000; ++i) text += row;
  static_assert(limits::height_count == 1000 * 1000);
  EXPECT_EQ(message_of(text), "accepted");
  EXPECT_EQ(message_of(text + row),
            "h.csv:1001:1: more heights than allowed, must be at most 1000000 in all");
}

TEST(HeightFile, IsReadFromTheScenesFolderAndOnlyCsv) {
  const std::filesystem::path folder = new_folder();
  std::ofstream(folder / "dune.csv") << "0,0,0\n0,1,0\n0,0,0\n";
  std::ofstream(folder / "broken.CSV") << "0,0\n0,a\n";
  std::ofstream(folder / "dune.txt") << "0,0\n0,0\n";
  const auto scene_with = [&](const std::string& file) {
    return parse_scene("rigor: 1\nbodies:\n  - {name: b, mass: 1, shapes: [{type: heightfield, file: " +
                           file + ", size: [2, 4], base: 0.5}]}\n",
                       "s.yaml", folder);
  };
  // A pyramid of 2 by 4 by 1 on a slab of 2 by 4 by 0.5.
  const Scene scene = scene_with("dune.csv");
  const Shape& shape = scene.model->bodies()[0].shapes[0].shape;
  EXPECT_NEAR(mass_properties(shape, 1).mass, 8.0 / 3 + 4, 1e-14);

  const auto message = [&](const std::string& file) -> std::string {
    try {
      scene_with(file);
    } catch (const InputError& error) {
      return error.what();
    }
    return "accepted";
  };
  const std::string whose = "s.yaml:3:59: shape 0 (heightfield) of body 'b': ";
  EXPECT_EQ(message("broken.CSV"), whose + "broken.CSV:2:3: 'a' is not a number");
  EXPECT_EQ(message("dune.txt"), whose + "dune.txt: unknown kind of file of heights '.txt'; allowed is .csv");
}

TEST(HeightFieldShape, OnAMovingBodyHasTheInertiaOfItsSolid) {
  const Scene scene = parse_scene(
      "rigor: 1\nbodies:\n  - {name: b, density: 5, shapes: [{type: heightfield, heights: [[1, 1], [1, 1], "
      "[1, 1]], "
      "size: [2, 4]}]}\n",
      "s.yaml", ".");
  // The default base is a tenth of 4 m.
  EXPECT_NEAR(scene.model->bodies()[0].mass, 5 * 2 * 4 * 0.4, 1e-13);
  EXPECT_NEAR(scene.model->bodies()[0].p_WB.z(), 1 - 0.2, 1e-14);
}

}  // namespace
}  // namespace rigor::height_file_test
