#include "io/trajectory_samples.hpp"
#include "rigor/core/input_error.hpp"
#include "rigor/io/files/file_error.hpp"
#include "rigor/view/3d/canvas.hpp"
#include "rigor/view/3d/png_file.hpp"

#include <gtest/gtest.h>

#include <fstream>

namespace rigor::image_test {
namespace {

Image made_up_image(int width, int height) {
  Image image(width, height);
  for (std::size_t i = 0; i < image.rgb.size(); ++i)
    image.rgb[i] = static_cast<std::uint8_t>(i * 37 + i / 11);
  return image;
}

TEST(PngFile, WhatIsReadIsWhatWasWritten) {
  const TemporaryFolder folder;
  for (const auto& [width, height] : {std::pair(1, 1), {17, 5}, {640, 360}}) {
    const Image image = made_up_image(width, height);
    write_png(folder / "a.png", image);
    EXPECT_EQ(read_png(folder / "a.png"), image);
    EXPECT_EQ(png_bytes(image), png_bytes(image));
  }
}

TEST(PngFile, WhatIsNoPictureAndPlacesThatCannotBeWrittenAreErrors) {
  const TemporaryFolder folder;
  std::ofstream(folder / "text.png") << "text";
  EXPECT_THROW(read_png(folder / "text.png"), InputError);
  EXPECT_THROW(read_png(folder / "missing.png"), InputError);
  EXPECT_THROW(write_png(folder / "missing/a.png", made_up_image(2, 2)), FileError);
}

TEST(Color, HexOfEveryGreyIsReadBack) {
  for (int value = 0; value < 256; ++value) {
    char text[8];
    std::snprintf(text, sizeof text, "#%02x%02x%02x", value, value, value);
    EXPECT_EQ(hex_text(color_from_hex(text)), text);
  }
  EXPECT_EQ(hex_text(color_from_hex("#3c6")), "#33cc66");
  EXPECT_EQ(hex_text(color_from_hex("#AbCdEf")), "#abcdef");
}

TEST(Color, HalfTheLightIsBrighterThanHalfTheValue) {
  // sRGB of the light 0.5 is 1.055 · 0.5^(1/2.4) - 0.055 = 0.7354, times 255.
  EXPECT_EQ(srgb_byte(0.5F), 188);
  EXPECT_EQ(srgb_byte(-1), 0);
  EXPECT_EQ(srgb_byte(7), 255);
}

/// Dark that was added to a white picture, in whole black pixels.
double darkness(const Image& image) {
  double sum = 0;
  for (const std::uint8_t value : image.rgb) sum += (255 - value) / 255.0 / 3;
  return sum;
}

TEST(Canvas, ALineCoversItsLengthTimesItsWidth) {
  // Ends are round: a disk of the pen's width more.
  for (const Vec2& end : {Vec2(90, 20.3), Vec2(90, 70), Vec2(21, 95)}) {
    for (const double width : {1.0, 2.0, 5.0}) {
      Image image(110, 110);
      const Polyline line = {Vec2(20.5, 20.3), end};
      Canvas(image).stroke({&line, 1}, width, Color::Zero());
      const double area = (end - line[0]).norm() * width + M_PI * width * width / 4;
      EXPECT_NEAR(darkness(image), area, 0.04 * area + 1) << end.transpose() << " " << width;
    }
  }
}

TEST(Canvas, WhatIsOutsideIsLeftOut) {
  Image image(20, 10);
  Canvas canvas(image);
  const Polyline outside = {Vec2(-50, -50), Vec2(-5, -5)};
  canvas.stroke({&outside, 1}, 3, Color::Zero());
  canvas.text("far away", 500, 5, {});
  canvas.fill(-10, -10, 0, 30, Color::Zero());
  EXPECT_EQ(darkness(image), 0);
  canvas.fill(-10, -10, 100, 100, Color::Zero());
  EXPECT_NEAR(darkness(image), 200, 1e-9);
}

TEST(Canvas, TextStandsWhereItsAnchorSays) {
  // Columns with ink, for each anchor.
  const auto extent = [](Anchor anchor) {
    Image image(200, 40);
    Canvas(image).text("HIH", 100, 30, {.size = 20, .anchor = anchor});
    std::pair<int, int> columns{200, -1};
    for (int x = 0; x < 200; ++x) {
      for (int y = 0; y < 40; ++y) {
        if (image.pixel(x, y)[0] < 128) columns = {std::min(columns.first, x), x};
      }
    }
    return columns;
  };
  const double width = text_width("HIH", 20);
  EXPECT_NEAR(extent(Anchor::start).first, 100, 1.5);
  EXPECT_NEAR(extent(Anchor::start).second, 100 + width, 1.5);
  EXPECT_NEAR(extent(Anchor::end).second, 100, 1.5);
  EXPECT_NEAR(extent(Anchor::middle).first, 100 - width / 2, 1.5);
}

TEST(Canvas, FittedTextIsNotWiderThanItsRoom) {
  EXPECT_EQ(fitted_text("short", 12, 1000), "short");
  const std::string cut = fitted_text("größere Überschrift", 12, 60);
  EXPECT_LE(text_width(cut, 12), 60);
  EXPECT_TRUE(cut.ends_with("..."));
  EXPECT_TRUE(cut.starts_with("gr"));
}

TEST(StrokeFont, HasAllOfAsciiAndEachLetterIsAnother) {
  const TextLines unknown = text_lines("\x01");
  std::vector<std::vector<Polyline>> seen;
  for (char c = '!'; c <= '~'; ++c) {
    const TextLines lines = text_lines(std::string(1, c));
    ASSERT_FALSE(lines.lines.empty()) << c;
    EXPECT_NE(lines.lines, unknown.lines) << c;
    for (const auto& other : seen) EXPECT_NE(lines.lines, other) << c;
    seen.push_back(lines.lines);
    for (const Polyline& line : lines.lines) {
      for (const Vec2& point : line) {
        EXPECT_GE(point.x(), 0) << c;
        EXPECT_LE(point.x(), lines.width) << c;
      }
    }
  }
  EXPECT_NE(text_lines("ω").lines, unknown.lines);
  EXPECT_LT(text_lines("²").width, text_lines("2").width);
}

}  // namespace
}  // namespace rigor::image_test
