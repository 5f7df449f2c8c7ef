#include "rigor/io/trajectory/checkpoint.hpp"

#include "rigor/core/index.hpp"
#include "rigor/core/input_error.hpp"
#include "rigor/core/quoted.hpp"
#include "rigor/io/files/output_file.hpp"
#include "rigor/model/state_check.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <fstream>
#include <iterator>
#include <string_view>
#include <type_traits>

namespace rigor {

namespace {

// Layout, all numbers little-endian of 8 bytes: magic, fingerprint, the audit's numbers in the order of
// visit_numbers, the spans of its schemes (count, then the numbers of visit_span, length and bytes of the
// cause), its warnings and violations (count, then length and bytes of each), length and bytes of the
// serialised State, and the FNV-1a hash of everything before it.
constexpr std::string_view magic = "RIGORCP\x0A";

std::uint64_t checksum(std::string_view bytes) {
  std::uint64_t hash = 14695981039346656037ull;
  for (const char c : bytes) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211ull;
  return hash;
}

/// Visits every number of the audit, listed once for both writing and reading. Part is Audit or const Audit.
template <typename Part, typename Visit>
void visit_numbers(Part& audit, Visit visit) {
  auto& report = audit.report;
  visit(audit.sim_time), visit(audit.wall_time), visit(audit.max_increase);
  auto& books = audit.books;
  visit(books.start_time), visit(books.lowest), visit(books.energy_scale);
  visit(books.momentum_scale), visit(books.angular_momentum_scale), visit(books.lowest_of_span);
  visit(books.knows_work);
  for (auto* energy : {&audit.initial, &audit.final, &books.given})
    visit(energy->kinetic), visit(energy->potential), visit(energy->elastic);
  visit(report.steps), visit(report.impacts), visit(report.resting), visit(report.separations);
  visit(report.slip_to_stick), visit(report.distance_queries), visit(report.toi_bracket);
  visit(report.problems), visit(report.effort);
  visit(report.max_penetration), visit(report.penetration_A), visit(report.penetration_B);
  visit(report.penetration_time), visit(report.worst_overlap.share), visit(report.worst_overlap.depth);
  visit(report.worst_overlap.body_A), visit(report.worst_overlap.body_B);
  visit(report.force_uncertainty.share), visit(report.force_uncertainty.body),
      visit(report.force_uncertainty.time);
  visit(report.worst_overlap.time), visit(report.work), visit(report.motor_work), visit(report.impact_loss),
      visit(report.impact_gain);
  visit(report.damping_loss), visit(report.friction_loss);
  visit(report.projection_loss), visit(report.max_residual), visit(report.max_iterations),
      visit(report.fallbacks), visit(report.coarse_steps);
  visit(report.quaternion_drift), visit(report.max_joint_drift), visit(report.drift_joint);
  visit(report.max_joint_projection), visit(report.rounded_momentum);
  for (auto* pair : {&report.passages, &report.inconsistent, &report.indeterminate}) {
    visit(pair->instants), visit(pair->body_A), visit(pair->body_B), visit(pair->first);
  }
  for (auto* error : {&report.momentum_error, &report.angular_momentum_error}) {
    visit((*error)[0]), visit((*error)[1]), visit((*error)[2]);
  }
}

/// The same of a span.
template <typename Part, typename Visit>
void visit_span(Part& span, Visit visit) {
  visit(span.scheme), visit(span.solver), visit(span.begin), visit(span.end), visit(span.energy),
      visit(span.work);
  visit(span.rise), visit(span.impacts);
}

bool is_finite(const Audit& audit) {
  bool is_finite = true;
  visit_numbers(
      audit, [&](const auto& value) { is_finite = is_finite && std::isfinite(static_cast<double>(value)); });
  for (const SchemeSpan& span : audit.report.spans) {
    visit_span(
        span, [&](const auto& value) { is_finite = is_finite && std::isfinite(static_cast<double>(value)); });
  }
  return is_finite;
}

/// Why the audit cannot be one of a run of the Model, or empty.
std::string audit_error(const Model& model, const Audit& audit) {
  const AdvanceReport& report = audit.report;
  const auto is_body = [&](int body) { return body >= -1 && body < model.body_count(); };
  if (!is_finite(audit)) return "a number of its audit is not finite";
  if (!(audit.sim_time >= 0 && audit.wall_time >= 0)) return "its audit has a negative time";

  // Counts, and values that are largest ones.
  for (const long count : {report.steps, report.impacts, report.resting, report.separations,
                           report.slip_to_stick, report.distance_queries, report.problems, report.fallbacks,
                           report.coarse_steps, long{report.max_iterations}, report.passages.instants,
                           report.inconsistent.instants, report.indeterminate.instants}) {
    // No run counts so far, and sums with such counts would overflow.
    constexpr long most = 1L << 53;
    if (count < 0 || count > most) return "a count of its audit is negative or beyond any run";
  }
  for (const double largest :
       {report.toi_bracket, report.max_penetration, report.max_joint_drift, report.max_joint_projection,
        report.max_residual, report.quaternion_drift, report.effort, report.rounded_momentum}) {
    if (largest < 0) return "an error in its audit is negative";
  }

  // Spans follow each other.
  double until = 0;
  for (const SchemeSpan& span : report.spans) {
    if (!(span.begin >= until && span.end >= span.begin)) return "the spans of its schemes are in disorder";
    if (span.scheme < Scheme::event_driven || span.scheme >= Scheme::automatic)
      return "a span of its schemes names a scheme that does not exist";
    if (span.solver < SolverMethod::exact || span.solver > SolverMethod::substep)
      return "a span of its schemes names a solver that does not exist";
    if (span.impacts < 0 || span.rise < 0) return "a span of its schemes holds a negative count or rise";
    until = span.end;
  }

  // Indices.
  for (const int body : {report.penetration_A, report.penetration_B, report.passages.body_A,
                         report.passages.body_B, report.inconsistent.body_A, report.inconsistent.body_B,
                         report.indeterminate.body_A, report.indeterminate.body_B}) {
    if (!is_body(body)) return "its audit names a body that does not exist";
  }
  for (const PairInstants* pair : {&report.passages, &report.inconsistent, &report.indeterminate}) {
    if (pair->instants > 0 && (pair->body_A < 0 || pair->body_B < 0))
      return "its audit counts instants of a pair without its bodies";
  }
  if (report.drift_joint < -1 || report.drift_joint >= static_cast<int>(model.joints().size()))
    return "its audit names a joint that does not exist";
  return {};
}

class ByteWriter {
 public:
  const std::string& bytes() const { return bytes_; }
  void write(std::uint64_t value) {
    for (int shift = 0; shift < 64; shift += 8) bytes_.push_back(static_cast<char>(value >> shift));
  }
  void write_text(std::string_view text) {
    write(static_cast<std::uint64_t>(text.size()));
    bytes_ += text;
  }
  void write_texts(const std::vector<std::string>& texts) {
    write(static_cast<std::uint64_t>(texts.size()));
    for (const std::string& text : texts) write_text(text);
  }

 private:
  std::string bytes_{magic};
};

/// Reads what ByteWriter wrote. Lengths may be wrong although the checksum is right: to read past the end is
/// an InputError.
class ByteReader {
 public:
  ByteReader(std::string_view bytes, const std::string& name) : bytes_(bytes), name_(name) {}

  std::uint64_t read() {
    const std::string_view field = take(8);
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < 8; ++i)
      value |= std::uint64_t{static_cast<unsigned char>(field[i])} << (8 * i);
    return value;
  }
  bool is_at_end() const { return bytes_.empty(); }
  std::string_view read_text() { return take(read()); }
  std::vector<std::string> read_texts() {
    std::vector<std::string> texts;
    for (std::uint64_t count = read(); count > 0; --count) texts.emplace_back(read_text());
    return texts;
  }

 private:
  std::string_view take(std::uint64_t length) {
    if (length > bytes_.size()) throw InputError(name_ + ": the checkpoint is damaged");
    const std::string_view part = bytes_.substr(0, at(length));
    bytes_.remove_prefix(part.size());
    return part;
  }

  std::string_view bytes_;
  const std::string& name_;
};

std::string read_bytes(const std::filesystem::path& path) {
  std::error_code ignored;
  std::ifstream file(path, std::ios::binary);
  if (!file || !std::filesystem::is_regular_file(path, ignored)) {
    throw InputError(path.string() +
                     ": the checkpoint cannot be read; there is no such file, or it is not a regular one");
  }
  return {std::istreambuf_iterator<char>(file), {}};
}

/// The bytes between the magic number and the checksum.
std::string_view checked_content(std::string_view bytes, const std::string& name) {
  if (!bytes.starts_with(magic)) throw InputError(name + ": this is not a checkpoint of this version");
  if (bytes.size() < magic.size() + 8) throw InputError(name + ": the checkpoint is cut off");
  const std::size_t end = bytes.size() - 8;
  if (ByteReader(bytes.substr(end), name).read() != checksum(bytes.substr(0, end))) {
    throw InputError(name + ": the checkpoint is damaged (its checksum is wrong)");
  }
  return bytes.substr(magic.size(), end - magic.size());
}

State state_of(std::string_view bytes, const std::string& name) {
  try {
    return deserialise({bytes.begin(), bytes.end()});
  } catch (const InputError& error) {
    throw InputError(name + ": " + error.what());
  }
}

}  // namespace

std::string checkpoint_bytes(const Checkpoint& checkpoint) {
  ByteWriter writer;
  writer.write(checkpoint.fingerprint);
  const auto write = [&](const auto& value) {
    if constexpr (std::is_floating_point_v<std::decay_t<decltype(value)>>) {
      writer.write(std::bit_cast<std::uint64_t>(value));
    } else {
      writer.write(static_cast<std::uint64_t>(value));
    }
  };
  visit_numbers(checkpoint.audit, write);
  writer.write(static_cast<std::uint64_t>(checkpoint.audit.report.spans.size()));
  for (const SchemeSpan& span : checkpoint.audit.report.spans) {
    visit_span(span, write);
    writer.write_text(span.end_cause);
  }
  writer.write_texts(checkpoint.audit.warnings);
  writer.write_texts(checkpoint.audit.violations);
  const std::vector<unsigned char> state = serialise(checkpoint.state);
  writer.write_text({reinterpret_cast<const char*>(state.data()), state.size()});
  writer.write(checksum(writer.bytes()));
  return writer.bytes();
}

void write_checkpoint(const std::filesystem::path& path, const Checkpoint& checkpoint) {
  write_atomically(path, checkpoint_bytes(checkpoint));
}

Checkpoint read_checkpoint(const std::filesystem::path& path, std::uint64_t fingerprint, const Model& model) {
  return parse_checkpoint(read_bytes(path), path.string(), fingerprint, model);
}

Checkpoint parse_checkpoint(std::string_view bytes, const std::string& name, std::uint64_t fingerprint,
                            const Model& model) {
  ByteReader reader(checked_content(bytes, name), name);
  Checkpoint checkpoint;
  checkpoint.fingerprint = reader.read();
  if (checkpoint.fingerprint != fingerprint) {
    throw InputError(
        name +
        ": this is a checkpoint of another simulation; scene, method and step must be the same, only "
        "duration and outputs may differ");
  }
  const auto read = [&](auto& value) {
    using Value = std::decay_t<decltype(value)>;
    if constexpr (std::is_floating_point_v<Value>) {
      value = std::bit_cast<double>(reader.read());
    } else {
      const std::int64_t number = static_cast<std::int64_t>(reader.read());
      value = static_cast<Value>(number);
      if (static_cast<std::int64_t>(value) != number)
        throw InputError(name + ": the checkpoint is damaged (a count is too large)");
    }
  };
  visit_numbers(checkpoint.audit, read);
  checkpoint.audit.knows_work = checkpoint.audit.books.knows_work;
  // A forged count ends where the bytes do.
  for (std::uint64_t count = reader.read(); count > 0; --count) {
    SchemeSpan span;
    visit_span(span, read);
    span.end_cause = reader.read_text();
    checkpoint.audit.report.spans.push_back(std::move(span));
  }
  checkpoint.audit.warnings = reader.read_texts();
  checkpoint.audit.violations = reader.read_texts();
  const std::string_view state = reader.read_text();
  if (!reader.is_at_end()) throw InputError(name + ": the checkpoint is damaged (bytes follow its end)");
  checkpoint.state = state_of(state, name);
  // The checksum is right; whether the values are, only the Model knows.
  std::string error = state_error(model, checkpoint.state);
  if (error.empty()) error = audit_error(model, checkpoint.audit);
  if (!error.empty()) throw InputError(name + ": the checkpoint cannot be of a run of this scene: " + error);
  return checkpoint;
}

Audit joined_audit(const Audit& first, const Audit& second) {
  Audit audit = second;
  audit.sim_time = first.sim_time + second.sim_time;
  audit.wall_time = first.wall_time + second.wall_time;
  audit.report = first.report;
  audit.report.add(second.report);
  audit.initial = first.initial;
  audit.dissipated = audit.initial.total() + audit.report.work - audit.final.total();
  audit.max_increase = std::max(first.max_increase, second.max_increase);
  // Work of which a part is not known is not known.
  audit.knows_work = first.knows_work && second.knows_work;
  audit.books.knows_work = first.books.knows_work && second.books.knows_work;
  audit.linear_momentum_error = audit.report.momentum_error.norm();
  audit.angular_momentum_error = audit.report.angular_momentum_error.norm();
  for (const auto list : {&Audit::warnings, &Audit::violations}) {
    audit.*list = first.*list;
    for (const std::string& line : second.*list) {
      if (std::find((audit.*list).begin(), (audit.*list).end(), line) == (audit.*list).end())
        (audit.*list).push_back(line);
    }
  }
  return audit;
}

}  // namespace rigor
