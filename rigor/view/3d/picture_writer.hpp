#pragma once

#include "rigor/view/3d/picture.hpp"
#include "rigor/view/recording/recording.hpp"

#include <array>
#include <memory>
#include <string_view>

namespace rigor {

/// Output of a run as a picture: a sheet of its key moments, written when the run ends.
class PictureWriter : public MotionRecorder {
 public:
  /// Throws FileError if the file cannot be written.
  PictureWriter(std::filesystem::path path, const Scene& scene);
  void close(const Audit& audit) override;

 private:
  std::filesystem::path path_;
};

/// Suffixes of the outputs of a run that this layer writes.
inline constexpr std::array<std::string_view, 2> picture_suffixes = {".png", ".mp4"};
/// Whether this layer writes the output, by its suffix.
bool is_picture(const std::filesystem::path& path);
/// The writer of such an output: a sheet of the key moments, or a film. Throws FileError.
std::unique_ptr<TrajectoryWriter> make_picture_writer(const std::filesystem::path& path, const Scene& scene);

/// Number of pictures on a sheet of key moments, and width of the sheet [px].
inline constexpr std::size_t sheet_pictures = 6;
inline constexpr int sheet_width = 1440;

/// The sheet of a recording's key moments.
Image key_moment_sheet(const Recording& recording, const CameraOptions& options, int width = sheet_width);

}  // namespace rigor
