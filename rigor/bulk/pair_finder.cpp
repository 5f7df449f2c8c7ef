#include "rigor/bulk/pair_finder.hpp"

#include "rigor/bulk/near_bodies.hpp"
#include "rigor/bulk/pair_filter.hpp"
#include "rigor/bulk/shape_places.hpp"
#include "rigor/bulk/unbounded_shapes.hpp"

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <utility>

namespace rigor {

namespace {

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

/// A shape with an end, of a body.
struct BoundedShape {
  int shape;  ///< Of the body.
  ShapeBound bound;
};

}  // namespace

/// What of the Model it needs, and room to work.
struct PairFinder::Tables {
  struct Step {
    const BulkBodies& bodies;
    float h, margin;
  };

  explicit Tables(const Model& model);
  void update(const Step& step, const Executor& executor);
  FloatBox update_body(const Step& step, int body);
  void add_pairs(const Step& step, int a, int b, std::vector<ShapePair>& pairs) const;
  void add_pair(const Step& step, const ShapePair& pair, std::vector<ShapePair>& pairs) const;
  void add_unbounded(const Step& step, std::vector<ShapePair>& pairs) const;

  PairFilter filter;
  std::function<bool(int, int)> may_touch;  ///< The caller's, or none.
  std::vector<BoundedShape> shapes;         ///< Of all bodies.
  std::vector<int> shape_begin;             ///< Of each body, and the end.
  std::vector<UnboundedShape> unbounded;
  std::vector<int> moving, bounded;  ///< Dynamic bodies with bounded shapes, and all bodies with some.
  std::unique_ptr<NearBodies> near_bodies;

  Vec3 origin = Vec3::Zero();  ///< Of what is in 32 bits: a body's place, so that far scenes lose nothing.
  std::vector<ShapePlace> places;
  std::vector<FloatBox> shape_boxes, body_boxes;
  std::vector<float> ways;  ///< Of bodies within the step, three each [m].
  std::vector<std::vector<ShapePair>> parts;
  std::vector<ShapePair> at_unbounded, merged;
};

PairFinder::Tables::Tables(const Model& model) : filter(model) {
  double size = 0;
  std::vector<int> standing;
  for (int i = 0; i < model.body_count(); ++i) {
    const Body& body = model.body(i);
    shape_begin.push_back(static_cast<int>(shapes.size()));
    for (std::size_t s = 0; s < body.shapes.size(); ++s) {
      const BodyShape& shape = body.shapes[s];
      if (is_unbounded(shape.shape)) {
        unbounded.push_back(make_unbounded_shape(i, static_cast<int>(s), shape));
      } else {
        shapes.push_back({static_cast<int>(s), make_shape_bound(shape)});
      }
    }
    if (shape_begin.back() == static_cast<int>(shapes.size())) continue;
    const bool is_dynamic = body.motion == MotionType::dynamic;
    (is_dynamic ? moving : standing).push_back(i);
    bounded.push_back(i);
    if (is_dynamic) size += 2 * body.bounding_radius;
  }
  shape_begin.push_back(static_cast<int>(shapes.size()));
  // The mean size of the dynamic bodies.
  const float cell = moving.empty() ? 1.0f : static_cast<float>(size / static_cast<double>(moving.size()));
  near_bodies = std::make_unique<NearBodies>(moving, standing, model.body_count(), cell);
  places.resize(shapes.size());
  shape_boxes.resize(shapes.size());
  body_boxes.resize(at(model.body_count()));
  ways.resize(3 * at(model.body_count()));
}

/// Places and boxes of all shapes, and which bodies are near.
void PairFinder::Tables::update(const Step& step, const Executor& executor) {
  constexpr int grain = 64;
  if (!moving.empty()) origin = step.bodies.x[at(moving[moving.size() / 2])];
  executor.for_ranges(static_cast<int>(bounded.size()), grain, [&](int begin, int end) {
    for (int i = begin; i < end; ++i) {
      const int body = bounded[at(i)];
      body_boxes[at(body)] = update_body(step, body);
      for (int k = 0; k < 3; ++k) ways[3 * at(body) + at(k)] = step.h * step.bodies.motion[at(body)].v[k];
    }
  });
  near_bodies->update({body_boxes, ways, origin}, filter, executor);
}

/// Returns the box of all its bounded shapes.
FloatBox PairFinder::Tables::update_body(const Step& step, int body) {
  FloatBox all{};
  for (int s = shape_begin[at(body)]; s < shape_begin[at(body) + 1]; ++s) {
    const ShapeBound& bound = shapes[at(s)].bound;
    places[at(s)] = place_of(bound, step.bodies, body, origin);
    const FloatBox box =
        swept_box(places[at(s)], bound, step.bodies.motion[at(body)], step.h, 0.5f * step.margin);
    shape_boxes[at(s)] = box;
    const bool is_first = s == shape_begin[at(body)];
    for (int k = 0; k < 3; ++k) {
      all.lower[k] = is_first ? box.lower[k] : std::min(all.lower[k], box.lower[k]);
      all.upper[k] = is_first ? box.upper[k] : std::max(all.upper[k], box.upper[k]);
    }
  }
  return all;
}

/// Of two bodies, a < b.
void PairFinder::Tables::add_pairs(const Step& step, int a, int b, std::vector<ShapePair>& pairs) const {
  if (!body_boxes[at(a)].overlaps(body_boxes[at(b)])) return;
  if (!step.bodies.stirs(a) && !step.bodies.stirs(b)) return;
  if (may_touch && !may_touch(a, b)) return;
  const int begin_A = shape_begin[at(a)], end_A = shape_begin[at(a) + 1];
  const int begin_B = shape_begin[at(b)], end_B = shape_begin[at(b) + 1];
  if (end_A - begin_A == 1 && end_B - begin_B == 1) return add_pair(step, {a, b, begin_A, begin_B, 0}, pairs);
  for (int i = begin_A; i < end_A; ++i) {
    for (int j = begin_B; j < end_B; ++j) {
      if (shape_boxes[at(i)].overlaps(shape_boxes[at(j)])) add_pair(step, {a, b, i, j, 0}, pairs);
    }
  }
}

/// `pair` has the numbers of its shapes among all shapes.
void PairFinder::Tables::add_pair(const Step& step, const ShapePair& pair,
                                  std::vector<ShapePair>& pairs) const {
  const std::optional<float> margin =
      find_pair_margin(places[at(pair.shape_A)], places[at(pair.shape_B)], step.h, step.margin);
  if (!margin) return;
  pairs.push_back(
      {pair.body_A, pair.body_B, shapes[at(pair.shape_A)].shape, shapes[at(pair.shape_B)].shape, *margin});
}

/// Dynamic bodies against all shapes without an end.
void PairFinder::Tables::add_unbounded(const Step& step, std::vector<ShapePair>& pairs) const {
  for (const UnboundedShape& other : unbounded) {
    const UnboundedPlace place = place_of(other, step.bodies, origin);
    for (const int body : moving) {
      if (!step.bodies.stirs(other.body) && !step.bodies.stirs(body)) continue;
      if (!filter.may_collide(other.body, body)) continue;
      if (may_touch && !may_touch(std::min(other.body, body), std::max(other.body, body))) continue;
      for (int s = shape_begin[at(body)]; s < shape_begin[at(body) + 1]; ++s) {
        const float margin = step.margin + approach_bound(place, places[at(s)], step.h);
        if (!may_be_within(other, place, places[at(s)], margin)) continue;
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

void PairFinder::find_pairs(const BulkBodies& bodies, double h, double margin, const Executor& executor,
                            std::vector<ShapePair>& pairs) {
  constexpr int pairs_of_a_part = 512;
  Tables& tables = *tables_;
  const Tables::Step step{bodies, static_cast<float>(h), static_cast<float>(margin)};
  tables.update(step, executor);
  // Each part has its own list; one behind the other they are in order.
  const std::vector<NearBodies::Pair>& near = tables.near_bodies->pairs();
  const int near_count = static_cast<int>(near.size());
  const int part_count = (near_count + pairs_of_a_part - 1) / pairs_of_a_part;
  if (tables.parts.size() < at(part_count)) tables.parts.resize(at(part_count));
  executor.for_ranges(part_count, 1, [&](int begin, int end) {
    for (int k = begin; k < end; ++k) {
      std::vector<ShapePair> found;
      found.swap(tables.parts[at(k)]);  // Heads of lists side by side are in one line of the cache.
      found.clear();
      const int last = std::min((k + 1) * pairs_of_a_part, near_count);
      for (int i = k * pairs_of_a_part; i < last; ++i)
        tables.add_pairs(step, near[at(i)].a, near[at(i)].b, found);
      found.swap(tables.parts[at(k)]);
    }
  });
  pairs.clear();
  for (int k = 0; k < part_count; ++k)
    pairs.insert(pairs.end(), tables.parts[at(k)].begin(), tables.parts[at(k)].end());
  if (tables.unbounded.empty()) return;
  tables.at_unbounded.clear();
  tables.add_unbounded(step, tables.at_unbounded);
  std::sort(tables.at_unbounded.begin(), tables.at_unbounded.end(), is_before);
  tables.merged.resize(pairs.size() + tables.at_unbounded.size());
  std::merge(pairs.begin(), pairs.end(), tables.at_unbounded.begin(), tables.at_unbounded.end(),
             tables.merged.begin(), is_before);
  pairs.swap(tables.merged);
}

}  // namespace rigor
