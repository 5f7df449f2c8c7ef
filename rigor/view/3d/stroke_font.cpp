#include "rigor/view/3d/stroke_font.hpp"

#include "rigor/core/quoted.hpp"

#include <algorithm>
#include <array>
#include <string>

namespace rigor {

namespace {

/// A glyph: its width, then its strokes, separated by spaces. A stroke is a row of points, each an x digit
/// and a y character: 0 to 9, or a, b for -1, -2. With ~ before it, the points are the control points of a
/// curve (a quadratic B-spline from the first to the last).
struct Glyph {
  std::string_view character;
  std::string_view strokes;
};

constexpr std::array glyphs = {
    Glyph{" ", "2"},
    Glyph{"!", "0 0702 0000"},
    Glyph{"\"", "2 0705 2725"},
    Glyph{"#", "4 1017 3037 0242 0545"},
    Glyph{"$", "4 ~46470704444000 ~400001 282a"},
    Glyph{"%", "5 0057 ~170705252717 ~403032525040"},
    Glyph{"&", "5 ~50040737340200400053"},
    Glyph{"'", "0 0705"},
    Glyph{"(", "2 ~2806012a"},
    Glyph{")", "2 ~0826210a"},
    Glyph{"*", "4 2226 0345 0543"},
    Glyph{"+", "4 2125 0343"},
    Glyph{",", "1 100b"},
    Glyph{"-", "3 0333"},
    Glyph{".", "0 0000"},
    Glyph{"/", "3 0a38"},
    Glyph{"0", "4 ~270700404727"},
    Glyph{"1", "3 052720"},
    Glyph{"2", "4 ~050747441200 0040"},
    Glyph{"3", "4 ~0607474414 ~1444400001"},
    Glyph{"4", "4 30370242"},
    Glyph{"5", "4 470704 ~042444402000"},
    Glyph{"6", "4 ~464707020040440402"},
    Glyph{"7", "4 074710"},
    Glyph{"8", "4 ~270704444727 ~240400404424"},
    Glyph{"9", "4 ~010040454707034345"},
    Glyph{":", "0 0000 0404"},
    Glyph{";", "1 100b 1414"},
    Glyph{"<", "4 460340"},
    Glyph{"=", "4 0242 0444"},
    Glyph{">", "4 064300"},
    Glyph{"?", "4 ~060747442422 2020"},
    Glyph{"@", "6 ~600007676141 ~4143 ~432523214143"},
    Glyph{"A", "4 002740 1333"},
    Glyph{"B", "4 0007 ~073747443404 ~043444403000"},
    Glyph{"C", "5 ~565707005051"},
    Glyph{"D", "5 0007 ~073757503000"},
    Glyph{"E", "4 47070040 0434"},
    Glyph{"F", "4 470700 0434"},
    Glyph{"G", "5 ~565707005053 5333"},
    Glyph{"H", "5 0007 5057 0454"},
    Glyph{"I", "0 0007"},
    Glyph{"J", "3 3732 ~32300001"},
    Glyph{"K", "4 0007 4703 1440"},
    Glyph{"L", "4 070040"},
    Glyph{"M", "6 0007336760"},
    Glyph{"N", "5 00075057"},
    Glyph{"O", "6 ~370700606737"},
    Glyph{"P", "4 0007 ~072747432303"},
    Glyph{"Q", "6 ~370700606737 426a"},
    Glyph{"R", "4 0007 ~072747432303 2340"},
    Glyph{"S", "4 ~4647070444400001"},
    Glyph{"T", "4 0747 2720"},
    Glyph{"U", "4 0702 4742 ~02004042"},
    Glyph{"V", "4 072047"},
    Glyph{"W", "6 0710365067"},
    Glyph{"X", "4 0047 0740"},
    Glyph{"Y", "4 072347 2320"},
    Glyph{"Z", "4 07470040"},
    Glyph{"[", "2 28080a2a"},
    Glyph{"\\", "3 083a"},
    Glyph{"]", "2 08282a0a"},
    Glyph{"^", "4 042744"},
    Glyph{"_", "4 0a4a"},
    Glyph{"`", "1 0715"},
    Glyph{"a", "4 ~250500404525 4540"},
    Glyph{"b", "4 ~250500404525 0700"},
    Glyph{"c", "4 ~444505004041"},
    Glyph{"d", "4 ~250500404525 4740"},
    Glyph{"e", "4 0343 ~434505004041"},
    Glyph{"f", "3 ~371715 1510 0535"},
    Glyph{"g", "4 ~250500404525 4540 ~404b0b0a"},
    Glyph{"h", "4 0700 ~03054542 4240"},
    Glyph{"i", "0 0500 0707"},
    Glyph{"j", "1 1510 ~101b0b 1717"},
    Glyph{"k", "3 0700 3502 1330"},
    Glyph{"l", "0 0700"},
    Glyph{"m", "6 0500 ~03053532 3230 ~33356562 6260"},
    Glyph{"n", "4 0500 ~03054542 4240"},
    Glyph{"o", "4 ~250500404525"},
    Glyph{"p", "4 ~250500404525 050b"},
    Glyph{"q", "4 ~250500404525 454b"},
    Glyph{"r", "3 0500 ~020535"},
    Glyph{"s", "3 ~3435050332300001"},
    Glyph{"t", "3 1712 ~121030 0535"},
    Glyph{"u", "4 0502 ~02004043 4540"},
    Glyph{"v", "4 052045"},
    Glyph{"w", "6 0510355065"},
    Glyph{"x", "4 0540 0045"},
    Glyph{"y", "4 0520 451b"},
    Glyph{"z", "4 05450040"},
    Glyph{"{", "2 ~28181403 ~03131a2a"},
    Glyph{"|", "0 080b"},
    Glyph{"}", "2 ~08181423 ~23131a0a"},
    Glyph{"~", "4 ~0205254144"},
    Glyph{"·", "0 0303"},
    Glyph{"°", "2 ~170705252717"},
    Glyph{"−", "4 0343"},
    Glyph{"–", "4 0343"},
    Glyph{"×", "4 0145 0541"},
    Glyph{"µ", "4 050b ~02004043 4540"},
    Glyph{"ω", "6 ~1505003033 ~3330606555"},
};
constexpr std::string_view unknown = "4 0007474000";

/// Superscript digits and signs are those of the base line, only smaller.
struct Raised {
  std::string_view character, base;
};
constexpr std::array raised_characters = {Raised{"⁰", "0"}, Raised{"¹", "1"}, Raised{"²", "2"},
                                          Raised{"³", "3"}, Raised{"⁴", "4"}, Raised{"⁵", "5"},
                                          Raised{"⁶", "6"}, Raised{"⁷", "7"}, Raised{"⁸", "8"},
                                          Raised{"⁹", "9"}, Raised{"⁻", "-"}};

constexpr double glyph_gap = 1.9;
constexpr double raised_size = 0.6, raised_height = 4;

Vec2 point_of(char x, char y) {
  return {x - '0', y >= 'a' ? 'a' - y - 1 : y - '0'};
}

Polyline points_of(std::string_view stroke) {
  Polyline points;
  for (std::size_t i = 0; i + 1 < stroke.size(); i += 2) points.push_back(point_of(stroke[i], stroke[i + 1]));
  return points;
}

/// The curve of the control points as short segments: parabolas that meet halfway between control points.
Polyline curve(const Polyline& controls) {
  constexpr int pieces = 8;
  Polyline line = {controls.front()};
  for (std::size_t i = 1; i + 1 < controls.size(); ++i) {
    const Vec2 begin = line.back();
    const Vec2& control = controls[i];
    const Vec2 end = i + 2 < controls.size() ? Vec2(0.5 * (control + controls[i + 1])) : controls[i + 1];
    for (int k = 1; k <= pieces; ++k) {
      const double s = static_cast<double>(k) / pieces;
      line.push_back((1 - s) * (1 - s) * begin + 2 * s * (1 - s) * control + s * s * end);
    }
  }
  return line;
}

std::string_view strokes_of(std::string_view character) {
  const auto found = std::find_if(glyphs.begin(), glyphs.end(),
                                  [&](const Glyph& glyph) { return glyph.character == character; });
  return found == glyphs.end() ? unknown : found->strokes;
}

struct Place {
  double x, y, scale;
};
/// Adds the lines of a glyph and returns its width.
double add_glyph(std::string_view strokes, const Place& place, std::vector<Polyline>& lines) {
  const double width = strokes[0] - '0';
  for (std::size_t at = 1; at < strokes.size();) {
    const std::size_t begin = at + 1, end = std::min(strokes.find(' ', begin), strokes.size());
    const bool is_curve = strokes[begin] == '~';
    const Polyline points = points_of(strokes.substr(begin + is_curve, end - begin - is_curve));
    Polyline line = is_curve && points.size() > 2 ? curve(points) : points;
    for (Vec2& point : line) point = Vec2(place.x, place.y) + place.scale * point;
    lines.push_back(std::move(line));
    at = end;
  }
  return place.scale * width;
}

}  // namespace

TextLines text_lines(std::string_view utf8) {
  TextLines text{{}, 0};
  double x = 0;
  while (!utf8.empty()) {
    const std::size_t length = static_cast<std::size_t>(std::max(1, utf8_length(utf8)));
    const std::string_view character = utf8.substr(0, length);
    utf8.remove_prefix(length);
    const auto raised = std::find_if(raised_characters.begin(), raised_characters.end(),
                                     [&](const Raised& r) { return r.character == character; });
    const bool is_raised = raised != raised_characters.end();
    const Place place{x, is_raised ? raised_height : 0, is_raised ? raised_size : 1};
    text.width = x + add_glyph(strokes_of(is_raised ? raised->base : character), place, text.lines);
    x = text.width + glyph_gap * (is_raised ? raised_size : 1);
  }
  return text;
}

}  // namespace rigor
