#include "rigor/bulk/bulk_contacts.hpp"

#include "rigor/bulk/contact_measures.hpp"
#include "rigor/bulk/list_room.hpp"
#include "rigor/bulk/manifold_bounce.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <span>

namespace rigor {

namespace {

constexpr double contact_damping = 5;

ManifoldSurface surface_of(const PairCoefficients& pair) {
  return {static_cast<float>(pair.friction), static_cast<float>(pair.restitution),
          static_cast<float>(pair.torsional_friction), static_cast<float>(pair.rolling_friction)};
}

bool does_press(const ManifoldMemories::View& memory) {
  return std::any_of(memory.normal_impulse, memory.normal_impulse + memory.point_count,
                     [](float impulse) { return impulse > 0; });
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
    is_round_.push_back((body.moments.array() == body.moments[0]).all());
  }
}

void BulkContacts::match(const std::vector<ShapePair>& pairs, const ManifoldList& manifolds,
                         const ManifoldMemories& memory, const Executor& executor) {
  pairs_ = &pairs;
  manifolds_ = &manifolds;
  memory_ = &memory;
  blocks_.clear_totals();
  renew(manifolds.size(), matches_);
  executor.for_ranges(static_cast<int>(manifolds.size()), 1024, [&](int begin, int end) {
    match_range(static_cast<std::size_t>(begin), static_cast<std::size_t>(end));
  });
}

/// Both lists are in the order of keys.
void BulkContacts::match_range(std::size_t begin, std::size_t end) {
  const ManifoldMemories& memory = *memory_;
  std::size_t next = memory.size();
  for (std::size_t i = begin; i < end; ++i) {
    const ShapePair& pair = pair_of(i);
    const std::array<int, 5> key = {pair.body_A, pair.body_B, pair.shape_A, pair.shape_B,
                                    manifolds_->part(i)};
    if (i == begin) next = memory.find_from(key);
    bool is_same = false;
    for (; next < memory.size(); ++next) {
      const std::strong_ordering order = memory.order(next, key);
      is_same = order == 0;
      if (order >= 0) break;
    }
    Match& match = matches_[i];
    match = {};
    match.surface = static_cast<std::uint32_t>(material_of(pair.body_A, pair.shape_A) *
                                                   static_cast<int>(material_count_) +
                                               material_of(pair.body_B, pair.shape_B)) &
                    0x7fffffffu;
    if (next == memory.size() || !is_same) continue;
    match.memory = static_cast<int>(next);
    match.energy = memory.energy(next);
    match.is_new = !does_press(memory.view(next));
  }
}

int BulkContacts::material_of(int body, int shape) const {
  return materials_[static_cast<std::size_t>(first_shape_[static_cast<std::size_t>(body)] + shape)];
}

StepManifold BulkContacts::manifold_at(std::size_t i) const {
  const Match& match = matches_[i];
  return {manifolds_->view(i),
          &pair_of(i),
          manifolds_->part(i),
          match.memory < 0 ? ManifoldMemories::View{} : memory_->view(static_cast<std::size_t>(match.memory)),
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
  const ShapePair& pair = pair_of(i);
  ManifoldMemory key;
  key.body_A = pair.body_A;
  key.body_B = pair.body_B;
  key.shape_A = pair.shape_A;
  key.shape_B = pair.shape_B;
  key.part = manifolds_->part(i);
  key.point_count = manifolds_->point_count(i);
  for (std::size_t k = 0; k < static_cast<std::size_t>(key.point_count); ++k)
    key.feature[k] = manifolds_->view(i).points[k].feature;
  return key;
}

void BulkContacts::prepare(const BulkBodies& bodies, double h, const DirectIslands& direct,
                           const Executor& executor) {
  colour(bodies, direct);
  blocks_.arrange(colouring_);
  const double frequency = contact_frequency_a_substep / h;
  const Softness between_moving = make_softness(frequency, contact_damping, h);
  const Softness on_ground = make_softness(2 * frequency, contact_damping, h);
  executor.for_ranges(blocks_.count(), 16, [&](int begin, int end) {
    blocks_.for_blocks(begin, end, [&](auto& block, int number) {
      std::array<BlockLane, kLaneCount> lanes;
      std::size_t count = 0;
      for (int lane = 0; lane < kLaneCount && manifold_of(number, lane) >= 0; ++lane) {
        const std::size_t i = static_cast<std::size_t>(manifold_of(number, lane));
        const Match& match = matches_[i];
        const ShapePair& key = pair_of(i);
        const bool both_move = bodies.is_dynamic(key.body_A) && bodies.is_dynamic(key.body_B);
        BlockLane& own = lanes[count++];
        own.manifold = manifolds_->view(i);
        own.surface = &surfaces_[static_cast<std::size_t>(match.surface)];
        own.softness = both_move ? &between_moving : &on_ground;
        if (match.memory >= 0) own.memory = memory_->view(static_cast<std::size_t>(match.memory));
        own.body_A = key.body_A;
        own.body_B = key.body_B;
      }
      fill_block(target_, std::span(lanes.data(), count), bodies, block);
    });
  });
}

/// Colours all manifolds but those of the islands that were solved directly.
void BulkContacts::colour(const BulkBodies& bodies, const DirectIslands& direct) {
  std::vector<int> swept(matches_.size());
  std::vector<ConstraintEdge> edges(matches_.size());
  std::vector<std::uint8_t> kinds(matches_.size());
  std::size_t count = 0;
  has_restitution_ = false;
  for (std::size_t i = 0; i < matches_.size(); ++i) {
    const ShapePair& pair = pair_of(i);
    const int a = pair.body_A, b = pair.body_B;
    if (direct.holds(a) || direct.holds(b)) continue;
    const ManifoldSurface& surface = surfaces_[static_cast<std::size_t>(matches_[i].surface)];
    const int points = manifolds_->point_count(i);
    const bool is_round =
        points == 1 && is_round_[static_cast<std::size_t>(a)] && is_round_[static_cast<std::size_t>(b)];
    has_restitution_ = has_restitution_ || surface.restitution > 0;
    swept[count] = static_cast<int>(i);
    edges[count] = {bodies.is_dynamic(a) ? a : -1, bodies.is_dynamic(b) ? b : -1};
    kinds[count] = static_cast<std::uint8_t>(find_block_kind(points, surface, is_round));
    ++count;
  }
  edges.resize(count);
  kinds.resize(count);
  is_all_swept_ = count == matches_.size();
  colour_graph(edges, kinds, bodies.count(), colouring_);
  for (auto& block : colouring_.blocks) {
    for (std::int32_t& edge : block) edge = edge < 0 ? -1 : swept[static_cast<std::size_t>(edge)];
  }
}

template <class Work>
void BulkContacts::for_colours(const Executor& executor, const Work& work) {
  for (int colour = 0; colour < colouring_.colour_count(); ++colour) {
    const int first = colouring_.colour_begin[static_cast<std::size_t>(colour)];
    const int count = colouring_.colour_begin[static_cast<std::size_t>(colour) + 1] - first;
    const int grain = colouring_.is_serial[static_cast<std::size_t>(colour)] ? count : 4;
    executor.for_ranges(count, std::max(grain, 1),
                        [&](int begin, int end) { work(first + begin, first + end); });
  }
}

void BulkContacts::warm_start(BulkBodies& bodies, const Executor& executor) {
  for_colours(executor, [&](int begin, int end) {
    blocks_.for_blocks(begin, end, [&](auto& block, int) { warm_start_block(target_, block, bodies); });
  });
}

void BulkContacts::solve(BlockPass pass, float h, BulkBodies& bodies, const Executor& executor) {
  for_colours(executor, [&](int begin, int end) {
    blocks_.for_blocks(begin, end, [&](auto& block, int) { solve_block(target_, pass, h, block, bodies); });
  });
}

void BulkContacts::add_up(const Executor& executor) {
  if (!blocks_.has_totals()) blocks_.make_totals();
  executor.for_ranges(blocks_.count(), 64, [&](int begin, int end) {
    blocks_.for_totals(begin, end, [](const auto& block, auto& total, int) {
      for (std::size_t k = 0; k < total.rows; ++k) {
        for (std::size_t i = 0; i < kLaneCount; ++i) total.row[k][i] += block.impulses.row[k][i];
      }
    });
  });
}

bool BulkContacts::find_bounces(const BulkBodies& bodies, const Executor& executor) {
  bounces_.assign(static_cast<std::size_t>(blocks_.count()), {});
  executor.for_ranges(blocks_.count(), 64, [&](int begin, int end) {
    blocks_.for_totals(begin, end, [&](const auto& block, const auto& total, int number) {
      BlockBounces& found = bounces_[static_cast<std::size_t>(number)];
      for (int lane = 0; lane < kLaneCount; ++lane) {
        if (manifold_of(number, lane) < 0) continue;
        const SolvedManifold own =
            read(block, total, lane, static_cast<std::size_t>(manifold_of(number, lane)));
        if (!bounces(own)) continue;
        found.does_any = true;
        found.most[static_cast<std::size_t>(lane)] =
            own.restitution * own.restitution * energy_taken(own, bodies);
      }
    });
  });
  return std::any_of(bounces_.begin(), bounces_.end(), [](const BlockBounces& b) { return b.does_any; });
}

void BulkContacts::bounce_apart(const Model& model, BulkBodies& bodies, const Executor& executor) {
  for_colours(executor, [&](int begin, int end) {
    blocks_.for_totals(begin, end, [&](const auto& block, auto& total, int number) {
      const BlockBounces& found = bounces_[static_cast<std::size_t>(number)];
      for (int lane = 0; found.does_any && lane < kLaneCount; ++lane) {
        const std::size_t i = static_cast<std::size_t>(lane);
        if (!(found.most[i] > 0)) continue;
        const std::size_t manifold = static_cast<std::size_t>(manifold_of(number, lane));
        const std::array<float, Manifold::max_points> impulses =
            bounce(model, read(block, total, lane, manifold), found.most[i], bodies);
        for (std::size_t k = 0; k < total.points; ++k) total.normal(k)[i] += impulses[k];
      }
    });
  });
}

std::vector<ManifoldMemory> BulkContacts::keys() const {
  std::vector<ManifoldMemory> keys;
  for (std::size_t i = 0; i < matches_.size(); ++i) keys.push_back(key_of(i));
  return keys;
}

void BulkContacts::remember(const BulkBodies& bodies, double h, int substeps, const Executor& executor,
                            ManifoldMemories& memory) {
  const bool has_energy = blocks_.has_totals();
  memory.arrange(matches_.size(), [&](std::size_t i) {
    const ShapePair& pair = pair_of(i);
    const ManifoldSurface& surface = surfaces_[static_cast<std::size_t>(matches_[i].surface)];
    const bool has_shapes = pair.shape_A != 0 || pair.shape_B != 0 || manifolds_->part(i) != 0;
    const bool has_moments = surface.torsional_friction > 0 || surface.rolling_friction > 0;
    const int points = manifolds_->point_count(i);
    return ManifoldMemories::Layout{points, has_shapes, has_moments || points > 1, has_moments, has_energy};
  });
  for (std::size_t i = 0; !is_all_swept_ && i < matches_.size(); ++i) {
    memory.put(i, key_of(i));
    if (has_energy) memory.set_energy(i, 0);
  }
  const auto for_lanes = [&](int number, const auto& work) {
    for (int lane = 0; lane < kLaneCount; ++lane) {
      const int manifold = manifold_of(number, lane);
      if (manifold >= 0) work(lane, static_cast<std::size_t>(manifold));
    }
  };
  executor.for_ranges(blocks_.count(), 64, [&](int begin, int end) {
    blocks_.for_blocks(begin, end, [&](const auto& block, int number) {
      for_lanes(number, [&](int lane, std::size_t i) {
        const ShapePair& pair = pair_of(i);
        const ManifoldView found = manifolds_->view(i);
        const ManifoldMemories::Slot slot =
            memory.put_key(i, {pair.body_A, pair.body_B, pair.shape_A, pair.shape_B, manifolds_->part(i)});
        for (int k = 0; k < found.point_count; ++k)
          slot.feature[k] = std::bit_cast<float>(found.points[k].feature);
        read_lane(block, lane, slot);
      });
    });
    if (!has_energy) return;
    blocks_.for_totals(begin, end, [&](const auto& block, const auto& total, int number) {
      for_lanes(number, [&](int lane, std::size_t i) {
        const SolvedManifold own = read_manifold(block, total, lane);
        memory.set_energy(i, static_cast<float>(spring_energy(own, bodies, h, substeps, matches_[i].energy)));
      });
    });
  });
}

}  // namespace rigor
