#include "rigor/bulk/graph/cached_colouring.hpp"

#include "rigor/bulk/lanes/list_room.hpp"
#include "rigor/core/index.hpp"

namespace rigor {

namespace {

/// Among more edges than this some change in each step: they are not kept.
constexpr std::size_t most_kept = 16384;

}  // namespace

void CachedColouring::begin(std::size_t most) {
  make_room(most, edges_);
  make_room(most, kinds_);
  edges_.resize(most);
  kinds_.resize(most);
  // Blocks whose edges have numbers of their own are not those of the next step.
  is_same_ = body_count_ >= 0 && numbers_.empty() && size_ <= most_kept;
  last_size_ = size_;
  size_ = 0;
  numbers_.clear();
}

void CachedColouring::set_number(int number) {
  while (numbers_.size() < size_) numbers_.push_back(static_cast<std::int32_t>(numbers_.size()));
  numbers_.push_back(number);
}

void CachedColouring::finish(int body_count) {
  if (is_same_ && size_ == last_size_ && numbers_.empty() && body_count == body_count_) return;
  // The edges have changed: all of them are coloured.
  edges_.resize(size_);
  kinds_.resize(size_);
  body_count_ = body_count;
  ++run_count_;
  colour_graph(edges_, kinds_, body_count, colouring_);
  if (size_ > most_kept) {
    edges_ = std::vector<ConstraintEdge>();
    kinds_ = std::vector<std::uint8_t>();
  }
  // Blocks hold the numbers that the caller gave.
  if (numbers_.empty()) return;
  for (auto& block : colouring_.blocks) {
    for (std::int32_t& edge : block) edge = edge < 0 ? -1 : numbers_[at(edge)];
  }
}

}  // namespace rigor
