#include "rigor/io/scene/shape_files.hpp"

#include "rigor/core/input_error.hpp"
#include "rigor/core/quoted.hpp"
#include "rigor/geometry/decomposition/make_mesh.hpp"
#include "rigor/geometry/mesh/mesh_check.hpp"
#include "rigor/geometry/mesh/triangle_tree.hpp"
#include "rigor/io/mesh/height_file.hpp"
#include "rigor/io/mesh/mesh_files.hpp"

#include <algorithm>
#include <memory>
#include <system_error>
#include <tuple>
#include <utility>

namespace rigor {

namespace {

/// Searching for faces that intersect each other is the slowest check and yields only a warning; it is
/// skipped for larger meshes.
constexpr std::size_t most_faces_searched = 200000;

Vec3 scale_of(const ObjectReader& shape) {
  return shape.vector("scale").value_or(Vec3::Ones());
}

/// Whether the polygons form a surface, possibly open; the mesh of a dynamic body is checked to be closed
/// when the body is built.
bool check_surface(const ObjectReader& shape, const PolygonMesh& mesh) {
  MeshCheckOptions options;
  options.may_be_open = true;
  options.self_intersections = mesh.faces.size() <= most_faces_searched;
  const std::vector<MeshDefect> defects = find_mesh_defects(mesh, options);
  for (const MeshDefect& defect : defects) {
    if (defect.is_error) {
      shape.fail("file", defect.text);
    } else if (defect.kind != MeshDefectKind::open_edge) {
      shape.errors().add_warning(shape.node(), shape.whose() + ": " + defect.text);
    }
  }
  return !has_errors(defects);
}

/// Whether the path, after following links and "..", stays in the folder, whose links have been followed
/// already.
bool is_inside(const std::filesystem::path& path, const std::filesystem::path& folder) {
  const auto [end_of_folder, rest] = std::mismatch(folder.begin(), folder.end(), path.begin(), path.end());
  return end_of_folder == folder.end() && rest != path.end();
}

}  // namespace

template <typename Read>
auto ShapeFiles::read_file(const ObjectReader& shape, const std::string& file, const Read& read) const {
  std::optional<decltype(read(std::filesystem::path()))> content;
  const std::optional<std::filesystem::path> path = find_file(shape, file);
  if (!path) return content;
  try {
    content = read(*path);
  } catch (const InputError& error) {
    // The message starts with the path where the file was found; it is shown as the user wrote it.
    for (std::string message : error.messages()) {
      if (message.starts_with(path->string())) message.replace(0, path->string().size(), file);
      shape.fail("file", message);
    }
  }
  return content;
}

std::optional<Mesh> ShapeFiles::mesh(const ObjectReader& shape) {
  const std::optional<std::string> file = shape.text("file");
  const Vec3 scale = scale_of(shape);
  if (!file) return std::nullopt;
  const auto [entry, is_new] = meshes_.try_emplace({*file, scale.x(), scale.y(), scale.z()});
  if (!is_new) return entry->second;
  const std::optional<PolygonMesh> polygons = read_scaled(shape, *file, scale);
  if (polygons && check_surface(shape, *polygons)) {
    entry->second = make_mesh(std::make_shared<const TriangleMesh>(triangulated(*polygons)));
  }
  return entry->second;
}

HeightRows ShapeFiles::heights(const ObjectReader& shape) {
  const std::optional<std::string> file = shape.text("file");
  if (!file) return {};
  const auto [entry, is_new] = heights_.try_emplace(*file);
  if (is_new) entry->second = read_file(shape, *file, read_heights).value_or(HeightRows{});
  return entry->second;
}

std::optional<Convex> ShapeFiles::convex(const ObjectReader& shape) {
  const std::optional<std::string> file = shape.text("file");
  const Vec3 scale = scale_of(shape);
  if (!file) return std::nullopt;
  const auto [entry, is_new] = convexes_.try_emplace({*file, scale.x(), scale.y(), scale.z()});
  if (!is_new) return entry->second;
  const std::optional<PolygonMesh> polygons = read_scaled(shape, *file, scale);
  if (!polygons) return std::nullopt;
  std::variant<ConvexHull, std::string> hull = make_convex_hull(polygons->vertices);
  if (const std::string* const reason = std::get_if<std::string>(&hull)) {
    shape.fail("file", *reason);
  } else {
    entry->second = Convex{std::make_shared<const ConvexHull>(std::get<ConvexHull>(std::move(hull)))};
  }
  return entry->second;
}

std::optional<std::filesystem::path> ShapeFiles::find_file(const ObjectReader& shape,
                                                           const std::string& file) const {
  const std::filesystem::path relative(file);
  if (file.empty() || relative.is_absolute()) {
    shape.fail("file", "file is " + quoted_text(file) + ", must be a path relative to the scene's folder");
    return std::nullopt;
  }
  std::error_code error;
  const std::filesystem::path folder = std::filesystem::canonical(folder_.empty() ? "." : folder_, error);
  const std::filesystem::path path = std::filesystem::weakly_canonical(folder / relative, error);
  if (error) {
    shape.fail("file", "file " + quoted_text(file) + " cannot be read (" + error.message() + ")");
    return std::nullopt;
  }
  // This is checked before any message reveals what exists there.
  if (!is_inside(path, folder)) {
    shape.fail("file",
               "file " + quoted_text(file) + " is outside of the scene's folder, must be in it or below");
    return std::nullopt;
  }
  if (!std::filesystem::exists(path, error)) {
    shape.fail("file", "there is no file " + quoted_text(file) + " in the scene's folder");
    return std::nullopt;
  }
  if (!std::filesystem::is_regular_file(path, error)) {
    shape.fail("file", "file " + quoted_text(file) + " is a directory or a device, must be a file");
    return std::nullopt;
  }
  return path;
}

std::optional<PolygonMesh> ShapeFiles::read_scaled(const ObjectReader& shape, const std::string& file,
                                                   const Vec3& scale) {
  const auto [entry, is_new] = files_.try_emplace(file);
  if (is_new) {
    entry->second = read_file(shape, file, [](const std::filesystem::path& path) { return read_mesh(path); });
  }
  std::optional<PolygonMesh> scaled = entry->second;
  if (!scaled) return std::nullopt;
  for (Vec3& vertex : scaled->vertices) vertex = vertex.cwiseProduct(scale);
  return scaled;
}

}  // namespace rigor
