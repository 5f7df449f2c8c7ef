#include "rigor/bulk/matching/step_manifolds.hpp"

#include "rigor/bulk/lanes/list_room.hpp"
#include "rigor/core/index.hpp"

#include <algorithm>
#include <compare>

namespace rigor {

namespace {

ManifoldSurface surface_of(const PairCoefficients& pair) {
  return {static_cast<float>(pair.friction), static_cast<float>(pair.restitution),
          static_cast<float>(pair.torsional_friction), static_cast<float>(pair.rolling_friction)};
}

bool does_press(const ManifoldMemories::View& memory) {
  return std::any_of(memory.normal_impulse, memory.normal_impulse + memory.point_count,
                     [](float impulse) { return impulse > 0; });
}

}  // namespace

StepManifolds::StepManifolds(const Model& model) : ranges_(model.bodies().size()) {
  materials_.reserve(model.bodies().size());
  for (int i = 0; i < model.body_count(); ++i) set_body(model, i);
  set_surfaces(model);
}

void StepManifolds::set_body(const Model& model, int body) {
  const BodyShapes& shapes = model.body(body).shapes;
  ranges_.give(body, static_cast<int>(shapes.size()));
  if (materials_.size() < ranges_.size()) materials_.resize(ranges_.size());
  for (std::size_t s = 0; s < shapes.size(); ++s)
    materials_[at(ranges_.begin(body)) + s] = shapes[s].material;
}

void StepManifolds::set_surfaces(const Model& model) {
  // Coefficients of all pairs of materials are looked up once.
  material_count_ = model.materials().size();
  surfaces_.clear();
  const int count = static_cast<int>(material_count_);
  for (int a = 0; a < count; ++a) {
    for (int b = 0; b < count; ++b) surfaces_.push_back(surface_of(model.coefficients(a, b)));
  }
}

void StepManifolds::match(const std::vector<ShapePair>& pairs, const ManifoldList& manifolds,
                          const ManifoldMemories& memory, const Executor& executor) {
  pairs_ = &pairs;
  manifolds_ = &manifolds;
  memory_ = &memory;
  renew(manifolds.size(), matches_);
  executor.for_ranges(static_cast<int>(manifolds.size()), 1024,
                      [&](int begin, int end) { match_range(at(begin), at(end)); });
}

/// Matches the manifolds [begin, end) with the memories of the step before. Both lists are in the order of
/// keys, so one pass over each is enough.
void StepManifolds::match_range(std::size_t begin, std::size_t end) {
  const ManifoldMemories& memory = *memory_;
  std::size_t next = memory.size();
  for (std::size_t i = begin; i < end; ++i) {
    const ShapePair& own = pair(i);
    const ContactKey key = {own.body_A, own.body_B, own.shape_A, own.shape_B, at(part(i))};
    // The search stops at the memory of the same shapes and part, or at the first one behind it.
    if (i == begin) next = memory.find_from(key);
    bool is_same = false;
    for (; next < memory.size(); ++next) {
      const std::strong_ordering order = memory.order(next, key);
      is_same = order == 0;
      if (order >= 0) break;
    }
    // A manifold without a memory begins with no impulse and no energy.
    Match& match = matches_[i];
    match = {};
    match.surface =
        static_cast<std::uint32_t>(material_of(own.body_A, own.shape_A) * static_cast<int>(material_count_) +
                                   material_of(own.body_B, own.shape_B)) &
        0x7fffffffu;
    if (next == memory.size() || !is_same) continue;
    match.memory = static_cast<int>(next);
    match.energy = memory.energy(next);
    match.is_new = !does_press(memory.view(next));
  }
}

int StepManifolds::material_of(int body, int shape) const {
  return materials_[at(ranges_.begin(body) + shape)];
}

ManifoldMemory StepManifolds::key(std::size_t i) const {
  // The key names the shapes and the part; features name the points.
  const ShapePair& own = pair(i);
  const ManifoldView found = view(i);
  ManifoldMemory key;
  key.body_A = own.body_A;
  key.body_B = own.body_B;
  key.shape_A = own.shape_A;
  key.shape_B = own.shape_B;
  key.part = part(i);
  key.point_count = found.point_count;
  for (std::size_t k = 0; k < at(key.point_count); ++k) key.feature[k] = found.points[k].feature;
  return key;
}

}  // namespace rigor
