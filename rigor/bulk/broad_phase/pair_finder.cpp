#include "rigor/bulk/broad_phase/pair_finder.hpp"

#include "rigor/bulk/broad_phase/near_bodies.hpp"
#include "rigor/bulk/broad_phase/pair_filter.hpp"
#include "rigor/bulk/broad_phase/pair_lanes.hpp"
#include "rigor/bulk/broad_phase/shape_places.hpp"
#include "rigor/bulk/broad_phase/unbounded_shapes.hpp"
#include "rigor/bulk/lanes/list_room.hpp"
#include "rigor/bulk/state/shape_ranges.hpp"
#include "rigor/core/index.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <limits>
#include <span>
#include <tuple>
#include <unordered_map>
#include <utility>

namespace rigor {

namespace {

/// A bounded shape of a body.
struct BoundedShape {
  int shape;  ///< Index among the shapes of the body.
  int bound;  ///< Index among the bounds.
  int box;    ///< Index among the boxes of shapes; -1 if its box is that of the body.
};

}  // namespace

/// What the search needs of the Model, and its working memory.
struct PairFinder::Tables {
  struct Step {
    const BulkBodies& bodies;
    float h, margin;
  };

  using Kind = NearBodies::Kind;

  explicit Tables(const Model& model);
  void set_bodies(const Model& model, std::span<const int> bodies);
  float add_body(const Model& model, int index);
  void list_moving();
  float mean_size() const;
  void find_simple(int first, int last);
  int bound_of(const BodyShape& shape);
  void update(const Step& step, const Executor& executor);
  FloatBox update_body(const Step& step, int body);
  void update_eight(const Step& step, int body);
  void add_near(const Step& step, int begin, int end, std::vector<ShapePair>& pairs) const;
  unsigned find_touching(const NearBodies::Pair* near, int count) const;
  template <class Add>
  void for_shapes(const NearBodies::Pair& near, const Add& add) const;
  void add_those_near(const Step& step, std::span<const ShapePair> found,
                      std::vector<ShapePair>& pairs) const;
  void add_unbounded(const Step& step, std::vector<ShapePair>& pairs) const;

  PairFilter filter;
  std::function<bool(int, int)> may_touch;  ///< The caller's filter, or none.
  std::vector<BoundedShape> shapes;         ///< Bounded shapes of all bodies.
  ShapeRanges ranges;
  std::vector<Kind> kinds;         ///< Of each body.
  std::vector<double> sizes;       ///< Of each body [m].
  std::vector<int> moving;         ///< Bodies of that kind, ascending.
  std::vector<char> are_simple;    ///< Whether this body and the next seven have one unrotated shape each.
  std::vector<ShapeBound> bounds;  ///< Bounds; bodies that share their shapes share these.
  std::unordered_map<const BodyShape*, int> bound_numbers;
  std::vector<UnboundedShape> unbounded;
  std::unique_ptr<NearBodies> near_bodies;
  LaneTarget target = best_lane_target();

  Vec3 origin = Vec3::Zero();  ///< Origin of all 32-bit numbers: the position of a body, so that scenes far
                               ///< from the origin of W lose no digits.
  std::vector<ShapePlace> places;
  std::vector<FloatBox> shape_boxes, body_boxes;
  std::vector<std::vector<ShapePair>> parts;  ///< Pairs found by several threads.
  std::vector<ShapePair> at_unbounded;
};

PairFinder::Tables::Tables(const Model& model)
    : filter(model),
      ranges(at(model.body_count())),
      kinds(at(model.body_count()), Kind::none),
      sizes(at(model.body_count()), 0),
      are_simple(at(model.body_count()), 0) {
  std::vector<int> standing;
  std::vector<float> radii;
  shapes.reserve(at(model.body_count()));
  places.reserve(at(model.body_count()));
  for (int i = 0; i < model.body_count(); ++i) {
    radii.push_back(add_body(model, i));
    if (kinds[at(i)] == Kind::standing) standing.push_back(i);
  }
  list_moving();
  find_simple(0, model.body_count() - 1);
  near_bodies = std::make_unique<NearBodies>(moving, std::move(standing), std::move(radii), mean_size());
  body_boxes.resize(at(model.body_count()) + 1);  // Each box has two more numbers behind it (RoundBoxPair).
}

void PairFinder::Tables::set_bodies(const Model& model, std::span<const int> bodies) {
  std::vector<char> has_changed(at(model.body_count()), 0);
  for (const int body : bodies) has_changed[at(body)] = 1;
  std::erase_if(unbounded, [&](const UnboundedShape& shape) { return has_changed[at(shape.body)] != 0; });
  std::vector<NearBodies::Change> changes;
  for (const int body : bodies) {
    filter.set_body(model, body);
    const float radius = add_body(model, body);
    changes.push_back({body, kinds[at(body)], radius});
  }
  for (const int body : bodies) find_simple(body - 7, body);
  list_moving();
  near_bodies->change(changes, mean_size());
}

/// Adds the shapes of a body; returns the radius of the rounded edges of the box around all bounded ones.
float PairFinder::Tables::add_body(const Model& model, int index) {
  const Body& body = model.body(index);
  std::vector<BoundedShape> own;
  float radius = std::numeric_limits<float>::infinity();
  for (std::size_t s = 0; s < body.shapes.size(); ++s) {
    // Unbounded shapes are tested against all moving bodies; only bounded ones have boxes.
    if (is_unbounded(body.shapes[s].shape)) {
      unbounded.push_back(make_unbounded_shape(index, static_cast<int>(s), body.shapes[s]));
      continue;
    }
    const int bound = bound_of(body.shapes[s]);
    own.push_back({static_cast<int>(s), bound, -1});
    radius = std::min(radius, bounds[at(bound)].radius);
  }
  // A single shape has the box of its body; several have one each besides.
  for (std::size_t k = 0; k < own.size() && own.size() > 1; ++k) {
    own[k].box = static_cast<int>(shape_boxes.size());
    shape_boxes.emplace_back();
  }
  ranges.give(index, static_cast<int>(own.size()));
  if (shapes.size() < ranges.size()) {
    make_room(ranges.size(), shapes);
    make_room(ranges.size(), places);
    shapes.resize(ranges.size());
    places.resize(ranges.size());
  }
  std::copy(own.begin(), own.end(), shapes.begin() + ranges.begin(index));
  const bool is_dynamic = body.motion == MotionType::dynamic;
  kinds[at(index)] = own.empty() ? Kind::none : (is_dynamic ? Kind::moving : Kind::standing);
  sizes[at(index)] = 2 * body.bounding_radius;
  return own.empty() ? 0 : radius;
}

void PairFinder::Tables::list_moving() {
  moving.clear();
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    if (kinds[i] == Kind::moving) moving.push_back(static_cast<int>(i));
  }
}

/// The mean size of the dynamic bodies, which is that of a cell [m].
float PairFinder::Tables::mean_size() const {
  double sum = 0;
  for (const int body : moving) sum += sizes[at(body)];
  return moving.empty() ? 1.0f : static_cast<float>(sum / static_cast<double>(moving.size()));
}

/// Where eight bodies in a row have one shape each, along the axes of the body, their boxes are made in
/// lanes. Finds out which of the bodies from the first to the last begin such a row.
void PairFinder::Tables::find_simple(int first, int last) {
  const int count = static_cast<int>(are_simple.size());
  int simple = 0;  // How many from this body on, at most eight.
  for (int i = std::min(last + 7, count - 1); i >= std::max(first, 0); --i) {
    const int begin = ranges.begin(i);
    const bool is_simple = ranges.count(i) == 1 && !bounds[at(shapes[at(begin)].bound)].is_turned;
    // Their places are one behind the other.
    const bool continues = simple > 0 && ranges.begin(i + 1) == begin + 1;
    simple = is_simple ? (continues ? std::min(simple + 1, 8) : 1) : 0;
    if (i <= last) are_simple[at(i)] = simple == 8;
  }
}

int PairFinder::Tables::bound_of(const BodyShape& shape) {
  const auto [known, is_new] = bound_numbers.emplace(&shape, static_cast<int>(bounds.size()));
  if (is_new) bounds.push_back(make_shape_bound(shape));
  return known->second;
}

/// Updates the places and swept boxes of all shapes, and which bodies are near each other.
void PairFinder::Tables::update(const Step& step, const Executor& executor) {
  constexpr int grain = 64;
  // The origin is the position of a moving body, so that a scene far away has the same bits.
  if (!moving.empty()) origin = step.bodies.x[at(moving[moving.size() / 2])];
  executor.for_ranges(step.bodies.count(), grain, [&](int begin, int end) {
    for (int body = begin; body < end;) {
      // Eight simple bodies at once; others one by one. Both give the same bits.
      if (body + 8 <= end && are_simple[at(body)]) {
        update_eight(step, body);
        body += 8;
        continue;
      }
      if (ranges.count(body) > 0) body_boxes[at(body)] = update_body(step, body);
      ++body;
    }
  });
  near_bodies->update({body_boxes, step.bodies.motion, step.h, origin}, filter, executor);
}

/// Updates this body and the next seven, where are_simple is true.
void PairFinder::Tables::update_eight(const Step& step, int body) {
  std::array<const ShapeBound*, 8> of_eight;
  for (int i = 0; i < 8; ++i) {
    of_eight[at(i)] = &bounds[at(shapes[at(ranges.begin(body + i))].bound)];
  }
  sweep_eight_shapes(of_eight, step.bodies, body, {origin, step.h, 0.5f * step.margin},
                     &places[at(ranges.begin(body))], &body_boxes[at(body)]);
}

/// Updates the bounded shapes of a body; returns the box of them all.
FloatBox PairFinder::Tables::update_body(const Step& step, int body) {
  // The box of the body is the union of those of its shapes.
  FloatBox all{};
  for (int s = ranges.begin(body); s < ranges.end(body); ++s) {
    const BoundedShape& shape = shapes[at(s)];
    const auto [place, box] =
        sweep_shape(bounds[at(shape.bound)], step.bodies, body, origin, step.h, 0.5f * step.margin);
    places[at(s)] = place;
    if (shape.box < 0) return box;
    shape_boxes[at(shape.box)] = box;
    const bool is_first = s == ranges.begin(body);
    for (int k = 0; k < 3; ++k) {
      all.lower[k] = is_first ? box.lower[k] : std::min(all.lower[k], box.lower[k]);
      all.upper[k] = is_first ? box.upper[k] : std::max(all.upper[k], box.upper[k]);
    }
  }
  return all;
}

/// Adds the pairs of shapes of a range of the pairs of bodies that are near each other.
void PairFinder::Tables::add_near(const Step& step, int begin, int end, std::vector<ShapePair>& pairs) const {
  const std::vector<NearBodies::Pair>& near = near_bodies->pairs();
  make_room(pairs.size() + at(end - begin), pairs);
  std::array<ShapePair, kLaneCount> waiting;  // With the indices of their shapes among all shapes.
  std::size_t count = 0;
  const auto add = [&](const ShapePair& pair) {
    waiting[count++] = pair;
    if (count < waiting.size()) return;
    add_those_near(step, waiting, pairs);
    count = 0;
  };
  // The boxes of eight pairs of bodies at a time; the pairs of shapes that are left fill lanes of their own.
  for (int i = begin; i < end; i += kLaneCount) {
    unsigned touching = find_touching(&near[at(i)], std::min(kLaneCount, end - i));
    for (; touching != 0; touching &= touching - 1) {
      const NearBodies::Pair& pair = near[at(i + std::countr_zero(touching))];
      // Contacts of two bodies that do not move stay as they are.
      if (!step.bodies.moves(pair.a) && !step.bodies.moves(pair.b)) continue;
      if (may_touch && !may_touch(pair.a, pair.b)) continue;
      for_shapes(pair, add);
    }
  }
  add_those_near(step, std::span(waiting.data(), count), pairs);
}

/// The bits of those of 1 to 8 pairs whose boxes touch.
unsigned PairFinder::Tables::find_touching(const NearBodies::Pair* near, int count) const {
  std::array<RoundBoxPair, kLaneCount> boxes;
  for (int i = 0; i < kLaneCount; ++i) {
    const auto [a, b] = near[i < count ? i : 0];
    boxes[at(i)] = {&body_boxes[at(a)], &body_boxes[at(b)], near_bodies->radius(a) + near_bodies->radius(b)};
  }
  return find_touching_boxes(boxes, target) & ((1u << count) - 1);
}

/// Calls add(pair) for each two shapes, of two bodies a < b whose boxes overlap, whose own boxes overlap too.
template <class Add>
void PairFinder::Tables::for_shapes(const NearBodies::Pair& near, const Add& add) const {
  const auto [a, b] = near;
  const int begin_A = ranges.begin(a), end_A = ranges.end(a);
  const int begin_B = ranges.begin(b), end_B = ranges.end(b);
  // Bodies with one shape each have no other boxes to test.
  if (end_A - begin_A == 1 && end_B - begin_B == 1) return add(ShapePair{a, b, begin_A, begin_B, 0});
  for (int i = begin_A; i < end_A; ++i) {
    for (int j = begin_B; j < end_B; ++j) {
      const int box_A = shapes[at(i)].box, box_B = shapes[at(j)].box;
      if ((box_A < 0 ? body_boxes[at(a)] : shape_boxes[at(box_A)])
              .overlaps(box_B < 0 ? body_boxes[at(b)] : shape_boxes[at(box_B)]))
        add(ShapePair{a, b, i, j, 0});
    }
  }
}

/// Adds those of at most eight pairs of shapes that may come within their margins.
void PairFinder::Tables::add_those_near(const Step& step, std::span<const ShapePair> found,
                                        std::vector<ShapePair>& pairs) const {
  if (found.empty()) return;
  std::array<ShapePlacePair, kLaneCount> both;
  for (std::size_t i = 0; i < both.size(); ++i) {
    const ShapePair& pair = found[i < found.size() ? i : 0];
    both[i] = {&places[at(pair.shape_A)], &places[at(pair.shape_B)]};
  }
  // Margins and balls in lanes; the box of the larger shape is asked for only where it may tell more.
  const PairMargins margins = find_pair_margins(both, step.h, step.margin, target);
  for (std::size_t i = 0; i < found.size(); ++i) {
    const ShapePair& pair = found[i];
    // Balls first, then the box of the larger shape.
    if ((margins.near >> i & 1) == 0) continue;
    if ((margins.asks_box >> i & 1) != 0 &&
        !find_pair_margin(
            {*both[i].a, *both[i].b, step.bodies.q[at(pair.body_A)], step.bodies.q[at(pair.body_B)]}, step.h,
            step.margin))
      continue;
    pairs.push_back({pair.body_A, pair.body_B, shapes[at(pair.shape_A)].shape, shapes[at(pair.shape_B)].shape,
                     margins.margin[i]});
  }
}

/// Adds the pairs of dynamic bodies and unbounded shapes.
void PairFinder::Tables::add_unbounded(const Step& step, std::vector<ShapePair>& pairs) const {
  for (const UnboundedShape& other : unbounded) {
    const UnboundedPlace place = place_of(other, step.bodies, origin);
    for (const int body : moving) {
      if (!step.bodies.moves(other.body) && !step.bodies.moves(body)) continue;
      if (!filter.may_collide(other.body, body)) continue;
      if (may_touch && !may_touch(std::min(other.body, body), std::max(other.body, body))) continue;
      for (int s = ranges.begin(body); s < ranges.end(body); ++s) {
        // The margin, with how far both can come to each other within the step.
        const float margin = step.margin + approach_bound(place, places[at(s)], step.h);
        if (!may_be_within(other, place, places[at(s)], step.bodies.q[at(body)], margin)) continue;
        // Pairs are named with the lower body first.
        if (other.body < body) {
          pairs.push_back({other.body, body, other.shape, shapes[at(s)].shape, margin});
        } else {
          pairs.push_back({body, other.body, shapes[at(s)].shape, other.shape, margin});
        }
      }
    }
  }
}

namespace {

bool is_before(const ShapePair& p, const ShapePair& q) {
  return std::tie(p.body_A, p.body_B, p.shape_A, p.shape_B) <
         std::tie(q.body_A, q.body_B, q.shape_A, q.shape_B);
}

}  // namespace

PairFinder::PairFinder(const Model& model) : tables_(std::make_unique<Tables>(model)) {}
PairFinder::~PairFinder() = default;

void PairFinder::set_contact_filter(std::function<bool(int, int)> may_touch) {
  tables_->may_touch = std::move(may_touch);
}

void PairFinder::set_bodies(const Model& model, std::span<const int> bodies) {
  tables_->set_bodies(model, bodies);
}

void PairFinder::set_excluded(const Model& model) {
  tables_->filter.set_excluded(model);
}

void PairFinder::find_pairs(const BulkBodies& bodies, double h, double margin, const Executor& executor,
                            std::vector<ShapePair>& pairs) {
  // Bodies near each other first, then pairs of their shapes, in parts.
  constexpr int pairs_of_a_part = 512;
  Tables& tables = *tables_;
  const Tables::Step step{bodies, static_cast<float>(h), static_cast<float>(margin)};
  tables.update(step, executor);
  const int near_count = static_cast<int>(tables.near_bodies->pairs().size());
  const int part_count = (near_count + pairs_of_a_part - 1) / pairs_of_a_part;
  const auto add_part = [&](int k, std::vector<ShapePair>& found) {
    tables.add_near(step, k * pairs_of_a_part, std::min((k + 1) * pairs_of_a_part, near_count), found);
  };
  pairs.clear();
  if (executor.threads() == 1) {
    for (int k = 0; k < part_count; ++k) add_part(k, pairs);
  } else {
    // Each part has its own list; one behind the other they are in order, whichever thread made them.
    if (tables.parts.size() < at(part_count)) tables.parts.resize(at(part_count));
    executor.for_ranges(part_count, 1, [&](int begin, int end) {
      for (int k = begin; k < end; ++k) {
        std::vector<ShapePair> found;
        found.swap(tables.parts[at(k)]);  // Neighbouring list heads share a cache line.
        found.clear();
        add_part(k, found);
        found.swap(tables.parts[at(k)]);
      }
    });
    for (int k = 0; k < part_count; ++k) {
      make_room(pairs.size() + tables.parts[at(k)].size(), pairs);
      pairs.insert(pairs.end(), tables.parts[at(k)].begin(), tables.parts[at(k)].end());
    }
  }
  // Pairs with unbounded shapes are merged in, so that all are in the order of their keys.
  if (tables.unbounded.empty()) return;
  tables.at_unbounded.clear();
  tables.add_unbounded(step, tables.at_unbounded);
  std::sort(tables.at_unbounded.begin(), tables.at_unbounded.end(), is_before);
  merge_into(tables.at_unbounded, is_before, pairs);
}

}  // namespace rigor
