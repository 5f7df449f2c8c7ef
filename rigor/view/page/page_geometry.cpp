#include "rigor/view/page/page_geometry.hpp"

#include "rigor/core/interrupt.hpp"
#include "rigor/geometry/shape/convex_hull.hpp"
#include "rigor/geometry/shape/triangle_mesh.hpp"
#include "rigor/io/files/json_text.hpp"
#include "rigor/math/rotation.hpp"
#include "rigor/view/3d/bowl.hpp"
#include "rigor/view/3d/surface.hpp"
#include "rigor/view/page/page_block.hpp"
#include "rigor/view/page/page_json.hpp"

#include <map>

namespace rigor {

namespace {

using Json = nlohmann::ordered_json;

std::string bytes_of(const TriangleMesh& mesh) {
  std::string bytes;
  for (const Vec3& vertex : mesh.vertices) {
    for (const double x : vertex) append_f32(static_cast<float>(x), bytes);
  }
  for (const std::array<int, 3>& triangle : mesh.triangles) {
    for (const int vertex : triangle) append_u32(static_cast<std::uint32_t>(vertex), bytes);
  }
  return bytes;
}

/// Writes each mesh once and returns its index.
class MeshTable {
 public:
  explicit MeshTable(PageGeometry& geometry) : geometry_(geometry) {}
  int index_of(const TriangleMesh& mesh) {
    const std::string bytes = bytes_of(mesh);
    const auto [place, is_new] = indices_.try_emplace(bytes, static_cast<int>(indices_.size()));
    if (is_new) {
      geometry_.meshes.push_back({{"vertices", mesh.vertices.size()}, {"triangles", mesh.triangles.size()}});
      geometry_.mesh_bytes += bytes;
    }
    return place->second;
  }

 private:
  PageGeometry& geometry_;
  std::map<std::string, int> indices_;
};

/// The faces of a drawing, cut into triangles.
TriangleMesh triangles_of(const Surface& surface) {
  PolygonMesh polygons{surface.vertices, {}};
  for (const Surface::Face& face : surface.faces) {
    const auto begin = surface.corners.begin() + face.begin;
    polygons.faces.emplace_back(begin, begin + face.count);
  }
  return triangulated(polygons);
}

/// The dimensions of a shape that the viewer draws by itself; for any other shape the mesh that pictures
/// draw, which is all that the page then knows of it.
struct Dimensions {
  MeshTable& meshes;

  Json operator()(const Sphere& s) const { return {{"radius", s.radius}}; }
  Json operator()(const Box& b) const { return {{"half_extents", json_of(b.half_extents)}}; }
  Json operator()(const Capsule& c) const { return round(c.radius, c.half_length); }
  Json operator()(const Cylinder& c) const { return round(c.radius, c.half_length); }
  Json operator()(const Cone& c) const { return round(c.radius, c.half_length); }
  Json operator()(const Ellipsoid& e) const { return {{"radii", json_of(e.radii)}}; }
  Json operator()(const HalfSpace& h) const { return {{"normal", json_of(h.normal)}, {"offset", h.offset}}; }
  /// The caller draws this shape as a mesh instead (drawn_form).
  Json operator()(const Cavity&) const { return Json::object(); }
  Json operator()(const Convex& c) const {
    return {{"mesh", meshes.index_of(triangulated({c.hull->vertices, c.hull->faces}))}};
  }
  Json operator()(const Mesh& m) const { return {{"mesh", meshes.index_of(*m.mesh)}}; }
  template <class Own>
  Json operator()(const Own& s) const {
    return {{"type", "mesh"}, {"mesh", meshes.index_of(triangles_of(make_surface(s)))}};
  }

 private:
  static Json round(double radius, double half_length) {
    return {{"radius", radius}, {"half_length", half_length}};
  }
};

Json look_of(const Body& body, MeshTable& meshes) {
  Json look = Json::array();
  for (const BodyShape& shape : body.shapes) {
    const Shape form = drawn_form(shape.shape);
    Json json = {{"type", shape_type_name(form)}};
    json.update(std::visit(Dimensions{meshes}, form));
    const Quat q = quaternion_of(shape.X_BS.R);
    json["p"] = json_of(shape.X_BS.p);
    json["q"] = {q.w(), q.x(), q.y(), q.z()};
    json["material"] = shape.material;
    json["color"] = shape.color;
    look.push_back(std::move(json));
  }
  return look;
}

}  // namespace

PageGeometry page_geometry(const Model& model) {
  PageGeometry geometry;
  MeshTable meshes(geometry);
  std::map<std::string, int> indices;
  for (const Body& body : model.bodies()) {
    poll_interrupt();
    const Json look = look_of(body, meshes);
    const auto [place, is_new] = indices.try_emplace(json_line(look), static_cast<int>(indices.size()));
    if (is_new) geometry.looks.push_back(look);
    geometry.look_of_body.push_back(place->second);
  }
  return geometry;
}

}  // namespace rigor
