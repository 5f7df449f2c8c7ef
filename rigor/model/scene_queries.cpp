#include "rigor/model/scene_queries.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/core/rounding.hpp"
#include "rigor/geometry/distance/distance.hpp"
#include "rigor/geometry/distance/point_distance.hpp"
#include "rigor/geometry/rays/box_bounds.hpp"
#include "rigor/math/rotation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace rigor {
namespace {

bool accepts(const SceneQueries::Filter& filter, int body) {
  return !filter || filter(body);
}

bool is_before(const BodyRayHit& a, const BodyRayHit& b) {
  return std::tie(a.hit.fraction, a.on.body, a.on.shape, a.hit.triangle) <
         std::tie(b.hit.fraction, b.on.body, b.on.shape, b.hit.triangle);
}

bool is_nearer(const NearBody& a, const NearBody& b) {
  return std::tie(a.distance, a.on.body) < std::tie(b.distance, b.on.body);
}

/// The box grown by the rounding errors of what is computed for points inside it.
Aabb with_rounding(const Aabb& box) {
  // Points inside are computed from coordinates of this size.
  double largest = 0;
  for (const Vec3& corner : {box.lower, box.upper}) {
    for (const double x : corner) {
      if (std::isfinite(x)) largest = std::max(largest, std::abs(x));
    }
  }
  return box.grown(32 * std::numeric_limits<double>::epsilon() * largest);
}

}  // namespace

SceneQueries::SceneQueries(const Model& model, const State& state) : model_(model) {
  update(state);
}

void SceneQueries::update(const State& state) {
  RIGOR_ASSERT(state.body_count() == model_.body_count());
  constexpr int updates_per_tree = 64;
  // The tree is kept and refitted; it gets worse the farther bodies go, so now and then it is built anew.
  const bool is_rebuilt = updates_++ % updates_per_tree == 0;
  poses_.resize(model_.bodies().size());
  boxes_.resize(model_.bodies().size());
  std::vector<BoxItem> items;
  for (int body = 0; body < model_.body_count(); ++body) {
    const std::size_t i = static_cast<std::size_t>(body);
    poses_[i] = {rotation_matrix(state.orientation(body)), state.position(body)};
    const std::vector<BodyShape>& shapes = model_.body(body).shapes;
    if (shapes.empty()) continue;
    Aabb box{Vec3::Constant(kInfinity), Vec3::Constant(-kInfinity)};
    for (const BodyShape& s : shapes) box = box.united(axis_aligned_box(s.shape, poses_[i] * s.X_BS));
    boxes_[i] = with_rounding(box);
    const bool is_bounded = (boxes_[i].upper - boxes_[i].lower).allFinite();
    if (is_rebuilt) {
      items.push_back({body, boxes_[i]});
    } else if (!is_bounded) {
      tree_.set(body, boxes_[i]);
    }
  }
  if (is_rebuilt) {
    tree_.build(items);
  } else {
    tree_.refit(boxes_);
  }
}

const Shape& SceneQueries::shape(const ShapeIndex& at) const {
  return model_.body(at.body).shapes[static_cast<std::size_t>(at.shape)].shape;
}

Pose SceneQueries::shape_pose(const ShapeIndex& at) const {
  return pose(at.body) * model_.body(at.body).shapes[static_cast<std::size_t>(at.shape)].X_BS;
}

std::optional<BodyRayHit> SceneQueries::first_hit(const Ray& ray, const Filter& filter) const {
  std::optional<BodyRayHit> first;
  const auto bound = [&](const Aabb& box) { return ray_bound(box, ray); };
  tree_.search(bound, [&](int body) {
    const int count = static_cast<int>(model_.body(body).shapes.size());
    for (ShapeIndex at{body, 0}; accepts(filter, body) && at.shape < count; ++at.shape) {
      const std::optional<RayHit> hit = find_ray_hit(shape(at), shape_pose(at), ray);
      if (hit && (!first || is_before({at, *hit}, *first))) first = BodyRayHit{at, *hit};
    }
    return first ? first->hit.fraction : kInfinity;
  });
  return first;
}

std::vector<BodyRayHit> SceneQueries::all_hits(const Ray& ray, const Filter& filter) const {
  std::vector<BodyRayHit> all;
  const auto bound = [&](const Aabb& box) { return ray_bound(box, ray); };
  tree_.search(bound, [&](int body) {
    const int count = static_cast<int>(model_.body(body).shapes.size());
    for (ShapeIndex at{body, 0}; accepts(filter, body) && at.shape < count; ++at.shape) {
      for (const RayHit& hit : find_ray_hits(shape(at), shape_pose(at), ray)) all.push_back({at, hit});
    }
    return kInfinity;
  });
  std::sort(all.begin(), all.end(), is_before);
  return all;
}

std::optional<BodyCastHit> SceneQueries::cast(const ShapeCast& cast, const Filter& filter) const {
  // A swept box meets a box when its centre meets that box grown by half its sizes (Minkowski sum).
  const Aabb box = with_rounding(axis_aligned_box(*cast.shape, cast.X_WS));
  const Vec3 half = 0.5 * (box.upper - box.lower), middle = 0.5 * (box.upper + box.lower);
  const bool is_bounded = half.allFinite();
  const Ray path{middle, cast.translation_W, 1};
  const auto bound = [&](const Aabb& other) {
    return is_bounded ? ray_bound({other.lower - half, other.upper + half}, path) : 0.0;
  };
  std::optional<BodyCastHit> first;
  tree_.search(bound, [&](int body) {
    const int count = static_cast<int>(model_.body(body).shapes.size());
    for (ShapeIndex at{body, 0}; accepts(filter, body) && at.shape < count; ++at.shape) {
      const std::optional<ShapeCastHit> hit = cast_shape(cast, shape(at), shape_pose(at));
      const bool is_first =
          hit && (!first || std::tie(hit->fraction, at.body, at.shape) <
                                std::tie(first->hit.fraction, first->on.body, first->on.shape));
      if (is_first) first = BodyCastHit{at, *hit};
    }
    return first ? first->hit.fraction : kInfinity;
  });
  return first;
}

std::vector<NearBody> SceneQueries::nearest(const Aabb& around, int k, const Filter& filter,
                                            const std::function<NearBody(const ShapeIndex&)>& measure) const {
  RIGOR_ASSERT(k >= 0);
  std::vector<NearBody> found;
  if (k == 0) return found;
  const auto bound = [&](const Aabb& box) { return signed_distance_bound(box, around); };
  tree_.search(bound, [&](int body) {
    if (accepts(filter, body)) {
      NearBody best;
      const int count = static_cast<int>(model_.body(body).shapes.size());
      for (ShapeIndex at{body, 0}; at.shape < count; ++at.shape) {
        const NearBody here = measure(at);
        if (at.shape == 0 || here.distance < best.distance) best = here;
      }
      // The k nearest so far, in their order; the farthest of them bounds the search.
      found.insert(std::upper_bound(found.begin(), found.end(), best, is_nearer), best);
      if (static_cast<int>(found.size()) > k) found.pop_back();
    }
    return static_cast<int>(found.size()) == k ? found.back().distance : kInfinity;
  });
  return found;
}

std::vector<NearBody> SceneQueries::nearest(const Vec3& p_W, int k, const Filter& filter) const {
  return nearest({p_W, p_W}, k, filter, [&](const ShapeIndex& at) {
    const PointDistance found = point_distance(shape(at), shape_pose(at), p_W);
    return NearBody{at, found.distance, p_W, found.p_W, -found.n_W};
  });
}

std::vector<NearBody> SceneQueries::nearest(const Shape& query, const Pose& X_WS, int k,
                                            const Filter& filter) const {
  const Aabb around = with_rounding(axis_aligned_box(query, X_WS));
  return nearest(around, k, filter, [&](const ShapeIndex& at) {
    const DistanceResult found = signed_distance(query, X_WS, shape(at), shape_pose(at));
    return NearBody{at, found.distance, found.p_WA, found.p_WB, found.n_W};
  });
}

std::vector<int> SceneQueries::containing(const Vec3& p_W, const Filter& filter) const {
  std::vector<int> bodies;
  for (const int body : tree_.overlapping({p_W, p_W})) {
    const int count = static_cast<int>(model_.body(body).shapes.size());
    bool holds = false;
    for (ShapeIndex at{body, 0}; accepts(filter, body) && !holds && at.shape < count; ++at.shape) {
      holds = point_distance(shape(at), shape_pose(at), p_W).distance <= 0;
    }
    if (holds) bodies.push_back(body);
  }
  return bodies;
}

std::vector<int> SceneQueries::overlapping(const Shape& query, const Pose& X_WS, const Filter& filter) const {
  std::vector<int> bodies;
  for (const int body : tree_.overlapping(with_rounding(axis_aligned_box(query, X_WS)))) {
    const int count = static_cast<int>(model_.body(body).shapes.size());
    bool meets = false;
    for (ShapeIndex at{body, 0}; accepts(filter, body) && !meets && at.shape < count; ++at.shape) {
      meets = signed_distance(query, X_WS, shape(at), shape_pose(at)).distance <= 0;
    }
    if (meets) bodies.push_back(body);
  }
  return bodies;
}

std::vector<int> SceneQueries::overlapping(const Aabb& box, const Filter& filter) const {
  RIGOR_ASSERT((box.lower.array() < box.upper.array()).all() && (box.upper - box.lower).allFinite());
  const Pose X_WS{Mat3::Identity(), 0.5 * (box.lower + box.upper)};
  return overlapping(Box{0.5 * (box.upper - box.lower)}, X_WS, filter);
}

}  // namespace rigor
