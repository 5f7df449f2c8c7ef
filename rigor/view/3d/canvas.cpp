#include "rigor/view/3d/canvas.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace rigor {

namespace {

constexpr double capital_share = 0.72;  ///< Height of capitals relative to the text size.
constexpr double pen_share = 0.085;     ///< Width of the pen relative to the text size.

double font_scale(double size) {
  return capital_share * size / capital_height;
}

/// Coverage mask of a part of a picture: the share of each pixel that lines cover.
struct Mask {
  int left, top, width, height;
  std::vector<float> share;

  /// Adds the segment a-b of a pen: a pixel is covered as far as its centre is inside the outline of the
  /// stroke.
  void add(const Vec2& a, const Vec2& b, double pen) {
    const double reach = 0.5 * pen + 0.5;
    const Vec2 along = b - a;
    const double length2 = along.squaredNorm();
    const auto clamped = [](double value, int low, int count) {
      return static_cast<int>(std::clamp(value - low, 0.0, static_cast<double>(count)));
    };
    const int first = clamped(std::min(a.y(), b.y()) - reach, top, height);
    const int last = clamped(std::max(a.y(), b.y()) + reach + 1, top, height);
    for (int row = first; row < last; ++row) {
      const double y = top + row + 0.5;
      // Only the part of the segment near this row matters.
      double low = std::min(a.x(), b.x()), high = std::max(a.x(), b.x());
      if (std::abs(along.y()) > reach) {
        const double at_upper = a.x() + (y - reach - a.y()) / along.y() * along.x();
        const double at_lower = a.x() + (y + reach - a.y()) / along.y() * along.x();
        low = std::max(low, std::min(at_upper, at_lower)),
        high = std::min(high, std::max(at_upper, at_lower));
      }
      for (int x = clamped(low - reach, left, width); x < clamped(high + reach + 1, left, width); ++x) {
        const Vec2 p(left + x + 0.5, y);
        const double s = length2 > 0 ? std::clamp((p - a).dot(along) / length2, 0.0, 1.0) : 0.0;
        const double covered = std::clamp(reach - (p - a - s * along).norm(), 0.0, std::min(1.0, pen));
        float& here = share[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                            static_cast<std::size_t>(x)];
        here = std::max(here, static_cast<float>(covered));
      }
    }
  }
};

/// A mask for the lines, clipped to the picture.
Mask make_mask(std::span<const Polyline> lines, double pen, const Image& image) {
  Vec2 low(HUGE_VAL, HUGE_VAL), high(-HUGE_VAL, -HUGE_VAL);
  for (const Polyline& line : lines) {
    for (const Vec2& point : line) low = low.cwiseMin(point), high = high.cwiseMax(point);
  }
  const auto clamped = [](double value, int limit) {
    return static_cast<int>(std::clamp(std::floor(value), 0.0, static_cast<double>(limit)));
  };
  Mask mask{clamped(low.x() - pen - 1, image.width), clamped(low.y() - pen - 1, image.height), 0, 0, {}};
  mask.width = clamped(high.x() + pen + 2, image.width) - mask.left;
  mask.height = clamped(high.y() + pen + 2, image.height) - mask.top;
  mask.share.assign(static_cast<std::size_t>(mask.width) * static_cast<std::size_t>(mask.height), 0);
  return mask;
}

}  // namespace

double text_width(std::string_view text, double size) {
  return text_lines(text).width * font_scale(size);
}

std::string fitted_text(std::string_view text, double size, double width) {
  if (text_width(text, size) <= width) return std::string(text);
  std::string cut(text);
  const auto drop_character = [&] {
    while (!cut.empty() && (static_cast<unsigned char>(cut.back()) & 0xC0) == 0x80) cut.pop_back();
    if (!cut.empty()) cut.pop_back();
  };
  while (!cut.empty() && text_width(cut + "...", size) > width) drop_character();
  return cut + "...";
}

void Canvas::blend(int x, int y, const Color& color, float share) {
  std::uint8_t* const pixel = image_.pixel(x, y);
  for (int channel = 0; channel < 3; ++channel) {
    const float below = static_cast<float>(pixel[channel]),
                above = static_cast<float>(srgb_byte(color[channel]));
    pixel[channel] = static_cast<std::uint8_t>(below + (above - below) * share + 0.5F);
  }
}

void Canvas::stroke(std::span<const Polyline> lines, double width, const Color& color) {
  if (lines.empty()) return;
  Mask mask = make_mask(lines, width, image_);
  for (const Polyline& line : lines) {
    for (std::size_t i = 0; i + 1 < line.size(); ++i) mask.add(line[i], line[i + 1], width);
  }
  std::size_t at = 0;
  for (int y = 0; y < mask.height; ++y) {
    for (int x = 0; x < mask.width; ++x, ++at) {
      if (mask.share[at] > 0) blend(mask.left + x, mask.top + y, color, mask.share[at]);
    }
  }
}

void Canvas::text(std::string_view text, double x, double y, const TextStyle& style) {
  TextLines lines = text_lines(text);
  const double scale = font_scale(style.size);
  const double shift = style.anchor == Anchor::start ? 0 : style.anchor == Anchor::middle ? 0.5 : 1.0;
  for (Polyline& line : lines.lines) {
    for (Vec2& point : line) {
      const double along = scale * (point.x() - shift * lines.width), above = scale * point.y();
      point = style.is_vertical ? Vec2(x - above, y - along) : Vec2(x + along, y - above);
    }
  }
  stroke(lines.lines, std::max(1.0, pen_share * style.size), style.color);
}

void Canvas::fill(double left, double top, double right, double bottom, const Color& color, double opacity) {
  const auto share = [](double low, double high, int at) {
    return std::max(0.0, std::min(high, at + 1.0) - std::max(low, static_cast<double>(at)));
  };
  for (int y = std::max(0, static_cast<int>(top)); y < std::min<double>(image_.height, bottom); ++y) {
    for (int x = std::max(0, static_cast<int>(left)); x < std::min<double>(image_.width, right); ++x)
      blend(x, y, color, static_cast<float>(opacity * share(left, right, x) * share(top, bottom, y)));
  }
}

void Canvas::paste(const Image& other, int x, int y) {
  for (int row = std::max(0, -y); row < std::min(other.height, image_.height - y); ++row) {
    for (int column = std::max(0, -x); column < std::min(other.width, image_.width - x); ++column)
      std::copy_n(other.pixel(column, row), 3, image_.pixel(x + column, y + row));
  }
}

}  // namespace rigor
