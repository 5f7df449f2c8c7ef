#include "rigor/core/input_error.hpp"
#include "rigor/model/state.hpp"

#include <array>
#include <bit>
#include <cstdint>
#include <string>

namespace rigor {

namespace {

// Layout, all little-endian: 8 bytes magic, version (u32), 0 (u32), body count n (u64), count m of remembered
// contacts (u64), then the doubles t, x (3n), q (4n), P (3n), L (3n), epoch (n), anchor (13n), then m times
// body_A, body_B, shape_A, shape_B, feature (8 bytes each), values (12 doubles) and energy, then the FNV-1a
// checksum (u64) of everything before it.
constexpr std::array<unsigned char, 8> magic = {'R', 'I', 'G', 'O', 'R', 'S', 'T', 0x1A};
constexpr std::uint64_t version = 2;
constexpr std::size_t header_length = 32;
constexpr std::size_t checksum_length = 8;
constexpr std::size_t doubles_of_a_body = 27;
constexpr std::size_t words_of_a_contact = 6 + ContactMemory::value_count;

using Bytes = std::vector<unsigned char>;

void append(std::uint64_t value, int length, Bytes& bytes) {
  for (int i = 0; i < length; ++i) bytes.push_back(static_cast<unsigned char>(value >> (8 * i)));
}

void append(const std::vector<double>& values, Bytes& bytes) {
  for (const double value : values) append(std::bit_cast<std::uint64_t>(value), 8, bytes);
}

std::uint64_t read_number(const Bytes& bytes, std::size_t at, std::size_t length) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < length; ++i) value |= static_cast<std::uint64_t>(bytes[at + i]) << (8 * i);
  return value;
}

/// Reads the numbers of eight bytes in turn.
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

void check_frame(const Bytes& bytes) {
  const std::string found = std::to_string(bytes.size()) + " bytes";
  if (bytes.size() < header_length + 8 + checksum_length) {
    throw InputError("state: damaged, it has only " + found);
  }
  if (!std::equal(magic.begin(), magic.end(), bytes.begin()))
    throw InputError("state: not a saved state of Rigor");
  if (const std::uint64_t number = read_number(bytes, 8, 4); number != version) {
    throw InputError("state: version " + std::to_string(number) + ", this program reads version " +
                     std::to_string(version));
  }
  // The counts are compared with what the bytes can hold before anything is computed from them.
  const std::uint64_t count = read_number(bytes, 16, 8), contact_count = read_number(bytes, 24, 8);
  const std::size_t payload = bytes.size() - header_length - 8 - checksum_length, words = payload / 8;
  const bool can_fit = count <= words / doubles_of_a_body && contact_count <= words / words_of_a_contact;
  if (payload % 8 != 0 || !can_fit ||
      count * doubles_of_a_body + contact_count * words_of_a_contact != words) {
    throw InputError("state: damaged, " + std::to_string(count) + " bodies and " +
                     std::to_string(contact_count) + " contacts do not fit its " + found);
  }
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

}  // namespace

std::vector<unsigned char> serialise(const State& state) {
  const std::size_t n = state.epoch.size();
  Bytes bytes(magic.begin(), magic.end());
  const std::size_t m = state.contacts.size();
  bytes.reserve(header_length + 8 * (1 + doubles_of_a_body * n + words_of_a_contact * m) + checksum_length);
  append(version, 8, bytes);
  append(n, 8, bytes);
  append(m, 8, bytes);
  append(std::bit_cast<std::uint64_t>(state.t), 8, bytes);
  for (const auto* array : {&state.x, &state.q, &state.P, &state.L, &state.epoch, &state.anchor}) {
    append(*array, bytes);
  }
  for (const ContactMemory& contact : state.contacts) append(contact, bytes);
  append(checksum(bytes, bytes.size()), 8, bytes);
  return bytes;
}

State deserialise(const std::vector<unsigned char>& bytes) {
  check_frame(bytes);
  const std::size_t n = static_cast<std::size_t>(read_number(bytes, 16, 8));
  const std::size_t m = static_cast<std::size_t>(read_number(bytes, 24, 8));
  WordReader reader(bytes);
  State state;
  state.t = reader.next_double();
  state.x = reader.next(3 * n);
  state.q = reader.next(4 * n);
  state.P = reader.next(3 * n);
  state.L = reader.next(3 * n);
  state.epoch = reader.next(n);
  state.anchor = reader.next(13 * n);
  for (std::size_t i = 0; i < m; ++i) state.contacts.push_back(read_contact(reader));
  return state;
}

}  // namespace rigor
