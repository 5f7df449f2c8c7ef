#pragma once

#include "rigor/io/scene/scene_reader.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace rigor {

/// A scene file that its author may change while it is being viewed.
class LiveFile {
 public:
  /// overrides: as given with --set.
  LiveFile(std::filesystem::path path, std::vector<std::string> overrides);

  /// Reads the scene as it is now. Throws InputError.
  Scene read();
  /// Whether the contents of the file differ from those last read (or cannot be read any more); it reads them
  /// only when the time stamp or the size of the file is new.
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
  std::optional<Stamp> stamp_;  ///< At the last look.
  std::string text_;
  bool has_changed_ = false;
};

}  // namespace rigor
