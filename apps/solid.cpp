#include "apps/solid.hpp"

#include "rigor/core/index.hpp"
#include "rigor/core/input_error.hpp"
#include "rigor/geometry/mesh/mesh_check.hpp"
#include "rigor/geometry/shape/aabb.hpp"
#include "rigor/geometry/shape/containment.hpp"
#include "rigor/io/mesh/mesh_files.hpp"
#include "rigor/io/scene/scene_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <utility>

namespace rigor {

namespace {

constexpr double usual_density = 1000;  // [kg/m³], water.

bool is_mesh_file(const std::filesystem::path& path) {
  std::string suffix = path.extension().string();
  std::transform(suffix.begin(), suffix.end(), suffix.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return suffix == ".obj" || suffix == ".stl" || suffix == ".ply";
}

/// As many cells as the points allow with two points in each.
SamplingOptions sampling(const MassOptions& options) {
  SamplingOptions sampling;
  sampling.points_per_cell = 2;
  sampling.cells = std::max(1, static_cast<int>(std::cbrt(options.samples / 2.0) + 1e-9));
  return sampling;
}

SolidReport mesh_report(const MassOptions& options) {
  const PolygonMesh polygons = read_mesh(options.file);
  SolidReport report{.name = options.file};
  std::vector<std::string> errors;
  for (const MeshDefect& defect : find_mesh_defects(polygons)) {
    (defect.is_error ? errors : report.notes).push_back(fmt::format("{}: {}", options.file, defect.text));
  }
  if (!errors.empty()) throw InputError(std::move(errors));
  const double density = options.density.value_or(usual_density);
  report.exact = mass_properties(polygons, density);
  report.volume = mass_properties(polygons, 1.0).mass;
  const WindingNumber winding(triangulated(polygons));
  Aabb box{polygons.vertices[0], polygons.vertices[0]};
  for (const Vec3& vertex : polygons.vertices) box = box.united({vertex, vertex});
  report.sampled =
      sampled_mass_properties([&](const Vec3& p) { return winding(p) > 0; }, box, density, sampling(options));
  return report;
}

/// The shapes of a body as parts of one solid in the user frame U.
struct Part {
  const Shape* shape;
  Pose X_US;
  double density;  ///< [kg/m³].
};

std::vector<Part> parts_of(const Body& body, const Model& model, const MassOptions& options) {
  std::vector<Part> parts;
  const Pose X_UB = body.X_BU.inverse();
  for (const BodyShape& shape : body.shapes) {
    const double material = model.materials()[at(shape.material)].density;
    parts.push_back({&shape.shape, X_UB * shape.X_BS, options.density.value_or(material)});
  }
  return parts;
}

/// Estimate from sample points inside any of the parts, which all have the same density.
SampledMassProperties sampled(const std::vector<Part>& parts, const MassOptions& options) {
  std::vector<std::pair<std::function<bool(const Vec3&)>, Pose>> tests;
  Aabb box = axis_aligned_box(*parts[0].shape, parts[0].X_US);
  for (const Part& part : parts) {
    tests.emplace_back(make_inside_test(*part.shape), part.X_US.inverse());
    box = box.united(axis_aligned_box(*part.shape, part.X_US));
  }
  const auto inside = [&](const Vec3& p_U) {
    return std::any_of(tests.begin(), tests.end(),
                       [&](const auto& test) { return test.first(test.second * p_U); });
  };
  return sampled_mass_properties(inside, box, parts[0].density, sampling(options));
}

SolidReport body_report(const Body& body, const Model& model, const MassOptions& options) {
  SolidReport report{.name = body.name};
  const Pose X_UB = body.X_BU.inverse();
  const Mat3 inertia = body.moments.asDiagonal();
  report.simulated = transformed({.mass = body.mass, .inertia = inertia}, X_UB);
  const std::vector<Part> parts = parts_of(body, model, options);
  std::vector<MassProperties> properties;
  bool is_uniform = true;
  for (const Part& part : parts) {
    properties.push_back(transformed(mass_properties(*part.shape, part.density), part.X_US));
    report.volume += mass_properties(*part.shape, 1.0).mass;
    is_uniform = is_uniform && part.density == parts[0].density;
  }
  report.exact = combined(properties);
  if (parts.empty()) report.notes.push_back("the body has no shapes: its inertia is what the scene gives");
  if (!is_uniform)
    report.notes.push_back("no sampled estimate: the shapes have several densities; give one with --density");
  if (!parts.empty() && is_uniform) report.sampled = sampled(parts, options);
  return report;
}

}  // namespace

std::vector<SolidReport> solid_reports(const MassOptions& options) {
  if (is_mesh_file(options.file)) return {mesh_report(options)};
  const Scene scene = read_scene(options.file);
  std::vector<SolidReport> reports;
  for (const Body& body : scene.model->bodies()) {
    if (body.motion == MotionType::dynamic) reports.push_back(body_report(body, *scene.model, options));
  }
  if (reports.empty())
    throw InputError(fmt::format("{}: the scene has no dynamic body, so nothing has a mass", options.file));
  return reports;
}

}  // namespace rigor
