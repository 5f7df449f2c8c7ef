#include "rigor/io/scene/synonyms.hpp"

#include "rigor/core/quoted.hpp"
#include "rigor/io/files/scalar_text.hpp"
#include "rigor/io/scene/scene_keys.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace rigor {

namespace {

/// A type of a shape or a joint by another name.
struct TypeSynonym {
  std::string_view family, written, type;
};
constexpr std::array type_synonyms = {
    TypeSynonym{"joint", "revolute", "hinge"},
    TypeSynonym{"joint", "rotational", "hinge"},
    TypeSynonym{"joint", "pin", "hinge"},
    TypeSynonym{"joint", "prismatic", "slider"},
    TypeSynonym{"joint", "translational", "slider"},
    TypeSynonym{"joint", "weld", "fixed"},
    TypeSynonym{"joint", "rigid", "fixed"},
    TypeSynonym{"joint", "spherical", "ball"},
    TypeSynonym{"joint", "ball_and_socket", "ball"},
    TypeSynonym{"joint", "ball_socket", "ball"},
    TypeSynonym{"joint", "hooke", "universal"},
    TypeSynonym{"joint", "cardan", "universal"},
    TypeSynonym{"joint", "helical", "screw"},
    TypeSynonym{"joint", "rod", "distance"},
    TypeSynonym{"shape", "ball", "sphere"},
    TypeSynonym{"shape", "cuboid", "box"},
    TypeSynonym{"shape", "cube", "box"},
    TypeSynonym{"shape", "brick", "box"},
    TypeSynonym{"shape", "ground", "plane"},
    TypeSynonym{"shape", "half_space", "plane"},
    TypeSynonym{"shape", "halfspace", "plane"},
    TypeSynonym{"shape", "hull", "convex"},
    TypeSynonym{"shape", "convex_hull", "convex"},
    TypeSynonym{"shape", "polyhedron", "convex"},
    TypeSynonym{"shape", "trimesh", "mesh"},
    TypeSynonym{"shape", "triangle_mesh", "mesh"},
    TypeSynonym{"shape", "height_field", "heightfield"},
    TypeSynonym{"shape", "hfield", "heightfield"},
};

/// A key of an object by another name; its numbers are `factor` times those written.
struct KeySynonym {
  std::string_view object, written, key;
  double factor = 1;
};
constexpr std::array key_synonyms = {
    KeySynonym{"box", "half_extents", "size", 2},
    KeySynonym{"box", "half_size", "size", 2},
    KeySynonym{"box", "extents", "size"},
    KeySynonym{"box", "dimensions", "size"},
    KeySynonym{"sphere", "diameter", "radius", 0.5},
    KeySynonym{"capsule", "height", "length"},
    KeySynonym{"capsule", "half_length", "length", 2},
    KeySynonym{"capsule", "half_height", "length", 2},
    KeySynonym{"cylinder", "height", "length"},
    KeySynonym{"cylinder", "half_length", "length", 2},
    KeySynonym{"cylinder", "half_height", "length", 2},
    KeySynonym{"cone", "height", "length"},
    KeySynonym{"ellipsoid", "semi_axes", "radii"},
    KeySynonym{"body", "pos", "position"},
    KeySynonym{"body", "linear_velocity", "velocity"},
    KeySynonym{"body", "omega", "angular_velocity"},
    KeySynonym{"body", "quaternion", "orientation"},
    KeySynonym{"material", "mu", "friction"},
    KeySynonym{"material", "friction_coefficient", "friction"},
    KeySynonym{"material", "bounciness", "restitution"},
    KeySynonym{"run", "dt", "step"},
    KeySynonym{"run", "timestep", "step"},
    KeySynonym{"run", "time_step", "step"},
    KeySynonym{"run", "t_end", "duration"},
    KeySynonym{"run", "end_time", "duration"},
};

/// A choice by another name.
struct ChoiceSynonym {
  std::string_view object, key, written, choice;
};
constexpr std::array choice_synonyms = {
    ChoiceSynonym{"body", "motion", "fixed", "static"},
    ChoiceSynonym{"body", "motion", "free", "dynamic"},
    ChoiceSynonym{"body", "motion", "animated", "kinematic"},
    ChoiceSynonym{"method", "integrator", "rk45", "dopri5"},
    ChoiceSynonym{"method", "integrator", "runge-kutta", "rk4"},
    ChoiceSynonym{"method", "integrator", "symplectic-euler", "semi-implicit-euler"},
};

/// What is called a scheme elsewhere and is a solver of time stepping here.
constexpr std::array<std::string_view, 2> schemes_of_substep = {"substep", "substeps"};

YamlNode::Pointer with_text(const YamlNode& node, std::string_view text) {
  auto changed = std::make_shared<YamlNode>(node);
  changed->text = std::string(text);
  return changed;
}

/// The number, or the numbers of the list, times a factor; what is no number is left for the reader.
YamlNode::Pointer scaled(const YamlNode::Pointer& node, double factor) {
  if (factor == 1) return node;
  auto changed = std::make_shared<YamlNode>(*node);
  if (node->kind == YamlNode::Kind::list) {
    for (YamlNode::Entry& entry : changed->entries) entry.value = scaled(entry.value, factor);
  } else if (const NumberText number = parse_number(node->text); number.value && !node->is_quoted) {
    changed->text = fmt::format("{:.17g}", factor * *number.value);
  }
  return changed;
}

class Rewriter {
 public:
  explicit Rewriter(SceneErrors& errors) : errors_(errors) {}

  /// The mapping of an object with its own words and those of the objects in it.
  YamlNode::Pointer object(const YamlNode::Pointer& node, std::string_view object_or_family) {
    if (node->kind != YamlNode::Kind::map) return node;
    YamlNode::Pointer own = node;
    const std::vector<std::string> types = types_of(object_or_family);
    if (!types.empty()) own = with_type(own, object_or_family);
    const KeyTable* const table = types.empty() ? &key_table(object_or_family) : table_of(*own, types);
    if (table == nullptr) return own;
    return with_parts(with_choices(with_keys(own, *table), *table), *table);
  }

 private:
  /// Tells each word once.
  void advise(const YamlNode& node, const std::string& message) {
    if (told_.insert(message).second) errors_.add_warning(node, message);
  }

  static const KeyTable* table_of(const YamlNode& node, const std::vector<std::string>& types) {
    const YamlNode::Entry* const type = node.find("type");
    if (!type || std::ranges::find(types, type->value->text) == types.end()) return nullptr;
    return &key_table(type->value->text);
  }

  /// The mapping with one entry's value changed.
  static YamlNode::Pointer with_value(const YamlNode& node, const YamlNode::Entry& entry,
                                      YamlNode::Pointer value) {
    auto changed = std::make_shared<YamlNode>(node);
    changed->entries[static_cast<std::size_t>(&entry - node.entries.data())].value = std::move(value);
    return changed;
  }

  YamlNode::Pointer with_type(const YamlNode::Pointer& node, std::string_view family) {
    const YamlNode::Entry* const type = node->find("type");
    if (!type || type->value->kind != YamlNode::Kind::scalar) return node;
    for (const TypeSynonym& synonym : type_synonyms) {
      if (synonym.family != family || synonym.written != type->value->text) continue;
      advise(*type->value, fmt::format("the {} '{}' is read as '{}', its name here", family, synonym.written,
                                       synonym.type));
      return with_value(*node, *type, with_text(*type->value, synonym.type));
    }
    return node;
  }

  YamlNode::Pointer with_keys(const YamlNode::Pointer& node, const KeyTable& table) {
    std::shared_ptr<YamlNode> changed;
    for (std::size_t i = 0; i < node->entries.size(); ++i) {
      const YamlNode::Entry& entry = node->entries[i];
      const auto synonym = std::ranges::find_if(key_synonyms, [&](const KeySynonym& each) {
        return each.object == table.object && each.written == entry.key && !node->find(each.key);
      });
      if (synonym == key_synonyms.end()) continue;
      const std::string times = synonym->factor == 1 ? "" : fmt::format(" (times {:g})", synonym->factor);
      advise(*entry.value, fmt::format("'{}' of {} is read as '{}'{}, its name here", entry.key, table.title,
                                       synonym->key, times));
      if (!changed) changed = std::make_shared<YamlNode>(*node);
      changed->entries[i].key = std::string(synonym->key);
      changed->entries[i].value = scaled(entry.value, synonym->factor);
    }
    return changed ? changed : node;
  }

  YamlNode::Pointer with_choices(const YamlNode::Pointer& node, const KeyTable& table) {
    YamlNode::Pointer changed = node;
    for (const ChoiceSynonym& synonym : choice_synonyms) {
      const YamlNode::Entry* const entry = changed->find(synonym.key);
      if (synonym.object != table.object || !entry || entry->value->text != synonym.written) continue;
      advise(*entry->value, fmt::format("{} '{}' is read as '{}', its name here", synonym.key,
                                        synonym.written, synonym.choice));
      changed = with_value(*changed, *entry, with_text(*entry->value, synonym.choice));
    }
    return table.object == "method" ? with_solver(changed) : changed;
  }

  /// `scheme: substep` as the solver of time stepping that it is, unless another solver is named.
  YamlNode::Pointer with_solver(const YamlNode::Pointer& node) {
    const YamlNode::Entry* const scheme = node->find("scheme");
    if (!scheme || std::ranges::find(schemes_of_substep, scheme->value->text) == schemes_of_substep.end())
      return node;
    const YamlNode::Entry* const solver = node->find("solver");
    if (solver && solver->value->text != "substep") return node;
    advise(*scheme->value,
           fmt::format("scheme '{}' is read as 'scheme: time-stepping, solver: substep': it is a "
                       "solver of that scheme",
                       scheme->value->text));
    auto changed = std::make_shared<YamlNode>(*node);
    const YamlNode::Pointer name = with_text(*scheme->value, "substep");
    changed->entries[static_cast<std::size_t>(scheme - node->entries.data())].value =
        with_text(*scheme->value, "time-stepping");
    if (!solver) changed->entries.push_back({"solver", scheme->line, scheme->column, name});
    return changed;
  }

  /// The objects in it, and in its lists.
  YamlNode::Pointer with_parts(const YamlNode::Pointer& node, const KeyTable& table) {
    std::shared_ptr<YamlNode> changed;
    for (std::size_t i = 0; i < node->entries.size(); ++i) {
      const YamlNode::Entry& entry = node->entries[i];
      const Key* const key = table.find(entry.key);
      if (!key || key->object.empty()) continue;
      const YamlNode::Pointer part =
          key->type == ValueType::objects ? list(entry.value, key->object) : object(entry.value, key->object);
      if (part == entry.value) continue;
      if (!changed) changed = std::make_shared<YamlNode>(*node);
      changed->entries[i].value = part;
    }
    return changed ? changed : node;
  }

  YamlNode::Pointer list(const YamlNode::Pointer& node, std::string_view of) {
    if (node->kind != YamlNode::Kind::list) return node;
    std::shared_ptr<YamlNode> changed;
    for (std::size_t i = 0; i < node->entries.size(); ++i) {
      const YamlNode::Pointer part = object(node->entries[i].value, of);
      if (part == node->entries[i].value) continue;
      if (!changed) changed = std::make_shared<YamlNode>(*node);
      changed->entries[i].value = part;
    }
    return changed ? changed : node;
  }

  SceneErrors& errors_;
  std::set<std::string> told_;
};

}  // namespace

YamlNode::Pointer with_synonyms(const YamlNode::Pointer& root, SceneErrors& errors) {
  return Rewriter(errors).object(root, "scene");
}

}  // namespace rigor
