#include "rigor/bulk/state/manifold_memories.hpp"

#include "rigor/core/assert.hpp"

#include <algorithm>
#include <bit>

namespace rigor {

namespace {

/// Whether a number must be stored: one that is not stored is +0.
bool is_set(float number) {
  return std::bit_cast<std::uint32_t>(number) != 0;
}

/// Makes room in a list. Lists grow by an eighth, not to twice their size, since they are most of the memory
/// of a large scene.
template <class T>
void make_room(std::size_t count, std::vector<T>& list) {
  if (count > list.capacity()) list.reserve(count + count / 8);
}

/// The layout with room for the numbers of the memory that are not 0.
ManifoldMemories::Layout layout_of(const ManifoldMemory& memory) {
  RIGOR_ASSERT(memory.point_count >= 0 && memory.point_count <= ManifoldMemory::max_points);
  return {memory.point_count, memory.shape_A != 0 || memory.shape_B != 0 || memory.part != 0,
          is_set(memory.twist_impulse),
          std::any_of(memory.rolling_impulse_W.begin(), memory.rolling_impulse_W.end(), is_set),
          is_set(memory.energy)};
}

void scale(ManifoldMemory& memory, float factor) {
  for (float& impulse : memory.normal_impulse) impulse *= factor;
  for (float& impulse : memory.friction_impulse_W) impulse *= factor;
  for (float& impulse : memory.rolling_impulse_W) impulse *= factor;
  memory.twist_impulse *= factor;
}

}  // namespace

ManifoldMemories::ManifoldMemories(const std::vector<ManifoldMemory>& memories) {
  arrange(memories.size(), [&](std::size_t i) { return layout_of(memories[i]); });
  for (std::size_t i = 0; i < memories.size(); ++i) {
    put(i, memories[i]);
    if (heads_[i].has_energy) set_energy(i, memories[i].energy);
  }
}

std::vector<ManifoldMemory> ManifoldMemories::values() const {
  std::vector<ManifoldMemory> memories(size());
  for (std::size_t i = 0; i < size(); ++i) memories[i] = (*this)[i];
  return memories;
}

void ManifoldMemories::clear() {
  heads_.clear();
  numbers_.clear();
}

void ManifoldMemories::make_heads(std::size_t count) {
  make_room(count, heads_);
  heads_.resize(count);
}

void ManifoldMemories::make_numbers(std::size_t count) {
  RIGOR_ASSERT(count <= std::size_t{0xffffffffu});
  make_room(count, numbers_);
  numbers_.resize(count, 0);
}

void ManifoldMemories::push_back(const ManifoldMemory& memory) {
  const Head head = make_head(layout_of(memory), numbers_.size());
  make_room(heads_.size() + 1, heads_);
  heads_.push_back(head);
  make_numbers(places_of(head).end);
  put(size() - 1, memory);
  if (head.has_energy) set_energy(size() - 1, memory.energy);
}

void ManifoldMemories::put(std::size_t i, const ManifoldMemory& memory) {
  // Numbers without a place are 0 by the layout.
  const Slot slot = put_key(i, memory.key());
  for (std::size_t k = 0; k < heads_[i].point_count; ++k) {
    slot.feature[k] = std::bit_cast<float>(memory.feature[k]);
    slot.normal_impulse[k] = memory.normal_impulse[k];
  }
  std::copy(memory.friction_impulse_W.begin(), memory.friction_impulse_W.end(), slot.friction_impulse_W);
  if (slot.twist_impulse != nullptr) *slot.twist_impulse = memory.twist_impulse;
  if (slot.rolling_impulse_W != nullptr)
    std::copy(memory.rolling_impulse_W.begin(), memory.rolling_impulse_W.end(), slot.rolling_impulse_W);
}

void ManifoldMemories::set_energy(std::size_t i, float energy) {
  RIGOR_ASSERT(heads_[i].has_energy);
  numbers_[places_of(heads_[i]).energy] = energy;
}

std::size_t ManifoldMemories::find_from(const ContactKey& wanted) const {
  // Binary search for the first key that is not less.
  std::size_t begin = 0, end = size();
  while (begin < end) {
    const std::size_t middle = begin + (end - begin) / 2;
    if (order(middle, wanted) < 0) {
      begin = middle + 1;
    } else {
      end = middle;
    }
  }
  return begin;
}

float ManifoldMemories::energy(std::size_t i) const {
  return heads_[i].has_energy ? numbers_[places_of(heads_[i]).energy] : 0;
}

ManifoldMemory ManifoldMemories::operator[](std::size_t i) const {
  // Numbers that are not stored are 0 in the view, or stay 0 in the copy.
  const View own = view(i);
  const ContactKey own_key = key(i);
  ManifoldMemory memory;
  memory.body_A = own_key.body_A, memory.body_B = own_key.body_B;
  memory.shape_A = own_key.shape_A, memory.shape_B = own_key.shape_B;
  memory.part = static_cast<int>(own_key.feature);
  memory.point_count = own.point_count;
  for (std::size_t k = 0; k < heads_[i].point_count; ++k) {
    memory.feature[k] = std::bit_cast<std::uint32_t>(own.feature[k]);
    memory.normal_impulse[k] = own.normal_impulse[k];
  }
  std::copy_n(own.friction_impulse_W, 3, memory.friction_impulse_W.begin());
  memory.twist_impulse = own.twist_impulse;
  if (own.rolling_impulse_W != nullptr)
    std::copy_n(own.rolling_impulse_W, 3, memory.rolling_impulse_W.begin());
  memory.energy = energy(i);
  return memory;
}

ManifoldMemories ManifoldMemories::scaled(float factor) const {
  std::vector<ManifoldMemory> memories = values();
  for (ManifoldMemory& memory : memories) scale(memory, factor);
  return memories;
}

ManifoldMemories ManifoldMemories::scaled_since(const ManifoldMemories& before, float factor) const {
  std::vector<ManifoldMemory> memories = values();
  for (ManifoldMemory& memory : memories) {
    if (factor <= 1 || before.presses(memory.key())) scale(memory, factor);
  }
  return memories;
}

bool ManifoldMemories::presses(const ContactKey& key) const {
  const std::size_t i = find_from(key);
  if (i == size() || order(i, key) != 0) return false;
  const View own = view(i);
  return std::any_of(own.normal_impulse, own.normal_impulse + own.point_count,
                     [](float impulse) { return impulse > 0; });
}

bool ManifoldMemories::operator==(const ManifoldMemories& other) const {
  if (size() != other.size()) return false;
  for (std::size_t i = 0; i < size(); ++i) {
    if ((*this)[i] != other[i]) return false;
  }
  return true;
}

}  // namespace rigor
