#pragma once

#include "rigor/io/scene/scene_reader.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace rigor {

/// A scene file that may be changed by its author while it is looked at.
class LiveFile {
 public:
  /// overrides: as of --set.
  LiveFile(std::filesystem::path path, std::vector<std::string> overrides);

  /// Reads the scene as it is now. Throws InputError.
  Scene read();
  /// Whether the file has other contents than those read last (or cannot be read any more); looks at them
  /// only when its time or size is new.
  bool has_changed();
  std::string name() const { return path_.filename().string(); }

 private:
  struct Stamp {
    std::filesystem::file_time_type time;
    std::uintmax_t size;
    bool operator==(const Stamp&) const = default;
  };
  std::optional<Stamp> stamp() const;

  std::filesystem::path path_;
  std::vector<std::string> overrides_;
  std::optional<Stamp> stamp_;  ///< When last looked at.
  std::string text_;
  bool has_changed_ = false;
};

}  // namespace rigor
