#pragma once

#include "rigor/io/files/yaml_document.hpp"
#include "rigor/math/types.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace rigor {

/// What a study asks.
enum class StudyKind { sweep, monte_carlo, bisection, sensitivity, morris, minimise, maximise, chaos };
/// How points are chosen in the cube of the uncertain parameters.
enum class Sampling { random, latin_hypercube, sobol };

/// A quantity that varies from run to run, alone or as a function of others.
struct Parameter {
  enum class Kind {
    list,         ///< The values, one after the other: an axis of a grid.
    interval,     ///< Anywhere between low and high: searched, or drawn uniformly.
    normal,       ///< Of this mean and deviation.
    lognormal,    ///< exp of a normal number of this mean and deviation.
    orientation,  ///< A quaternion w, x, y, z, uniform on SO(3).
    box,          ///< A point x, y, z, uniform between low and high.
    sphere,       ///< A point x, y, z, uniform on a sphere.
    formula,      ///< A function of the parameters above it.
  };
  std::string name;
  std::vector<std::string> keys;  ///< Of the scene, as of --set; none: for formulas alone.
  Kind kind = Kind::list;
  std::vector<double> values;  ///< Of a list that is written out.
  std::uint64_t count = 0;   ///< Of a list without them: so many values evenly from low to high; at least 2.
  double low = 0, high = 1;  ///< Of an interval, or of such a list, low < high.
  bool is_logarithmic = false;  ///< The interval's logarithm is uniform.
  double mean = 0, deviation = 1;
  Vec3 low_corner = Vec3::Zero(), high_corner = Vec3::Ones();
  Vec3 center = Vec3::Zero();
  double radius = 1;
  std::string formula;
  std::string where;  ///< Its place in the file, for messages.

  /// Whether it is an axis of a grid.
  bool is_list() const { return kind == Kind::list; }
  /// Of a list: how many values it has, and each by its index.
  std::uint64_t value_count() const { return values.empty() ? count : values.size(); }
  double value_at(std::uint64_t index) const;
  /// Of a range: the value at a share of the way from low to high, or of its logarithm. The ends are exact.
  double value_between(double share) const;
  /// How many numbers of (0, 1) its value is a function of; an axis of a grid has one too, its index.
  int coordinates() const;
  /// Names of its numbers: "mu", or "q.w", "q.x", "q.y", "q.z".
  std::vector<std::string> columns() const;
};

/// A value of the scene, or a part of it, written with formulas of the parameters.
struct Assignment {
  std::string key;
  YamlNode::Pointer value;  ///< Scalars that are not numbers are formulas.
};

/// The event of an outcome, by its kind and the bodies that take part.
struct EventFilter {
  std::string kind;                 ///< "impact", "rest", "separation" or "slip_to_stick".
  std::vector<std::string> bodies;  ///< None, one that takes part, or both.
};

/// A number that each run gives.
struct Outcome {
  enum class Kind {
    value,     ///< A formula of quantities of the scene, at an instant.
    smallest,  ///< Its smallest value at any output.
    largest,   ///< Its largest value at any output.
    first,     ///< The time of the first output at which a condition holds [s].
    count,     ///< How many events.
    time_of,   ///< The time of the number-th event [s].
    impulse,   ///< The largest impulse along or across contacts of events [N s].
    face,      ///< Which face of a body is up.
    cpu_time,  ///< What the run cost [s]; not the same in every run of the study.
    formula,   ///< A function of parameters and of the outcomes above it.
  };
  std::string name;
  Kind kind = Kind::value;
  std::string formula;       ///< Or condition.
  std::optional<double> at;  ///< When a value is taken [s]; the end if neither this nor `when` is given.
  std::string when;          ///< A condition: at the first output at which it holds.
  EventFilter event;         ///< Of a value with a kind: just after the number-th such event.
  int number = 1;            ///< Which event, from 1.
  std::string body;          ///< Of a face.
  std::optional<double> otherwise;  ///< What stands for what did not happen; none: NaN.
  std::string where;

  /// Whether it is a value that is taken at an event, or at the end.
  bool is_at_event() const { return kind == Kind::value && !event.kind.empty(); }
  bool is_at_end() const { return kind == Kind::value && !at && when.empty() && event.kind.empty(); }
};

/// A number that a study must find, known independently.
struct ExpectedFinding {
  std::string finding;
  double value = 0;
  std::optional<double> tolerance;  ///< None: the interval of the finding holds the value.
};

/// All that a study file says.
struct StudyPlan {
  std::string name;
  std::filesystem::path file;
  std::string text;                  ///< Of the file.
  std::filesystem::path scene;       ///< Empty: outcomes are formulas of the parameters alone.
  std::vector<Assignment> settings;  ///< The same in all runs, as written.
  StudyKind kind = StudyKind::sweep;
  Sampling sampling = Sampling::random;
  std::uint64_t seed = 1;
  bool varies_seed = false;   ///< Each run has a `run.seed` of its own.
  std::uint64_t runs = 1000;  ///< Of a Monte Carlo study the most; of others a number of points.
  std::uint64_t repeats = 1;  ///< Runs a point.
  double confidence = 0.95;   ///< Of all intervals.
  std::vector<Parameter> parameters;
  std::vector<Assignment> assignments;
  std::vector<Outcome> outcomes;
  std::string outcome;               ///< The one that the study is about; by default the last.
  std::optional<double> half_width;  ///< Monte Carlo: ends when the interval of `outcome` is that narrow.
  std::string search;                ///< Bisection: the parameter.
  std::string condition;             ///< Bisection: what holds on one side of the threshold.
  double tolerance = 1e-3;           ///< Bisection: width of the last bracket; optimum: of the parameters.
  int starts = 1;                    ///< Optimum: searches from so many points.
  int levels = 4;                    ///< Morris: of the grid.
  double perturbation = 1e-9;        ///< Chaos: added to the parameter `perturbed`.
  std::string perturbed;
  double bound = 0.01;              ///< Chaos: largest distance of motions that agree [m].
  std::optional<double> cpu_limit;  ///< Of a run [s].
  std::vector<ExpectedFinding> expected;

  /// How many coordinates a run has, over all parameters.
  int coordinate_count() const;
  /// Names of the numbers of all parameters, in order.
  std::vector<std::string> columns() const;
  std::optional<std::size_t> find_outcome(const std::string& wanted) const;
  /// Index of `outcome`.
  std::size_t main_outcome() const;
};

/// "monte-carlo" and so on, as written in study files.
const std::vector<std::string>& study_kind_names();
const std::vector<std::string>& sampling_names();

}  // namespace rigor
