#pragma once

#include "io/forged_files.hpp"
#include "rigor/core/input_error.hpp"
#include "rigor/geometry/mesh/mesh_check.hpp"
#include "rigor/io/files/text_file.hpp"
#include "rigor/io/mesh/height_file.hpp"
#include "rigor/io/mesh/obj_file.hpp"
#include "rigor/io/mesh/ply_file.hpp"
#include "rigor/io/mesh/stl_file.hpp"
#include "rigor/io/scene/scene_reader.hpp"
#include "rigor/io/trajectory/checkpoint.hpp"
#include "rigor/io/trajectory/fingerprint.hpp"
#include "rigor/io/trajectory/hdf5_writer.hpp"
#include "rigor/model/state_check.hpp"
#include "rigor/sim/make_stepper.hpp"
#include "rigor/sim/simulation.hpp"
#include "rigor/study/study.hpp"
#include "rigor/view/live/live_command.hpp"
#include "rigor/view/recording/recording.hpp"

#include <array>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>

#include <unistd.h>

/// What reads bytes from outside, each as one function of the bytes: for libFuzzer (reader_fuzz.cpp) and for
/// a test with fixed random bytes. Whatever the bytes, a reader returns or throws InputError.
namespace rigor::test {

/// A folder for files that must have a name; it goes at the end of the process.
class FuzzFolder {
 public:
  FuzzFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "rigor_fuzz_XXXXXX").string();
    if (!::mkdtemp(name.data())) std::abort();
    path_ = name;
  }
  ~FuzzFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  std::filesystem::path write(const char* name, const std::string& bytes) const {
    std::ofstream(path_ / name, std::ios::binary) << bytes;
    return path_ / name;
  }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

inline const FuzzFolder& fuzz_folder() {
  static const FuzzFolder folder;
  return folder;
}

inline const char* const fuzz_scene = R"(rigor: 1
name: seed
run: {duration: 0.2, step: 0.01, output_interval: 0.05}
materials: [{name: rubber, friction: 0.3, restitution: 0.5}]
bodies:
  - {name: floor, motion: static, shapes: [{type: plane, material: rubber}]}
  - {name: a, position: [0, 0, 0.1], mass: 1, shapes: [{type: box, size: [0.2, 0.2, 0.2], material: rubber}]}
  - {name: b, position: [0.5, 0, 0.5], mass: 2, angular_velocity: [1, 2, 3], shapes: [{type: sphere, radius: 0.1}]}
  - {name: c, position: [0.8, 0, 0.5], density: 1000, shapes: [{type: capsule, radius: 0.1, length: 0.2}]}
joints:
  - {name: arm, type: hinge, bodies: [b, c], anchor: [0.65, 0, 0.5], axis: [0, 1, 0], limits: [-45 deg, 45 deg]}
forces:
  - {type: spring, between: [world, a], points: [[0, 0, 1], [0, 0, 0]], stiffness: 10, length: 0.5}
)";

struct FuzzRun {
  Scene scene;
  std::uint64_t fingerprint;
  std::string checkpoint, trajectory;  ///< Bytes of the files of its run.
};

/// A run of the scene, whose files are the beginning of forged ones.
inline const FuzzRun& fuzz_run_files() {
  static const FuzzRun run = [] {
    Scene scene = parse_scene(fuzz_scene, "scene.yaml", ".");
    TrajectoryHeader header{
        .scene = scene.name, .scene_text = fuzz_scene, .method = scene.method, .run = scene.run};
    for (const Body& body : scene.model->bodies()) header.bodies.push_back(body.name);
    header.joints = trajectory_joints(*scene.model);
    header.has_joint_forces = true;
    const std::filesystem::path path = fuzz_folder().path() / "seed.h5";
    Hdf5Writer writer(path, header);
    const Observer observer = [&](const State& state, const AdvanceReport& since, const Auditor& auditor) {
      TrajectorySample sample = make_sample(*scene.model, state, auditor.energy());
      add_joint_motion(*scene.model, scene.method, state, sample);
      writer.write(sample, since.events);
      return true;
    };
    const RunResult result = run_simulation(scene.model, scene.method, scene.run, std::nullopt, observer);
    writer.close(result.audit);
    std::ifstream file(path, std::ios::binary);
    std::string trajectory{std::istreambuf_iterator<char>(file), {}};
    const std::uint64_t own = fingerprint(*scene.model, scene.method, scene.run.step);
    std::string checkpoint = checkpoint_bytes({own, result.state, result.audit});
    return FuzzRun{std::move(scene), own, std::move(checkpoint), std::move(trajectory)};
  }();
  return run;
}

inline void read_fuzz_scene(const std::string& bytes) {
  check_text(bytes, "scene.yaml");
  parse_scene(bytes, "scene.yaml", fuzz_folder().path());
}

/// A study of the scene above, with each way to say what varies and what is asked.
inline const char* const fuzz_study = R"(rigor_study: 1
name: seed
scene: scene.yaml
kind: monte-carlo
sampling: sobol
runs: 20
half_width: 0.1
set: {run: {duration: 0.1, step: 0.01, output_interval: 0.05}, world.gravity: [0, 0, -9.81]}
parameters:
  - {name: mu, key: materials.rubber.friction, range: [0.3, 1], log: true}
  - {name: v, distribution: normal, mean: 2, deviation: 0.1}
  - {name: q, distribution: orientation}
  - {name: p, distribution: box, low: [0, 0, 1], high: [1, 1, 2]}
  - {name: s, distribution: sphere, radius: 2}
  - {name: w, formula: "v*sin(mu) + p.x"}
assign: {bodies.b.velocity: [v, "w > 1 ? s.y : 0", 0], bodies.b.orientation: [q.w, q.x, q.y, q.z]}
outcomes:
  - {name: height, value: body.b.position.z, at: 0.05}
  - {name: low, min: energy.kinetic}
  - {name: hits, count: impact, bodies: [b, floor]}
  - {name: hit, time_of: impact, bodies: b, number: 2, else: -1}
  - {name: sum, formula: "height + 2*hits"}
expect: [{finding: mean of sum, value: 1, tolerance: 1e-3}]
)";

/// As a file of its own, and what is read against its scene.
inline void read_fuzz_study(const std::string& bytes) {
  check_text(bytes, "study.yaml");
  static const std::filesystem::path scene = fuzz_folder().write("scene.yaml", fuzz_scene);
  StudyPlan plan = parse_study(bytes, fuzz_folder().path() / "study.yaml");
  if (!plan.scene.empty()) plan.scene = scene;
  const Study study(std::move(plan));
}

inline void read_fuzz_obj(const std::string& bytes) {
  check_text(bytes, "a.obj");
  find_mesh_defects(parse_obj(bytes, "a.obj"), {});
}
inline void read_fuzz_stl(const std::string& bytes) {
  find_mesh_defects(parse_stl(bytes, "a.stl"), {});
}
inline void read_fuzz_ply(const std::string& bytes) {
  find_mesh_defects(parse_ply(bytes, "a.ply"), {});
}

inline void read_fuzz_heights(const std::string& bytes) {
  check_text(bytes, "a.csv");
  for (const auto& row : parse_heights(bytes, "a.csv")) {
    for (const double height : row) {
      if (!std::isfinite(height)) throw std::logic_error("a height is not finite");
    }
  }
}

/// As it is, and with its checksums made right. What is read continues for some steps.
inline void read_fuzz_checkpoint(const std::string& given) {
  const FuzzRun& run = fuzz_run_files();
  for (const bool is_signed : {false, true}) {
    std::string bytes = given;
    if (is_signed && bytes.size() >= 24) {
      bytes.replace(0, 8, run.checkpoint, 0, 8);
      put_word(run.fingerprint, 8, bytes);
      sign_checkpoint(bytes);
    }
    std::optional<Checkpoint> read;
    try {
      read = read_checkpoint(fuzz_folder().write("a.cp", bytes), run.fingerprint, *run.scene.model);
    } catch (const InputError&) {
      continue;
    }
    if (!state_error(*run.scene.model, read->state).empty()) throw std::logic_error("a state that cannot be");
    if (read->state.t > 1e8) continue;
    const std::unique_ptr<Stepper> stepper =
        make_stepper(run.scene.model, run.scene.method, run.scene.run.step);
    long asked = 0;
    stepper->set_interrupt([&asked] { return ++asked > 2000; });
    stepper->advance(read->state, read->state.t + 0.02);
    for (const double x : read->state.x) {
      if (!std::isfinite(x)) throw std::logic_error("a position is not finite");
    }
  }
}

inline void read_fuzz_trajectory(const std::string& bytes) {
  read_recording(fuzz_folder().write("a.h5", bytes));
}

inline void read_fuzz_message(const std::string& bytes) {
  parse_live_command(bytes);
}

struct ReaderTarget {
  const char* name;
  void (*read)(const std::string& bytes);
  std::string seed;  ///< A file that is read.
};

inline const std::array<ReaderTarget, 9>& reader_targets() {
  static const std::array<ReaderTarget, 9> targets = {{
      {"scene", read_fuzz_scene, fuzz_scene},
      {"study", read_fuzz_study, fuzz_study},
      {"obj", read_fuzz_obj,
       "# seed\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf -3//1 3/1 4/1/1\nf 1 4 3\n"},
      {"stl", read_fuzz_stl,
       "solid seed\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1e0 0\nendloop\n"
       "endfacet\nendsolid seed\n"},
      {"ply", read_fuzz_ply,
       "ply\nformat ascii 1.0\ncomment seed\nelement vertex 3\nproperty float x\nproperty double y\nproperty "
       "float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 "
       "0\n3 0 1 2\n"},
      {"heights", read_fuzz_heights, "0, 1, 2.5\n-1, 1e-3, +4\n\n7, 8, 9\n"},
      {"checkpoint", read_fuzz_checkpoint, fuzz_run_files().checkpoint},
      {"trajectory", read_fuzz_trajectory, fuzz_run_files().trajectory},
      {"message", read_fuzz_message,
       R"({"do": "push", "body": 1, "point": [0, 0.5, 0], "impulse": [1, 2, -3e0]})"},
  }};
  return targets;
}

/// What is wrong with what the reader does with the bytes; empty if nothing is.
inline std::string fault_of_reader(const ReaderTarget& target, const std::string& bytes) {
  try {
    target.read(bytes);
  } catch (const InputError&) {
  } catch (const std::exception& error) {
    return std::string(target.name) + ": " + error.what();
  }
  return {};
}

}  // namespace rigor::test
