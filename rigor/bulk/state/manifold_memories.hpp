#pragma once

#include "rigor/model/manifold_memory.hpp"

#include <array>
#include <bit>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <iterator>
#include <vector>

namespace rigor {

/// The memories of a State's manifolds while the many-body path works on them: packed, each with no more
/// numbers than it needs (40 B for two balls, where ManifoldMemory has 88), and written by all threads.
/// Elements are read as copies, with the same bits as were put in.
class ManifoldMemories {
 public:
  /// Which numbers a memory has besides its bodies, friction and points. Those that are 0 need not be stored.
  struct Layout {
    int point_count = 0;
    bool has_shapes = true, has_twist = true, has_rolling = true, has_energy = true;
  };
  /// The numbers of a memory where they are stored; valid until the list changes.
  struct View {
    int point_count = 0;
    const float* feature = nullptr;  ///< Bits of 32-bit numbers.
    const float* normal_impulse = nullptr;
    const float* friction_impulse_W =
        nullptr;  ///< A fourth number is behind its three, so that lanes may load four.
    float twist_impulse = 0;
    const float* rolling_impulse_W = nullptr;  ///< Null: zero.

    bool is_there() const { return friction_impulse_W != nullptr; }
  };

  /// Where the numbers of a memory are to be written.
  struct Slot {
    int point_count = 0;
    float* feature = nullptr;  ///< Bits of 32-bit numbers.
    float* normal_impulse = nullptr;
    float* friction_impulse_W = nullptr;
    float* twist_impulse = nullptr;      ///< Null: it is 0.
    float* rolling_impulse_W = nullptr;  ///< Null: it is 0.
  };

  ManifoldMemories() = default;
  ManifoldMemories(std::initializer_list<ManifoldMemory> memories)
      : ManifoldMemories(std::vector<ManifoldMemory>(memories)) {}
  ManifoldMemories(const std::vector<ManifoldMemory>& memories);
  /// Unpacked, as a State has them.
  std::vector<ManifoldMemory> values() const;

  using value_type = ManifoldMemory;

  std::size_t size() const { return heads_.size(); }
  bool empty() const { return heads_.empty(); }
  void clear();
  void push_back(const ManifoldMemory& memory);
  ManifoldMemory operator[](std::size_t i) const;
  /// With all impulses times this factor.
  ManifoldMemories scaled(float factor) const;
  /// The same, but what pressed nothing in `before` does not grow: the impulse of a strike does not depend on
  /// the time in which it was found. `before` must be in the order of keys.
  ManifoldMemories scaled_since(const ManifoldMemories& before, float factor) const;
  bool operator==(const ManifoldMemories& other) const;

  int body_A(std::size_t i) const { return heads_[i].body_A; }
  int body_B(std::size_t i) const { return heads_[i].body_B; }
  ContactKey key(std::size_t i) const {
    const Head& head = heads_[i];
    if (!head.has_shapes) return {head.body_A, head.body_B, 0, 0, 0};
    const float* shapes = &numbers_[places_of(head).shapes];
    return {head.body_A, head.body_B, std::bit_cast<int>(shapes[0]), std::bit_cast<int>(shapes[1]),
            std::bit_cast<std::uint32_t>(shapes[2])};
  }
  /// Compares the key of a memory with another key.
  std::strong_ordering order(std::size_t i, const ContactKey& other) const {
    const Head& head = heads_[i];
    if (head.body_A != other.body_A) return head.body_A <=> other.body_A;
    if (head.body_B != other.body_B) return head.body_B <=> other.body_B;
    if (!head.has_shapes && (other.shape_A | other.shape_B) == 0 && other.feature == 0)
      return std::strong_ordering::equal;
    return key(i) <=> other;
  }
  /// The first memory whose key is not less. The list must be in the order of keys.
  std::size_t find_from(const ContactKey& key) const;
  float energy(std::size_t i) const;
  View view(std::size_t i) const {
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

  /// Makes `count` memories; layout_of(i) says what the i-th has room for. All of them must then be written
  /// by the functions below, different ones from any threads.
  template <class LayoutOf>
  void arrange(std::size_t count, const LayoutOf& layout_of) {
    make_heads(count);
    std::size_t end = 0;
    for (std::size_t i = 0; i < count; ++i) {
      heads_[i] = make_head(layout_of(i), end);
      end = places_of(heads_[i]).end;
    }
    make_numbers(end);
  }
  /// Writes the key and returns where the rest, all but the energy, must be written.
  Slot put_key(std::size_t i, const ContactKey& key) {
    Head& head = heads_[i];
    const Places at = places_of(head);
    float* numbers = numbers_.data();
    head.body_A = key.body_A;
    head.body_B = key.body_B;
    // Most pairs are of the first shapes of two bodies and have one part: these zeros are not stored.
    if (head.has_shapes) {
      numbers[at.shapes] = std::bit_cast<float>(key.shape_A);
      numbers[at.shapes + 1] = std::bit_cast<float>(key.shape_B);
      numbers[at.shapes + 2] = std::bit_cast<float>(static_cast<std::uint32_t>(key.feature));
    }
    return {head.point_count,
            numbers + at.features,
            numbers + at.impulses,
            numbers + at.friction,
            head.has_twist ? numbers + at.twist : nullptr,
            head.has_rolling ? numbers + at.rolling : nullptr};
  }
  /// Writes all of a memory but the energy.
  void put(std::size_t i, const ManifoldMemory& memory);
  void set_energy(std::size_t i, float energy);

  /// Reads the list in its order.
  class Iterator {
   public:
    using iterator_category = std::input_iterator_tag;
    using value_type = ManifoldMemory;
    using difference_type = std::ptrdiff_t;
    using pointer = void;
    using reference = ManifoldMemory;

    Iterator(const ManifoldMemories& list, std::size_t i) : list_(&list), i_(i) {}
    ManifoldMemory operator*() const { return (*list_)[i_]; }
    Iterator& operator++() {
      ++i_;
      return *this;
    }
    Iterator operator++(int) { return Iterator(*list_, i_++); }
    bool operator==(const Iterator& other) const { return i_ == other.i_; }

   private:
    const ManifoldMemories* list_;
    std::size_t i_;
  };
  Iterator begin() const { return {*this, 0}; }
  Iterator end() const { return {*this, size()}; }

 private:
  struct Head {
    int body_A, body_B;
    std::uint32_t first;  ///< Index of its first number.
    std::uint8_t point_count;
    bool has_shapes : 1, has_twist : 1, has_rolling : 1, has_energy : 1;
  };
  /// Where the numbers of a memory begin, in the order in which they are stored.
  struct Places {
    std::size_t friction, twist, rolling, energy, shapes, features, impulses, end;
  };
  static Places places_of(const Head& head) {
    Places at;
    at.friction = head.first;
    at.twist = at.friction + 3;
    at.rolling = at.twist + head.has_twist;
    at.energy = at.rolling + 3 * std::size_t{head.has_rolling};
    at.shapes = at.energy + head.has_energy;
    at.features = at.shapes + 3 * std::size_t{head.has_shapes};
    at.impulses = at.features + head.point_count;
    // There are at least four numbers from the friction on, so that lanes may load four.
    at.end = at.impulses + head.point_count;
    if (at.end < at.friction + 4) at.end = at.friction + 4;
    return at;
  }
  static Head make_head(const Layout& layout, std::size_t first) {
    return {-1,
            -1,
            static_cast<std::uint32_t>(first),
            static_cast<std::uint8_t>(layout.point_count),
            layout.has_shapes,
            layout.has_twist,
            layout.has_rolling,
            layout.has_energy};
  }
  /// Whether the list, in the order of keys, has normal impulses of this contact.
  bool presses(const ContactKey& key) const;
  void make_heads(std::size_t count);
  void make_numbers(std::size_t count);

  std::vector<Head> heads_;
  /// The numbers of each memory: friction (3), twist, rolling (3), energy, shapes and part (3), features,
  /// impulses.
  std::vector<float> numbers_;
};

}  // namespace rigor
