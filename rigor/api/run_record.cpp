#include "rigor/api/run_record.hpp"

#include "rigor/api/engine.hpp"
#include "rigor/core/input_error.hpp"
#include "rigor/io/files/file_error.hpp"
#include "rigor/io/trajectory/trajectory_writer.hpp"
#include "rigor/sim/simulation.hpp"
#include "rigor/view/3d/picture_writer.hpp"
#include "rigor/view/page/page_writer.hpp"

#include <array>
#include <chrono>
#include <exception>
#include <memory>
#include <string_view>

namespace rigor {

namespace {

void append(const std::vector<double>& from, std::vector<double>& to) {
  to.insert(to.end(), from.begin(), from.end());
}

/// The files of a run.
class RunFiles {
 public:
  RunFiles(const Scene& scene, const RecordOptions& options) {
    TrajectoryHeader header = trajectory_header(scene);
    header.scene_text = options.scene_text;
    header.scene_file = options.scene_file;
    header.overrides = options.overrides;
    // All suffixes are looked at before a file is made.
    constexpr std::array<std::string_view, 3> elsewhere{page_suffixes[0], picture_suffixes[0],
                                                        picture_suffixes[1]};
    for (const std::filesystem::path& path : options.files) {
      const std::string error = check_output_suffix(path, elsewhere);
      if (!error.empty()) throw InputError(error);
    }
    for (const std::filesystem::path& path : options.files) {
      if (path.extension() == page_suffixes[0]) {
        pages_.push_back(std::make_unique<PageWriter>(path, scene));
      } else if (is_picture(path)) {
        writers_.push_back(make_picture_writer(path, scene));
      } else {
        writers_.push_back(make_trajectory_writer(path, header));
      }
    }
  }

  void write(const TrajectorySample& sample, const State& state, const AdvanceReport& since,
             const Energy& energy) {
    for (const auto& writer : writers_) writer->write(sample, since.events);
    for (const auto& page : pages_) page->write(state, since, energy);
  }
  void close(const Audit& audit) {
    for (const auto& writer : writers_) writer->close(audit);
    for (const auto& page : pages_) page->close(audit);
  }
  bool has_trajectory() const { return !writers_.empty(); }

 private:
  std::vector<std::unique_ptr<TrajectoryWriter>> writers_;
  std::vector<std::unique_ptr<PageWriter>> pages_;
};

/// The rates and coordinates of all joints, without their forces.
void add_joint_coordinates(const Model& model, const State& state, RunRecord& record) {
  for (const JointReaction& joint : joint_motions(model, state)) {
    append(joint.coordinates, record.joint_coordinate);
    append(joint.rates, record.joint_rate);
  }
}

}  // namespace

RunRecord record_run(const Scene& scene, const RecordOptions& options) {
  // The engine checks the scene and finds its start.
  const State start = SimulationEngine(scene, options.separate).state();
  const auto began = std::chrono::steady_clock::now();
  RunRecord record;
  RunFiles files(scene, options);
  std::exception_ptr file_error;
  const Observer observer = [&](const State& state, const AdvanceReport& since, const Auditor& auditor) {
    TrajectorySample sample = make_sample(*scene.model, state, auditor.energy());
    sample.penetration = since.max_penetration;
    record.time.push_back(sample.time);
    append(sample.position, record.position);
    append(sample.orientation, record.orientation);
    append(sample.velocity, record.velocity);
    append(sample.angular_velocity, record.angular_velocity);
    record.kinetic.push_back(sample.energy.kinetic);
    record.potential.push_back(sample.energy.potential);
    record.elastic.push_back(sample.energy.elastic);
    record.penetration.push_back(sample.penetration);
    add_joint_coordinates(*scene.model, state, record);
    record.events.insert(record.events.end(), since.events.begin(), since.events.end());
    try {
      if (files.has_trajectory()) add_joint_motion(*scene.model, scene.method, state, sample);
      files.write(sample, state, since, auditor.energy());
    } catch (const FileError&) {
      file_error = std::current_exception();
      return false;
    }
    if (options.progress) options.progress(state.t);
    return true;
  };
  const RunResult result =
      run_simulation(scene.model, scene.method, scene.run, start, observer, options.interrupt);
  if (file_error) std::rethrow_exception(file_error);
  record.audit = result.audit;
  record.audit.wall_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  record.was_interrupted = result.was_stopped;
  files.close(record.audit);
  return record;
}

}  // namespace rigor
