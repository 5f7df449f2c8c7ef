#include "rigor/io/scene/scene_reader.hpp"

#include "rigor/core/input_error.hpp"
#include "rigor/io/files/scalar_text.hpp"
#include "rigor/io/files/text_file.hpp"
#include "rigor/io/files/yaml_document.hpp"
#include "rigor/io/scene/body_reader.hpp"
#include "rigor/io/scene/expectation_reader.hpp"
#include "rigor/io/scene/force_reader.hpp"
#include "rigor/io/scene/joint_reader.hpp"
#include "rigor/io/scene/method_reader.hpp"
#include "rigor/io/scene/object_reader.hpp"
#include "rigor/io/scene/scene_overrides.hpp"
#include "rigor/io/scene/scene_tree.hpp"
#include "rigor/io/scene/shape_files.hpp"
#include "rigor/io/scene/synonyms.hpp"
#include "rigor/sim/method/scheme_check.hpp"

#include <algorithm>
#include <cctype>
#include <initializer_list>
#include <map>
#include <utility>

namespace rigor {

namespace {

/// Standard gravity along -z.
const Vec3 standard_gravity(0, 0, -9.80665);

using Materials = std::map<std::string, Material>;

void read_world(const ObjectReader& scene, ModelBuilder& builder) {
  if (!scene.has("world")) return builder.set_gravity(standard_gravity);
  const ObjectReader world(*scene.find("world"), key_table("world"), "world", scene.errors());
  const YamlNode* const gravity = world.find("gravity");
  builder.set_gravity(world.vector("gravity").value_or(standard_gravity),
                      scene.errors().where(gravity ? *gravity : world.node()));
}

Materials read_materials(const ObjectReader& scene, ModelBuilder& builder) {
  Materials materials{{"default", Material{.name = "default"}}};
  std::size_t index = 0;
  for (const YamlNode* const node : scene.list("materials")) {
    const ObjectReader reader(*node, key_table("material"), whose_text("material", *node, index++),
                              scene.errors());
    Material material;
    const std::optional<std::string> name = reader.text("name");
    material.density = reader.number("density").value_or(material.density);
    material.friction = reader.number("friction").value_or(material.friction);
    material.restitution = reader.number("restitution").value_or(material.restitution);
    material.tangential_restitution = reader.number("tangential_restitution").value_or(0);
    material.rolling_friction = reader.number("rolling_friction").value_or(0);
    material.torsional_friction = reader.number("torsional_friction").value_or(0);
    material.static_friction = reader.number("static_friction");
    if (!name) continue;
    material.name = *name;
    materials[material.name] = material;
    builder.add_material(std::move(material), scene.errors().where(*node));
  }
  return materials;
}

void read_pairs(const ObjectReader& scene, const Materials& materials, ModelBuilder& builder) {
  std::size_t index = 0;
  for (const YamlNode* const node : scene.list("pairs")) {
    const ObjectReader pair(*node, key_table("pair"), "pair " + std::to_string(index++), scene.errors());
    const std::vector<std::string> names = pair.names("between");
    const std::optional<double> friction = pair.number("friction"), restitution = pair.number("restitution");
    const std::optional<double> rolling = pair.number("rolling_friction"),
                                torsional = pair.number("torsional_friction");
    if (names.empty()) continue;
    const auto a = materials.find(names[0]), b = materials.find(names[1]);
    PairCoefficients coefficients{0, 0};
    if (a != materials.end() && b != materials.end())
      coefficients = combined_coefficients(a->second, b->second);
    coefficients.friction = friction.value_or(coefficients.friction);
    coefficients.restitution = restitution.value_or(coefficients.restitution);
    coefficients.tangential_restitution =
        pair.number("tangential_restitution").value_or(coefficients.tangential_restitution);
    coefficients.rolling_friction = rolling.value_or(coefficients.rolling_friction);
    coefficients.torsional_friction = torsional.value_or(coefficients.torsional_friction);
    // The static friction of the materials belongs to their own friction.
    if (friction || pair.has("static_friction"))
      coefficients.static_friction = pair.number("static_friction");
    builder.set_pair(names[0], names[1], coefficients, scene.errors().where(*node));
  }
}

void read_bodies(const ObjectReader& scene, std::uint64_t seed, const std::filesystem::path& folder,
                 ModelBuilder& builder) {
  ShapeFiles files(folder);
  BodyReader reader({seed, jointed_names(scene)}, files, scene.errors(), builder);
  std::size_t index = 0;
  for (const YamlNode* const node : scene.list("bodies")) {
    if (scene.errors().is_full()) return;
    reader.read(*node, index++);
  }
}

void read_excluded(const ObjectReader& scene, ModelBuilder& builder) {
  for (const YamlNode* const node : scene.list("exclude")) {
    const std::vector<std::string> names = read_name_pair(*node, "exclude", scene.errors());
    if (!names.empty()) builder.exclude_pair(names[0], names[1], scene.errors().where(*node));
  }
}

void read_forces(const ObjectReader& scene, ModelBuilder& builder) {
  std::size_t index = 0;
  for (const YamlNode* const node : scene.list("forces")) {
    if (scene.errors().is_full()) return;
    read_force(*node, index++, scene.errors(), builder);
  }
}

void read_joints(const ObjectReader& scene, ModelBuilder& builder) {
  JointReader reader(scene.errors(), builder);
  std::size_t index = 0;
  for (const YamlNode* const node : scene.list("joints")) {
    if (scene.errors().is_full()) return;
    reader.read(*node, index++);
  }
}

/// Collects all errors that the reader and the builder find, so that they are reported at once.
void check_all(const ModelBuilder& builder, SceneErrors& errors) {
  if (errors.count() == 0) return;
  if (!errors.is_full()) {
    for (const std::string& message : builder.check()) errors.add_text(message);
  }
  throw InputError(errors.sorted_messages());
}

/// Reads a document without synonyms; `errors` has what was told of them.
Scene scene_of_root(const YamlNode& root, const YamlSources& sources, const std::filesystem::path& folder,
                    SceneErrors& errors) {
  const ObjectReader reader(root, key_table("scene"), "the scene", errors);
  ModelBuilder builder;
  Scene scene;
  reader.number("rigor");
  scene.name = reader.text("name").value_or(std::filesystem::path(sources.names[0]).stem().string());
  builder.set_name(scene.name);
  scene.run = read_run(reader);
  scene.method = read_method(reader);
  read_world(reader, builder);
  const Materials materials = read_materials(reader, builder);
  read_pairs(reader, materials, builder);
  read_bodies(reader, scene.run.seed, folder, builder);
  read_excluded(reader, builder);
  read_forces(reader, builder);
  read_joints(reader, builder);
  scene.expected = read_expectations(reader);
  // What is in it the layer of studies reads.
  if (const YamlNode* const study = reader.find("study"); study && study->kind != YamlNode::Kind::map)
    reader.fail("study", "study must be a mapping, found " + found_text(*study));
  check_all(builder, errors);
  try {
    scene.model = builder.build();
  } catch (const InputError& error) {
    for (const std::string& message : error.messages()) errors.add_text(message);
    throw InputError(errors.sorted_messages());
  }
  check_expectations(reader, scene.expected, *scene.model);
  if (errors.count() > 0) throw InputError(errors.sorted_messages());
  const std::vector<std::string> refusals = check_scheme(*scene.model, scene.method);
  if (!refusals.empty()) {
    const YamlNode* const method = reader.find("method");
    for (const std::string& message : refusals) errors.add(method ? *method : root, message);
    throw InputError(errors.sorted_messages());
  }
  scene.warnings = errors.warnings();
  return scene;
}

}  // namespace

Scene read_scene_tree(const YamlNode::Pointer& written, const YamlSources& sources,
                      const std::filesystem::path& folder) {
  SceneErrors errors(sources);
  const YamlNode::Pointer translated = with_synonyms(written, errors);
  return scene_of_root(*translated, sources, folder, errors);
}

Scene read_tree_without_synonyms(const YamlNode::Pointer& root, const YamlSources& sources,
                                 const std::filesystem::path& folder) {
  SceneErrors errors(sources);
  return scene_of_root(*root, sources, folder, errors);
}

Scene parse_scene(const std::string& text, const std::string& file_name, const std::filesystem::path& folder,
                  const std::vector<std::string>& overrides, std::size_t varied) {
  YamlSources sources{{file_name}};
  for (std::size_t i = 0; i < overrides.size(); ++i) {
    sources.names.push_back((i + varied < overrides.size() ? "--set " : "--vary ") + overrides[i]);
  }
  YamlNode::Pointer root = parse_yaml(text, 0, sources);
  for (std::size_t i = 0; i < overrides.size(); ++i) {
    root = with_override(root, overrides[i], static_cast<int>(i) + 1, sources);
  }
  return read_scene_tree(root, sources, folder);
}

namespace {

/// What a file is good for whose suffix is that of something else; empty for what may be a scene.
std::string foreign_use(const std::filesystem::path& path) {
  std::string suffix = path.extension().string();
  std::transform(suffix.begin(), suffix.end(), suffix.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const auto is_one_of = [&](std::initializer_list<const char*> all) {
    return std::find(all.begin(), all.end(), suffix) != all.end();
  };
  if (is_one_of({".h5", ".hdf5"}))
    return suffix + " is a stored motion, no scene: 'rigor view', 'rigor render' and 'rigor plot' take it";
  if (is_one_of({".obj", ".stl", ".ply"}))
    return suffix +
           " is a mesh, no scene: 'rigor convert' and 'rigor mass' take it, and shapes of a scene "
           "name it (type: mesh, file: ...)";
  if (is_one_of({".urdf", ".xacro", ".sdf",  ".world", ".xml",  ".mjcf", ".mjb",
                 ".usd",  ".usda",  ".usdc", ".usdz",  ".dae",  ".gltf", ".glb",
                 ".fbx",  ".blend", ".step", ".stp",   ".iges", ".igs",  ".3mf"}))
    return suffix +
           " is no format that Rigor reads; scenes are .yaml or .json (docs/scene.md, docs/tutorial.md)";
  return {};
}

}  // namespace

Scene read_scene(const std::filesystem::path& path, const std::vector<std::string>& overrides,
                 std::size_t varied) {
  const std::string use = foreign_use(path);
  if (!use.empty() && std::filesystem::exists(path)) throw InputError(path.string() + ": " + use);
  const std::string text = read_text_file(path, YamlLimits{}.max_bytes);
  return parse_scene(text, path.string(), path.parent_path(), overrides, varied);
}

}  // namespace rigor
