#include "rigor/model/model_changes.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/core/input_error.hpp"
#include "rigor/core/quoted.hpp"
#include "rigor/model/findings.hpp"
#include "rigor/model/limits.hpp"

namespace rigor {

ModelChanges unchanged(const Model& model) {
  ModelChanges changes{.g_W = model.g_W()};
  for (const Material& material : model.materials()) {
    changes.surfaces.push_back({material.friction, material.restitution});
  }
  return changes;
}

std::shared_ptr<const Model> changed_model(const Model& model, const ModelChanges& changes) {
  RIGOR_ASSERT(changes.surfaces.size() == model.materials().size());
  std::vector<std::string> messages;
  Model changed = model;
  changed.g_W_ = changes.g_W;
  Findings("", "world", messages).check("gravity", changes.g_W, limits::gravity, "m/s²");
  for (std::size_t i = 0; i < changes.surfaces.size(); ++i) {
    Material& material = changed.materials_[i];
    material.friction = changes.surfaces[i].friction;
    material.restitution = changes.surfaces[i].restitution;
    Findings findings("", "material " + quoted_text(material.name), messages);
    findings.check("friction", material.friction, limits::friction, "");
    findings.check("restitution", material.restitution, limits::restitution, "");
  }
  if (!messages.empty()) throw InputError(std::move(messages));
  changed.forces_.insert(changed.forces_.end(), changes.added_forces.begin(), changes.added_forces.end());
  return std::make_shared<const Model>(std::move(changed));
}

}  // namespace rigor
