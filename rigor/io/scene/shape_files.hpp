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

/// The mesh and hull files of a scene. Each file is read once, and each shape is made once per scale. Files
/// must lie in the folder of the scene or below: links and ".." that leave it are refused.
class ShapeFiles {
 public:
  explicit ShapeFiles(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// Surface from the key `file`, scaled by the key `scale`, as triangles; nothing, and the reason in the
  /// errors, if it is invalid.
  std::optional<Mesh> mesh(const ObjectReader& shape);
  /// Rows of heights from the key `file`; empty, and the reason in the errors, if there are none.
  HeightRows heights(const ObjectReader& shape);
  /// Hull of the vertices from the key `file`, scaled.
  std::optional<Convex> convex(const ObjectReader& shape);

 private:
  std::optional<std::filesystem::path> find_file(const ObjectReader& shape, const std::string& file) const;
  std::optional<PolygonMesh> read_scaled(const ObjectReader& shape, const std::string& file,
                                         const Vec3& scale);
  /// The result of read(path); nothing, and the reason in the errors, if the file cannot be read.
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
