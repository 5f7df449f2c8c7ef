#include "rigor/view/3d/shape_colors.hpp"

#include "rigor/core/index.hpp"
#include "rigor/geometry/shape/shape_data.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <map>
#include <string>
#include <string_view>
#include <tuple>

namespace rigor {

namespace {

/// Parts of names of materials, and the colour of what is called so. The viewer has the same
/// (viewer/src/materials.ts).
struct NamedColor {
  std::string_view word, color;
};
constexpr std::array named_colors = {
    NamedColor{"brass", "#c7a04a"},  NamedColor{"gold", "#c7a04a"},    NamedColor{"bronze", "#c7a04a"},
    NamedColor{"copper", "#bf7a4e"}, NamedColor{"steel", "#a9b3bd"},   NamedColor{"iron", "#a9b3bd"},
    NamedColor{"metal", "#a9b3bd"},  NamedColor{"alumin", "#a9b3bd"},  NamedColor{"wood", "#c18d57"},
    NamedColor{"oak", "#c18d57"},    NamedColor{"beech", "#c18d57"},   NamedColor{"timber", "#c18d57"},
    NamedColor{"rubber", "#5d636c"}, NamedColor{"felt", "#5d636c"},    NamedColor{"stone", "#a8a196"},
    NamedColor{"rock", "#a8a196"},   NamedColor{"granite", "#a8a196"}, NamedColor{"concrete", "#a8a196"},
    NamedColor{"brick", "#a8a196"},  NamedColor{"sand", "#a8a196"},    NamedColor{"ice", "#a6cfe2"},
    NamedColor{"glass", "#a6cfe2"},  NamedColor{"ivory", "#d9d3c4"},   NamedColor{"plastic", "#d9d3c4"},
};
constexpr std::array<std::string_view, 4> few_colors = {"#5f8fb8", "#d19a5b", "#6fa78a", "#b185ad"};
constexpr int most_colors = 12;

/// The colour that the name of a material tells; null if it tells none.
const NamedColor* color_of_name(std::string name) {
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const auto* const found =
      std::find_if(named_colors.begin(), named_colors.end(),
                   [&](const NamedColor& known) { return name.find(known.word) != std::string::npos; });
  return found != named_colors.end() ? found : nullptr;
}

/// A brightness from 0.75 to 1.2 that neighbours by number do not share (steps of the golden ratio).
float shade_of(int body) {
  constexpr double golden = 0.61803398875;
  double whole = 0;
  return static_cast<float>(0.75 + 0.45 * std::modf(golden * body, &whole));
}

}  // namespace

ShapeColors::ShapeColors(const Model& model) : model_(model) {
  // Forms are numbered in the order in which they come; pointers are only compared, so their order does not
  // matter.
  using Form = std::vector<std::tuple<std::size_t, const void*, std::array<double, 4>>>;
  std::map<Form, int> numbers;
  int dynamic = 0;
  for (const Body& body : model.bodies()) {
    Form form;
    for (const BodyShape& shape : body.shapes) {
      const ShapeData data = shape_data(shape.shape);
      form.emplace_back(shape.shape.index(), data.shared, data.own);
    }
    dynamic += body.motion == MotionType::dynamic ? 1 : 0;
    forms_.push_back(
        body.motion == MotionType::dynamic
            ? numbers.try_emplace(std::move(form), static_cast<int>(numbers.size())).first->second
            : 0);
  }
  is_crowd_ = dynamic > most_colors;
}

Color ShapeColors::of(int index, const BodyShape& shape) const {
  if (!shape.color.empty()) return color_from_hex(shape.color);
  if (std::holds_alternative<HalfSpace>(shape.shape)) return color_from_hex("#e7e8ea");
  const Body& body = model_.body(index);
  const bool has_material = at(shape.material) < model_.materials().size();
  const NamedColor* const named =
      has_material ? color_of_name(model_.materials()[at(shape.material)].name) : nullptr;
  if (body.motion == MotionType::fixed) {
    const Color grey = color_from_hex("#a8adb3");
    return named ? Color(0.6F * grey + 0.4F * color_from_hex(named->color)) : grey;
  }
  if (!is_crowd_ || body.motion != MotionType::dynamic) return palette_color(index);
  // Forms of one material are told apart by how light they are.
  constexpr std::array<float, 3> tones = {1, 0.62F, 1.35F};
  const std::size_t form = at(forms_[at(index)]);
  const std::string_view color = named ? named->color : few_colors[form % few_colors.size()];
  const float tone = named ? tones[form % tones.size()] : 1;
  return (tone * shade_of(index) * color_from_hex(color)).cwiseMin(1);
}

}  // namespace rigor
