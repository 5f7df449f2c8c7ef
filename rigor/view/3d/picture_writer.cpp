#include "rigor/view/3d/picture_writer.hpp"

#include "rigor/io/files/output_file.hpp"
#include "rigor/view/3d/png_file.hpp"

#include <utility>

namespace rigor {

PictureWriter::PictureWriter(std::filesystem::path path, const Scene& scene)
    : MotionKeeper(scene), path_(std::move(path)) {
  check_can_write(path_);
}

void PictureWriter::close(const Audit&) {
  if (recording().frame_count() > 0) write_png(path_, key_moment_sheet(recording(), {}));
}

Image key_moment_sheet(const Recording& recording, const CameraWishes& wishes, int width) {
  return Photographer(recording, wishes, sheet_tile(width))
      .sheet(find_key_moments(recording, sheet_pictures));
}

}  // namespace rigor
