// The bytes of a simulation: CBOR of the inputs, and a checkpoint of the State with the books (which has a
// checksum of its own).

#include "rigor/api/engine.hpp"
#include "rigor/core/index.hpp"
#include "rigor/core/input_error.hpp"
#include "rigor/io/trajectory/checkpoint.hpp"
#include "rigor/io/trajectory/fingerprint.hpp"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <utility>

namespace rigor {

namespace {

using Json = nlohmann::ordered_json;

constexpr int saved_version = 1;

/// Looks at bytes of CBOR without keeping them: parsing is by recursion, and a megabyte of brackets would
/// fill the stack.
class DepthGuard : public nlohmann::json_sax<Json> {
 public:
  bool null() override { return true; }
  bool boolean(bool) override { return true; }
  bool number_integer(number_integer_t) override { return true; }
  bool number_unsigned(number_unsigned_t) override { return true; }
  bool number_float(number_float_t, const string_t&) override { return true; }
  bool string(string_t&) override { return true; }
  bool binary(binary_t&) override { return true; }
  bool start_object(std::size_t) override { return begin(); }
  bool key(string_t&) override { return true; }
  bool end_object() override { return end(); }
  bool start_array(std::size_t) override { return begin(); }
  bool end_array() override { return end(); }
  bool parse_error(std::size_t, const std::string&, const Json::exception& error) override {
    what_ = error.what();
    return false;
  }
  const std::string& what() const { return what_; }

 private:
  static constexpr int most = 16;  ///< What save() writes has 6.
  bool begin() { return ++depth_ <= most; }
  bool end() {
    --depth_;
    return true;
  }
  int depth_ = 0;
  std::string what_ = "lists in lists in lists";
};

Json parsed(std::string_view bytes) {
  DepthGuard guard;
  if (!Json::sax_parse(bytes.begin(), bytes.end(), &guard, Json::input_format_t::cbor))
    throw InputError("these are not the bytes of a saved simulation: " + guard.what());
  return Json::from_cbor(bytes.begin(), bytes.end());
}

}  // namespace

std::string SimulationEngine::save(const WaitingLoads& loads) const {
  const std::string checkpoint = checkpoint_bytes(
      {fingerprint(*scene_.model, scene_.method, scene_.run.step), state_, auditor_->audit(state_)});
  const Json json = {{"rigor simulation", saved_version},
                     {"inputs", inputs_json(inputs_, loads.given)},
                     {"control", inputs_json(inputs_, loads.of_control)},
                     // What acts in the books now: it is taken out of them when it ends.
                     {"applied", inputs_json({applied_, {}}, loads_)},
                     {"inputs changed", inputs_changed_},
                     {"checkpoint", Json::binary({checkpoint.begin(), checkpoint.end()})}};
  const std::vector<std::uint8_t> bytes = Json::to_cbor(json);
  return {bytes.begin(), bytes.end()};
}

SimulationEngine::WaitingLoads SimulationEngine::restore(std::string_view bytes) {
  try {
    const Json json = parsed(bytes);
    if (json.at("rigor simulation").get<int>() != saved_version)
      throw InputError("these bytes are of another version of Rigor");
    SimulationInputs inputs, same, applied;
    WaitingLoads loads;
    std::vector<BodyLoad> acting;
    read_inputs(json.at("inputs"), *scene_.model, inputs, loads.given);
    read_inputs(json.at("control"), *scene_.model, same, loads.of_control);
    read_inputs(json.at("applied"), *scene_.model, applied, acting);
    const bool inputs_changed = json.at("inputs changed").get<bool>();

    const std::shared_ptr<const Model> model = changed_model(*scene_.model, applied.changes);
    const auto& binary = json.at("checkpoint").get_binary();
    const Checkpoint checkpoint =
        parse_checkpoint({reinterpret_cast<const char*>(binary.data()), binary.size()}, "saved simulation",
                         fingerprint(*scene_.model, scene_.method, scene_.run.step), *model);
    inputs_ = std::move(inputs);
    applied_ = std::move(applied.changes);
    inputs_changed_ = inputs_changed;
    state_ = checkpoint.state;
    events_.clear();
    // The model in which the books were kept, and a stepper of its own.
    stepper_.reset();
    use(applied_, std::move(acting));
    auditor_ = std::make_unique<Auditor>(model_, choice_, state_, checkpoint.audit);
    return loads;
  } catch (const Json::exception& error) {
    throw InputError(std::string("these are not the bytes of a saved simulation: ") + error.what());
  }
}

}  // namespace rigor
