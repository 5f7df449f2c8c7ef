#include "rigor/view/3d/picture_writer.hpp"

#include "rigor/io/files/output_file.hpp"
#include "rigor/view/3d/film_writer.hpp"
#include "rigor/view/3d/png_file.hpp"

#include <algorithm>
#include <utility>

namespace rigor {

PictureWriter::PictureWriter(std::filesystem::path path, const Scene& scene)
    : MotionRecorder(scene), path_(std::move(path)) {
  check_can_write(path_);
}

void PictureWriter::close(const Audit&) {
  if (recording().frame_count() > 0) write_png(path_, key_moment_sheet(recording(), {}));
}

bool is_picture(const std::filesystem::path& path) {
  return std::ranges::find(picture_suffixes, path.extension().string()) != picture_suffixes.end();
}

std::unique_ptr<TrajectoryWriter> make_picture_writer(const std::filesystem::path& path, const Scene& scene) {
  if (path.extension() == ".mp4") return std::make_unique<FilmWriter>(path, scene);
  return std::make_unique<PictureWriter>(path, scene);
}

Image key_moment_sheet(const Recording& recording, const CameraOptions& options, int width) {
  return PictureRenderer(recording, options, sheet_tile(width))
      .sheet(find_key_moments(recording, sheet_pictures));
}

}  // namespace rigor
