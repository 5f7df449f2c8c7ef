#include "rigor/io/hdf5_reader.hpp"

#include "rigor/core/input_error.hpp"
#include "rigor/core/quoted.hpp"
#include "rigor/io/hdf5_handle.hpp"

#include <algorithm>
#include <sstream>

namespace rigor {

namespace {

/// Reads the parts of one file; what is missing or of another form is an InputError.
class Reader {
 public:
  explicit Reader(const std::filesystem::path& path)
      : name_(quoted_text(path.string())),
        file_(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose) {
    if (!file_.is_open())
      throw InputError("cannot read " + name_ + ": it is not an HDF5 file that can be opened");
  }

  std::string attribute(const char* name) const {
    const Hdf5Handle attribute(H5Aopen(file_, name, H5P_DEFAULT), H5Aclose);
    check(attribute.is_open(), name);
    const Hdf5Handle type(H5Aget_type(attribute), H5Tclose);
    std::string text(H5Tget_size(type), '\0');
    check(H5Tget_class(type) == H5T_STRING && !H5Tis_variable_str(type) &&
              H5Aread(attribute, type, text.data()) >= 0,
          name);
    return trimmed(text);
  }

  std::vector<std::string> texts(const char* name) const {
    const Hdf5Handle dataset = open(name);
    const Hdf5Handle type(H5Dget_type(dataset), H5Tclose);
    check(H5Tget_class(type) == H5T_STRING && !H5Tis_variable_str(type), name);
    const std::size_t length = H5Tget_size(type), count = value_count(dataset);
    std::string bytes(length * count, '\0');
    check(count == 0 || H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, bytes.data()) >= 0, name);
    std::vector<std::string> texts;
    for (std::size_t i = 0; i < count; ++i) texts.push_back(trimmed(bytes.substr(i * length, length)));
    return texts;
  }

  /// All numbers of a dataset.
  std::vector<double> numbers(const char* name) const { return values<double>(name, H5T_NATIVE_DOUBLE); }
  /// The first numbers of a dataset: what comes behind belongs to rows that are not complete, because the
  /// writer was killed.
  std::vector<double> numbers(const char* name, std::size_t count) const {
    return first(count, count > 0 ? numbers(name) : std::vector<double>{}, name);
  }
  std::vector<int> integers(const char* name, std::size_t count) const {
    return first(count, values<int>(name, H5T_NATIVE_INT), name);
  }
  /// An enumeration's values as numbers.
  std::vector<int> kinds(const char* name, std::size_t count) const {
    const Hdf5Handle dataset = open(name);
    const Hdf5Handle type(H5Dget_type(dataset), H5Tclose);
    check(H5Tget_class(type) == H5T_ENUM && H5Tget_size(type) == 1, name);
    std::vector<signed char> values(value_count(dataset));
    check(H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) >= 0, name);
    return first(count, std::vector<int>(values.begin(), values.end()), name);
  }

 private:
  template <typename Value>
  std::vector<Value> values(const char* name, hid_t type) const {
    const Hdf5Handle dataset = open(name);
    std::vector<Value> values(value_count(dataset));
    check(H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) >= 0, name);
    return values;
  }

  template <typename Value>
  std::vector<Value> first(std::size_t count, std::vector<Value> values, const char* name) const {
    check(values.size() >= count, name);
    values.resize(count);
    return values;
  }

  Hdf5Handle open(const char* name) const {
    Hdf5Handle dataset(H5Dopen2(file_, name, H5P_DEFAULT), H5Dclose);
    check(dataset.is_open(), name);
    return dataset;
  }

  static std::size_t value_count(const Hdf5Handle& dataset) {
    const Hdf5Handle space(H5Dget_space(dataset), H5Sclose);
    return static_cast<std::size_t>(std::max<hssize_t>(0, H5Sget_simple_extent_npoints(space)));
  }

  static std::string trimmed(std::string text) { return text.erase(std::min(text.find('\0'), text.size())); }

  void check(bool is_good, const char* part) const {
    if (!is_good)
      throw InputError("cannot read " + name_ + ": '" + part + "' is missing or not as Rigor writes it");
  }

  std::string name_;
  Hdf5Handle file_;
};

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

}  // namespace

StoredTrajectory read_hdf5_trajectory(const std::filesystem::path& path) {
  const Hdf5Quiet quiet;
  const Reader reader(path);
  StoredTrajectory stored;
  stored.rigor = reader.attribute("rigor");
  stored.scene = reader.attribute("scene");
  stored.scene_text = reader.texts("scene_text").at(0);
  stored.overrides = lines_of(reader.attribute("overrides"));
  stored.bodies = reader.texts("bodies/names");
  const std::size_t n = stored.bodies.size();
  stored.time = reader.numbers("time");
  const std::size_t rows = stored.time.size();
  stored.position = reader.numbers("position", 3 * n * rows);
  stored.orientation = reader.numbers("orientation", 4 * n * rows);
  stored.velocity = reader.numbers("velocity", 3 * n * rows);
  stored.angular_velocity = reader.numbers("angular_velocity", 3 * n * rows);
  stored.energy = reader.numbers("energy", 3 * rows);

  stored.event_time = reader.numbers("events/time");
  const std::size_t events = stored.event_time.size();
  stored.event_kind = reader.kinds("events/kind", events);
  stored.event_bodies = reader.integers("events/bodies", 2 * events);
  stored.event_point = reader.numbers("events/point", 3 * events);
  stored.event_impulse = reader.numbers("events/impulse", 3 * events);
  return stored;
}

}  // namespace rigor
