#include "rigor/io/trajectory/hdf5_reader.hpp"

#include "rigor/core/index.hpp"
#include "rigor/core/input_error.hpp"
#include "rigor/core/quoted.hpp"
#include "rigor/io/trajectory/hdf5_handle.hpp"
#include "rigor/io/trajectory/hdf5_truncated.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <sstream>
#include <utility>

namespace rigor {

namespace {

/// The library keeps attributes of this size at most outside their object's header.
constexpr std::size_t most_attribute_bytes = std::size_t{1} << 26;
/// More than any memory: what is beyond is a damaged number.
constexpr hsize_t most_dataset_bytes = hsize_t{1} << 40;

/// Reads the parts of one file; a part that is missing or of another form is an InputError.
class Reader {
 public:
  Reader(const std::filesystem::path& path, Hdf5Quiet& quiet)
      : name_(quoted_text(path.string())),
        file_(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose) {
    if (file_.is_open()) return;
    quiet.stay();
    TruncatedFile cut_off = open_truncated_file(path);
    if (cut_off.whole > cut_off.present)
      lost_ = fmt::format("it is cut off, {} of {} bytes are left", cut_off.present, cut_off.whole);
    present_ = cut_off.present;
    file_ = std::move(cut_off.file);
    if (file_.is_open()) return;
    throw InputError(fmt::format(
        "cannot read {}: {}", name_,
        is_truncated() ? lost_ + ", not even its first parts" : "it is not an HDF5 file that can be opened"));
  }

  const std::string& name() const { return name_; }
  bool is_truncated() const { return !lost_.empty(); }
  /// "it is cut off, 100 of 200 bytes are left".
  const std::string& lost() const { return lost_; }

  /// Number of rows that all datasets hold: that of the first one, from which the others may not differ
  /// unless the file is truncated.
  std::size_t common_rows(const std::vector<const char*>& names) const {
    std::size_t rows = row_count(names.front());
    if (!is_truncated()) return rows;
    for (const char* const name : names) rows = std::min(rows, row_count(name));
    return rows;
  }

  std::string attribute(const char* name) const {
    const Hdf5Handle attribute(H5Aopen(file_, name, H5P_DEFAULT), H5Aclose);
    check(attribute.is_open(), name);
    const Hdf5Handle type(H5Aget_type(attribute), H5Tclose);
    const Hdf5Handle space(H5Aget_space(attribute), H5Sclose);
    check(H5Sget_simple_extent_npoints(space) == 1 && H5Tget_size(type) <= most_attribute_bytes, name);
    std::string text(H5Tget_size(type), '\0');
    check(H5Tget_class(type) == H5T_STRING && !H5Tis_variable_str(type) &&
              H5Aread(attribute, type, text.data()) >= 0,
          name);
    return trimmed(text);
  }
  double number_attribute(const char* name) const {
    const Hdf5Handle attribute(H5Aopen(file_, name, H5P_DEFAULT), H5Aclose);
    check(attribute.is_open(), name);
    const Hdf5Handle space(H5Aget_space(attribute), H5Sclose);
    double value = 0;
    check(H5Sget_simple_extent_npoints(space) == 1 && H5Aread(attribute, H5T_NATIVE_DOUBLE, &value) >= 0,
          name);
    return value;
  }

  bool has_attribute(const char* name) const { return H5Aexists(file_, name) > 0; }
  /// Whether the dataset exists; if it is in a group, the group must exist.
  bool has(const char* name) const { return H5Lexists(file_, name, H5P_DEFAULT) > 0; }

  /// Number of values of a dataset that does not grow.
  std::size_t value_count(const char* name) const { return value_count(open(name)); }
  std::vector<std::string> texts(const char* name) const {
    const Hdf5Handle dataset = open(name);
    const Hdf5Handle type(H5Dget_type(dataset), H5Tclose);
    check(H5Tget_class(type) == H5T_STRING && !H5Tis_variable_str(type), name);
    const std::size_t length = H5Tget_size(type), count = value_count(dataset);
    check_stored(dataset, count, length, name);
    std::string bytes(length * count, '\0');
    check(count == 0 || H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, bytes.data()) >= 0, name);
    std::vector<std::string> texts;
    for (std::size_t i = 0; i < count; ++i) texts.push_back(trimmed(bytes.substr(i * length, length)));
    return texts;
  }

  /// A dataset of one text.
  std::string text(const char* name) const {
    std::vector<std::string> found = texts(name);
    check(found.size() == 1, name);
    return std::move(found.front());
  }

  /// The first rows of a dataset, with `width` numbers each: whatever follows belongs to incomplete rows,
  /// because the writer was killed or the file is truncated.
  std::vector<double> numbers(const char* name, std::size_t rows, std::size_t width = 1) const {
    return values<double>(name, H5T_NATIVE_DOUBLE, rows, width);
  }
  std::vector<int> integers(const char* name, std::size_t rows, std::size_t width) const {
    return values<int>(name, H5T_NATIVE_INT, rows, width);
  }
  /// The values of an enumeration as numbers.
  std::vector<int> kinds(const char* name, std::size_t rows) const {
    const Hdf5Handle dataset = open(name);
    const Hdf5Handle type(H5Dget_type(dataset), H5Tclose);
    check(H5Tget_class(type) == H5T_ENUM && H5Tget_size(type) == 1, name);
    const std::vector<signed char> kinds = values<signed char>(name, type, rows, 1);
    return {kinds.begin(), kinds.end()};
  }

 private:
  template <typename Value>
  std::vector<Value> values(const char* name, hid_t type, std::size_t rows, std::size_t width) const {
    if (rows * width == 0) return {};
    const Hdf5Handle dataset = open(name);
    const Hdf5Handle space(H5Dget_space(dataset), H5Sclose);
    // The dataset must have enough rows, each of the expected width.
    std::vector<hsize_t> shape(at(std::max(1, H5Sget_simple_extent_ndims(space))), 0);
    check(H5Sget_simple_extent_dims(space, shape.data(), nullptr) >= 1 && shape[0] >= rows, name);
    hsize_t row_size = 1;
    for (std::size_t i = 1; i < shape.size(); ++i) row_size *= shape[i];
    check(row_size == width, name);
    const Hdf5Handle file_type(H5Dget_type(dataset), H5Tclose);
    check_stored(dataset, rows * width, H5Tget_size(file_type), name);
    // Select the first rows and read them.
    shape[0] = rows;
    const std::vector<hsize_t> start(shape.size(), 0);
    H5Sselect_hyperslab(space, H5S_SELECT_SET, start.data(), nullptr, shape.data(), nullptr);
    const Hdf5Handle memory(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr),
                            H5Sclose);
    std::vector<Value> values(rows * width);
    check(H5Dread(dataset, type, memory, space, H5P_DEFAULT, values.data()) >= 0, name);
    return values;
  }

  std::size_t row_count(const char* name) const {
    const Hdf5Handle dataset = open(name);
    if (is_truncated()) return intact_rows(dataset, present_);
    const Hdf5Handle space(H5Dget_space(dataset), H5Sclose);
    check(H5Sget_simple_extent_ndims(space) >= 1, name);
    std::vector<hsize_t> shape(at(H5Sget_simple_extent_ndims(space)));
    check(H5Sget_simple_extent_dims(space, shape.data(), nullptr) >= 1, name);
    return shape[0];
  }

  Hdf5Handle open(const char* name) const {
    Hdf5Handle dataset(H5Dopen2(file_, name, H5P_DEFAULT), H5Dclose);
    check(dataset.is_open(), name);
    return dataset;
  }

  /// A dataset may claim more values than its file holds; memory is allocated for what is there only. What a
  /// cut-off file has lost was counted before.
  void check_stored(const Hdf5Handle& dataset, std::size_t count, std::size_t bytes, const char* name) const {
    const hsize_t stored = H5Dget_storage_size(dataset);
    check(bytes > 0 && count <= stored / bytes && stored <= most_dataset_bytes, name);
  }

  static std::size_t value_count(const Hdf5Handle& dataset) {
    const Hdf5Handle space(H5Dget_space(dataset), H5Sclose);
    return at(std::max<hssize_t>(0, H5Sget_simple_extent_npoints(space)));
  }

  static std::string trimmed(std::string text) { return text.erase(std::min(text.find('\0'), text.size())); }

  void check(bool is_good, const char* part) const {
    if (is_good) return;
    throw InputError(
        is_truncated()
            ? fmt::format("cannot read {}: {}, and '{}' is not whole", name_, lost_, part)
            : fmt::format("cannot read {}: '{}' is missing or not as Rigor writes it", name_, part));
  }

  std::string name_, lost_;
  std::uint64_t present_ = 0;  ///< Present bytes of a truncated file.
  Hdf5Handle file_;
};

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// Datasets with one row per output time, the times first, for a file with this many bodies.
std::vector<const char*> motion_parts(const Reader& reader, std::size_t body_count) {
  std::vector<const char*> parts = {"time", "energy"};
  if (body_count > 0) parts.insert(parts.end(), {"position", "orientation", "velocity", "angular_velocity"});
  if (!reader.has("joints")) return parts;
  for (const char* const part :
       {"joints/coordinate", "joints/rate", "joints/force", "joints/torque", "joints/effort"}) {
    if (reader.has(part)) parts.push_back(part);
  }
  return parts;
}

void read_joints(const Reader& reader, std::size_t rows, StoredTrajectory& stored) {
  stored.joints = reader.texts("joints/names");
  const std::size_t joints = stored.joints.size();
  if (reader.has("joints/coordinate")) {
    const std::size_t coordinates = reader.value_count("joints/coordinate_joint");
    stored.coordinate_joint = reader.integers("joints/coordinate_joint", coordinates, 1);
    stored.joint_coordinate = reader.numbers("joints/coordinate", rows, coordinates);
    stored.joint_rate = reader.numbers("joints/rate", rows, coordinates);
    if (reader.has("joints/effort")) stored.joint_effort = reader.numbers("joints/effort", rows, coordinates);
  }
  if (reader.has("joints/force")) {
    stored.joint_force = reader.numbers("joints/force", rows, 3 * joints);
    stored.joint_torque = reader.numbers("joints/torque", rows, 3 * joints);
  }
}

}  // namespace

StoredTrajectory read_hdf5_trajectory(const std::filesystem::path& path) {
  Hdf5Quiet quiet;
  const Reader reader(path, quiet);
  StoredTrajectory stored;
  // Header: the program, the scene and the names of the bodies.
  stored.rigor = reader.attribute("rigor");
  stored.scene = reader.attribute("scene");
  stored.scene_text = reader.text("scene_text");
  if (reader.has_attribute("scene_file")) stored.scene_file = reader.attribute("scene_file");
  stored.overrides = lines_of(reader.attribute("overrides"));
  stored.bodies = reader.texts("bodies/names");
  const std::size_t n = stored.bodies.size();
  // Motion: only the rows that every dataset holds.
  const std::size_t rows = reader.common_rows(motion_parts(reader, n));
  stored.time = reader.numbers("time", rows);
  stored.position = reader.numbers("position", rows, 3 * n);
  stored.orientation = reader.numbers("orientation", rows, 4 * n);
  stored.velocity = reader.numbers("velocity", rows, 3 * n);
  stored.angular_velocity = reader.numbers("angular_velocity", rows, 3 * n);
  stored.energy = reader.numbers("energy", rows, 3);
  if (reader.has("joints")) read_joints(reader, rows, stored);
  if (reader.has("penetration")) {
    stored.penetration = reader.numbers("penetration", std::min(rows, reader.common_rows({"penetration"})));
    stored.penetration.resize(rows, std::nan(""));
  }

  // Events have rows of their own.
  const std::size_t events =
      reader.common_rows({"events/time", "events/kind", "events/bodies", "events/point", "events/impulse"});
  stored.event_time = reader.numbers("events/time", events);
  stored.event_kind = reader.kinds("events/kind", events);
  stored.event_bodies = reader.integers("events/bodies", events, 2);
  stored.event_point = reader.numbers("events/point", events, 3);
  stored.event_impulse = reader.numbers("events/impulse", events, 3);
  if (reader.has_attribute("duration") && !stored.time.empty()) {
    const double duration = reader.number_attribute("duration"), end = stored.time.back();
    constexpr double rounding = 1e-9;
    if (end < duration * (1 - rounding))
      stored.ended_early =
          fmt::format("{}: the run ended at t = {:g} s of {:g} s", reader.name(), end, duration);
  }
  // A truncated file must have at least one output time, and its message says how many.
  if (!reader.is_truncated()) return stored;
  if (rows == 0)
    throw InputError(
        fmt::format("cannot read {}: {}, and no output time is whole", reader.name(), reader.lost()));
  stored.cut_off = fmt::format("{}: {}, with the first {} output times, to t = {:g} s", reader.name(),
                               reader.lost(), rows, stored.time.back());
  return stored;
}

}  // namespace rigor
