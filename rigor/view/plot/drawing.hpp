#pragma once

#include "rigor/view/3d/canvas.hpp"

#include <string>
#include <vector>

namespace rigor {

/// A picture of boxes, lines and texts, x right and y down, that can be written as SVG or drawn in pixels.
struct Drawing {
  /// A filled rectangle, below all lines.
  struct Box {
    double left, top, right, bottom;
    std::string color;  ///< "#rrggbb".
  };
  struct Stroke {
    Polyline points;
    double width;
    std::string color;  ///< "#rrggbb".
  };
  struct Label {
    std::string text;
    double x, y;  ///< Position of the base line.
    double size;
    Anchor anchor = Anchor::start;
    bool is_vertical = false;  ///< Runs upwards.
  };
  double width = 0, height = 0;
  std::vector<Box> boxes;
  std::vector<Stroke> strokes;
  std::vector<Label> labels;
};

/// The drawing as an SVG document of its own, on white.
std::string svg_text(const Drawing& drawing);
/// The drawing in pixels, `scale` of them per unit, on white.
Image rasterised(const Drawing& drawing, double scale);

}  // namespace rigor
