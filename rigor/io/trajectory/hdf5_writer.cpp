#include "rigor/io/trajectory/hdf5_writer.hpp"

#include "rigor/core/quoted.hpp"
#include "rigor/io/files/file_error.hpp"
#include "rigor/io/files/output_file.hpp"
#include "rigor/io/files/version.hpp"
#include "rigor/io/trajectory/hdf5_file_driver.hpp"
#include "rigor/io/trajectory/hdf5_handle.hpp"
#include "rigor/io/trajectory/hdf5_series.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace rigor {

namespace {

void write_attribute(hid_t owner, const char* name, std::string_view text) {
  const Hdf5Handle type = hdf5_text_type(text.size());
  const Hdf5Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  const Hdf5Handle attribute(H5Acreate2(owner, name, type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  const std::string bytes = text.empty() ? std::string(1, '\0') : std::string(text);
  H5Awrite(attribute, type, bytes.data());
}

void write_attribute(hid_t owner, const char* name, double value) {
  const Hdf5Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  const Hdf5Handle attribute(H5Acreate2(owner, name, H5T_IEEE_F64LE, space, H5P_DEFAULT, H5P_DEFAULT),
                             H5Aclose);
  H5Awrite(attribute, H5T_NATIVE_DOUBLE, &value);
}

void write_integers(hid_t parent, const char* name, const std::vector<int>& values) {
  const hsize_t count = values.size();
  const Hdf5Handle space(H5Screate_simple(1, &count, nullptr), H5Sclose);
  const Hdf5Handle dataset(
      H5Dcreate2(parent, name, H5T_STD_I32LE, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Dclose);
  H5Dwrite(dataset, H5T_NATIVE_INT, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
}

/// The kinds of events as an enumeration, so that readers see their names.
Hdf5Handle event_kind_type() {
  Hdf5Handle type(H5Tenum_create(H5T_STD_I8LE), H5Tclose);
  for (const MotionEvent::Kind kind : {MotionEvent::Kind::impact, MotionEvent::Kind::rest,
                                       MotionEvent::Kind::separation, MotionEvent::Kind::slip_to_stick}) {
    signed char value = static_cast<signed char>(kind);
    H5Tenum_insert(type, event_kind_name(kind), &value);
  }
  return type;
}

void write_header(hid_t file, const TrajectoryHeader& header) {
  write_attribute(file, "rigor", version);
  write_attribute(file, "scene", header.scene);
  write_attribute(file, "scene_file", header.scene_file);
  std::string overrides;
  for (const std::string& line : header.overrides) overrides.append(line).append("\n");
  write_attribute(file, "overrides", overrides);
  write_attribute(file, "duration", header.run.duration);
  write_attribute(file, "step", header.run.step);
  write_attribute(file, "output_interval", header.run.output_interval);
  for (const std::string& key : method_choice_keys()) {
    const std::string value = method_choice(header.method, key);
    if (!value.empty()) write_attribute(file, fmt::format("method.{}", key).c_str(), value);
  }
  for (const MethodNumber& number : method_numbers()) {
    write_attribute(file, fmt::format("method.{}", number.key).c_str(), header.method.*number.member);
  }
  write_hdf5_texts(file, "scene_text", {header.scene_text});
  const Hdf5Handle bodies(H5Gcreate2(file, "bodies", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose);
  write_hdf5_texts(bodies, "names", header.bodies);
}

/// Number of joints, and of the coordinates of all of them.
struct JointSizes {
  explicit JointSizes(const TrajectoryHeader& header)
      : joints(header.joints.size()), has_forces(header.has_joint_forces), has_efforts(header.has_efforts) {
    for (const TrajectoryJoint& joint : header.joints) coordinates += joint.units.size();
  }
  hsize_t joints, coordinates = 0;
  bool has_forces, has_efforts;
};

/// Writes the names of the joints, and the joint and unit of each coordinate.
void write_joints(hid_t group, const std::vector<TrajectoryJoint>& joints) {
  std::vector<std::string> names, units;
  std::vector<int> owners;
  for (const TrajectoryJoint& joint : joints) {
    owners.insert(owners.end(), joint.units.size(), static_cast<int>(names.size()));
    units.insert(units.end(), joint.units.begin(), joint.units.end());
    names.push_back(joint.name);
  }
  write_hdf5_texts(group, "names", names);
  if (owners.empty()) return;
  write_integers(group, "coordinate_joint", owners);
  write_hdf5_texts(group, "coordinate_unit", units);
}

/// Describes a dataset that has just been created.
template <typename Value>
void describe(const Hdf5Series<Value>& series, const char* unit, const char* columns) {
  write_attribute(series.id(), "unit", unit);
  write_attribute(series.id(), "columns", columns);
}

/// Number of output times of a run that reaches its end.
hsize_t expected_rows(const RunSettings& run) {
  constexpr double most = Hdf5Series<double>::most_chunk_rows;  // Larger values make no difference.
  return static_cast<hsize_t>(std::clamp(std::ceil(run.duration / run.output_interval) + 1, 1.0, most));
}

/// Creates a file through the driver, in the newest format, as single-writer mode requires; the handle is
/// closed if HDF5 fails.
Hdf5Handle create_file(const std::filesystem::path& path, const Hdf5FileDriver& driver) {
  const Hdf5Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  H5Pset_libver_bounds(access, H5F_LIBVER_LATEST, H5F_LIBVER_LATEST);
  // A killed process can leave a write half done where it crosses a memory page: the alignment keeps what
  // HDF5 rewrites while datasets grow (headers and indices of less than 300 bytes) from crossing one.
  constexpr hsize_t smallest_header = 64, block = 512;
  H5Pset_alignment(access, smallest_header, block);
  if (!driver.set_in(access)) return {};
  return {H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access), H5Fclose};
}

}  // namespace

struct Hdf5Writer::File {
  File(const std::filesystem::path& file_path, const TrajectoryHeader& header);
  void check(bool is_good) const;
  bool write_pending();
  std::size_t pending_bytes() const;
  void append(const MotionEvent& event);
  /// False if HDF5 fails.
  bool close();

  std::filesystem::path path;
  Hdf5FileStatus status;
  Hdf5FileDriver driver;
  Hdf5Handle file, events, joints;
  hsize_t body_count;
  JointSizes joint_sizes;
  // A model without bodies has no motion to store.
  std::optional<Hdf5Series<double>> position, orientation, velocity, angular_velocity;
  // Likewise for a model without joints.
  std::optional<Hdf5Series<double>> joint_coordinate, joint_rate, joint_force, joint_torque, joint_effort;
  std::optional<Hdf5Series<double>> energy, penetration, time;
  std::optional<Hdf5Series<double>> event_time, event_point, event_impulse;
  std::optional<Hdf5Series<signed char>> event_kind;
  std::optional<Hdf5Series<int>> event_bodies;
  FlushTimer flush_timer;

 private:
  void create_series(hsize_t rows);
  void create_joint_series(hsize_t rows);
};

Hdf5Writer::File::File(const std::filesystem::path& file_path, const TrajectoryHeader& header)
    : path(file_path),
      driver(status),
      file(create_file(path, driver)),
      body_count(header.bodies.size()),
      joint_sizes(header) {
  check(file.is_open());
  write_header(file, header);
  if (joint_sizes.joints > 0) {
    joints = Hdf5Handle(H5Gcreate2(file, "joints", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose);
    write_joints(joints, header.joints);
  }
  create_series(expected_rows(header.run));
  check(H5Fstart_swmr_write(file) >= 0);
}

void Hdf5Writer::File::create_series(hsize_t rows) {
  const hid_t real = H5T_IEEE_F64LE;
  describe(time.emplace(file, "time", std::vector<hsize_t>{}, real, rows), "s", "time");
  if (body_count > 0) {
    const std::vector<hsize_t> vectors = {body_count, 3}, quaternions = {body_count, 4};
    describe(position.emplace(file, "position", vectors, real, rows), "m", "x y z");
    describe(orientation.emplace(file, "orientation", quaternions, real, rows), "1", "w x y z");
    describe(velocity.emplace(file, "velocity", vectors, real, rows), "m/s", "x y z");
    describe(angular_velocity.emplace(file, "angular_velocity", vectors, real, rows), "rad/s", "x y z");
  }
  create_joint_series(rows);
  describe(energy.emplace(file, "energy", std::vector<hsize_t>{3}, real, rows), "J",
           "kinetic potential elastic");
  describe(penetration.emplace(file, "penetration", std::vector<hsize_t>{}, real, rows), "m", "penetration");
  events = Hdf5Handle(H5Gcreate2(file, "events", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose);
  describe(event_time.emplace(events, "time", std::vector<hsize_t>{}, real), "s", "time");
  event_kind.emplace(events, "kind", std::vector<hsize_t>{}, event_kind_type());
  describe(event_bodies.emplace(events, "bodies", std::vector<hsize_t>{2}, H5T_STD_I32LE), "1", "A B");
  describe(event_point.emplace(events, "point", std::vector<hsize_t>{3}, real), "m", "x y z");
  describe(event_impulse.emplace(events, "impulse", std::vector<hsize_t>{3}, real), "N s", "x y z");
  check(event_impulse->is_open() && event_kind->is_open() && energy->is_open());
}

void Hdf5Writer::File::create_joint_series(hsize_t rows) {
  const hid_t real = H5T_IEEE_F64LE;
  if (joint_sizes.coordinates > 0) {
    const std::vector<hsize_t> numbers = {joint_sizes.coordinates};
    describe(joint_coordinate.emplace(joints, "coordinate", numbers, real, rows), "rad or m",
             "as coordinate_joint and coordinate_unit say");
    describe(joint_rate.emplace(joints, "rate", numbers, real, rows), "rad/s or m/s",
             "as coordinate_joint and coordinate_unit say");
    check(joint_rate->is_open());
    if (joint_sizes.has_efforts) {
      describe(joint_effort.emplace(joints, "effort", numbers, real, rows), "N m or N",
               "as coordinate_joint and coordinate_unit say");
      check(joint_effort->is_open());
    }
  }
  if (joint_sizes.has_forces) {
    const std::vector<hsize_t> vectors = {joint_sizes.joints, 3};
    describe(joint_force.emplace(joints, "force", vectors, real, rows), "N", "x y z");
    describe(joint_torque.emplace(joints, "torque", vectors, real, rows), "N m", "x y z");
    check(joint_torque->is_open());
  }
}

void Hdf5Writer::File::check(bool is_good) const {
  if (status.error != 0) throw write_error(path, status.error);
  if (!is_good)
    throw FileError(fmt::format("cannot write {}: the HDF5 library failed", quoted_text(path.string())));
}

/// Writes in three rounds, so that at any instant every event time in the file has the rest of its event, and
/// every output time has its motion and all earlier events.
bool Hdf5Writer::File::write_pending() {
  bool is_good = true;
  const auto write_one = [&](auto& series) { is_good = is_good && (!series || series->write_pending()); };
  const auto flush_file = [&] { is_good = is_good && H5Fflush(file, H5F_SCOPE_LOCAL) >= 0; };
  write_one(position), write_one(orientation), write_one(velocity), write_one(angular_velocity),
      write_one(energy), write_one(penetration);
  write_one(joint_coordinate), write_one(joint_rate), write_one(joint_force), write_one(joint_torque),
      write_one(joint_effort);
  write_one(event_kind), write_one(event_bodies), write_one(event_point), write_one(event_impulse);
  flush_file();
  write_one(event_time);
  flush_file();
  write_one(time);
  flush_file();
  return is_good;
}

std::size_t Hdf5Writer::File::pending_bytes() const {
  const std::size_t motion = position ? position->pending_bytes() * 13 / 3 : 0;
  const std::size_t of_joints = (joint_coordinate ? joint_coordinate->pending_bytes() * 2 : 0) +
                                (joint_force ? joint_force->pending_bytes() * 2 : 0);
  return motion + of_joints + energy->pending_bytes() + event_point->pending_bytes() * 3;
}

void Hdf5Writer::File::append(const MotionEvent& event) {
  event_time->append(event.time);
  event_kind->append(static_cast<signed char>(event.kind));
  event_bodies->append(event.body_A);
  event_bodies->append(event.body_B);
  event_point->append(event.p_W.data(), 3);
  event_impulse->append(event.j_W.data(), 3);
}

bool Hdf5Writer::File::close() {
  for (std::optional<Hdf5Series<double>>* series :
       {&position, &orientation, &velocity, &angular_velocity, &joint_coordinate, &joint_rate, &joint_force,
        &joint_torque, &joint_effort, &energy, &penetration, &time, &event_time, &event_point,
        &event_impulse}) {
    series->reset();
  }
  event_kind.reset();
  event_bodies.reset();
  return joints.reset() && events.reset() && file.reset();
}

Hdf5Writer::Hdf5Writer(const std::filesystem::path& path, const TrajectoryHeader& header) {
  const Hdf5Quiet quiet;
  file_ = std::make_unique<File>(path, header);
}

Hdf5Writer::~Hdf5Writer() {
  const Hdf5Quiet quiet;
  file_.reset();
}

void Hdf5Writer::write(const TrajectorySample& sample, std::span<const MotionEvent> events) {
  File& file = *file_;
  for (const MotionEvent& event : events) file.append(event);
  if (file.body_count > 0) {
    file.position->append(sample.position.data(), sample.position.size());
    file.orientation->append(sample.orientation.data(), sample.orientation.size());
    file.velocity->append(sample.velocity.data(), sample.velocity.size());
    file.angular_velocity->append(sample.angular_velocity.data(), sample.angular_velocity.size());
  }
  if (file.joint_coordinate) {
    file.joint_coordinate->append(sample.joint_coordinate.data(), sample.joint_coordinate.size());
    file.joint_rate->append(sample.joint_rate.data(), sample.joint_rate.size());
  }
  if (file.joint_effort) file.joint_effort->append(sample.joint_effort.data(), sample.joint_effort.size());
  if (file.joint_force) {
    file.joint_force->append(sample.joint_force.data(), sample.joint_force.size());
    file.joint_torque->append(sample.joint_torque.data(), sample.joint_torque.size());
  }
  const double energies[] = {sample.energy.kinetic, sample.energy.potential, sample.energy.elastic};
  file.energy->append(energies, 3);
  file.penetration->append(sample.penetration);
  file.time->append(sample.time);
  if (file.flush_timer.is_due() || file.pending_bytes() > kMostPendingBytes) flush();
}

void Hdf5Writer::flush() {
  const Hdf5Quiet quiet;
  file_->check(file_->write_pending());
}

void Hdf5Writer::close(const Audit&) {
  flush();
  const Hdf5Quiet quiet;
  file_->check(file_->close());
}

}  // namespace rigor
