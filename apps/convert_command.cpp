#include "apps/commands.hpp"
#include "apps/interrupt.hpp"
#include "apps/progress.hpp"
#include "apps/terminal.hpp"
#include "rigor/core/input_error.hpp"
#include "rigor/geometry/decomposition/convex_decomposition.hpp"
#include "rigor/geometry/decomposition/make_mesh.hpp"
#include "rigor/geometry/mesh/mesh_check.hpp"
#include "rigor/geometry/mesh/triangle_tree.hpp"
#include "rigor/io/files/json_text.hpp"
#include "rigor/io/files/output_file.hpp"
#include "rigor/io/mesh/mesh_files.hpp"
#include "rigor/io/scene/solid_writer.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cctype>
#include <cmath>
#include <filesystem>

namespace rigor {

namespace {

/// Default of the largest excess of a piece, as a fraction of the longest side of the mesh.
constexpr double usual_tolerance = 0.01;

/// The checked mesh of a solid. Throws InputError for a mesh that bounds no solid.
PolygonMesh read_solid(const std::string& path) {
  PolygonMesh polygons = read_mesh(path);
  std::vector<std::string> errors;
  for (const MeshDefect& defect : find_mesh_defects(polygons)) {
    const std::string message = fmt::format("{}: {}", path, defect.text);
    if (defect.is_error) {
      errors.push_back(message);
    } else {
      print_warning(message);
    }
  }
  if (!errors.empty()) throw InputError(std::move(errors));
  return polygons;
}

/// The name of the file without folder and suffix, restricted to the characters of a name.
std::string name_of(const std::string& path) {
  std::string name = std::filesystem::path(path).stem().string();
  for (char& c : name) {
    if (!std::isalnum(static_cast<unsigned char>(c)) && c != '-') c = '_';
  }
  return name.empty() ? "pieces" : name;
}

std::string error_text(const ConvexDecomposition& d) {
  if (d.is_exact) return "none: the pieces are the solid, up to rounding";
  return fmt::format("no point of a piece is farther than {:.3g} m from the solid", d.error);
}

std::string comment_of(const ConvexDecomposition& d, const std::string& input) {
  return fmt::format(
      "{} convex {} of {}, by `rigor convert`.\nError: {}.\nVolume: {:.9g} m³; of the solid {:.9g} m³.",
      d.pieces.size(), d.pieces.size() == 1 ? "piece" : "pieces",
      std::filesystem::path(input).filename().string(), error_text(d), d.pieces_volume, d.volume);
}

std::string report_of(const ConvexDecomposition& d, const ConvertOptions& options) {
  return fmt::format(
      "{}: {} convex {} in {}\n  error         {}\n  volume        {:.9g} m³; of the solid {:.9g} m³\n",
      toned(options.input, Tone::strong, stdout), d.pieces.size(), d.pieces.size() == 1 ? "piece" : "pieces",
      options.output, error_text(d), d.pieces_volume, d.volume);
}

nlohmann::ordered_json json_of(const ConvexDecomposition& d, const ConvertOptions& options) {
  nlohmann::ordered_json json = {{"input", options.input},
                                 {"output", options.output},
                                 {"pieces", d.pieces.size()},
                                 {"exact", d.is_exact},
                                 {"error", d.error},
                                 {"volume", d.volume},
                                 {"pieces_volume", d.pieces_volume},
                                 {"excess", nlohmann::ordered_json::array()}};
  for (const ConvexPiece& piece : d.pieces) json["excess"].push_back(piece.excess);
  return json;
}

ExitCode convert_to_pieces(const ConvertOptions& options) {
  const Mesh mesh = make_mesh(std::make_shared<const TriangleMesh>(triangulated(read_solid(options.input))));
  const double tolerance =
      options.is_exact ? 0 : options.tolerance.value_or(usual_tolerance * mesh.tree->size);
  const InterruptWatch interrupt;
  ConvexDecomposition pieces;
  {
    ProgressLine line(true);
    const auto goes_on = [&](int count, double excess) {
      line.update(CuttingProgress{options.input, count, options.max_pieces, excess});
      return !interrupt.is_requested();
    };
    pieces = decompose(mesh, {.tolerance = tolerance, .max_pieces = options.max_pieces, .goes_on = goes_on});
  }
  if (interrupt.is_requested()) return exit_interrupted;
  if (options.is_exact && !pieces.is_exact) {
    throw InputError(fmt::format(
        "{}: more than {} convex pieces are needed to be exact; allow more with --max-pieces, or leave out "
        "--exact for pieces that stand out a little",
        options.input, options.max_pieces));
  }
  write_atomically(options.output,
                   pieces_scene(pieces, name_of(options.input), comment_of(pieces, options.input)));
  if (options.json != "-") fmt::print("{}", report_of(pieces, options));
  write_text(options.json, json_text(json_of(pieces, options)).append("\n"));
  if (pieces.error <= tolerance) return exit_done;
  print_warning(fmt::format("{} pieces are not enough for an error of {:.3g} m; allow more with --max-pieces",
                            options.max_pieces, tolerance));
  return exit_audit_violated;
}

}  // namespace

ExitCode execute(const ConvertOptions& options) {
  check_can_write(options.output);
  if (!options.is_mesh_output) return convert_to_pieces(options);
  const PolygonMesh mesh = read_mesh(options.input);
  write_atomically(options.output, obj_text(mesh));
  fmt::print("{}: {} vertices and {} faces in {}\n", toned(options.input, Tone::strong, stdout),
             mesh.vertices.size(), mesh.faces.size(), options.output);
  return exit_done;
}

}  // namespace rigor
