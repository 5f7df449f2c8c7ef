#include "rigor/view/live/live_file.hpp"

#include "rigor/core/input_error.hpp"
#include "rigor/io/files/text_file.hpp"
#include "rigor/io/files/yaml_document.hpp"

#include <utility>

namespace rigor {

LiveFile::LiveFile(std::filesystem::path path, std::vector<std::string> overrides)
    : path_(std::move(path)), overrides_(std::move(overrides)) {}

Scene LiveFile::read() {
  // The stamp is taken first, so that anything written afterwards counts as a change.
  stamp_ = stamp();
  has_changed_ = false;
  text_.clear();
  text_ = read_text_file(path_, YamlLimits{}.max_bytes);
  return parse_scene(text_, path_.string(), path_.parent_path(), overrides_);
}

bool LiveFile::has_changed() {
  const std::optional<Stamp> now = stamp();
  if (now == stamp_) return has_changed_;
  stamp_ = now;
  try {
    has_changed_ = read_text_file(path_, YamlLimits{}.max_bytes) != text_;
  } catch (const InputError&) {
    has_changed_ = true;
  }
  return has_changed_;
}

std::optional<LiveFile::Stamp> LiveFile::stamp() const {
  std::error_code error;
  const std::filesystem::file_time_type time = std::filesystem::last_write_time(path_, error);
  if (error) return std::nullopt;
  const std::uintmax_t size = std::filesystem::file_size(path_, error);
  if (error) return std::nullopt;
  return Stamp{time, size};
}

}  // namespace rigor
