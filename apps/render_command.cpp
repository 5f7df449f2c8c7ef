#include "apps/commands.hpp"
#include "apps/overlap_text.hpp"
#include "apps/progress.hpp"
#include "apps/stop_advice.hpp"
#include "apps/terminal.hpp"
#include "apps/usage_error.hpp"
#include "rigor/core/input_error.hpp"
#include "rigor/core/quoted.hpp"
#include "rigor/io/files/output_file.hpp"
#include "rigor/sim/simulation.hpp"
#include "rigor/view/3d/film_writer.hpp"
#include "rigor/view/3d/movie_file.hpp"
#include "rigor/view/3d/picture_writer.hpp"
#include "rigor/view/3d/png_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <utility>

namespace rigor {

namespace {

/// The numbers of a text, separated by a character; nothing if any part of it is not a number.
template <typename Number, std::size_t count>
std::optional<std::array<Number, count>> parse_numbers(const std::string& text, char separator) {
  std::array<Number, count> numbers{};
  const char *at = text.data(), *const end = at + text.size();
  for (std::size_t i = 0; i < count; ++i) {
    if (i > 0 && (at == end || *at++ != separator)) return {};
    const auto [next, error] = std::from_chars(at, end, numbers[i]);
    if (error != std::errc()) return {};
    at = next;
  }
  if (at != end) return {};
  return numbers;
}

PictureSize parse_size(const std::string& text) {
  constexpr long most_pixels = 1L << 25;
  const auto numbers = parse_numbers<int, 2>(text, 'x');
  if (!numbers) throw UsageError(fmt::format("--size {}: not a size such as 1280x720", quoted_text(text)));
  const auto [width, height] = *numbers;
  const auto is_allowed = [](int side) { return side >= least_picture_side && side <= most_picture_side; };
  if (!is_allowed(width) || !is_allowed(height) || long{width} * height > most_pixels) {
    throw UsageError(
        fmt::format("--size {}: width and height must be from {} to {} pixels, and together at most {}",
                    quoted_text(text), least_picture_side, most_picture_side, most_pixels));
  }
  return {width, height};
}

std::optional<Vec3> parse_point(const char* option, const std::string& text) {
  if (text.empty()) return {};
  const auto numbers = parse_numbers<double, 3>(text, ',');
  if (!numbers || !Vec3::Map(numbers->data()).allFinite())
    throw UsageError(fmt::format("{} {}: not a point such as 1,-2,0.5", option, quoted_text(text)));
  return Vec3::Map(numbers->data());
}

CameraOptions camera_options(const RenderOptions& options) {
  CameraOptions camera{parse_point("--eye", options.eye), parse_point("--target", options.target), {}};
  if (options.field_of_view) camera.field_of_view = *options.field_of_view * M_PI / 180;
  if (camera.eye && camera.target && *camera.eye == *camera.target)
    throw UsageError("--eye and --target are the same point; give two");
  return camera;
}

bool is_trajectory(const RenderOptions& options) {
  return std::filesystem::path(options.input).extension() == ".h5";
}

std::filesystem::path output_path(const RenderOptions& options) {
  if (!options.output.empty()) return options.output;
  if (!options.mp4.empty()) return options.mp4;
  return std::filesystem::path(options.input).filename().replace_extension(".png");
}

/// The options with `-o OUT.mp4` read as the film that it asks for.
RenderOptions with_film(RenderOptions options) {
  if (!options.mp4.empty() && !options.output.empty())
    throw UsageError("-o and --mp4 name two outputs; give one");
  if (std::filesystem::path(options.output).extension() != ".mp4") return options;
  options.mp4 = std::exchange(options.output, "");
  return options;
}

void check_suffix(const std::filesystem::path& path, const char* suffix) {
  if (path.extension() == suffix) return;
  throw UsageError(fmt::format("output {}: its name must end in {}", quoted_text(path.string()), suffix));
}

void check_options(const RenderOptions& options) {
  const int wanted = options.time.has_value() + (options.frames || !options.mp4.empty()) + options.is_sheet;
  if (wanted > 1) throw UsageError("--time, --frames (or --mp4) and --sheet do not go together; choose one");
  if (is_trajectory(options) && !options.overrides.empty())
    throw UsageError("--set needs a scene: a trajectory has been computed already");
  check_suffix(output_path(options), options.mp4.empty() ? ".png" : ".mp4");
}

/// A recording, and the reason why its simulation did not reach its end, if so.
struct Shot {
  Recording recording;
  std::string stop;
};

Shot simulate(const RenderOptions& options) {
  Scene scene = read_scene(options.input, options.overrides);
  for (const std::string& warning : scene.warnings) print_warning(warning);
  const State start = make_initial_state(*scene.model);
  const double tolerance = scene.method.contact_tolerance;
  const std::vector<Overlap> overlaps = find_overlaps(*scene.model, start, tolerance);
  if (!overlaps.empty()) throw InputError(overlap_messages(options.input, *scene.model, overlaps, tolerance));
  if (options.time && *options.time > 0 && *options.time < scene.run.duration)
    scene.run.duration = *options.time;

  MotionRecorder keeper(scene);
  ProgressLine line(true);
  Progress progress{.time = 0, .start = 0, .end = scene.run.duration};
  const RunResult result =
      run_simulation(scene.model, scene.method, scene.run, start,
                     [&](const State& state, const AdvanceReport& since, const Auditor& auditor) {
                       TrajectorySample sample = make_sample(*scene.model, state, auditor.energy());
                       sample.penetration = since.max_penetration;
                       keeper.write(sample, since.events);
                       progress.time = state.t;
                       progress.impacts += since.impacts, progress.resting += since.resting;
                       progress.energy_drift = auditor.max_increase();
                       line.update(progress);
                       return true;
                     });
  return {keeper.recording(), stop_text(result.audit, result.state.t)};
}

void write_picture(const std::filesystem::path& path, const Image& image) {
  write_png(path, image);
  fmt::print(stderr, "wrote {}: {} x {} pixels\n", path.string(), image.width, image.height);
}

void write_sequence(const std::filesystem::path& path, const std::vector<std::size_t>& frames,
                    PictureRenderer& renderer) {
  const auto numbered = [&](std::size_t number) {
    return std::filesystem::path(path).replace_filename(
        fmt::format("{}_{:04}.png", path.stem().string(), number));
  };
  const std::vector<Camera> cameras = renderer.cameras_of_film(frames);
  for (std::size_t i = 0; i < frames.size(); ++i)
    write_png(numbered(i + 1), renderer.picture(frames[i], cameras[i]));
  fmt::print(stderr, "wrote {} to {}: {} pictures\n", numbered(1).string(), numbered(frames.size()).string(),
             frames.size());
}

void write_film(const std::filesystem::path& path, const PictureSize& size,
                const std::vector<std::size_t>& frames, PictureRenderer& renderer) {
  MovieFile film(path, size.width, size.height);
  const std::vector<Camera> cameras = renderer.cameras_of_film(frames);
  for (std::size_t i = 0; i < frames.size(); ++i) film.add(renderer.picture(frames[i], cameras[i]));
  film.close();
  fmt::print(stderr, "wrote {}: {} pictures, {} per second\n", path.string(), frames.size(),
             MovieFile::frames_per_second);
}

void check_time(double time, const Recording& recording) {
  const double begin = recording.motion.time.front(), end = recording.motion.time.back();
  if (time >= begin && time <= end) return;
  throw UsageError(
      fmt::format("--time {:g} s is outside the run, which is from {:g} s to {:g} s", time, begin, end));
}

}  // namespace

ExitCode execute(const RenderOptions& given) {
  const RenderOptions options = with_film(given);
  check_options(options);
  const CameraOptions camera = camera_options(options);
  const std::filesystem::path output = output_path(options);
  const bool is_film = !options.mp4.empty(), is_single = options.time.has_value();
  const bool is_sheet = !is_film && !is_single && !options.frames;
  const PictureSize size = !options.size.empty() ? parse_size(options.size)
                           : is_sheet            ? sheet_tile(sheet_width)
                                                 : PictureSize{};
  if (is_film && (size.width % 2 != 0 || size.height % 2 != 0))
    throw UsageError("--mp4: width and height of the pictures must be even numbers");
  if (is_film) check_can_film(output);
  check_can_write(output);

  const Shot shot = is_trajectory(options) ? Shot{read_recording(options.input), ""} : simulate(options);
  const Recording& recording = shot.recording;
  for (const std::string& text : {recording.motion.cut_off, recording.motion.ended_early}) {
    if (!text.empty()) print_warning(text);
  }
  if (is_single) check_time(*options.time, recording);
  PictureRenderer renderer(recording, camera, size);
  if (is_sheet) {
    write_picture(output, renderer.sheet(find_key_moments(recording, sheet_pictures)));
  } else if (is_single) {
    write_picture(output, renderer.picture(nearest_frame(recording, *options.time)));
  } else if (is_film) {
    write_film(output, size, even_frames(recording, options.frames.value_or(film_frames(recording))),
               renderer);
  } else {
    write_sequence(output, even_frames(recording, *options.frames), renderer);
  }
  if (shot.stop.empty()) return exit_done;
  print_error(shot.stop);
  return exit_stopped;
}

}  // namespace rigor
