#include "rigor/bulk/pair_finder.hpp"

#include "rigor/bulk/pair_filter.hpp"
#include "rigor/bulk/pair_order.hpp"
#include "rigor/bulk/shape_places.hpp"
#include "rigor/bulk/unbounded_shapes.hpp"

#include <algorithm>
#include <cstddef>
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
  /// Bodies of one kind by number, their boxes, and those in a tree.
  struct Side {
    std::vector<int> bodies;
    std::vector<FloatBox> boxes;
    BoxTree tree;
  };
  /// What is found by whom does not matter: each part of the blocks has its own list.
  struct Part {
    std::vector<BoxTree::Pair> candidates;
    std::vector<ShapePair> pairs;
  };
  struct Step {
    const BulkBodies& bodies;
    float h, margin;
  };

  explicit Tables(const Model& model);
  void choose_sides(const BulkBodies& bodies);
  void update(const Step& step, const Executor& executor);
  FloatBox update_body(const Step& step, int body);
  void search_blocks(const Step& step, int begin, int end, Part& part) const;
  void add_pairs(const Step& step, int a, int b, std::vector<ShapePair>& pairs) const;
  void add_pair(const Step& step, const ShapePair& pair, std::vector<ShapePair>& pairs) const;
  void add_unbounded(const Step& step, const Side& side, int begin, int end,
                     std::vector<ShapePair>& pairs) const;

  PairFilter filter;
  std::function<bool(int, int)> may_touch;  ///< The caller's, or none.
  std::vector<BoundedShape> shapes;         ///< Of all bodies.
  std::vector<int> shape_begin;             ///< Of each body, and the end.
  std::vector<UnboundedShape> unbounded;
  std::vector<int> bounded_bodies;  ///< Those with bounded shapes.
  std::vector<bool> may_move;       ///< Of each body: it is dynamic, asleep or not.
  Side moving, standing;            ///< Bodies that look for others; those that are found by them.
  bool has_sleepers = false;
  int middle_body = 0;  ///< A dynamic body in the middle of the list, if there is one.
  float cell = 1;       ///< Mean size of the dynamic bodies [m].

  Vec3 origin = Vec3::Zero();  ///< Of what is in 32 bits: a body's place, so that far scenes lose nothing.
  std::vector<ShapePlace> places;
  std::vector<FloatBox> shape_boxes;  ///< Used of bodies with several shapes.
  std::vector<Part> parts;
  PairOrder order;
};

PairFinder::Tables::Tables(const Model& model) : filter(model) {
  double size = 0;
  std::vector<int> dynamic;
  for (int i = 0; i < model.body_count(); ++i) {
    const Body& body = model.body(i);
    may_move.push_back(body.motion == MotionType::dynamic);
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
    bounded_bodies.push_back(i);
    if (!may_move.back()) continue;
    size += 2 * body.bounding_radius;
    dynamic.push_back(i);
  }
  shape_begin.push_back(static_cast<int>(shapes.size()));
  if (!dynamic.empty()) {
    cell = static_cast<float>(size / static_cast<double>(dynamic.size()));
    middle_body = dynamic[dynamic.size() / 2];
  }
  places.resize(shapes.size());
  shape_boxes.resize(shapes.size());
}

/// Those that sleep stand with the others; kinematic bodies that move look for them too, to wake them.
void PairFinder::Tables::choose_sides(const BulkBodies& bodies) {
  moving.bodies.clear();
  standing.bodies.clear();
  has_sleepers = false;
  for (const int body : bounded_bodies)
    has_sleepers = has_sleepers || (may_move[at(body)] && !bodies.is_dynamic(body));
  for (const int body : bounded_bodies) {
    const bool looks = has_sleepers ? bodies.stirs(body) : may_move[at(body)];
    (looks ? moving : standing).bodies.push_back(body);
  }
}

/// Places and boxes of all shapes, and the trees.
void PairFinder::Tables::update(const Step& step, const Executor& executor) {
  constexpr int grain = 64;
  choose_sides(step.bodies);
  origin = step.bodies.x[at(middle_body)];
  for (Side* side : {&moving, &standing}) {
    side->boxes.resize(side->bodies.size());
    executor.for_ranges(static_cast<int>(side->bodies.size()), grain, [&](int begin, int end) {
      for (int i = begin; i < end; ++i) side->boxes[at(i)] = update_body(step, side->bodies[at(i)]);
    });
    side->tree.build(side->boxes, cell);
  }
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

void PairFinder::Tables::search_blocks(const Step& step, int begin, int end, Part& part) const {
  part.candidates.clear();
  for (int block = begin; block < end; ++block) moving.tree.find_own_pairs(block, part.candidates);
  for (const BoxTree::Pair& pair : part.candidates)
    add_pairs(step, moving.bodies[at(pair.a)], moving.bodies[at(pair.b)], part.pairs);
  part.candidates.clear();
  for (int block = begin; block < end; ++block)
    moving.tree.find_pairs_with(standing.tree, block, part.candidates);
  for (const BoxTree::Pair& pair : part.candidates)
    add_pairs(step, moving.bodies[at(pair.a)], standing.bodies[at(pair.b)], part.pairs);
}

/// Of two bodies whose boxes overlap.
void PairFinder::Tables::add_pairs(const Step& step, int a, int b, std::vector<ShapePair>& pairs) const {
  if (!may_move[at(a)] && !may_move[at(b)]) return;
  if (!filter.may_collide(a, b)) return;
  if (a > b) std::swap(a, b);
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
  const ShapePlace &A = places[at(pair.shape_A)], &B = places[at(pair.shape_B)];
  const float margin = step.margin + approach_bound(A, B, step.h);
  if (!may_be_within(A, B, margin)) return;
  pairs.push_back(
      {pair.body_A, pair.body_B, shapes[at(pair.shape_A)].shape, shapes[at(pair.shape_B)].shape, margin});
}

/// Bodies of this range of a side against all shapes without an end; of those that stand the sleeping ones
/// against those that move.
void PairFinder::Tables::add_unbounded(const Step& step, const Side& side, int begin, int end,
                                       std::vector<ShapePair>& pairs) const {
  for (const UnboundedShape& other : unbounded) {
    if (&side == &standing && !step.bodies.has_velocity(other.body)) continue;
    const UnboundedPlace place = place_of(other, step.bodies, origin);
    for (int i = begin; i < end; ++i) {
      const int body = side.bodies[at(i)];
      if (!may_move[at(body)]) continue;
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

PairFinder::PairFinder(const Model& model) : tables_(std::make_unique<Tables>(model)) {}
PairFinder::~PairFinder() = default;

void PairFinder::set_contact_filter(std::function<bool(int, int)> may_touch) {
  tables_->may_touch = std::move(may_touch);
}

void PairFinder::find_pairs(const BulkBodies& bodies, double h, double margin, const Executor& executor,
                            std::vector<ShapePair>& pairs) {
  constexpr int blocks_of_a_part = 16, bodies_of_a_part = blocks_of_a_part * BoxTree::width;
  Tables& tables = *tables_;
  const Tables::Step step{bodies, static_cast<float>(h), static_cast<float>(margin)};
  tables.update(step, executor);
  const int block_count = tables.moving.tree.block_count();
  const int body_count = static_cast<int>(tables.moving.bodies.size());
  const int part_count = (block_count + blocks_of_a_part - 1) / blocks_of_a_part;
  tables.parts.resize(at(part_count));
  executor.for_ranges(part_count, 1, [&](int begin, int end) {
    for (int k = begin; k < end; ++k) {
      Tables::Part& part = tables.parts[at(k)];
      part.pairs.clear();
      tables.search_blocks(step, k * blocks_of_a_part, std::min((k + 1) * blocks_of_a_part, block_count),
                           part);
      tables.add_unbounded(step, tables.moving, k * bodies_of_a_part,
                           std::min((k + 1) * bodies_of_a_part, body_count), part.pairs);
    }
  });
  if (tables.has_sleepers) {
    Tables::Part& part = tables.parts.emplace_back();
    tables.add_unbounded(step, tables.standing, 0, static_cast<int>(tables.standing.bodies.size()),
                         part.pairs);
  }
  tables.order.clear(bodies.count());
  for (const Tables::Part& part : tables.parts) tables.order.add(part.pairs);
  tables.order.write(pairs);
}

}  // namespace rigor
