#include "rigor/geometry/shape/convex_hull.hpp"

#include "rigor/core/index.hpp"
#include "rigor/geometry/shape/polygon_triangulation.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <memory>
#include <optional>
#include <tuple>

#include <fmt/format.h>

extern "C" {
#include <libqhull_r/qhull_ra.h>
}

namespace rigor {

namespace {

/// An edge of a face, in its direction.
struct DirectedEdge {
  int from, to, face;
  bool operator<(const DirectedEdge& other) const {
    return std::tie(from, to, face) < std::tie(other.from, other.to, other.face);
  }
};

/// Text that a C library writes to a stream, instead of the terminal.
class TextStream {
 public:
  TextStream() : stream_(open_memstream(&buffer_, &size_)) {}
  TextStream(const TextStream&) = delete;
  TextStream& operator=(const TextStream&) = delete;
  ~TextStream() {
    if (stream_) std::fclose(stream_);
    std::free(buffer_);
  }
  std::FILE* stream() const { return stream_; }
  /// First line of what was written so far.
  std::string first_line() const {
    if (!stream_) return {};
    std::fflush(stream_);
    const std::string text(buffer_, size_);
    return text.substr(0, text.find('\n'));
  }

 private:
  char* buffer_ = nullptr;
  std::size_t size_ = 0;
  std::FILE* stream_;
};

/// A run of qhull, freed at the end.
class QhullRun {
 public:
  /// Coordinates x y z x y z ..., which must outlive the run.
  explicit QhullRun(std::vector<double>& coordinates)
      : qh_(std::make_unique<qhT>()), points_(coordinates.data()) {
    if (!messages_.stream()) return;
    qh_zero(qh_.get(), messages_.stream());
    // C-0 merges facets that are coplanar within rounding; no other output than messages.
    char command[] = "qhull C-0";
    exit_code_ = qh_new_qhull(qh_.get(), 3, static_cast<int>(coordinates.size() / 3), points_, False, command,
                              nullptr, messages_.stream());
    has_run_ = true;
  }
  QhullRun(const QhullRun&) = delete;
  QhullRun& operator=(const QhullRun&) = delete;
  ~QhullRun() {
    if (!has_run_) return;
    qh_freeqhull(qh_.get(), !qh_ALL);
    int long_blocks, long_bytes;
    qh_memfreeshort(qh_.get(), &long_blocks, &long_bytes);
  }

  int exit_code() const { return exit_code_; }
  std::string message() const { return messages_.first_line(); }

  /// Vertex loops as indices of the points, counter-clockwise seen from outside; nothing if a facet is not a
  /// simple loop.
  std::optional<std::vector<std::vector<int>>> faces(const std::vector<Vec3>& points) const {
    std::vector<std::vector<int>> result;
    for (const facetT* facet = qh_->facet_list; facet && facet->next; facet = facet->next) {
      std::vector<int> loop = facet->simplicial ? corners(facet) : chained_ridges(facet);
      if (loop.size() < 3) return std::nullopt;
      const Vec3 outward(facet->normal[0], facet->normal[1], facet->normal[2]);
      if (doubled_area_vector(points, loop).dot(outward) < 0) std::reverse(loop.begin(), loop.end());
      result.push_back(std::move(loop));
    }
    return result;
  }

 private:
  int point_of(const void* vertex) const {
    return static_cast<int>((static_cast<const vertexT*>(vertex)->point - points_) / 3);
  }

  std::vector<int> corners(const facetT* facet) const {
    std::vector<int> result;
    for (const setelemT* v = facet->vertices->e; v->p; ++v) result.push_back(point_of(v->p));
    return result;
  }

  /// The ridges of a merged facet are its edges, in no order. Empty if they do not make one loop.
  std::vector<int> chained_ridges(const facetT* facet) const {
    std::vector<std::array<int, 2>> links;  // each edge in both directions
    for (const setelemT* r = facet->ridges->e; r->p; ++r) {
      const setT* ends = static_cast<const ridgeT*>(r->p)->vertices;
      const int a = point_of(ends->e[0].p), b = point_of(ends->e[1].p);
      links.push_back({a, b});
      links.push_back({b, a});
    }
    std::sort(links.begin(), links.end());
    for (std::size_t i = 0; i + 1 < links.size(); i += 2) {
      const bool is_last = i + 2 == links.size();
      if (links[i][0] != links[i + 1][0] || (!is_last && links[i][0] == links[i + 2][0])) return {};
    }
    if (links.empty()) return {};
    // From each point to the neighbour that is not where the loop came from, until it closes.
    std::vector<int> loop = {links[0][0]};
    for (int before = links[0][1], here = links[0][0];;) {
      const auto first = std::lower_bound(links.begin(), links.end(), std::array<int, 2>{here, -1});
      const int next = (*first)[1] != before ? (*first)[1] : (*(first + 1))[1];
      if (next == loop[0]) break;
      before = here;
      here = next;
      loop.push_back(here);
      if (loop.size() > links.size()) return {};
    }
    return 2 * loop.size() == links.size() ? loop : std::vector<int>{};
  }

  std::unique_ptr<qhT> qh_;
  TextStream messages_;
  double* points_;
  int exit_code_ = qh_ERRmem;
  bool has_run_ = false;
};

/// Coordinates from the points' mean, scaled by a power of two to a size near 1: qhull's tolerances are then
/// the same everywhere and for every unit.
std::vector<double> normalized(const std::vector<Vec3>& points) {
  // The mean, and the exponent of the largest coordinate from it.
  Vec3 mean = Vec3::Zero();
  for (const Vec3& p : points) mean += p / static_cast<double>(points.size());
  double size = 0;
  for (const Vec3& p : points) size = std::max(size, (p - mean).cwiseAbs().maxCoeff());
  const int exponent = size > 0 ? std::ilogb(size) : 0;
  std::vector<double> coordinates;
  coordinates.reserve(3 * points.size());
  for (const Vec3& p : points) {
    for (int i = 0; i < 3; ++i) coordinates.push_back(std::scalbn(p[i] - mean[i], -exponent));
  }
  return coordinates;
}

/// Renumbers the faces' vertices without gaps, in the order of the points, and brings faces and loops into an
/// order of their own: the smallest vertex first.
ConvexHull with_used_points(const std::vector<Vec3>& points, std::vector<std::vector<int>> faces) {
  std::vector<int> number(points.size(), -1);
  for (const std::vector<int>& face : faces) {
    for (const int v : face) number[at(v)] = 0;
  }
  ConvexHull hull;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (number[i] < 0) continue;
    number[i] = static_cast<int>(hull.vertices.size());
    hull.vertices.push_back(points[i]);
  }
  for (std::vector<int>& face : faces) {
    for (int& v : face) v = number[at(v)];
    std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
  }
  std::sort(faces.begin(), faces.end());
  hull.faces = std::move(faces);
  return hull;
}

/// Fills normals, edges, neighbours and the support table from the faces. False if the faces do not close.
bool complete(ConvexHull& hull) {
  std::vector<DirectedEdge> edges;
  for (std::size_t f = 0; f < hull.faces.size(); ++f) {
    const std::vector<int>& loop = hull.faces[f];
    hull.face_normals.push_back(doubled_area_vector(hull.vertices, loop).normalized());
    for (std::size_t i = 0; i < loop.size(); ++i) {
      edges.push_back({loop[i], loop[(i + 1) % loop.size()], static_cast<int>(f)});
    }
  }
  std::sort(edges.begin(), edges.end());

  // Each directed edge has its reverse in the neighbouring face, once.
  hull.vertex_neighbours.resize(hull.vertices.size());
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const DirectedEdge& edge = edges[i];
    const auto reverse = std::lower_bound(edges.begin(), edges.end(), DirectedEdge{edge.to, edge.from, -1});
    const bool is_paired = reverse != edges.end() && reverse->from == edge.to && reverse->to == edge.from;
    const bool is_repeated = i > 0 && edges[i - 1].from == edge.from && edges[i - 1].to == edge.to;
    if (!is_paired || is_repeated) return false;
    hull.vertex_neighbours[at(edge.from)].push_back(edge.to);
    if (edge.from < edge.to) hull.edges.push_back({edge.from, edge.to, edge.face, reverse->face});
  }
  hull.support_table = make_support_table(hull);
  // Euler: V - E + F = 2.
  return hull.vertices.size() + hull.faces.size() == hull.edges.size() + 2;
}

/// Fills what is made from the rest.
void add_features(ConvexHull& hull) {
  hull.features = make_feature_graph(hull.vertices, hull.faces, hull.face_normals);
  for (const Vec3& v : hull.vertices) hull.extent = std::max(hull.extent, v.norm());
}

/// Why the points have no hull, before qhull sees them.
std::string obvious_reason(const std::vector<Vec3>& points) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!points[i].allFinite()) return fmt::format("point {} is not finite", i);
  }
  if (points.size() < 4) {
    return fmt::format("{} points have no convex hull with a volume, at least 4 are needed", points.size());
  }
  if (points.size() > at(std::numeric_limits<int>::max() / 8)) return "too many points for a convex hull";
  if (std::all_of(points.begin(), points.end(), [&points](const Vec3& p) { return p == points[0]; })) {
    return fmt::format("all {} points are equal; they have no convex hull with a volume", points.size());
  }
  return {};
}

}  // namespace

std::variant<ConvexHull, std::string> make_convex_hull(const std::vector<Vec3>& points) {
  const std::string reason = obvious_reason(points);
  if (!reason.empty()) return reason;

  // Qhull finds the facets; points without a volume are told apart.
  std::vector<double> coordinates = normalized(points);
  const QhullRun run(coordinates);
  if (run.exit_code() == qh_ERRsingular) {
    return fmt::format("all {} points lie in one plane or on one line; their convex hull has no volume",
                       points.size());
  }
  if (run.exit_code() != qh_ERRnone) return "no convex hull: " + run.message();

  // The faces as loops of the points, and what is made from them.
  std::optional<std::vector<std::vector<int>>> faces = run.faces(points);
  if (faces) {
    std::optional<ConvexHull> hull = make_hull_of_faces(points, std::move(*faces));
    if (hull) return std::move(*hull);
  }
  return "no convex hull: its faces do not close, the points are too close to each other or to a plane";
}

std::optional<ConvexHull> make_hull_of_faces(const std::vector<Vec3>& points,
                                             std::vector<std::vector<int>> faces) {
  ConvexHull hull = with_used_points(points, std::move(faces));
  if (!complete(hull)) return std::nullopt;
  add_features(hull);
  return hull;
}

ConvexHull make_box_hull(const Vec3& half_extents) {
  ConvexHull hull;
  for (int i = 0; i < 8; ++i) {
    const Vec3 signs((i & 1) ? 1 : -1, (i & 2) ? 1 : -1, (i & 4) ? 1 : -1);
    hull.vertices.push_back(signs.cwiseProduct(half_extents));
  }
  hull.faces = {{0, 1, 5, 4}, {0, 2, 3, 1}, {0, 4, 6, 2}, {1, 3, 7, 5}, {2, 6, 7, 3}, {4, 5, 7, 6}};
  complete(hull);
  // The normals are known without rounding.
  hull.face_normals = {-Vec3::UnitY(), -Vec3::UnitZ(), -Vec3::UnitX(),
                       Vec3::UnitX(),  Vec3::UnitY(),  Vec3::UnitZ()};
  add_features(hull);
  return hull;
}

}  // namespace rigor
