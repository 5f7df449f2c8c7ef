#pragma once

#include "rigor/view/3d/color.hpp"
#include "rigor/view/3d/image.hpp"
#include "rigor/view/3d/stroke_font.hpp"

#include <span>
#include <string>
#include <string_view>

namespace rigor {

enum class Anchor { start, middle, end };

/// How a text is set on a picture.
struct TextStyle {
  double size = 14;  ///< Distance of base lines; capitals are 0.72 of it [px].
  Color color = Color::Zero();
  Anchor anchor = Anchor::start;  ///< Which part of the text is at the given position.
  bool is_vertical = false;       ///< Runs upwards.
};

/// Width of a text [px].
double text_width(std::string_view text, double size);
/// The text cut to the width, with "..." at its end if something is missing.
std::string fitted_text(std::string_view text, double size, double width);

/// Draws lines, text and rectangles on a picture; each pixel is mixed by the share that they cover. Positions
/// are in pixels from the upper left corner, x right and y down; anything outside the picture is clipped.
class Canvas {
 public:
  explicit Canvas(Image& image) : image_(image) {}

  /// Lines of one colour with round ends; where they cross, they are not blended twice.
  void stroke(std::span<const Polyline> lines, double width, const Color& color);
  /// The text with its base line at y.
  void text(std::string_view text, double x, double y, const TextStyle& style);
  /// Mixes the rectangle with the colour; opacity 0 to 1.
  void fill(double left, double top, double right, double bottom, const Color& color, double opacity = 1);
  /// Puts the other picture at (x, y).
  void paste(const Image& other, int x, int y);

 private:
  void blend(int x, int y, const Color& color, float share);

  Image& image_;
};

}  // namespace rigor
