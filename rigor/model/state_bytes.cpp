#include "rigor/core/input_error.hpp"
#include "rigor/model/state.hpp"

#include <array>
#include <bit>
#include <cstdint>
#include <string>
#include <type_traits>
#include <utility>

namespace rigor {

namespace {

// The layout of the bytes, all little-endian: 8 bytes magic, version (u32), 0 (u32), the counts (u64 each) n
// of bodies, m of remembered contacts, of remembered manifolds, of joint impulses, of quiet times and of
// contacts of events, then the doubles t, of the hand-over the number of the carrier, work owed, price,
// operations owed by steps and length of soft steps, whether a scheme of events has left the State (0 or 1),
// x (3n), q (4n), P (3n), L (3n), epoch (n), anchor (13n), then m times body_A, body_B, shape_A, shape_B,
// feature (8 bytes each), values (12 doubles) and energy, the contacts of events in the same way, then the
// manifolds (22 numbers of 4 bytes each), the joint impulses and the quiet times (floats, two to 8 bytes),
// then the FNV-1a checksum (u64) of everything before it.
constexpr std::array<unsigned char, 8> magic = {'R', 'I', 'G', 'O', 'R', 'S', 'T', 0x1A};
constexpr std::uint64_t version = 8;
/// Beside the header: t, the hand-over, and who has left the State.
constexpr std::size_t single_words = 7;
constexpr std::size_t header_length = 64;
constexpr std::size_t checksum_length = 8;
constexpr std::size_t doubles_of_a_body = 27;
constexpr std::size_t words_of_a_contact = 6 + ContactMemory::value_count;
constexpr std::size_t words_of_a_manifold = 11;

using Bytes = std::vector<unsigned char>;

void append(std::uint64_t value, int length, Bytes& bytes) {
  for (int i = 0; i < length; ++i) bytes.push_back(static_cast<unsigned char>(value >> (8 * i)));
}

void append(const std::vector<double>& values, Bytes& bytes) {
  for (const double value : values) append(std::bit_cast<std::uint64_t>(value), 8, bytes);
}

HandoverMemory::Carrier carrier_of(double number) {
  using Carrier = HandoverMemory::Carrier;
  for (const Carrier carrier : {Carrier::events, Carrier::steps, Carrier::soft_steps}) {
    if (number == static_cast<double>(carrier)) return carrier;
  }
  throw InputError("state: damaged, no scheme has the number " + std::to_string(number));
}

bool is_left(double number) {
  if (number == 0 || number == 1) return number == 1;
  throw InputError("state: damaged, it does not say whether a scheme of events has left it");
}

std::uint64_t read_number(const Bytes& bytes, std::size_t at, std::size_t length) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < length; ++i) value |= static_cast<std::uint64_t>(bytes[at + i]) << (8 * i);
  return value;
}

/// Reads the numbers of eight bytes one after the other.
class WordReader {
 public:
  explicit WordReader(const Bytes& bytes) : bytes_(bytes) {}
  std::uint64_t next_word() {
    const std::uint64_t word = read_number(bytes_, at_, 8);
    at_ += 8;
    return word;
  }
  double next_double() { return std::bit_cast<double>(next_word()); }
  int next_int() { return static_cast<int>(static_cast<std::int64_t>(next_word())); }
  std::vector<double> next(std::size_t count) {
    std::vector<double> values(count);
    for (double& value : values) value = next_double();
    return values;
  }

 private:
  const Bytes& bytes_;
  std::size_t at_ = header_length;
};

/// Source: Fowler, Noll, Vo and Eastlake, The FNV Non-Cryptographic Hash Algorithm (64-bit FNV-1a).
std::uint64_t checksum(const Bytes& bytes, std::size_t length) {
  std::uint64_t hash = 14695981039346656037ull;
  for (std::size_t i = 0; i < length; ++i) hash = (hash ^ bytes[i]) * 1099511628211ull;
  return hash;
}

/// The counts in the header.
struct Counts {
  std::uint64_t bodies, contacts, manifolds, joint_impulses, quiet_times, events;
};

Counts read_counts(const Bytes& bytes) {
  return {read_number(bytes, 16, 8), read_number(bytes, 24, 8), read_number(bytes, 32, 8),
          read_number(bytes, 40, 8), read_number(bytes, 48, 8), read_number(bytes, 56, 8)};
}

/// Whether these counts take exactly `words` numbers of 8 bytes, without overflow.
bool do_fit(const Counts& counts, std::uint64_t words) {
  const std::pair<std::uint64_t, std::uint64_t> parts[] = {
      {counts.bodies, doubles_of_a_body},
      {counts.contacts, words_of_a_contact},
      {counts.events, words_of_a_contact},
      {counts.manifolds, words_of_a_manifold},
      {counts.joint_impulses / 2 + counts.joint_impulses % 2, 1},
      {counts.quiet_times / 2 + counts.quiet_times % 2, 1}};
  for (const auto& [count, size] : parts) {
    if (count > words / size) return false;
    words -= count * size;
  }
  return words == 0;
}

void check_frame(const Bytes& bytes) {
  // From the outside inwards: length, kind of file, version.
  const std::string found = std::to_string(bytes.size()) + " bytes";
  if (bytes.size() < header_length + 8 * single_words + checksum_length) {
    throw InputError("state: damaged, it has only " + found);
  }
  if (!std::equal(magic.begin(), magic.end(), bytes.begin()))
    throw InputError("state: not a saved state of Rigor");
  if (const std::uint64_t number = read_number(bytes, 8, 4); number != version) {
    throw InputError("state: version " + std::to_string(number) + ", this program reads version " +
                     std::to_string(version));
  }
  // The counts are compared with what the bytes can hold before anything is computed from them.
  const Counts counts = read_counts(bytes);
  const std::size_t payload = bytes.size() - header_length - 8 * single_words - checksum_length;
  if (payload % 8 != 0 || !do_fit(counts, payload / 8)) {
    throw InputError("state: damaged, " + std::to_string(counts.bodies) + " bodies, " +
                     std::to_string(counts.contacts) + " contacts, " + std::to_string(counts.manifolds) +
                     " manifolds, " + std::to_string(counts.joint_impulses) + " joint impulses, " +
                     std::to_string(counts.quiet_times) + " quiet times and " +
                     std::to_string(counts.events) + " contacts of events do not fit its " + found);
  }
  // The checksum last, over bytes whose layout is plausible.
  const std::size_t end = bytes.size() - checksum_length;
  if (checksum(bytes, end) != read_number(bytes, end, 8))
    throw InputError("state: damaged, its checksum is wrong");
}

void append(const ContactMemory& contact, Bytes& bytes) {
  for (const int index : {contact.body_A, contact.body_B, contact.shape_A, contact.shape_B})
    append(static_cast<std::uint64_t>(static_cast<std::int64_t>(index)), 8, bytes);
  append(contact.feature, 8, bytes);
  for (const double value : contact.values) append(std::bit_cast<std::uint64_t>(value), 8, bytes);
  append(std::bit_cast<std::uint64_t>(contact.energy), 8, bytes);
}

ContactMemory read_contact(WordReader& reader) {
  ContactMemory contact;
  for (int* const index : {&contact.body_A, &contact.body_B, &contact.shape_A, &contact.shape_B})
    *index = reader.next_int();
  contact.feature = reader.next_word();
  for (double& value : contact.values) value = reader.next_double();
  contact.energy = reader.next_double();
  return contact;
}

/// Numbers of 4 bytes, two to a word.
std::uint64_t joined_halves(std::uint32_t low, std::uint32_t high) {
  return low | static_cast<std::uint64_t>(high) << 32;
}
std::uint32_t low_half(std::uint64_t word) {
  return static_cast<std::uint32_t>(word);
}
std::uint32_t high_half(std::uint64_t word) {
  return static_cast<std::uint32_t>(word >> 32);
}

void append(const std::vector<float>& values, Bytes& bytes) {
  const auto half = [&](std::size_t i) {
    return i < values.size() ? std::bit_cast<std::uint32_t>(values[i]) : 0u;
  };
  for (std::size_t i = 0; i < values.size(); i += 2) append(joined_halves(half(i), half(i + 1)), 8, bytes);
}

std::vector<float> read_floats(std::size_t count, WordReader& reader) {
  std::vector<float> values(count);
  for (std::size_t i = 0; i < count; i += 2) {
    const std::uint64_t word = reader.next_word();
    values[i] = std::bit_cast<float>(low_half(word));
    if (i + 1 < count) values[i + 1] = std::bit_cast<float>(high_half(word));
  }
  return values;
}

/// Calls f with each number of a manifold, in the order of the layout.
template <typename Memory, typename F>
void visit_numbers_of(Memory& manifold, F f) {
  for (auto* index : {&manifold.body_A, &manifold.body_B, &manifold.shape_A, &manifold.shape_B,
                      &manifold.part, &manifold.point_count})
    f(*index);
  for (auto& feature : manifold.feature) f(feature);
  for (auto& impulse : manifold.normal_impulse) f(impulse);
  for (auto& impulse : manifold.friction_impulse_W) f(impulse);
  f(manifold.twist_impulse);
  for (auto& impulse : manifold.rolling_impulse_W) f(impulse);
  f(manifold.energy);
}

void append(const ManifoldMemory& manifold, Bytes& bytes) {
  visit_numbers_of(manifold,
                   [&](const auto& number) { append(std::bit_cast<std::uint32_t>(number), 4, bytes); });
}

ManifoldMemory read_manifold(WordReader& reader) {
  ManifoldMemory manifold;
  std::uint64_t word = 0;
  bool is_second = false;
  visit_numbers_of(manifold, [&](auto& number) {
    if (!is_second) word = reader.next_word();
    number = std::bit_cast<std::decay_t<decltype(number)>>(is_second ? high_half(word) : low_half(word));
    is_second = !is_second;
  });
  // A checksum does not protect from forged bytes, so a number that indexes arrays is checked.
  if (manifold.point_count < 0 || manifold.point_count > ManifoldMemory::max_points)
    throw InputError("state: damaged, a manifold has " + std::to_string(manifold.point_count) + " points");
  return manifold;
}

}  // namespace

std::vector<unsigned char> serialise(const State& state) {
  const std::size_t n = state.epoch.size();
  Bytes bytes(magic.begin(), magic.end());
  // One allocation: the length follows from the counts.
  const std::size_t m = state.contacts.size();
  bytes.reserve(header_length +
                8 * (single_words + doubles_of_a_body * n +
                     words_of_a_contact * (m + state.events.contacts.size()) +
                     words_of_a_manifold * state.manifolds.size() + state.joint_impulses.size() +
                     state.quiet_time.size()) +
                checksum_length);
  append(version, 8, bytes);
  for (const std::size_t count : {n, m, state.manifolds.size(), state.joint_impulses.size(),
                                  state.quiet_time.size(), state.events.contacts.size()})
    append(count, 8, bytes);
  append(std::bit_cast<std::uint64_t>(state.t), 8, bytes);
  const HandoverMemory& handover = state.handover;
  append(std::vector<double>{static_cast<double>(handover.carrier), handover.owed, handover.price,
                             handover.owed_by_steps, handover.soft_step, state.events.is_left ? 1.0 : 0.0},
         bytes);
  for (const auto* array : {&state.x, &state.q, &state.P, &state.L, &state.epoch, &state.anchor}) {
    append(*array, bytes);
  }
  for (const auto* contacts : {&state.contacts, &state.events.contacts}) {
    for (const ContactMemory& contact : *contacts) append(contact, bytes);
  }
  for (const ManifoldMemory& manifold : state.manifolds) append(manifold, bytes);
  append(state.joint_impulses, bytes);
  append(state.quiet_time, bytes);
  append(checksum(bytes, bytes.size()), 8, bytes);
  return bytes;
}

State deserialise(const std::vector<unsigned char>& bytes) {
  check_frame(bytes);
  const Counts counts = read_counts(bytes);
  const std::size_t n = static_cast<std::size_t>(counts.bodies);
  WordReader reader(bytes);
  State state;
  state.t = reader.next_double();
  state.handover.carrier = carrier_of(reader.next_double());
  state.handover.owed = reader.next_double();
  state.handover.price = reader.next_double();
  state.handover.owed_by_steps = reader.next_double();
  state.handover.soft_step = reader.next_double();
  state.events.is_left = is_left(reader.next_double());
  state.x = reader.next(3 * n);
  state.q = reader.next(4 * n);
  state.P = reader.next(3 * n);
  state.L = reader.next(3 * n);
  state.epoch = reader.next(n);
  state.anchor = reader.next(13 * n);
  for (std::uint64_t i = 0; i < counts.contacts; ++i) state.contacts.push_back(read_contact(reader));
  for (std::uint64_t i = 0; i < counts.events; ++i) state.events.contacts.push_back(read_contact(reader));
  for (std::uint64_t i = 0; i < counts.manifolds; ++i) state.manifolds.push_back(read_manifold(reader));
  state.joint_impulses = read_floats(static_cast<std::size_t>(counts.joint_impulses), reader);
  state.quiet_time = read_floats(static_cast<std::size_t>(counts.quiet_times), reader);
  return state;
}

}  // namespace rigor
