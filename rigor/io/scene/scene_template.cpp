#include "rigor/io/scene/scene_template.hpp"

#include "rigor/core/range.hpp"
#include "rigor/io/files/text_file.hpp"
#include "rigor/io/scene/scene_overrides.hpp"
#include "rigor/io/scene/scene_tree.hpp"

namespace rigor {

namespace {

YamlNode::Pointer with_values(YamlNode::Pointer root, const std::vector<SceneValue>& values,
                              const std::string& whose) {
  for (const SceneValue& value : values)
    root = with_value(root, value.key, value.value, whose + ": " + value.key + ": ");
  return root;
}

}  // namespace

SceneTemplate::SceneTemplate(const std::filesystem::path& path, const std::vector<SceneValue>& settings)
    : path_(path), text_(read_text_file(path, YamlLimits{}.max_bytes)) {
  root_ = with_values(parse_yaml(text_, 0, YamlSources{{path.string()}}), settings, "set");
}

Scene SceneTemplate::make(const std::vector<SceneValue>& values, const std::string& whose,
                          bool has_synonyms) const {
  const YamlSources sources{{path_.string(), whose}};
  const YamlNode::Pointer root = with_values(root_, values, whose);
  return has_synonyms ? read_scene_tree(root, sources, path_.parent_path())
                      : read_tree_without_synonyms(root, sources, path_.parent_path());
}

YamlNode::Pointer number_node(double value, int source) {
  const auto node = std::make_shared<YamlNode>();
  node->kind = YamlNode::Kind::scalar;
  node->source = source;
  node->text = number_text(value);
  return node;
}

}  // namespace rigor
