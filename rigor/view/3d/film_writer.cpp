#include "rigor/view/3d/film_writer.hpp"

#include "rigor/core/interrupt.hpp"
#include "rigor/core/quoted.hpp"
#include "rigor/io/files/file_error.hpp"
#include "rigor/io/files/output_file.hpp"
#include "rigor/view/3d/movie_file.hpp"
#include "rigor/view/3d/picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace rigor {

FilmWriter::FilmWriter(std::filesystem::path path, const Scene& scene)
    : MotionRecorder(scene), path_(std::move(path)) {
  check_can_film(path_);
  check_can_write(path_);
}

void FilmWriter::close(const Audit&) {
  const Recording& motion = recording();
  if (motion.frame_count() == 0) return;
  const PictureSize size;
  PictureRenderer renderer(motion, {}, size);
  MovieFile film(path_, size.width, size.height);
  const std::vector<std::size_t> frames = even_frames(motion, film_frames(motion));
  try {
    const std::vector<Camera> cameras = renderer.cameras_of_film(frames);
    for (std::size_t i = 0; i < frames.size(); ++i) film.add(renderer.picture(frames[i], cameras[i]));
  } catch (const Interrupted&) {
    film.give_up();
    throw;
  }
  film.close();
}

void check_can_film(const std::filesystem::path& path) {
  if (has_program("ffmpeg")) return;
  throw FileError(
      fmt::format("cannot write {}: films are encoded by the program ffmpeg, which is not installed "
                  "(Debian: apt-get install ffmpeg). Without it: a page that plays in a browser "
                  "(rigor run SCENE -o run.html), or single pictures (rigor render SCENE --frames 100)",
                  quoted_text(path.string())));
}

std::vector<std::size_t> even_frames(const Recording& recording, int count) {
  const double begin = recording.motion.time.front(), end = recording.motion.time.back();
  std::vector<std::size_t> frames;
  for (int i = 0; i < count; ++i) {
    const double share = count > 1 ? static_cast<double>(i) / (count - 1) : 1;
    frames.push_back(nearest_frame(recording, begin + share * (end - begin)));
  }
  return frames;
}

int film_frames(const Recording& recording) {
  constexpr double shortest = 4, longest = 30;  // [s]
  const double span = recording.motion.time.back() - recording.motion.time.front();
  return static_cast<int>(std::lround(MovieFile::frames_per_second * std::clamp(span, shortest, longest)));
}

}  // namespace rigor
