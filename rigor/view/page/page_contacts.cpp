#include "rigor/view/page/page_contacts.hpp"

#include "rigor/core/index.hpp"
#include "rigor/view/page/page_frames.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace rigor {

namespace {

/// A chunk is full with this many contacts or frames: it takes some ten MB while it is filled.
constexpr std::size_t contacts_of_chunk = 250000, frames_of_chunk = 256;

/// Sizes of the forces that are known and not zero [N].
std::vector<double> sizes_of_forces(const std::vector<std::vector<TouchingPoint>>& frames) {
  std::vector<double> sizes;
  for (const std::vector<TouchingPoint>& points : frames) {
    for (const TouchingPoint& point : points) {
      if (point.force_W.allFinite() && point.force_W.norm() > 1e-300) sizes.push_back(point.force_W.norm());
    }
  }
  return sizes;
}

/// The size that all but a fiftieth of them stay below; 0 if there are none.
double usual_size(std::vector<double> sizes) {
  if (sizes.empty()) return 0;
  const std::size_t place = (sizes.size() - 1) * 49 / 50;
  std::nth_element(sizes.begin(), sizes.begin() + static_cast<std::ptrdiff_t>(place), sizes.end());
  return sizes[place];
}

double step_below(double size) {
  return size > 1e-300 ? power_of_two_below(size) : 1;
}

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

PageContacts::PageContacts(const PageScale& scale, double contact_tolerance)
    : origin_(scale.origin),
      place_step_(scale.contact_step),
      gap_step_(contact_tolerance / 16),
      body_radius_(scale.body_radius),
      is_crowd_of_bodies_(scale.is_crowd) {}

std::optional<PageBlock> PageContacts::add(const std::vector<TouchingPoint>& all) {
  const bool is_crowd = is_crowd_of_bodies_ || all.size() > most_single;
  is_crowded_ = is_crowded_ || is_crowd;
  const std::vector<TouchingPoint> points = is_crowd ? crowd_of(all) : all;
  const std::size_t count = std::min(points.size(), most_in_frame);
  frames_.emplace_back(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(count));
  count_ += count;
  if (count_ >= contacts_of_chunk || frames_.size() == frames_of_chunk) return finish();
  return std::nullopt;
}

/// What carries something, may do so, or lies deep, one a pair.
std::vector<TouchingPoint> PageContacts::crowd_of(const std::vector<TouchingPoint>& all) const {
  std::vector<TouchingPoint> points = joined_by_pairs(all);
  std::erase_if(points, [&](const TouchingPoint& point) {
    return point.mode != TouchingPoint::Mode::unknown && point.force_W.isZero() &&
           point.gap > -body_radius_ / 32;
  });
  return points;
}

PageContacts::Steps PageContacts::steps_of_chunk() const {
  const std::vector<double> sizes = sizes_of_forces(frames_);
  if (is_crowded_) {
    return {step_below(usual_size(sizes) / 32), power_of_two_below(body_radius_ / 64),
            std::max(place_step_, power_of_two_below(body_radius_ / 8)), 1.0 / 16};
  }
  // Forces are quantised to 1/1024 of the largest one of the chunk.
  const double largest = sizes.empty() ? 0 : *std::max_element(sizes.begin(), sizes.end());
  return {step_below(largest / 512), gap_step_, place_step_, 1.0 / 1024};
}

PageContacts::Numbers PageContacts::numbers_of(const TouchingPoint& point, const Steps& steps) const {
  Numbers result{};
  result[0] = static_cast<std::int64_t>(point.mode);
  result[1] = quantised(point.gap, steps.gap);
  for (int k = 0; k < 3; ++k) {
    const std::size_t place = at(k);
    result[2 + place] = quantised(point.p_W[k] - origin_[k], steps.place);
    result[5 + place] = quantised(point.n_W[k], steps.normal);
    result[8 + place] = quantised(point.force_W[k], steps.force);
  }
  return result;
}

/// In the order of names; of contacts of one name the last one stays.
void PageContacts::put_in_order(Frame& frame) {
  const auto comes_before = [](const auto& a, const auto& b) { return a.first < b.first; };
  if (!std::is_sorted(frame.begin(), frame.end(), comes_before))
    std::stable_sort(frame.begin(), frame.end(), comes_before);
  const auto is_same = [](const auto& a, const auto& b) { return a.first == b.first; };
  frame.erase(frame.begin(), std::unique(frame.rbegin(), frame.rend(), is_same).base());
}

/// Finds contacts of a frame by name; quickly, where they are asked for in the order of their names.
class PageContacts::Lookup {
 public:
  explicit Lookup(const Frame& frame) : frame_(frame), next_(frame.begin()) {}

  /// Nothing if the frame has none of this name.
  const Numbers* find(const Name& name) {
    if (next_ != frame_.begin() && !(std::prev(next_)->first < name)) next_ = frame_.begin();
    while (next_ != frame_.end() && next_->first < name) ++next_;
    return next_ != frame_.end() && next_->first == name ? &next_->second : nullptr;
  }

 private:
  const Frame& frame_;
  Frame::const_iterator next_;  ///< The first one that is not before the last name.
};

/// Prediction of the numbers of a contact from the same contact in the last two frames.
PageContacts::Numbers PageContacts::expected(const Name& name, Lookup& last, Lookup& before) {
  const Numbers *const newer = last.find(name), *const older = before.find(name);
  if (!newer) return {};
  Numbers result = *newer;
  if (!older) return result;
  // Only point and normal are extrapolated; the other numbers jump too much.
  constexpr std::size_t first_smooth = 2, end_smooth = 8;  // point and normal
  for (std::size_t k = first_smooth; k < end_smooth; ++k) result[k] += (*newer)[k] - (*older)[k];
  return result;
}

std::optional<PageBlock> PageContacts::finish() {
  if (frames_.empty()) return std::nullopt;
  // Each number of a contact goes to its own column, as the residual of its prediction.
  const Steps steps = steps_of_chunk();
  std::array<std::string, 3 + numbers> columns;
  Frame before, last, now;
  for (const std::vector<TouchingPoint>& points : frames_) {
    append_varint(static_cast<std::int64_t>(points.size()), columns[0]);
    int last_A = 0, last_B = -1, which = 0;
    Lookup in_last(last), in_before(before);
    for (const TouchingPoint& point : points) {
      // Contacts of the same pair are numbered in their order, so that frames can be matched.
      which = point.body_A == last_A && point.body_B == last_B ? which + 1 : 0;
      append_varint(point.body_A - last_A, columns[1]);
      append_varint(point.body_B - point.body_A, columns[2]);
      last_A = point.body_A, last_B = point.body_B;
      const Name name{last_A, last_B, which};
      const Numbers values = numbers_of(point, steps), guess = expected(name, in_last, in_before);
      for (std::size_t k = 0; k < numbers; ++k) append_varint(values[k] - guess[k], columns[3 + k]);
      now.emplace_back(name, values);
    }
    put_in_order(now);
    before = std::exchange(last, std::exchange(now, {}));
  }
  // The header of the chunk, then one column after the other.
  std::string bytes;
  for (const double step : {steps.force, steps.gap, steps.place, steps.normal}) append_f64(step, bytes);
  append_u32(static_cast<std::uint32_t>(frames_.size()), bytes);
  for (const std::string& column : columns) bytes += column;
  frames_.clear();
  count_ = 0;
  is_crowded_ = false;
  return make_page_block("contacts", bytes);
}

}  // namespace rigor
