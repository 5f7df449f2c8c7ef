// The materials of a ModelEditor.

#include "rigor/core/index.hpp"
#include "rigor/core/input_error.hpp"
#include "rigor/core/quoted.hpp"
#include "rigor/model/material_checks.hpp"
#include "rigor/model/model_editor.hpp"

#include <algorithm>
#include <utility>

namespace rigor {

namespace {

void require_valid(const Material& material) {
  std::vector<std::string> messages;
  Findings findings("", "material " + quoted_text(material.name), messages);
  check_material(material, findings);
  if (!messages.empty()) throw InputError(std::move(messages));
}

}  // namespace

int ModelEditor::add_material(const Material& material) {
  require_valid(material);
  if (materials_.index.count(material.name) > 0)
    throw InputError(
        {"material " + quoted_text(material.name) + ": there is already a material of this name"});
  int number = static_cast<int>(materials_.materials.size());
  if (free_materials_.empty()) {
    materials_.materials.emplace_back();
    model_->materials_.emplace_back();
    material_uses_.push_back(0);
  } else {
    // The lowest free number, whatever the order in which they became free.
    const auto lowest = std::min_element(free_materials_.begin(), free_materials_.end());
    number = *lowest;
    free_materials_.erase(lowest);
  }
  materials_.index[material.name] = number;
  materials_.materials[at(number)] = model_->materials_[at(number)] = material;
  return number;
}

void ModelEditor::set_material(int material, const Material& to) {
  Material changed = to;
  changed.name = model_->materials_[at(material)].name;
  require_valid(changed);
  materials_.materials[at(material)] = model_->materials_[at(material)] = changed;
}

void ModelEditor::set_pair(int a, int b, const PairCoefficients& coefficients) {
  std::vector<std::string> messages;
  Findings findings("",
                    "pair " + quoted_text(model_->materials_[at(a)].name) + ", " +
                        quoted_text(model_->materials_[at(b)].name),
                    messages);
  check_coefficients(coefficients, findings);
  if (!messages.empty()) throw InputError(std::move(messages));
  model_->pair_overrides_[std::minmax(a, b)] = coefficients;
}

bool ModelEditor::is_in_use(int material) const {
  return material_uses_[at(material)] > 0;
}

void ModelEditor::remove_material(int material) {
  materials_.index.erase(materials_.materials[at(material)].name);
  std::erase_if(model_->pair_overrides_, [material](const auto& pair) {
    return pair.first.first == material || pair.first.second == material;
  });
  materials_.materials[at(material)] = model_->materials_[at(material)] = Material{};
  free_materials_.push_back(material);
}

}  // namespace rigor
