#include "rigor/bulk/contacts/bulk_contacts.hpp"

#include "rigor/bulk/contacts/contact_measures.hpp"
#include "rigor/bulk/contacts/manifold_bounce.hpp"
#include "rigor/core/index.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <limits>
#include <span>

namespace rigor {

namespace {

constexpr double contact_damping = 5;

}  // namespace

namespace {

/// Lessens all impulses of a memory in one part, to a normal impulse of `most` [N s].
void lessen_impulses(float most, const ManifoldMemories::Slot& slot) {
  float pressed = 0;
  for (int k = 0; k < slot.point_count; ++k) pressed += slot.normal_impulse[k];
  if (!(pressed > most)) return;
  const float part = most / pressed;
  for (int k = 0; k < slot.point_count; ++k) slot.normal_impulse[k] *= part;
  for (int k = 0; k < 3; ++k) {
    slot.friction_impulse_W[k] *= part;
    if (slot.rolling_impulse_W != nullptr) slot.rolling_impulse_W[k] *= part;
  }
  if (slot.twist_impulse != nullptr) *slot.twist_impulse *= part;
}

bool has_equal_moments(const Body& body) {
  return (body.moments.array() == body.moments[0]).all();
}

}  // namespace

BulkContacts::BulkContacts(const Model& model) : manifolds_(model) {
  for (const Body& body : model.bodies()) is_round_.push_back(has_equal_moments(body));
}

void BulkContacts::set_body(const Model& model, int body) {
  is_round_[at(body)] = has_equal_moments(model.body(body));
  manifolds_.set_body(model, body);
}

void BulkContacts::match(const std::vector<ShapePair>& pairs, const ManifoldList& manifolds,
                         const ManifoldMemories& memory, const Executor& executor) {
  blocks_.clear_totals();
  kept_.clear();
  manifolds_.match(pairs, manifolds, memory, executor);
}

void BulkContacts::colour(const BulkBodies& bodies) {
  colour_those(bodies, [](int, int) { return true; });
}

template <class IsSwept>
void BulkContacts::colour_those(const BulkBodies& bodies, const IsSwept& is_swept) {
  // Pairs in their order; bodies that stand still may be in many manifolds of a colour.
  colouring_.begin(manifolds_.size());
  has_restitution_ = false;
  for (std::size_t i = 0; i < manifolds_.size(); ++i) {
    const int a = manifolds_.body_A(i), b = manifolds_.body_B(i);
    if (!is_swept(a, b)) continue;
    const ManifoldSurface& surface = manifolds_.surface(i);
    const int points = manifolds_.point_count(i);
    const bool is_round = points == 1 && is_round_[at(a)] && is_round_[at(b)];
    has_restitution_ = has_restitution_ || surface.restitution > 0;
    colouring_.add(static_cast<int>(i), {bodies.is_dynamic(a) ? a : -1, bodies.is_dynamic(b) ? b : -1},
                   find_block_kind(points, surface, is_round));
  }
  is_all_swept_ = colouring_.size() == manifolds_.size();
  colouring_.finish(bodies.count());
}

void BulkContacts::prepare(const BulkBodies& bodies, double h, double whole, const DirectIslands& direct,
                           const Executor& executor) {
  // Manifolds of islands that are solved directly get no block.
  if (direct.island_count() > 0)
    colour_those(bodies, [&](int a, int b) { return !direct.holds(a) && !direct.holds(b); });
  blocks_.arrange(colouring_.now());

  // Springs (docs/theory/bulk.md, section 3).
  const Softness between_moving = make_softness(contact_frequency_a_substep / whole, contact_damping, h);
  const Softness on_ground = make_softness(ground_frequency_a_substep / whole, contact_damping, h);

  // Eight manifolds a block.
  executor.for_ranges(blocks_.count(), 16, [&](int begin, int end) {
    blocks_.for_blocks(begin, end, [&](auto& block, int number) {
      std::array<BlockLane, kLaneCount> lanes;
      std::size_t count = 0;
      for (int lane = 0; lane < kLaneCount && manifold_of(number, lane) >= 0; ++lane) {
        const std::size_t i = at(manifold_of(number, lane));
        BlockLane& own = lanes[count++];
        own.manifold = manifolds_.view(i);
        own.surface = &manifolds_.surface(i);
        own.memory = manifolds_.memory(i);
        own.body_A = manifolds_.body_A(i);
        own.body_B = manifolds_.body_B(i);
        const bool both_move = bodies.gives_way(own.body_A) && bodies.gives_way(own.body_B);
        own.softness = both_move ? &between_moving : &on_ground;
      }
      fill_block(target_, std::span(lanes.data(), count), bodies, block);
    });
  });
}

template <class Work>
void BulkContacts::for_colours(const Executor& executor, const Work& work) {
  const GraphColouring& colouring = colouring_.now();
  for (int colour = 0; colour < colouring.colour_count(); ++colour) {
    const int first = colouring.colour_begin[at(colour)];
    const int count = colouring.colour_begin[at(colour) + 1] - first;
    const int grain = colouring.is_serial[at(colour)] ? count : 4;
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

bool BulkContacts::find_bounces(const std::vector<MotionRow>& accelerations, const BulkBodies& bodies,
                                const Executor& executor) {
  bounces_.assign(at(blocks_.count()), {});
  executor.for_ranges(blocks_.count(), 64, [&](int begin, int end) {
    blocks_.for_totals(begin, end, [&](const auto& block, const auto& total, int number) {
      BlockBounces& found = bounces_[at(number)];
      for (int lane = 0; lane < kLaneCount; ++lane) {
        if (manifold_of(number, lane) < 0) continue;
        const SolvedManifold own = read(block, total, lane, at(manifold_of(number, lane)));
        if (!bounces(own)) continue;
        found.does_any = true;
        found.most[at(lane)] = own.restitution * own.restitution * energy_taken(own, accelerations, bodies);
      }
    });
  });
  return std::any_of(bounces_.begin(), bounces_.end(), [](const BlockBounces& b) { return b.does_any; });
}

void BulkContacts::bounce_apart(const Model& model, const std::vector<MotionRow>& accelerations,
                                HeldBodies& held, BulkBodies& bodies, const Executor& executor) {
  for_colours(executor, [&](int begin, int end) {
    blocks_.for_totals(begin, end, [&](const auto& block, auto& total, int number) {
      const BlockBounces& found = bounces_[at(number)];
      for (int lane = 0; found.does_any && lane < kLaneCount; ++lane) {
        const std::size_t i = at(lane);
        if (!(found.most[i] > 0)) continue;
        const std::size_t manifold = at(manifold_of(number, lane));
        add_impulses(
            bounce(model, read(block, total, lane, manifold), found.most[i], accelerations, held, bodies),
            lane, total);
      }
    });
  });
}

void BulkContacts::add(std::size_t manifold, const ManifoldImpulses& impulses, double kept) {
  kept_.resize(manifolds_.size(), std::numeric_limits<float>::infinity());
  kept_[manifold] = static_cast<float>(kept);
  blocks_.for_totals(0, blocks_.count(), [&](const auto&, auto& total, int number) {
    for (int lane = 0; lane < kLaneCount; ++lane) {
      if (manifold_of(number, lane) == static_cast<int>(manifold)) add_impulses(impulses, lane, total);
    }
  });
}

void BulkContacts::remember(const BulkBodies& bodies, double h, int substeps, const Executor& executor,
                            ManifoldMemories& memory) {
  // Room for what each manifold keeps.
  const bool has_energy = blocks_.has_totals();
  memory.arrange(manifolds_.size(), [&](std::size_t i) {
    const ShapePair& pair = manifolds_.pair(i);
    const ManifoldSurface& surface = manifolds_.surface(i);
    const bool has_shapes = pair.shape_A != 0 || pair.shape_B != 0 || manifolds_.part(i) != 0;
    const bool has_moments = surface.torsional_friction > 0 || surface.rolling_friction > 0;
    const int points = manifolds_.point_count(i);
    return ManifoldMemories::Layout{points, has_shapes, has_moments || points > 1, has_moments, has_energy};
  });

  // Those of islands that were solved directly: DirectIslands writes their impulses.
  for (std::size_t i = 0; !is_all_swept_ && i < manifolds_.size(); ++i) {
    memory.put(i, manifolds_.key(i));
    if (has_energy) memory.set_energy(i, 0);
  }

  // Impulses that the next step begins with, and the energies of the springs.
  const auto for_lanes = [&](int number, const auto& work) {
    for (int lane = 0; lane < kLaneCount; ++lane) {
      const int manifold = manifold_of(number, lane);
      if (manifold >= 0) work(lane, at(manifold));
    }
  };
  executor.for_ranges(blocks_.count(), 64, [&](int begin, int end) {
    blocks_.for_blocks(begin, end, [&](const auto& block, int number) {
      for_lanes(number, [&](int lane, std::size_t i) {
        const ShapePair& pair = manifolds_.pair(i);
        const ManifoldView found = manifolds_.view(i);
        const ManifoldMemories::Slot slot =
            memory.put_key(i, {pair.body_A, pair.body_B, pair.shape_A, pair.shape_B, at(manifolds_.part(i))});
        for (int k = 0; k < found.point_count; ++k)
          slot.feature[k] = std::bit_cast<float>(found.points[k].feature);
        read_lane(block, lane, slot);
        if (!kept_.empty()) lessen_impulses(kept_[i], slot);
      });
    });
    if (!has_energy) return;
    blocks_.for_totals(begin, end, [&](const auto& block, const auto& total, int number) {
      LaneArray energies{};
      for_lanes(number, [&](int lane, std::size_t i) { energies[at(lane)] = manifolds_.energy(i); });
      find_spring_energies(target_, block, total, bodies, {h, substeps}, energies);
      for_lanes(number, [&](int lane, std::size_t i) { memory.set_energy(i, energies[at(lane)]); });
    });
  });
}

}  // namespace rigor
