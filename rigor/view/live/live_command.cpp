#include "rigor/view/live/live_command.hpp"

#include "rigor/core/index.hpp"
#include "rigor/core/input_error.hpp"
#include "rigor/core/quoted.hpp"
#include "rigor/core/suggestion.hpp"
#include "rigor/model/limits.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <limits>
#include <set>
#include <utility>
#include <vector>

namespace rigor {

namespace {

using Json = nlohmann::ordered_json;

constexpr Range speed{1e-6, 1e6};
constexpr Range any_number{};

/// Reads the values of a command by name; values that nobody reads are an error.
class Fields {
 public:
  explicit Fields(const Json& object) : object_(object) {}

  std::optional<double> find_number(const char* key, const Range& range) {
    const Json* const value = find(key);
    if (!value) return std::nullopt;
    if (!value->is_number()) throw InputError(fmt::format("{} must be a number", key));
    const std::string message = range_error(key, value->get<double>(), range, "");
    if (!message.empty()) throw InputError(message);
    return value->get<double>();
  }
  double number(const char* key, const Range& range) { return needed(find_number(key, range), key); }

  int index(const char* key, const char* what = "a body's number") {
    const Json* const value = find(key);
    if (!value || !value->is_number_unsigned() ||
        value->get<std::uint64_t>() > static_cast<std::uint64_t>(std::numeric_limits<int>::max()))
      throw InputError(fmt::format("{} must be {}", key, what));
    return value->get<int>();
  }

  Vec3 vector(const char* key, const Range& range) {
    const Json* const value = find(key);
    if (!value || !value->is_array() || value->size() != 3)
      throw InputError(fmt::format("{} must be a list of three numbers", key));
    Vec3 v;
    for (int i = 0; i < 3; ++i) {
      const Json& component = (*value)[at(i)];
      if (!component.is_number()) throw InputError(fmt::format("{} must be a list of three numbers", key));
      v[i] = component.get<double>();
      const std::string message = range_error(key, v[i], range, "");
      if (!message.empty()) throw InputError(message);
    }
    return v;
  }

  std::string text(const char* key) {
    const Json* const value = find(key);
    if (!value || !value->is_string()) throw InputError(fmt::format("{} must be a text", key));
    return value->get<std::string>();
  }

  bool truth(const char* key) {
    const Json* const value = find(key);
    if (!value || !value->is_boolean()) throw InputError(fmt::format("{} must be true or false", key));
    return value->get<bool>();
  }

  void check_all_taken() const {
    for (const auto& [key, value] : object_.items()) {
      if (!taken_.contains(key)) throw InputError("unknown key " + quoted_text(key));
    }
  }

 private:
  const Json* find(const char* key) {
    taken_.insert(key);
    const auto found = object_.find(key);
    return found == object_.end() ? nullptr : &*found;
  }
  static double needed(std::optional<double> value, const char* key) {
    if (!value) throw InputError(fmt::format("{} is missing", key));
    return *value;
  }

  const Json& object_;
  std::set<std::string> taken_;
};

using Maker = LiveCommand (*)(Fields&);
const std::vector<std::pair<std::string, Maker>>& makers() {
  static const std::vector<std::pair<std::string, Maker>> table = {
      {"run", [](Fields&) -> LiveCommand { return live::Run{}; }},
      {"pause", [](Fields&) -> LiveCommand { return live::Pause{}; }},
      {"step", [](Fields&) -> LiveCommand { return live::Step{}; }},
      {"back", [](Fields&) -> LiveCommand { return live::Back{}; }},
      {"reset", [](Fields&) -> LiveCommand { return live::Reset{}; }},
      {"reload", [](Fields&) -> LiveCommand { return live::Reload{}; }},
      {"follow", [](Fields& f) -> LiveCommand { return live::Follow{f.truth("value")}; }},
      {"speed", [](Fields& f) -> LiveCommand { return live::Speed{f.number("value", speed)}; }},
      {"gravity", [](Fields& f) -> LiveCommand { return live::Gravity{f.vector("value", limits::gravity)}; }},
      {"surface",
       [](Fields& f) -> LiveCommand {
         return live::Surface{f.text("material"), f.find_number("friction", limits::friction),
                              f.find_number("restitution", limits::restitution)};
       }},
      {"target_step",
       [](Fields& f) -> LiveCommand { return live::TargetStep{f.number("value", any_number)}; }},
      {"method",
       [](Fields& f) -> LiveCommand {
         return live::MethodValue{f.text("key"), f.text("value")};
       }},
      {"pull",
       [](Fields& f) -> LiveCommand {
         return live::Pull{{.body = f.index("body"),
                            .p_BP = f.vector("point", limits::position),
                            .target = f.vector("target", limits::position)}};
       }},
      {"release", [](Fields&) -> LiveCommand { return live::Release{}; }},
      {"push",
       [](Fields& f) -> LiveCommand {
         return live::Push{f.index("body"), f.vector("point", limits::position),
                           f.vector("impulse", limits::force)};
       }},
      {"motor",
       [](Fields& f) -> LiveCommand {
         return live::Motor{f.index("joint", "a joint's number"), f.index("coordinate", "a whole number"),
                            f.find_number("velocity", any_number)};
       }},
      {"rest",
       [](Fields& f) -> LiveCommand {
         return live::Rest{f.index("joint", "a joint's number"), f.index("coordinate", "a whole number"),
                           f.number("value", any_number)};
       }},
      {"save", [](Fields&) -> LiveCommand { return live::Save{}; }},
      {"export", [](Fields&) -> LiveCommand { return live::Export{}; }}};
  return table;
}

Json parsed(std::string_view text) {
  try {
    return Json::parse(text);
  } catch (const Json::exception&) {
    throw InputError("the message is not JSON");
  }
}

}  // namespace

LiveCommand parse_live_command(std::string_view text) {
  const Json object = parsed(text);
  if (!object.is_object()) throw InputError("a command is a JSON object");
  Fields fields(object);
  const std::string name = fields.text("do");
  std::vector<std::string> names;
  for (const auto& [known, make] : makers()) {
    if (known == name) {
      LiveCommand command = make(fields);
      fields.check_all_taken();
      return command;
    }
    names.push_back(known);
  }
  throw InputError("unknown command " + quoted_text(name) + suggestion(name, names));
}

}  // namespace rigor
