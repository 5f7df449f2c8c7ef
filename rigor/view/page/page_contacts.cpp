#include "rigor/view/page/page_contacts.hpp"

#include <algorithm>
#include <utility>

namespace rigor {

namespace {

/// A chunk is full with this many contacts or frames: it takes some ten MB while it is filled.
constexpr std::size_t contacts_of_chunk = 250000, frames_of_chunk = 256;

/// Joins a group of points of one pair.
TouchingPoint joined(const std::vector<TouchingPoint>& points, std::size_t begin, std::size_t end) {
  TouchingPoint result = points[begin];
  double largest = -1, sum = 0;
  Vec3 force = Vec3::Zero(), place = Vec3::Zero(), middle = Vec3::Zero();
  for (std::size_t i = begin; i < end; ++i) {
    const TouchingPoint& point = points[i];
    const double size = point.force_W.allFinite() ? point.force_W.norm() : 0;
    if (size > largest) {
      largest = size;
      result = point;
    }
    force += point.force_W;
    place += size * point.p_W;
    middle += point.p_W / static_cast<double>(end - begin);
    sum += size;
  }
  result.force_W = force;
  result.p_W = sum > 0 ? Vec3(place / sum) : middle;
  for (std::size_t i = begin; i < end; ++i) result.gap = std::min(result.gap, points[i].gap);
  return result;
}

}  // namespace

std::vector<TouchingPoint> joined_by_pairs(const std::vector<TouchingPoint>& points) {
  std::vector<TouchingPoint> result;
  for (std::size_t begin = 0, end = 0; begin < points.size(); begin = end) {
    const auto is_same = [&](const TouchingPoint& point) {
      return point.body_A == points[begin].body_A && point.body_B == points[begin].body_B;
    };
    while (end < points.size() && is_same(points[end])) ++end;
    result.push_back(joined(points, begin, end));
  }
  return result;
}

PageContacts::PageContacts(const Model& model, const PageScale& scale, double contact_tolerance)
    : chunk_{model, scale, contact_tolerance / 16} {}

std::optional<PagePacking> PageContacts::add(std::vector<TouchingPoint> points,
                                             std::shared_ptr<const State> phases) {
  count_ += points.size();
  chunk_.frames.push_back({std::move(points), std::move(phases)});
  if (count_ >= contacts_of_chunk || chunk_.frames.size() == frames_of_chunk) return finish();
  return std::nullopt;
}

std::optional<PagePacking> PageContacts::finish() {
  if (chunk_.frames.empty()) return std::nullopt;
  // The points are many: they move.
  auto full = std::make_shared<ContactChunk>(
      ContactChunk{chunk_.model, chunk_.scale, chunk_.gap_step, std::exchange(chunk_.frames, {})});
  count_ = 0;
  return [full = std::move(full)] { return packed_contacts(*full); };
}

}  // namespace rigor
