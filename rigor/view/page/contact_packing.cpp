#include "rigor/core/index.hpp"
#include "rigor/view/page/page_contacts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <tuple>
#include <utility>

namespace rigor {

namespace {

using Points = std::vector<TouchingPoint>;

/// Sizes of the forces that are known and not zero [N].
std::vector<double> sizes_of_forces(const std::vector<Points>& frames) {
  std::vector<double> sizes;
  for (const std::vector<TouchingPoint>& points : frames) {
    for (const TouchingPoint& point : points) {
      if (point.force_W.allFinite() && point.force_W.norm() > 1e-300) sizes.push_back(point.force_W.norm());
    }
  }
  return sizes;
}

std::vector<double> gaps_of(const std::vector<Points>& frames) {
  std::vector<double> gaps;
  for (const Points& points : frames)
    for (const TouchingPoint& point : points)
      if (std::isfinite(point.gap)) gaps.push_back(std::abs(point.gap));
  return gaps;
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

/// Sizes of the steps of a chunk.
struct Steps {
  double force, gap, place, normal;
};
Steps steps_of(const ContactChunk& chunk, const std::vector<Points>& frames, bool is_crowded) {
  const std::vector<double> sizes = sizes_of_forces(frames);
  const PageScale& scale = chunk.scale;
  if (is_crowded) {
    return {step_below(usual_size(sizes) / 16), power_of_two_below(scale.body_radius / 64),
            std::max(scale.contact_step, power_of_two_below(scale.body_radius / 8)), 1.0 / 16};
  }
  // Forces are quantised to 1/1024 of the largest one of the chunk, gaps to as much of the usual one.
  const double largest = sizes.empty() ? 0 : *std::max_element(sizes.begin(), sizes.end());
  const double usual_gap = usual_size(gaps_of(frames)) / 512;
  const double gap_step = usual_gap > chunk.gap_step ? power_of_two_below(usual_gap) : chunk.gap_step;
  return {step_below(largest / 512), gap_step, scale.contact_step, 1.0 / 1024};
}

/// What carries something, may do so, or lies deep, one a pair.
Points crowd_of(const Points& all, double body_radius) {
  Points points = joined_by_pairs(all);
  std::erase_if(points, [&](const TouchingPoint& point) {
    return point.mode != TouchingPoint::Mode::unknown && point.force_W.isZero() &&
           point.gap > -body_radius / 32;
  });
  return points;
}

bool comes_before(const TouchingPoint& a, const TouchingPoint& b) {
  return std::pair(a.body_A, a.body_B) < std::pair(b.body_A, b.body_B);
}

/// The points of a frame that are stored, in the order of their bodies.
Points stored_points(const ContactChunk& chunk, std::size_t frame, bool& is_crowded) {
  const Points& all = chunk.frames[frame].points;
  const bool is_crowd = chunk.scale.is_crowd || all.size() > PageContacts::most_single;
  is_crowded = is_crowded || is_crowd;
  Points points = is_crowd ? crowd_of(all, chunk.scale.body_radius) : all;
  points.resize(std::min(points.size(), PageContacts::most_in_frame), TouchingPoint{});
  if (!std::is_sorted(points.begin(), points.end(), comes_before))
    std::stable_sort(points.begin(), points.end(), comes_before);
  return points;
}

constexpr std::size_t numbers_of_contact = 11;
/// Point and normal: the other numbers jump too much to be extrapolated.
constexpr std::size_t first_smooth = 2, end_smooth = 8;
using Numbers = std::array<std::int64_t, numbers_of_contact>;

/// A contact of a frame, and its place among those of the frame before; -1 if it is new.
struct Stored {
  int body_A, body_B, which;  ///< The two bodies and its index among their contacts.
  int from;
  Numbers numbers;
  auto name() const { return std::tuple(body_A, body_B, which); }
};

/// What follows of points and normals from where the bodies are stored.
class Centres {
 public:
  Centres(const ContactChunk& chunk, const Steps& steps)
      : chunk_(chunk), ratio_(steps.place / chunk.scale.position_step), normal_step_(steps.normal) {}

  /// Middle of the centres of mass of the bodies that are not fixed, in steps of places.
  std::array<std::int64_t, 3> middle(const TouchingPoint& point, const State& state) const {
    std::array<std::int64_t, 3> sum{};
    int count = 0;
    for (const int body : {point.body_A, point.body_B}) {
      if (is_fixed(body)) continue;
      for (int c = 0; c < 3; ++c) sum[at(c)] += place(body, state, c);
      ++count;
    }
    if (count == 0) return {};
    // Steps are powers of two, so nothing is rounded but here.
    for (std::int64_t& own : sum)
      own = static_cast<std::int64_t>(std::floor(static_cast<double>(own) / (count * ratio_) + 0.5));
    return sum;
  }

  /// The direction from the centre of A to that of B, in steps of normals; none if one of them is fixed.
  std::array<std::int64_t, 3> direction(const TouchingPoint& point, const State& state) const {
    if (is_fixed(point.body_A) || is_fixed(point.body_B)) return {};
    std::array<double, 3> d{};
    double square = 0;
    for (int c = 0; c < 3; ++c) {
      d[at(c)] = static_cast<double>(place(point.body_B, state, c) - place(point.body_A, state, c));
      square += d[at(c)] * d[at(c)];
    }
    if (square == 0) return {};
    const double scale = std::sqrt(square) * normal_step_;
    std::array<std::int64_t, 3> result{};
    for (std::size_t c = 0; c < 3; ++c) result[c] = static_cast<std::int64_t>(std::floor(d[c] / scale + 0.5));
    return result;
  }

 private:
  bool is_fixed(int body) const { return chunk_.model.body(body).motion == MotionType::fixed; }
  std::int64_t place(int body, const State& state, int c) const {
    return quantised(state.x[3 * at(body) + at(c)] - chunk_.scale.origin[c], chunk_.scale.position_step);
  }

  const ContactChunk& chunk_;
  double ratio_, normal_step_;
};

Numbers numbers_of(const TouchingPoint& point, const Steps& steps, const PageScale& scale) {
  Numbers result{};
  result[0] = static_cast<std::int64_t>(point.mode);
  result[1] = quantised(point.gap, steps.gap);
  for (int k = 0; k < 3; ++k) {
    const std::size_t place = at(k);
    result[2 + place] = quantised(point.p_W[k] - scale.origin[k], steps.place);
    result[5 + place] = quantised(point.n_W[k], steps.normal);
    result[8 + place] = quantised(point.force_W[k], steps.force);
  }
  return result;
}

/// The columns of a chunk, to which frame after frame is added.
class ContactColumns {
 public:
  explicit ContactColumns(ColumnOrder order) : order_(order) {}

  void add(std::vector<Stored> now) {
    find_earlier(now);
    append_changes(now);
    for (const Stored& contact : now) append_numbers(contact);
    before_ = std::exchange(last_, std::move(now));
  }

  std::string bytes() const {
    std::string all;
    for (const std::string* column : {&new_counts_, &runs_, &bodies_A_, &bodies_B_}) all += *column;
    for (const std::string& column : numbers_) all += column;
    return all;
  }

 private:
  /// Both frames are in the order of names.
  void find_earlier(std::vector<Stored>& now) {
    stays_.assign(last_.size(), false);
    std::size_t i = 0;
    for (Stored& contact : now) {
      while (i < last_.size() && last_[i].name() < contact.name()) ++i;
      const bool was_there = i < last_.size() && last_[i].name() == contact.name();
      contact.from = was_there ? static_cast<int>(i) : -1;
      if (was_there) stays_[i] = true;
    }
  }

  void append_changes(const std::vector<Stored>& now) {
    // Which of the last frame stay: lengths of runs, beginning with one that stays.
    bool stays = true;
    std::int64_t length = 0;
    for (const bool own : stays_) {
      if (own != stays) {
        append_varint(length, runs_);
        stays = own, length = 0;
      }
      ++length;
    }
    if (!stays_.empty()) append_varint(length, runs_);
    // What is new.
    std::int64_t count = 0;
    int last_A = 0;
    for (const Stored& contact : now) {
      if (contact.from >= 0) continue;
      append_varint(contact.body_A - last_A, bodies_A_);
      append_varint(contact.body_B - contact.body_A, bodies_B_);
      last_A = contact.body_A;
      ++count;
    }
    append_varint(count, new_counts_);
  }

  void append_numbers(const Stored& contact) {
    const Stored* const newer = contact.from < 0 ? nullptr : &last_[at(contact.from)];
    const Stored* const older = !newer || newer->from < 0 ? nullptr : &before_[at(newer->from)];
    for (std::size_t k = 0; k < numbers_of_contact; ++k) {
      std::int64_t guess = newer ? newer->numbers[k] : 0;
      if (order_ == ColumnOrder::linear && older && k >= first_smooth && k < end_smooth)
        guess += newer->numbers[k] - older->numbers[k];
      append_varint(contact.numbers[k] - guess, numbers_[k]);
    }
  }

  ColumnOrder order_;
  std::vector<Stored> last_, before_;
  std::vector<bool> stays_;
  std::string new_counts_, runs_, bodies_A_, bodies_B_;
  std::array<std::string, numbers_of_contact> numbers_;
};

}  // namespace

PageBlock packed_contacts(const ContactChunk& chunk) {
  // Which points are stored, and how finely.
  bool is_crowded = false;
  std::vector<Points> frames;
  for (std::size_t f = 0; f < chunk.frames.size(); ++f) frames.push_back(stored_points(chunk, f, is_crowded));
  const Steps steps = steps_of(chunk, frames, is_crowded);
  const ColumnOrder order = is_crowded ? ColumnOrder::constant : ColumnOrder::linear;

  // The numbers of each contact, as residuals of their prediction.
  ContactColumns columns(order);
  const Centres centres(chunk, steps);
  for (std::size_t f = 0; f < frames.size(); ++f) {
    std::vector<Stored> stored;
    stored.reserve(frames[f].size());
    for (const TouchingPoint& point : frames[f]) {
      const bool is_same =
          !stored.empty() && stored.back().body_A == point.body_A && stored.back().body_B == point.body_B;
      Stored& own =
          stored.emplace_back(Stored{point.body_A, point.body_B, is_same ? stored.back().which + 1 : 0, -1,
                                     numbers_of(point, steps, chunk.scale)});
      const State& state = *chunk.frames[f].state;
      const std::array<std::int64_t, 3> middle = centres.middle(point, state),
                                        direction = order == ColumnOrder::constant
                                                        ? centres.direction(point, state)
                                                        : std::array<std::int64_t, 3>{};
      for (std::size_t c = 0; c < 3; ++c) {
        own.numbers[2 + c] -= middle[c];
        own.numbers[5 + c] -= direction[c];
      }
    }
    columns.add(std::move(stored));
  }

  // The header of the chunk, then one column after the other.
  std::string bytes;
  for (const double step : {steps.force, steps.gap, steps.place, steps.normal}) append_f64(step, bytes);
  append_u32(static_cast<std::uint32_t>(order), bytes);
  append_u32(static_cast<std::uint32_t>(frames.size()), bytes);
  bytes += columns.bytes();
  return make_page_block("contacts", bytes);
}

}  // namespace rigor
