#pragma once

#include "rigor/bulk/lanes/list_room.hpp"
#include "rigor/bulk/narrow_phase/manifold.hpp"
#include "rigor/core/index.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace rigor {

/// A manifold and the pair of shapes that it belongs to.
struct PairManifold {
  int pair;  ///< Index into the pairs.
  int part;  ///< Number of the manifold within the pair (meshes have several), ascending.
  Manifold manifold;
};

/// A list of manifolds that take no more room than their points need: 44 B for one point, 104 B for four.
class ManifoldList {
 public:
  std::size_t size() const { return heads_.size(); }
  bool empty() const { return heads_.empty(); }
  void clear() {
    heads_.clear();
    points_.clear();
  }
  void push_back(const PairManifold& found) { add(found.pair, found.part, found.manifold); }
  /// The manifold `own` of a pair (PairManifold).
  void add(int pair, int part, const Manifold& own) {
    const std::size_t first = points_.size(), count = at(own.point_count);
    // Lists grow by an eighth, not to twice their size.
    if (heads_.size() == heads_.capacity()) make_room(heads_.size() + kMore, heads_);
    if (first + count > points_.capacity()) make_room(first + kMore, points_);
    heads_.push_back({{own.normal[0], own.normal[1], own.normal[2]},
                      pair,
                      static_cast<std::uint32_t>(first),
                      static_cast<std::uint32_t>(part) & 0x1fffffffu,
                      static_cast<std::uint32_t>(own.point_count) & 7u});
    points_.insert(points_.end(), own.points.data(), own.points.data() + count);
  }

  /// Takes out the manifolds for whose index `is_out` holds; their points keep their room until clear().
  template <class IsOut>
  void take_out(const IsOut& is_out) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < heads_.size(); ++i)
      if (!is_out(i)) heads_[kept++] = heads_[i];
    heads_.resize(kept);
  }

  int pair(std::size_t i) const { return heads_[i].pair; }
  int part(std::size_t i) const { return static_cast<int>(heads_[i].part); }
  int point_count(std::size_t i) const { return heads_[i].points(); }
  ManifoldView view(std::size_t i) const {
    const Head& head = heads_[i];
    return {head.normal, points_.data() + head.first_point, head.points()};
  }
  PairManifold operator[](std::size_t i) const {
    const Head& head = heads_[i];
    const float* n = head.normal;
    PairManifold found{head.pair, part(i), {{n[0], n[1], n[2]}, head.points(), {}}};
    std::copy_n(view(i).points, head.points(), found.manifold.points.begin());
    return found;
  }
  /// Copies of all manifolds.
  std::vector<PairManifold> copies() const {
    std::vector<PairManifold> all;
    for (std::size_t i = 0; i < size(); ++i) all.push_back((*this)[i]);
    return all;
  }

  std::size_t all_points() const { return points_.size(); }
  /// Makes room for this many manifolds and points, which put() then writes, from any thread.
  void arrange(std::size_t manifolds, std::size_t points) {
    renew(manifolds, heads_);
    renew(points, points_);
  }
  /// Copies a list to its place among all, given by its first manifold and its first point.
  void put(const ManifoldList& list, std::size_t first, std::size_t first_point) {
    std::copy(list.points_.begin(), list.points_.end(),
              points_.begin() + static_cast<std::ptrdiff_t>(first_point));
    for (std::size_t i = 0; i < list.size(); ++i) {
      heads_[first + i] = list.heads_[i];
      heads_[first + i].first_point += static_cast<std::uint32_t>(first_point);
    }
  }

 private:
  static constexpr std::size_t kMore = 64;
  struct Head {
    float normal[3];
    int pair;
    std::uint32_t first_point;
    std::uint32_t part : 29, point_count : 3;

    int points() const { return static_cast<int>(point_count); }
  };
  std::vector<Head> heads_;
  std::vector<ManifoldPoint> points_;
};

}  // namespace rigor
