#pragma once

#include "rigor/bulk/narrow_phase/collide_polytopes.hpp"
#include "rigor/bulk/narrow_phase/smooth_core.hpp"
#include "rigor/bulk/state/float_mesh.hpp"

#include <optional>
#include <vector>

namespace rigor {

/// A mesh as seen from the centre of another body, along the mesh's axes.
struct MeshView {
  const FloatMesh* mesh;
  Mat3f R_MW;
  Vec3 c_M;  ///< The centre of the other body [m].
};

/// The contacts of one normal.
struct MeshContacts {
  int part;   ///< Of the least feature of the mesh among them: a flat patch or an edge.
  Vec3f n_M;  ///< Unit, from the mesh to the core.
  std::vector<ManifoldCandidate> candidates;  ///< Relative to the centre of the core's body, along M's axes.
};

/// Finds where a core (a point, a segment, a box or a hull, grown by its radius, a solid of revolution or an
/// ellipsoid) touches a mesh. It holds its working memory; its answers depend on the poses alone.
///
/// A triangle is touched over its face, along its normal; two triangles that bend away from each other are
/// touched at their edge too, along the directions between their normals. Where a triangle's neighbour
/// separates the core from it better, what is deep in the triangle is held by the neighbour. Edges inside
/// flat patches and edges that bend inwards are not felt (docs/theory/narrow_phase.md).
class MeshMeeting {
 public:
  /// Finds the contacts up to the margin; `segment` is the hull of a segment.
  void find(const MeshView& view, const BulkShape& core, const PlacedShape& placed, float margin,
            const FloatHull& segment);
  /// The contacts, in the order of their parts, all of different normals.
  std::size_t count() const { return group_count_; }
  MeshContacts& contacts(std::size_t k) { return groups_[k]; }
  /// Gaps that differ by less are equal [m].
  float equal_depth() const { return equal_depth_; }
  /// Whether the core's centre may be inside the mesh: it is if no triangle is near or one near has its back
  /// to it, and the mesh is closed.
  bool may_be_inside() const { return may_be_inside_; }
  /// Whether it is known how the core touches all that it is near: else contact_set has to say.
  bool is_clear() const { return is_clear_; }

 private:
  /// A triangle near the core, seen from the side on which the core's centre is.
  struct Facet {
    int triangle;
    bool is_back;      ///< The centre is behind it, and the mesh is closed: the triangle alone holds nothing.
    Vec3f n;           ///< Unit, towards the centre unless is_back.
    Vec3f corners[3];  ///< [m].
    float separation;  ///< Height of the core's lowest point over the plane [m].
    int lowest;        ///< That vertex, if the core has vertices.
    Vec3f lowest_point;  ///< [m].
    float least;         ///< Least gap over the face.
  };
  /// An edge between two triangles (or at the border of one) that the core touches.
  struct Ridge {
    int first, second;  ///< Facets; the second may be -1.
    int ends[2];        ///< Vertices.
    Vec3f from;         ///< The first of them [m].
    Vec3f n;
    Vec3f top;  ///< Of the part of the edge that is near the core the end that is higher along n [m].
    float gap;
    int part;
    std::vector<ManifoldCandidate> candidates;
  };

  /// The part of an edge that is near the core: from p along u. Its ends, if they are vertices.
  struct EdgePart {
    Vec3f p, u;
    int number, first, last;
  };

  void place_core(const MeshView& view, const BulkShape& core, const PlacedShape& placed);
  void find_box(Vec3f& lower, Vec3f& upper) const;
  float find_lowest(Facet& facet) const;
  void list_facets(const MeshView& view);
  float bound_of(const MeshView& view, const Facet& facet) const;
  void add_ridges(const MeshView& view);
  void try_ridge(const MeshView& view, std::size_t first, int side, int second);
  bool find_on_segment(const MeshView& view, const Vec3f& to, int triangle, int side, Ridge& ridge);
  std::optional<int> touch_round(const EdgePart& edge, Ridge& ridge) const;
  std::optional<int> touch_polytope(const MeshView& view, const EdgePart& edge, Ridge& ridge);
  bool touch_smooth(const MeshView& view, const EdgePart& edge, Ridge& ridge);
  std::optional<NormalArc> normals_about(const EdgePart& edge, const Ridge& ridge) const;
  void add_ring_candidates(const MeshView& view, const EdgePart& edge, const RingCore& ring, Ridge& ridge);
  bool is_normal(const MeshView& view, const Ridge& ridge, int vertex) const;
  void add_face(const MeshView& view, Facet& facet);
  float part_from(const Facet& facet) const;
  void find_region(const MeshView& view, const FloatMesh::Triangle& triangle, const Facet& facet);
  void find_smooth_region(const MeshView& view, const FloatMesh::Triangle& triangle, const Facet& facet);
  bool may_lie_over(const FaceOutline& outline, const Facet& facet) const;
  void add_explained_ridges();
  void add(const Vec3f& n, int part, const std::vector<ManifoldCandidate>& candidates);
  template <class Meets>
  bool patch_meets(const MeshView& view, const Facet& facet, const Meets& meets) const;
  float height_above(const Facet& facet, const Vec3f& n, const Vec3f& p) const;
  bool may_part_better(const Facet& own, const Facet* other, const Vec3f& from, const Vec3f& outward) const;
  int facet_of(int triangle) const;
  Vec3f point(const MeshView& view, int vertex) const;
  float preference(float gap) const;
  Ridge& next_ridge();

  PlacedPolytopes pair_;              ///< `a` is an edge of the mesh, `b` the core, if it has vertices.
  std::optional<SmoothCore> smooth_;  ///< The core, if it has none.
  Vec3f center_ = Vec3f::Zero();      ///< Of a ball inside the core [m].
  float radius_ = 0;                  ///< By which the core is grown [m].
  float extent_ = 0;                  ///< No point of the core is farther from that centre [m].
  bool is_clear_ = true;
  float blocked_ = 0;  ///< Least gap of what leaves the core along no normal of the surface [m].
  float margin_ = 0, limit_ = 0, rounding_ = 0, equal_depth_ = 0, thinnest_ = 0, reach_ = 0;
  bool may_be_inside_ = false;
  const FloatHull* segment_ = nullptr;
  std::vector<int> stack_, near_;
  std::vector<Facet> facets_;
  std::vector<Ridge> ridges_;
  std::size_t ridge_count_ = 0;
  std::vector<ManifoldCandidate> found_;
  OutlineMeeting meeting_;
  std::vector<MeshContacts> groups_;
  std::size_t group_count_ = 0;
};

}  // namespace rigor
