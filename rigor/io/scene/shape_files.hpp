#pragma once

#include "rigor/geometry/shape/convex_hull.hpp"
#include "rigor/geometry/shape/height_field.hpp"
#include "rigor/geometry/shape/shape.hpp"
#include "rigor/geometry/shape/triangle_mesh.hpp"
#include "rigor/io/scene/object_reader.hpp"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace rigor {

/// The mesh and hull files of a scene. Each file is read once, each shape made once for each scale. Files lie
/// in the scene's folder or below: links and ".." that lead out of it are refused.
class ShapeFiles {
 public:
  explicit ShapeFiles(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// Surface of the key `file`, scaled by the key `scale`, as triangles; nothing, and why in the errors, if
  /// it is none.
  std::optional<Mesh> mesh(const ObjectReader& shape);
  /// Rows of heights of the key `file`; empty, and why in the errors, if it has none.
  HeightRows heights(const ObjectReader& shape);
  /// Hull of the vertices of the key `file`, scaled.
  std::optional<Convex> convex(const ObjectReader& shape);

 private:
  std::optional<std::filesystem::path> find_file(const ObjectReader& shape, const std::string& file) const;
  std::optional<PolygonMesh> read_scaled(const ObjectReader& shape, const std::string& file,
                                         const Vec3& scale);
  /// What read(path) makes of the file; nothing, and why in the errors, if it cannot be read.
  template <typename Read>
  auto read_file(const ObjectReader& shape, const std::string& file, const Read& read) const;

  using Identity = std::tuple<std::string, double, double, double>;  // file, scale
  std::filesystem::path folder_;
  std::map<std::string, std::optional<PolygonMesh>> files_;
  std::map<std::string, HeightRows> heights_;
  std::map<Identity, std::optional<Mesh>> meshes_;
  std::map<Identity, std::optional<Convex>> convexes_;
};

}  // namespace rigor
