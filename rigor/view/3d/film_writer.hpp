#pragma once

#include "rigor/view/recording/recording.hpp"

#include <cstddef>
#include <filesystem>
#include <vector>

namespace rigor {

/// Output of a run as a film of 1280 by 720 pixels, encoded by ffmpeg when the run ends.
class FilmWriter : public MotionRecorder {
 public:
  /// Throws FileError if ffmpeg is not there or the file cannot be written: before the run, not after it.
  FilmWriter(std::filesystem::path path, const Scene& scene);
  void close(const Audit& audit) override;

 private:
  std::filesystem::path path_;
};

/// Throws FileError, with what to do instead, if the program ffmpeg is not on the PATH.
void check_can_film(const std::filesystem::path& path);

/// `count` output times from the first to the last, evenly spaced.
std::vector<std::size_t> even_frames(const Recording& recording, int count);
/// Number of pictures of a film: in real time, except for runs too short to see or too long to watch.
int film_frames(const Recording& recording);

}  // namespace rigor
