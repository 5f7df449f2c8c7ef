#include "rigor/geometry/mesh/mesh_check.hpp"

#include "rigor/core/index.hpp"
#include "rigor/core/rounding.hpp"
#include "rigor/geometry/mass/mass_properties.hpp"
#include "rigor/geometry/mass/polyhedron_integrals.hpp"
#include "rigor/geometry/mesh/mesh_shells.hpp"
#include "rigor/geometry/mesh/self_intersection.hpp"
#include "rigor/geometry/shape/polygon_triangulation.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace rigor {

namespace {

/// Number of items written out in a message before "and n more".
constexpr std::size_t kListed = 5;

/// Number of pairs of faces that cut each other after which the search ends.
constexpr int kMaxPairs = 1000;

/// "3, 5 and 7" or "3, 5, 6, 8, 9 and 12 more".
std::string listed(const std::vector<std::string>& names) {
  const std::size_t shown = std::min(names.size(), kListed);
  std::string text;
  for (std::size_t i = 0; i < shown; ++i) {
    const bool is_last = i + 1 == shown && names.size() == shown;
    text += (i == 0 ? "" : (is_last ? " and " : ", ")) + names[i];
  }
  if (names.size() > shown) text += fmt::format(" and {} more", names.size() - shown);
  return text;
}

/// "face 3" or "2 faces (3 and 5)", numbers counting from 0.
std::string named(const char* one, const char* many, const std::vector<int>& numbers) {
  if (numbers.size() == 1) return fmt::format("{} {}", one, numbers[0]);
  std::vector<std::string> names;
  names.reserve(numbers.size());
  for (const int i : numbers) names.push_back(std::to_string(i));
  return fmt::format("{} {} ({})", numbers.size(), many, listed(names));
}

std::string named_faces(const std::vector<int>& faces) {
  return named("face", "faces", faces);
}

std::string named_vertices(const std::vector<int>& vertices) {
  return named("vertex", "vertices", vertices);
}

/// Runs the checks over one mesh and collects what they find.
class MeshChecker {
 public:
  MeshChecker(const PolygonMesh& mesh, const MeshCheckOptions& options) : mesh_(mesh), options_(options) {}

  std::vector<MeshDefect> run() {
    // Later checks rely on earlier ones: faces need valid indices, volumes a surface without errors.
    check_vertices();
    check_indices();
    if (!has_errors(defects_)) {
      check_unused_vertices();
      check_faces();
      edges_ = sorted_edges(mesh_);
      const bool is_closed = check_edges();
      if (!has_errors(defects_)) {
        if (is_closed) check_solid();
        if (options_.self_intersections) check_self_intersections();
      }
    }
    std::stable_sort(defects_.begin(), defects_.end(),
                     [](const MeshDefect& a, const MeshDefect& b) { return a.kind < b.kind; });
    return std::move(defects_);
  }

 private:
  void add(MeshDefectKind kind, bool is_error, std::size_t count, const std::string& text) {
    if (count > 0) defects_.push_back({kind, is_error, static_cast<int>(count), text});
  }

  void check_vertices();
  void check_size();
  void check_indices();
  void check_unused_vertices();
  void check_faces();
  bool check_edges();
  void check_solid();
  void check_volume(const PolyhedronIntegrals& integrals);
  void check_shells();
  void check_inertia(const PolyhedronIntegrals& integrals);
  void check_self_intersections();

  const PolygonMesh& mesh_;
  const MeshCheckOptions& options_;
  std::vector<MeshDefect> defects_;
  std::vector<FaceEdge> edges_;
  Vec3 lower_ = Vec3::Zero(), upper_ = Vec3::Zero();
  double scale_ = 0;  ///< Largest coordinate or extent: its rounding limits all decisions.
};

void MeshChecker::check_vertices() {
  add(MeshDefectKind::empty, true, mesh_.faces.empty(), "the mesh has no faces");
  std::vector<int> bad;
  for (std::size_t i = 0; i < mesh_.vertices.size(); ++i) {
    if (!mesh_.vertices[i].allFinite()) bad.push_back(static_cast<int>(i));
  }
  add(MeshDefectKind::not_finite, true, bad.size(),
      fmt::format("{}: coordinates must be finite numbers", named_vertices(bad)));
  if (bad.empty() && !mesh_.vertices.empty()) check_size();
}

void MeshChecker::check_size() {
  // The box about the mesh, and the largest coordinate, whose rounding no decision can go below.
  lower_ = upper_ = mesh_.vertices[0];
  double largest = 0;
  for (const Vec3& v : mesh_.vertices) {
    lower_ = lower_.cwiseMin(v);
    upper_ = upper_.cwiseMax(v);
    largest = std::max(largest, v.cwiseAbs().maxCoeff());
  }
  const double size = (upper_ - lower_).maxCoeff();
  scale_ = std::max(size, largest);

  // Inertia grows with the fifth power of the size and its determinant with the fifteenth; the determinant
  // must stay a normal double.
  const double smallest_size = std::exp2(-1022.0 / 15), largest_size = std::exp2(1022.0 / 15);
  if (size == 0) {
    add(MeshDefectKind::size_out_of_range, true, 1, "all vertices lie at one point");
  } else if (size < smallest_size || scale_ > largest_size) {
    add(MeshDefectKind::size_out_of_range, true, 1,
        fmt::format(
            "the mesh is {:.3g} m large, with coordinates up to {:.3g} m; for its inertia to fit in double "
            "precision it must be between {:.1g} m and {:.1g} m (wrong unit or scale?)",
            size, largest, smallest_size, largest_size));
  }
}

void MeshChecker::check_indices() {
  std::vector<int> out_of_range, degenerate;
  const int count = static_cast<int>(mesh_.vertices.size());
  for (std::size_t f = 0; f < mesh_.faces.size(); ++f) {
    // Sorted vertices show at once whether one occurs twice.
    std::vector<int> loop = mesh_.faces[f];
    const bool is_valid =
        std::all_of(loop.begin(), loop.end(), [count](int v) { return v >= 0 && v < count; });
    if (!is_valid) out_of_range.push_back(static_cast<int>(f));
    std::sort(loop.begin(), loop.end());
    const bool is_repeated = std::adjacent_find(loop.begin(), loop.end()) != loop.end();
    if (loop.size() < 3 || is_repeated) degenerate.push_back(static_cast<int>(f));
  }
  if (!out_of_range.empty()) {
    add(MeshDefectKind::index_out_of_range, true, out_of_range.size(),
        fmt::format("{}: vertex index out of range, the mesh has {} vertices", named_faces(out_of_range),
                    count));
  }
  if (!degenerate.empty()) {
    add(MeshDefectKind::degenerate_face, true, degenerate.size(),
        fmt::format("{}: a face needs at least three different vertices, each once",
                    named_faces(degenerate)));
  }
}

void MeshChecker::check_unused_vertices() {
  std::vector<bool> is_used(mesh_.vertices.size(), false);
  for (const std::vector<int>& face : mesh_.faces) {
    for (const int v : face) is_used[at(v)] = true;
  }
  std::vector<int> unused;
  for (std::size_t i = 0; i < is_used.size(); ++i) {
    if (!is_used[i]) unused.push_back(static_cast<int>(i));
  }
  if (unused.empty()) return;
  add(MeshDefectKind::unused_vertex, false, unused.size(),
      fmt::format("{}: used by no face", named_vertices(unused)));
}

void MeshChecker::check_faces() {
  std::vector<int> flat, bent;
  double worst = 0;
  for (std::size_t f = 0; f < mesh_.faces.size(); ++f) {
    // Length from the first vertex and area of the face: together they give its height.
    const std::vector<int>& loop = mesh_.faces[f];
    const Vec3& p0 = mesh_.vertices[at(loop[0])];
    double length = 0;
    for (const int v : loop) length = std::max(length, (mesh_.vertices[at(v)] - p0).norm());
    const Vec3 area = doubled_area_vector(mesh_.vertices, loop);
    // A height over the longest side below the rounding of the coordinates is no height.
    if (!(area.norm() > 4 * kUnitRoundoff * scale_ * length)) {
      flat.push_back(static_cast<int>(f));
      continue;
    }
    // Distances of the vertices from the plane through the first vertex along the mean normal.
    double height = 0;
    for (const int v : loop)
      height = std::max(height, std::abs(area.normalized().dot(mesh_.vertices[at(v)] - p0)));
    if (height > options_.planarity * scale_) bent.push_back(static_cast<int>(f));
    worst = std::max(worst, height);
  }
  if (!flat.empty()) {
    add(MeshDefectKind::zero_area_face, true, flat.size(),
        fmt::format("{}: no area, its vertices lie on one line", named_faces(flat)));
  }
  if (!bent.empty()) {
    add(MeshDefectKind::not_planar, true, bent.size(),
        fmt::format("{}: vertices up to {:.3g} m off the plane of the face, allowed are {:.3g} m; split such "
                    "faces into triangles",
                    named_faces(bent), worst, options_.planarity * scale_));
  }
}

/// Reports edges that are open, flipped or crowded; true if every edge is traversed once in each direction.
bool MeshChecker::check_edges() {
  std::vector<std::string> open, flipped, crowded;
  for (std::size_t i = 0; i < edges_.size();) {
    // Sides between the same two vertices follow each other.
    std::size_t end = i;
    while (end < edges_.size() && edges_[end].low == edges_[i].low && edges_[end].high == edges_[i].high)
      ++end;
    const FaceEdge& edge = edges_[i];
    if (end - i == 1) {
      open.push_back(fmt::format("{}-{} of face {}", edge.low, edge.high, edge.face));
    } else if (end - i > 2) {
      crowded.push_back(fmt::format("{}-{} with {} faces", edge.low, edge.high, end - i));
    } else if (edge.is_forward == edges_[i + 1].is_forward) {
      flipped.push_back(
          fmt::format("{}-{} of faces {} and {}", edge.low, edge.high, edge.face, edges_[i + 1].face));
    }
    i = end;
  }
  const bool is_error = !options_.may_be_open;
  add(MeshDefectKind::open_edge, is_error, open.size(),
      fmt::format("the surface is not closed: {} edges with one face only ({})", open.size(), listed(open)));
  add(MeshDefectKind::flipped_face, is_error, flipped.size(),
      fmt::format("faces are not oriented alike: {} edges run in the same direction by both faces ({}); flip "
                  "the odd ones",
                  flipped.size(), listed(flipped)));
  add(MeshDefectKind::non_manifold_edge, is_error, crowded.size(),
      fmt::format(
          "{} edges with more than two faces ({}); remove double faces, or give each part its own vertices",
          crowded.size(), listed(crowded)));
  return open.empty() && flipped.empty() && crowded.empty();
}

/// Each check needs the one before: shells are judged by their volumes, and the inertia of a misplaced shell
/// is meaningless.
void MeshChecker::check_solid() {
  const PolyhedronIntegrals integrals = polyhedron_integrals(mesh_.vertices, mesh_.faces);
  const std::size_t before = defects_.size();
  check_volume(integrals);
  if (defects_.size() == before) check_shells();
  if (defects_.size() == before) check_inertia(integrals);
}

void MeshChecker::check_volume(const PolyhedronIntegrals& integrals) {
  const bool is_error = !options_.may_be_open;
  // A volume within its own error bound has no sign; the sign tells the orientation.
  const double volume = integrals.volume, box = (upper_ - lower_).prod();
  if (std::abs(volume) <= integrals.volume_error) {
    add(MeshDefectKind::zero_volume, is_error, 1,
        "the volume is zero: the surface is flat, or its parts cancel each other (it crosses itself)");
  } else if (volume < 0) {
    add(MeshDefectKind::inverted, is_error, 1,
        fmt::format("the surface is inside out: its volume is {:.6g} m³; turn all faces round "
                    "(counter-clockwise seen "
                    "from outside)",
                    volume));
  } else if (volume <= options_.volume_fraction * box) {
    add(MeshDefectKind::small_volume, is_error, 1,
        fmt::format("the volume {:.3g} m³ is less than {:.0e} of the box about the mesh ({:.3g} m³)", volume,
                    options_.volume_fraction, box));
  }
}

void MeshChecker::check_shells() {
  const MeshShells parts = find_shells(mesh_, edges_);
  std::vector<int> faces;
  for (const int s : find_misplaced_shells(parts.shells)) faces.push_back(parts.first_face[at(s)]);
  if (faces.empty()) return;
  add(MeshDefectKind::misplaced_shell, !options_.may_be_open, faces.size(),
      fmt::format("of {} separate shells, those with {} are misplaced: either solid inside another solid "
                  "(which would count "
                  "twice), or inside out without a solid around",
                  parts.shells.size(), named_faces(faces)));
}

void MeshChecker::check_inertia(const PolyhedronIntegrals& integrals) {
  // The mass properties at density 1 must be those of a solid, with the centre of mass inside the box.
  const MassProperties properties = mass_properties(integrals, 1.0);
  // Twice the error bound of the integrals, so that rounding is never blamed on the mesh.
  const double tolerance = std::max(1e-14, 2 * properties.error_bound);
  std::vector<std::string> reasons = find_mass_defects(properties, tolerance);
  const Vec3 margin = tolerance * Vec3::Constant(scale_);
  const bool is_inside = (properties.center.array() >= (lower_ - margin).array()).all() &&
                         (properties.center.array() <= (upper_ + margin).array()).all();
  if (!is_inside) reasons.emplace_back("the centre of mass is outside the box about the mesh");
  for (const std::string& reason : reasons) {
    add(MeshDefectKind::impossible_inertia, !options_.may_be_open, 1,
        fmt::format("the surface does not bound a solid (it crosses itself): at density 1 {}", reason));
  }
}

void MeshChecker::check_self_intersections() {
  // The triangulation takes the faces in order and splits one with n vertices into n - 2 triangles.
  std::vector<int> face_of;
  for (std::size_t f = 0; f < mesh_.faces.size(); ++f) {
    face_of.insert(face_of.end(), mesh_.faces[f].size() - 2, static_cast<int>(f));
  }
  std::vector<std::string> names;
  const std::vector<std::array<int, 2>> pairs = find_self_intersections(triangulated(mesh_), kMaxPairs);
  names.reserve(pairs.size());
  for (const std::array<int, 2>& pair : pairs) {
    names.push_back(fmt::format("{} and {}", face_of[at(pair[0])], face_of[at(pair[1])]));
  }
  names.erase(std::unique(names.begin(), names.end()), names.end());
  const std::size_t shown = std::min(names.size(), kListed);
  std::string text;
  for (std::size_t i = 0; i < shown; ++i) text += (i ? "; " : "") + names[i];
  add(MeshDefectKind::self_intersection, false, names.size(),
      fmt::format("{}{} pairs of faces cut or touch each other (faces {}{}); where the solid overlaps itself "
                  "it counts twice",
                  at(kMaxPairs) == pairs.size() ? "at least " : "", names.size(), text,
                  names.size() > shown ? "; ..." : ""));
}

}  // namespace

std::vector<MeshDefect> find_mesh_defects(const PolygonMesh& mesh, const MeshCheckOptions& options) {
  return MeshChecker(mesh, options).run();
}

std::vector<MeshDefect> find_mesh_defects(const TriangleMesh& mesh, const MeshCheckOptions& options) {
  return find_mesh_defects(as_polygons(mesh), options);
}

bool has_errors(const std::vector<MeshDefect>& defects) {
  return std::any_of(defects.begin(), defects.end(), [](const MeshDefect& d) { return d.is_error; });
}

}  // namespace rigor
