#include "apps/commands.hpp"
#include "apps/solid.hpp"
#include "apps/terminal.hpp"
#include "rigor/io/files/json_text.hpp"
#include "rigor/math/principal_axes.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <iterator>

namespace rigor {

namespace {

using Json = nlohmann::ordered_json;

Json solid_json(const Vec3& v) {
  return {v.x(), v.y(), v.z()};
}
Json solid_json(const Mat3& m) {
  Json rows = Json::array();
  for (int i = 0; i < 3; ++i) rows.push_back(solid_json(Vec3(m.row(i))));
  return rows;
}

Json solid_json(const MassProperties& properties) {
  const PrincipalAxes principal = principal_axes(properties.inertia);
  return {{"mass", properties.mass},
          {"center", solid_json(properties.center)},
          {"inertia", solid_json(properties.inertia)},
          {"principal_moments", solid_json(principal.moments)},
          {"principal_axes", solid_json(principal.R)}};
}

Json solid_json(const SolidReport& report) {
  Json json = {{"name", report.name}, {"volume", report.volume}, {"exact", solid_json(report.exact)}};
  json["sampled"] = nullptr;
  if (report.sampled) {
    const SampledMassProperties& sampled = *report.sampled;
    json["sampled"] = solid_json(sampled.properties);
    json["sampled"]["volume"] = sampled.volume;
    json["sampled"]["deviation"] = {{"volume", sampled.volume_deviation},
                                    {"center", solid_json(sampled.center_deviation)},
                                    {"inertia", solid_json(sampled.inertia_deviation)}};
  }
  json["simulated"] = report.simulated ? solid_json(*report.simulated) : Json(nullptr);
  json["notes"] = report.notes;
  return json;
}

/// A line of the table: one quantity, computed in both ways.
struct Row {
  std::string title;
  double exact, sampled, deviation;
};

std::vector<Row> rows_of(const SolidReport& report) {
  const double none = std::nan("");
  const SampledMassProperties sampled = report.sampled.value_or(SampledMassProperties{});
  const bool has = report.sampled.has_value();
  std::vector<Row> rows;
  const auto add = [&](std::string title, double exact, double estimate, double deviation) {
    rows.push_back({std::move(title), exact, has ? estimate : none, has ? deviation : none});
  };
  add("volume [m³]", report.volume, sampled.volume, sampled.volume_deviation);
  const double density = sampled.volume > 0 ? sampled.properties.mass / sampled.volume : 0;
  add("mass [kg]", report.exact.mass, sampled.properties.mass, sampled.volume_deviation * density);
  for (int i = 0; i < 3; ++i) {
    add(fmt::format("center {} [m]", "xyz"[i]), report.exact.center[i], sampled.properties.center[i],
        sampled.center_deviation[i]);
  }
  for (const auto& [i, k] : {std::pair(0, 0), {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}}) {
    add(fmt::format("inertia {}{} [kg m²]", "xyz"[i], "xyz"[k]), report.exact.inertia(i, k),
        sampled.properties.inertia(i, k), sampled.inertia_deviation(i, k));
  }
  return rows;
}

/// Text padded by counting its characters, not its bytes.
std::string padded(const std::string& text, std::size_t width) {
  std::size_t characters = 0;
  for (const char c : text) characters += (static_cast<unsigned char>(c) & 0xC0) != 0x80;
  return text + std::string(characters < width ? width - characters : 0, ' ');
}

void add_table(const SolidReport& report, std::string& text) {
  fmt::format_to(std::back_inserter(text), "  {} {:>16} {:>16} {:>10} {:>12}\n", padded("", 18), "exact",
                 "sampled", "deviation", "difference");
  for (const Row& row : rows_of(report)) {
    fmt::format_to(std::back_inserter(text), "  {} {:>16.9g}", padded(row.title, 18), row.exact);
    if (std::isfinite(row.sampled)) {
      fmt::format_to(std::back_inserter(text), " {:>16.9g} {:>10}", row.sampled,
                     fmt::format("±{:.2g}", row.deviation));
      const double difference = row.sampled - row.exact;
      text += row.deviation > 0 ? fmt::format(" {:>8.2f} dev", difference / row.deviation)
                                : fmt::format(" {:>12.2g}", difference);
    }
    text += '\n';
  }
}

void add_principal(const char* title, const MassProperties& properties, std::string& text) {
  const PrincipalAxes principal = principal_axes(properties.inertia);
  fmt::format_to(std::back_inserter(text), "  {}mass {:.9g} kg, principal moments and axes:\n", title,
                 properties.mass);
  for (int i = 0; i < 3; ++i) {
    const Vec3 axis = principal.R.col(i);
    fmt::format_to(std::back_inserter(text), "    {:>16.9g} kg m²  along [{:.9g}, {:.9g}, {:.9g}]\n",
                   principal.moments[i], axis.x(), axis.y(), axis.z());
  }
}

std::string text_of(const SolidReport& report) {
  std::string text = fmt::format("{}\n", toned(report.name, Tone::strong, stdout));
  if (report.exact.mass > 0) {
    add_table(report, text);
    add_principal("exact: ", report.exact, text);
  }
  if (report.simulated) add_principal("as simulated: ", *report.simulated, text);
  for (const std::string& note : report.notes)
    text += fmt::format("  {} {}\n", toned("note:", Tone::doubtful, stdout), note);
  return text;
}

}  // namespace

ExitCode execute(const MassOptions& options) {
  const std::vector<SolidReport> reports = solid_reports(options);
  Json json = {{"file", options.file}, {"solids", Json::array()}};
  for (const SolidReport& report : reports) {
    json["solids"].push_back(solid_json(report));
    if (options.json != "-") fmt::print("{}", text_of(report));
  }
  write_text(options.json, json_text(json).append("\n"));
  return exit_done;
}

}  // namespace rigor
