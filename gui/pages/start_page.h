// The first page: which scenario, on which patient, with which device.
#pragma once

#include <QWidget>
#include <filesystem>
#include <memory>
#include <vector>

#include "curricula/scenario.h"
#include "device/found_devices.h"

class QComboBox;
class QDialog;
class QLabel;
class QListWidget;
class QPushButton;

namespace vallecula::gui {

struct Choice {
  std::filesystem::path curriculum;
  curricula::Scenario scenario;
  std::filesystem::path patient;  ///< empty: the built-in manikin that the scenario asks for
  QString device;                 ///< as `vallecula trial --device` takes it
  curricula::ToolChoice taken;    ///< of what the scenario offers
  QString second;                 ///< as `--second`, of a scenario with a tube; empty: what goes with the device
};

class StartPage : public QWidget {
  Q_OBJECT
 public:
  explicit StartPage(QWidget* parent = nullptr);
  /// Replaces the curricula, the first is shown; keeps the last choice where it is still to be had.
  void set_curricula(std::vector<curricula::Curriculum> curricula);
  void add_patient(const std::filesystem::path& package, bool choose);
  /// Offers what is plugged in beside what is always there; what is gone is no longer offered, unless it is chosen.
  void set_found_devices(const std::vector<device::FoundDevice>& devices);
  /// Offers this device and chooses it.
  void choose_device(const QString& name, const QString& label);
  void set_message(const QString& message);
  /// The first scenario of this id, in whichever curriculum, and the device; false where one of them is not to be had.
  bool select(const QString& scenario, const QString& device);
  Choice choice() const;
  /// Patient and devices of the choice alone, whatever the scenario.
  Choice hands() const;

 signals:
  void chosen(const vallecula::gui::Choice& choice);
  void import_wanted();
  void devices_wanted();
  void courses_wanted();

 private:
  void show_curriculum(int index);
  void show_scenario(int row);
  const curricula::Scenario* scenario_at(int row) const;  ///< of the curriculum shown; null: none
  void browse();
  void offer(const curricula::Scenario& scenario);  ///< blades and tubes to choose from, where there are any
  void allow_start();  ///< nothing that is to be chosen is open
  /// Of the chosen device, as it was last found; null: it was not, or has none.
  std::unique_ptr<QDialog> device_settings();
  std::vector<curricula::Curriculum> curricula_;
  std::vector<device::FoundDevice> found_{device::found_mouse()};  ///< looked for elsewhere: it may take seconds
  QListWidget* list_;
  QLabel *briefing_, *message_, *second_label_, *blade_label_, *tube_label_;
  QComboBox *curriculum_, *patient_, *device_, *second_, *blade_, *tube_;
  QPushButton* go_;
};

}  // namespace vallecula::gui
