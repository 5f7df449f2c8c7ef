#include "rigor/model/manifold_memory.hpp"

#include "rigor/core/assert.hpp"

#include <algorithm>
#include <bit>

namespace rigor {

namespace {

/// Not 0, which is what numbers are that are not there.
bool is_set(float number) {
  return std::bit_cast<std::uint32_t>(number) != 0;
}

/// Friction, and twist and rolling behind it if they are there.
inline void put_friction(const ManifoldMemory& memory, float* to, bool has_twist, bool has_rolling) {
  for (std::size_t k = 0; k < 3; ++k) to[k] = memory.friction_impulse_W[k];
  if (has_twist) to[3] = memory.twist_impulse;
  if (has_rolling) std::copy_n(memory.rolling_impulse_W.begin(), 3, to + (has_twist ? 4 : 3));
}

/// Lists take what they hold and an eighth, not up to twice that.
template <class T>
void make_room(std::size_t count, std::vector<T>& list) {
  if (count > list.capacity()) list.reserve(count + count / 8);
}

}  // namespace

ManifoldMemories::ManifoldMemories(std::initializer_list<ManifoldMemory> memories) {
  for (const ManifoldMemory& memory : memories) push_back(memory);
}

ManifoldMemories::ManifoldMemories(const std::vector<ManifoldMemory>& memories) {
  for (const ManifoldMemory& memory : memories) push_back(memory);
}

void ManifoldMemories::clear() {
  heads_.clear();
  numbers_.clear();
}

ManifoldMemories::Places ManifoldMemories::places_of(const Head& head) {
  Places at;
  at.friction = head.first;
  at.twist = at.friction + 3;
  at.rolling = at.twist + (head.has_twist ? 1 : 0);
  at.energy = at.rolling + (head.has_rolling ? 3 : 0);
  at.shapes = at.energy + (head.has_energy ? 1 : 0);
  at.features = at.shapes + (head.has_shapes ? 3 : 0);
  at.impulses = at.features + head.point_count;
  // At least four numbers from the friction on.
  at.end = std::max(at.impulses + head.point_count, at.friction + 4);
  return at;
}

void ManifoldMemories::clear_for(std::size_t count) {
  heads_.clear();
  make_room(count, heads_);
}

std::size_t ManifoldMemories::lay_out(const Layout& layout, std::size_t first) {
  RIGOR_ASSERT(layout.point_count >= 0 && layout.point_count <= ManifoldMemory::max_points);
  heads_.push_back({-1, -1, static_cast<std::uint32_t>(first), static_cast<std::uint8_t>(layout.point_count),
                    layout.has_shapes, layout.has_twist, layout.has_rolling, layout.has_energy});
  return places_of(heads_.back()).end;
}

void ManifoldMemories::make_numbers(std::size_t numbers) {
  RIGOR_ASSERT(numbers <= std::size_t{0xffffffffu});
  make_room(numbers, numbers_);
  numbers_.resize(numbers, 0);
}

void ManifoldMemories::push_back(const ManifoldMemory& memory) {
  const Layout layout{memory.point_count, memory.shape_A != 0 || memory.shape_B != 0 || memory.part != 0,
                      is_set(memory.twist_impulse),
                      std::any_of(memory.rolling_impulse_W.begin(), memory.rolling_impulse_W.end(), is_set),
                      is_set(memory.energy)};
  make_room(heads_.size() + 1, heads_);
  const std::size_t end = lay_out(layout, numbers_.size());
  make_room(end, numbers_);
  numbers_.resize(end, 0);
  put(size() - 1, memory);
  if (layout.has_energy) set_energy(size() - 1, memory.energy);
}

void ManifoldMemories::put(std::size_t i, const ManifoldMemory& memory) {
  Head& head = heads_[i];
  const Places at = places_of(head);
  float* numbers = numbers_.data();
  head.body_A = memory.body_A;
  head.body_B = memory.body_B;
  if (head.has_shapes) {
    numbers[at.shapes] = std::bit_cast<float>(memory.shape_A);
    numbers[at.shapes + 1] = std::bit_cast<float>(memory.shape_B);
    numbers[at.shapes + 2] = std::bit_cast<float>(memory.part);
  }
  for (std::size_t k = 0; k < head.point_count; ++k) {
    numbers[at.features + k] = std::bit_cast<float>(memory.feature[k]);
    numbers[at.impulses + k] = memory.normal_impulse[k];
  }
  put_friction(memory, numbers + at.friction, head.has_twist, head.has_rolling);
}

void ManifoldMemories::set_energy(std::size_t i, float energy) {
  RIGOR_ASSERT(heads_[i].has_energy);
  numbers_[places_of(heads_[i]).energy] = energy;
}

std::array<int, 5> ManifoldMemories::key(std::size_t i) const {
  const Head& head = heads_[i];
  if (!head.has_shapes) return {head.body_A, head.body_B, 0, 0, 0};
  const float* shapes = &numbers_[places_of(head).shapes];
  return {head.body_A, head.body_B, std::bit_cast<int>(shapes[0]), std::bit_cast<int>(shapes[1]),
          std::bit_cast<int>(shapes[2])};
}

std::size_t ManifoldMemories::find_from(const std::array<int, 5>& wanted) const {
  std::size_t begin = 0, end = size();
  while (begin < end) {
    const std::size_t middle = begin + (end - begin) / 2;
    if (key(middle) < wanted) {
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

ManifoldMemories::View ManifoldMemories::view(std::size_t i) const {
  const Head& head = heads_[i];
  const Places at = places_of(head);
  const float* numbers = numbers_.data();
  return {head.point_count,
          numbers + at.features,
          numbers + at.impulses,
          numbers + at.friction,
          head.has_twist ? numbers[at.twist] : 0,
          head.has_rolling ? numbers + at.rolling : nullptr};
}

ManifoldMemory ManifoldMemories::operator[](std::size_t i) const {
  const View own = view(i);
  const std::array<int, 5> whose = key(i);
  ManifoldMemory memory;
  memory.body_A = whose[0], memory.body_B = whose[1];
  memory.shape_A = whose[2], memory.shape_B = whose[3];
  memory.part = whose[4];
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

bool ManifoldMemories::operator==(const ManifoldMemories& other) const {
  if (size() != other.size()) return false;
  for (std::size_t i = 0; i < size(); ++i) {
    if ((*this)[i] != other[i]) return false;
  }
  return true;
}

}  // namespace rigor
