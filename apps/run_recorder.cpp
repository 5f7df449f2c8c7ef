#include "apps/run_recorder.hpp"

#include "apps/terminal.hpp"
#include "rigor/core/interrupt.hpp"
#include "rigor/io/files/file_error.hpp"
#include "rigor/io/files/text_file.hpp"
#include "rigor/io/trajectory/audit_json.hpp"
#include "rigor/io/trajectory/fingerprint.hpp"
#include "rigor/sim/handover/auto_stepper.hpp"
#include "rigor/sim/method/scheme_choice.hpp"
#include "rigor/view/3d/picture_writer.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>

namespace rigor {

namespace {

constexpr std::uintmax_t most_scene_bytes = std::uintmax_t{32} << 20;

/// The scene's file as a trajectory may name it: where it lies is the user's own affair.
std::filesystem::path scene_file(const RunOptions& options) {
  const std::filesystem::path path = std::filesystem::absolute(options.scene);
  return options.keeps_path ? path : path.filename();
}

TrajectoryHeader make_header(const RunOptions& options, const Scene& scene) {
  TrajectoryHeader header = trajectory_header(scene);
  header.scene_text = read_text_file(options.scene, most_scene_bytes);
  header.scene_file = scene_file(options).string();
  header.overrides = options.overrides;
  return header;
}

/// Whether the scene names a scheme that `auto` would leave if its events crowd or its steps take too long.
bool names_what_auto_leaves(const Scene& scene) {
  const Scheme named = scene.method.scheme;
  if (named != Scheme::event_driven && named != Scheme::hybrid && named != Scheme::time_stepping)
    return false;
  Method by_auto = scene.method;
  by_auto.scheme = Scheme::automatic;
  const ResolvedMethod choice = resolve_scheme(*scene.model, by_auto);
  return named == Scheme::time_stepping ? choice.soft_steps.has_value() : choice.steps.has_value();
}

}  // namespace

RunRecorder::RunRecorder(const RunOptions& options, const Scene& scene, double start_time,
                         double earlier_time)
    : options_(options),
      scene_(scene),
      earlier_time_(earlier_time),
      begin_(std::chrono::steady_clock::now()),
      progress_line_(!options.is_quiet),
      progress_{.time = start_time, .start = start_time, .end = scene.run.duration} {
  could_hand_over_ = names_what_auto_leaves(scene);
  if (!options.checkpoint.empty()) check_can_write(options.checkpoint);
  if (!options.json.empty() && options.json != "-") json_ = std::make_unique<OutputFile>(options.json);
  if (!options.outputs.empty()) {
    const TrajectoryHeader header = make_header(options, scene);
    for (const std::string& output : options.outputs) {
      if (std::filesystem::path(output).extension() == page_suffixes[0]) {
        pages_.emplace_back(output, PageWriter(output, scene));
      } else if (is_picture(output)) {
        pictures_.emplace_back(output, make_picture_writer(output, scene));
      } else {
        writers_.push_back(make_trajectory_writer(output, header));
      }
    }
  }
  if (options.checkpoint_every)
    checkpoint_count_ = static_cast<long>(std::floor(start_time / *options.checkpoint_every));
}

double RunRecorder::elapsed() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
}

Audit RunRecorder::whole(Audit audit) const {
  audit.wall_time = earlier_time_ + elapsed();
  return audit;
}

bool RunRecorder::observe(const State& state, const AdvanceReport& since, const Auditor& auditor) {
  try {
    record(state, since, auditor);
  } catch (const FileError& error) {
    file_error_ = error.what();
    return false;
  }
  show_progress(state, since, auditor);
  return !interrupt_.is_requested();
}

void RunRecorder::record(const State& state, const AdvanceReport& since, const Auditor& auditor) {
  if (!writers_.empty() || !pictures_.empty()) {
    TrajectorySample sample = make_sample(*scene_.model, state, auditor.energy());
    sample.penetration = since.max_penetration;
    for (const auto& [name, picture] : pictures_) picture->write(sample, since.events);
    if (!writers_.empty()) add_joint_motion(*scene_.model, scene_.method, state, sample);
    for (const auto& writer : writers_) writer->write(sample, since.events);
  }
  for (auto& [name, page] : pages_) page.write(state, since, auditor.energy());
  // The cause of the stop would only stop a resumed run again.
  if (!options_.checkpoint_every || since.reason != StopReason::reached_end) return;
  if (state.t >= scene_.run.duration) return;  // finish() writes it.
  const long passed = static_cast<long>(std::floor(state.t / *options_.checkpoint_every));
  if (passed <= checkpoint_count_) return;
  checkpoint_count_ = passed;
  write_checkpoint_at(state, whole(auditor.audit(state)));
}

void RunRecorder::write_checkpoint_at(const State& state, const Audit& audit) {
  write_checkpoint(options_.checkpoint,
                   {fingerprint(*scene_.model, scene_.method, scene_.run.step), state, audit});
}

void RunRecorder::show_progress(const State& state, const AdvanceReport& since, const Auditor& auditor) {
  // The work of the events and steps since the last output, as `auto` judges it.
  const HandoverBounds bounds;
  const double duration = state.t - progress_.time;
  progress_.advice = "";
  if (could_hand_over_ && since.step_work > bounds.paid_to_steps * duration)
    progress_.advice = "exact steps take long: method.scheme=auto would be quicker";
  else if (could_hand_over_ && since.effort > bounds.paid_by_events * duration)
    progress_.advice = "events crowd: method.scheme=auto would be quicker";
  progress_.time = state.t;
  progress_.elapsed = elapsed();
  progress_.impacts += since.impacts;
  progress_.resting += since.resting;
  progress_.energy_drift = auditor.max_increase();
  course_.add(auditor.energy().total(), since.max_penetration);
  progress_line_.update(progress_);
}

/// Pictures and pages, which take as long as the run is large: a signal ends their writing.
void RunRecorder::write_views(const Audit& audit) {
  const std::function<bool()> has_to_end = [this] { return interrupt_.is_requested_since(grace_of_writing); };
  const InterruptScope scope(has_to_end);
  std::optional<FileError> first_error;
  const auto attempt = [&](const std::string& name, const auto& write) {
    try {
      poll_interrupt();
      write();
    } catch (const FileError& error) {
      if (!first_error) first_error = error;
    } catch (const Interrupted&) {
      given_up_.push_back(name);
    }
  };
  for (const auto& [name, picture] : pictures_) attempt(name, [&, &own = picture] { own->close(audit); });
  for (auto& [name, page] : pages_) attempt(name, [&, &own = page] { own.close(audit); });
  if (first_error) throw *first_error;
}

Audit RunRecorder::finish(const RunResult& result, const std::vector<std::string>& warnings) {
  progress_line_.clear();
  Audit audit = whole(result.audit);
  const bool can_go_on = result.audit.report.reason == StopReason::reached_end;
  const auto attempt = [this](const auto& write) {
    try {
      write();
    } catch (const FileError& error) {
      if (file_error_.empty()) file_error_ = error.what();
    }
  };
  if (!options_.checkpoint.empty() && can_go_on) {
    attempt([&] { write_checkpoint_at(result.resumable, whole(result.resumable_audit)); });
  }
  audit.warnings.insert(audit.warnings.begin(), warnings.begin(), warnings.end());
  for (const auto& writer : writers_) attempt([&] { writer->close(audit); });
  attempt([&] { write_views(audit); });
  if (json_) {
    attempt([&] {
      json_->append(fmt::format("{}\n", audit_json(audit)));
      json_->close();
    });
  }
  return audit;
}

}  // namespace rigor
