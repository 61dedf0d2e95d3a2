// `vallecula devices`: what is plugged in, what it can do, and what is missing.
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <algorithm>
#include <iostream>
#include <memory>

#include "gui/commands/commands.h"
#include "gui/session/device_rows.h"

namespace vallecula::gui {
namespace {

QString qt(const std::string& words) { return QString::fromStdString(words); }

/// Null where there is nothing to tell.
QJsonValue known(const std::string& words) { return words.empty() ? QJsonValue() : QJsonValue(qt(words)); }

QJsonObject json_of(const device::FoundDevice& found) {
  const device::DeviceInfo& info = found.info;
  QJsonArray workspace;
  for (const double edge : info.workspace_m) workspace.append(1e3 * edge);
  const bool bounded = info.workspace_m[0] > 0.0;
  const auto figure = [&found](const QJsonValue& value) { return found.figures_known ? value : QJsonValue(); };
  return {{"name", known(found.name)},
          {"usable", usable(found)},
          {"kind", qt(info.kind)},
          {"model", qt(info.model)},
          {"serial", known(info.serial)},
          {"driver", known(info.driver)},
          {"rate_hz", figure(info.rate_hz)},
          {"workspace_mm", bounded ? QJsonValue(workspace) : QJsonValue()},
          {"peak_force_n", figure(info.peak_force_n)},
          {"continuous_force_n", figure(info.continuous_force_n > 0.0 ? info.continuous_force_n : info.peak_force_n)},
          {"sensed_dof", figure(info.sensed_dof)},
          {"actuated_dof", figure(info.actuated_dof)},
          {"calibration", figure(calibration_word(found.calibration))},
          {"problem", known(found.problem)},
          {"mend", known(found.mend)}};
}

void print_json(const std::vector<device::FoundDevice>& devices) {
  QJsonArray list;
  for (const auto& found : devices) list.append(json_of(found));
  std::cout << QJsonDocument(QJsonObject{{"devices", list}}).toJson().toStdString();
}

void print_table(const std::vector<device::FoundDevice>& devices) {
  std::vector<DeviceRow> rows;
  std::array<std::size_t, kDeviceColumns.size()> widths;
  for (std::size_t i = 0; i < widths.size(); ++i) widths[i] = std::string(kDeviceColumns[i]).size();
  for (const auto& found : devices) {
    rows.push_back(device_row(found));
    const auto cells = cells_of(rows.back());
    for (std::size_t i = 0; i < widths.size(); ++i) widths[i] = std::max(widths[i], cells[i].size());
  }
  const auto print_line = [&widths](const auto& cells) {
    std::string line;
    for (std::size_t i = 0; i < widths.size(); ++i) {
      const std::string cell = cells[i];
      line += cell + std::string(widths[i] + 2 - cell.size(), ' ');
    }
    std::cout << line.substr(0, line.find_last_not_of(' ') + 1) << "\n";
  };
  print_line(kDeviceColumns);
  for (const DeviceRow& row : rows) {
    print_line(cells_of(row));
    if (!row.trouble.empty()) std::cout << "    " << row.trouble << "\n";
  }
}

}  // namespace

void add_devices_command(CLI::App& app, int& exit_code) {
  CLI::App* command =
      app.add_subcommand("devices", "List what is plugged in, what it can do, and what is missing to use it");
  auto json = std::make_shared<bool>(false);
  command->add_flag("--json", *json, "The list as JSON");
  command->callback([json, &exit_code] {
    const auto devices = device::find_devices();
    if (*json)
      print_json(devices);
    else
      print_table(devices);
    exit_code = 0;
  });
}

}  // namespace vallecula::gui
