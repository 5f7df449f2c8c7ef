#include "rigor/bulk/bulk_contacts.hpp"

#include "rigor/bulk/list_room.hpp"
#include "rigor/bulk/manifold_bounce.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

namespace rigor {

namespace {

constexpr double contact_damping = 5;

ManifoldSurface surface_of(const PairCoefficients& pair) {
  return {static_cast<float>(pair.friction), static_cast<float>(pair.restitution),
          static_cast<float>(pair.torsional_friction), static_cast<float>(pair.rolling_friction)};
}

bool does_press(const ManifoldMemory& memory) {
  const auto end = memory.normal_impulse.begin() + memory.point_count;
  return std::any_of(memory.normal_impulse.begin(), end, [](float impulse) { return impulse > 0; });
}

}  // namespace

BulkContacts::BulkContacts(const Model& model) : material_count_(model.materials().size()) {
  const int count = static_cast<int>(material_count_);
  for (int a = 0; a < count; ++a) {
    for (int b = 0; b < count; ++b) surfaces_.push_back(surface_of(model.coefficients(a, b)));
  }
  first_shape_.reserve(model.bodies().size());
  materials_.reserve(model.bodies().size());
  for (const Body& body : model.bodies()) {
    first_shape_.push_back(static_cast<int>(materials_.size()));
    for (const BodyShape& shape : body.shapes) materials_.push_back(shape.material);
  }
}

void BulkContacts::match(const std::vector<ShapePair>& pairs, const std::vector<PairManifold>& manifolds,
                         const std::vector<ManifoldMemory>& memory, const Executor& executor) {
  pairs_ = &pairs;
  manifolds_ = &manifolds;
  memory_ = &memory;
  totals_.clear();
  renew(manifolds.size(), matches_);
  executor.for_ranges(static_cast<int>(manifolds.size()), 1024, [&](int begin, int end) {
    match_range(static_cast<std::size_t>(begin), static_cast<std::size_t>(end));
  });
}

/// Both lists are in the order of keys.
void BulkContacts::match_range(std::size_t begin, std::size_t end) {
  const std::vector<ManifoldMemory>& memory = *memory_;
  const auto key_before = [](const ManifoldMemory& m, const std::array<int, 5>& key) {
    return m.key() < key;
  };
  std::size_t next = memory.size();
  for (std::size_t i = begin; i < end; ++i) {
    const PairManifold& found = (*manifolds_)[i];
    const ShapePair& pair = (*pairs_)[static_cast<std::size_t>(found.pair)];
    const std::array<int, 5> key = {pair.body_A, pair.body_B, pair.shape_A, pair.shape_B, found.part};
    if (i == begin)
      next = static_cast<std::size_t>(std::lower_bound(memory.begin(), memory.end(), key, key_before) -
                                      memory.begin());
    while (next < memory.size() && memory[next].key() < key) ++next;
    Match& match = matches_[i];
    match = {.surface = material_of(pair.body_A, pair.shape_A) * static_cast<int>(material_count_) +
                        material_of(pair.body_B, pair.shape_B)};
    if (next == memory.size() || memory[next].key() != key) continue;
    match.memory = static_cast<int>(next);
    match.energy = memory[next].energy;
    match.is_new = !does_press(memory[next]);
  }
}

int BulkContacts::material_of(int body, int shape) const {
  return materials_[static_cast<std::size_t>(first_shape_[static_cast<std::size_t>(body)] + shape)];
}

StepManifold BulkContacts::manifold_at(std::size_t i) const {
  const PairManifold& found = (*manifolds_)[i];
  const Match& match = matches_[i];
  return {&found.manifold,
          &(*pairs_)[static_cast<std::size_t>(found.pair)],
          found.part,
          match.memory < 0 ? nullptr : &(*memory_)[static_cast<std::size_t>(match.memory)],
          &surfaces_[static_cast<std::size_t>(match.surface)],
          match.is_new};
}

std::vector<StepManifold> BulkContacts::manifolds() const {
  std::vector<StepManifold> all;
  all.reserve(matches_.size());
  for (std::size_t i = 0; i < matches_.size(); ++i) all.push_back(manifold_at(i));
  return all;
}

ManifoldMemory BulkContacts::key_of(std::size_t i) const {
  const PairManifold& found = (*manifolds_)[i];
  const ShapePair& pair = (*pairs_)[static_cast<std::size_t>(found.pair)];
  ManifoldMemory key;
  key.body_A = pair.body_A;
  key.body_B = pair.body_B;
  key.shape_A = pair.shape_A;
  key.shape_B = pair.shape_B;
  key.part = found.part;
  key.point_count = found.manifold.point_count;
  for (std::size_t k = 0; k < static_cast<std::size_t>(key.point_count); ++k)
    key.feature[k] = found.manifold.points[k].feature;
  return key;
}

void BulkContacts::prepare(const BulkBodies& bodies, double h, const DirectIslands& direct,
                           const Executor& executor) {
  swept_.clear();
  edges_.clear();
  make_room(matches_.size(), swept_);
  make_room(matches_.size(), edges_);
  for (std::size_t i = 0; i < matches_.size(); ++i) {
    const ShapePair& pair = (*pairs_)[static_cast<std::size_t>((*manifolds_)[i].pair)];
    const int a = pair.body_A, b = pair.body_B;
    if (direct.holds(a) || direct.holds(b)) continue;
    swept_.push_back(static_cast<int>(i));
    edges_.push_back({bodies.is_dynamic(a) ? a : -1, bodies.is_dynamic(b) ? b : -1});
  }
  colour_graph(edges_, bodies.count(), colouring_);

  const double frequency = contact_frequency_a_substep / h;
  const Softness between_moving = make_softness(frequency, contact_damping, h);
  const Softness on_ground = make_softness(2 * frequency, contact_damping, h);
  renew(colouring_.blocks.size(), blocks_);
  executor.for_ranges(static_cast<int>(blocks_.size()), 16, [&](int begin, int end) {
    for (int k = begin; k < end; ++k) {
      std::array<BlockLane, kLaneCount> lanes;
      std::size_t count = 0;
      for (const int edge : colouring_.blocks[static_cast<std::size_t>(k)]) {
        if (edge < 0) break;
        const std::size_t e = static_cast<std::size_t>(edge);
        const int number = swept_[e];
        const StepManifold found = manifold_at(static_cast<std::size_t>(number));
        const bool both_move = edges_[e].a >= 0 && edges_[e].b >= 0;
        lanes[count++] = {found.manifold, found.surface,     both_move ? &between_moving : &on_ground,
                          found.memory,   found.key->body_A, found.key->body_B,
                          number};
      }
      fill_block(target_, std::span(lanes.data(), count), bodies, blocks_[static_cast<std::size_t>(k)]);
    }
  });
  has_restitution_ = std::any_of(blocks_.begin(), blocks_.end(),
                                 [](const ManifoldBlock& block) { return block.has_restitution; });
}

template <class Work>
void BulkContacts::for_blocks(const Executor& executor, const Work& work) {
  for (int colour = 0; colour < colouring_.colour_count(); ++colour) {
    const int first = colouring_.colour_begin[static_cast<std::size_t>(colour)];
    const int count = colouring_.colour_begin[static_cast<std::size_t>(colour) + 1] - first;
    const int grain = colour == serial_colour ? count : 4;
    executor.for_ranges(count, std::max(grain, 1), [&](int begin, int end) {
      for (int k = begin; k < end; ++k) work(blocks_[static_cast<std::size_t>(first + k)]);
    });
  }
}

void BulkContacts::warm_start(BulkBodies& bodies, const Executor& executor) {
  for_blocks(executor, [&](ManifoldBlock& block) { warm_start_block(target_, block, bodies); });
}

void BulkContacts::solve(BlockPass pass, float h, BulkBodies& bodies, const Executor& executor) {
  for_blocks(executor, [&](ManifoldBlock& block) { solve_block(target_, pass, h, block, bodies); });
}

bool BulkContacts::find_bounces(const BulkBodies& bodies, const Executor& executor) {
  bounces_.resize(blocks_.size());
  executor.for_ranges(static_cast<int>(blocks_.size()), 64, [&](int begin, int end) {
    for (std::size_t k = static_cast<std::size_t>(begin); k < static_cast<std::size_t>(end); ++k) {
      const ManifoldBlock& block = blocks_[k];
      bounces_[k].does_any = false;
      for (int lane = 0; block.has_restitution && lane < kLaneCount; ++lane) {
        const std::size_t i = static_cast<std::size_t>(lane);
        const bool does = bounces(block, totals_[k], lane);
        const double e = block.restitution[i];
        bounces_[k].most[i] = does ? e * e * energy_taken(block, totals_[k], lane, bodies) : 0;
        bounces_[k].does_any = bounces_[k].does_any || does;
      }
    }
  });
  return std::any_of(bounces_.begin(), bounces_.end(), [](const BlockBounces& b) { return b.does_any; });
}

void BulkContacts::bounce_apart(const Model& model, BulkBodies& bodies, const Executor& executor) {
  for_blocks(executor, [&](ManifoldBlock& block) {
    const std::size_t k = static_cast<std::size_t>(&block - blocks_.data());
    for (int lane = 0; bounces_[k].does_any && lane < kLaneCount; ++lane) {
      const double most = bounces_[k].most[static_cast<std::size_t>(lane)];
      if (most > 0) bounce(model, block, lane, most, totals_[k], bodies);
    }
  });
}

std::vector<ManifoldMemory> BulkContacts::keys() const {
  std::vector<ManifoldMemory> keys;
  for (std::size_t i = 0; i < matches_.size(); ++i) keys.push_back(key_of(i));
  return keys;
}

void BulkContacts::add_up(const Executor& executor) {
  make_room(blocks_.size(), totals_);
  totals_.resize(blocks_.size());
  executor.for_ranges(static_cast<int>(blocks_.size()), 64, [&](int begin, int end) {
    for (int k = begin; k < end; ++k)
      totals_[static_cast<std::size_t>(k)].add(blocks_[static_cast<std::size_t>(k)]);
  });
}

void BulkContacts::remember(const BulkBodies& bodies, double h, int substeps, const Executor& executor,
                            std::vector<ManifoldMemory>& memory) const {
  renew(matches_.size(), memory);
  executor.for_ranges(static_cast<int>(matches_.size()), 1024, [&](int begin, int end) {
    for (std::size_t i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
      memory[i] = key_of(i);
  });
  executor.for_ranges(static_cast<int>(blocks_.size()), 64, [&](int begin, int end) {
    for (std::size_t k = static_cast<std::size_t>(begin); k < static_cast<std::size_t>(end); ++k) {
      for (int lane = 0; lane < kLaneCount; ++lane) {
        const int number = blocks_[k].manifold[static_cast<std::size_t>(lane)];
        if (number < 0) continue;
        ManifoldMemory& remembered = memory[static_cast<std::size_t>(number)];
        read_lane(blocks_[k], lane, remembered);
        if (totals_.empty()) continue;
        const double held = matches_[static_cast<std::size_t>(number)].energy;
        remembered.energy =
            static_cast<float>(spring_energy(blocks_[k], totals_[k], lane, bodies, h, substeps, held));
      }
    }
  });
}

}  // namespace rigor
