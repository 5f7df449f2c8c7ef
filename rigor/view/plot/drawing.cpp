#include "rigor/view/plot/drawing.hpp"

#include "rigor/view/plot/markup_text.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

namespace rigor {

namespace {

constexpr std::string_view ink = "#1d2733";

std::string_view anchor_name(Anchor anchor) {
  return anchor == Anchor::start ? "start" : anchor == Anchor::middle ? "middle" : "end";
}

}  // namespace

std::string svg_text(const Drawing& drawing) {
  std::string svg;
  const auto out = std::back_inserter(svg);
  fmt::format_to(out,
                 "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:g}\" height=\"{1:g}\" "
                 "viewBox=\"0 0 {0:g} {1:g}\" font-family=\"Helvetica, Arial, sans-serif\" fill=\"{2}\">\n"
                 "<rect width=\"{0:g}\" height=\"{1:g}\" fill=\"#ffffff\"/>\n",
                 drawing.width, drawing.height, ink);
  for (const Drawing::Box& box : drawing.boxes) {
    fmt::format_to(out, "<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" fill=\"{}\"/>\n",
                   box.left, box.top, box.right - box.left, box.bottom - box.top, box.color);
  }
  for (const Drawing::Stroke& stroke : drawing.strokes) {
    svg += "<path d=\"";
    for (std::size_t i = 0; i < stroke.points.size(); ++i)
      fmt::format_to(out, "{}{:.2f} {:.2f}", i == 0 ? "M" : " L", stroke.points[i].x(), stroke.points[i].y());
    fmt::format_to(out,
                   "\" fill=\"none\" stroke=\"{}\" stroke-width=\"{:g}\" stroke-linejoin=\"round\" "
                   "stroke-linecap=\"round\"/>\n",
                   stroke.color, stroke.width);
  }
  for (const Drawing::Label& label : drawing.labels) {
    const std::string turn =
        label.is_vertical ? fmt::format(" transform=\"rotate(-90 {:.2f} {:.2f})\"", label.x, label.y) : "";
    fmt::format_to(out, "<text x=\"{:.2f}\" y=\"{:.2f}\" font-size=\"{:g}\" text-anchor=\"{}\"{}>{}</text>\n",
                   label.x, label.y, label.size, anchor_name(label.anchor), turn, markup_text(label.text));
  }
  return svg += "</svg>\n";
}

Image rasterised(const Drawing& drawing, double scale) {
  Image image(static_cast<int>(std::lround(drawing.width * scale)),
              static_cast<int>(std::lround(drawing.height * scale)));
  Canvas canvas(image);
  for (const Drawing::Box& box : drawing.boxes) {
    canvas.fill(box.left * scale, box.top * scale, box.right * scale, box.bottom * scale,
                color_from_hex(box.color));
  }
  for (const Drawing::Stroke& stroke : drawing.strokes) {
    Polyline line = stroke.points;
    for (Vec2& point : line) point *= scale;
    // A pen thinner than a pixel gives a fainter line, not a broken one.
    canvas.stroke({&line, 1}, stroke.width * scale, color_from_hex(stroke.color));
  }
  for (const Drawing::Label& label : drawing.labels) {
    canvas.text(label.text, label.x * scale, label.y * scale,
                {.size = label.size * scale,
                 .color = color_from_hex(ink),
                 .anchor = label.anchor,
                 .is_vertical = label.is_vertical});
  }
  return image;
}

}  // namespace rigor
