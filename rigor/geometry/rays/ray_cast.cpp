#include "rigor/geometry/rays/ray_cast.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/geometry/rays/ray_mesh.hpp"
#include "rigor/geometry/rays/ray_span.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {
namespace {

/// The ray in the frame S of the shape: a line parametrised from its point nearest to the origin of S, where
/// coordinates have the most digits, and the parameters at which the ray begins and ends [m].
struct LocalRay {
  ShapeLine line;
  Vec3 start_S;
  double begin, end;
  double length;  ///< Length of the direction [m].

  LocalRay(const Pose& X_WS, const Ray& ray) : length(ray.direction_W.stableNorm()) {
    RIGOR_ASSERT(length > 0 && std::isfinite(length) && ray.origin_W.allFinite() && ray.max_fraction >= 0);
    line.u = X_WS.R.transpose() * (ray.direction_W / length);
    line.u.normalize();
    start_S = X_WS.R.transpose() * (ray.origin_W - X_WS.p);
    begin = line.u.dot(start_S);
    line.c = start_S - begin * line.u;
    end = begin + ray.max_fraction * length;
  }

  RayHit hit(const Pose& X_WS, double s, const Vec3& n_S, bool enters) const {
    return {std::max(0.0, (s - begin) / length), X_WS * line.at(s), X_WS.R * n_S, enters, -1};
  }
  RayHit hit(const Pose& X_WS, const MeshCrossing& at) const {
    RayHit found = hit(X_WS, at.s, at.n_M, at.enters);
    found.triangle = at.triangle;
    return found;
  }
  MeshRay in_mesh() const { return {line, start_S, begin, end}; }
};

/// The ends of the span of a convex shape that lie on the ray.
std::vector<RayHit> span_hits(const RaySpan& span, const LocalRay& local, const Pose& X_WS) {
  std::vector<RayHit> hits;
  if (span.is_empty()) return hits;
  if (std::isfinite(span.in) && span.in >= local.begin && span.in <= local.end) {
    hits.push_back(local.hit(X_WS, span.in, span.n_in, true));
  }
  if (std::isfinite(span.out) && span.out >= local.begin && span.out <= local.end) {
    hits.push_back(local.hit(X_WS, span.out, span.n_out, false));
  }
  return hits;
}

}  // namespace

std::vector<RayHit> find_ray_hits(const Shape& shape, const Pose& X_WS, const Ray& ray) {
  const LocalRay local(X_WS, ray);
  const Mesh* mesh = std::get_if<Mesh>(&shape);
  if (mesh == nullptr) return span_hits(ray_span(shape, local.line), local, X_WS);
  std::vector<RayHit> hits;
  for (const MeshCrossing& at : mesh_crossings(*mesh, local.in_mesh())) hits.push_back(local.hit(X_WS, at));
  return hits;
}

std::optional<RayHit> find_ray_hit(const Shape& shape, const Pose& X_WS, const Ray& ray) {
  if (const Mesh* mesh = std::get_if<Mesh>(&shape)) {
    const LocalRay local(X_WS, ray);
    const std::optional<MeshCrossing> at = first_mesh_crossing(*mesh, local.in_mesh());
    return at ? std::optional(local.hit(X_WS, *at)) : std::nullopt;
  }
  const std::vector<RayHit> hits = find_ray_hits(shape, X_WS, ray);
  return hits.empty() ? std::nullopt : std::optional(hits.front());
}

}  // namespace rigor
