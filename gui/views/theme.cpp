#include "gui/views/theme.h"

#include <QAbstractScrollArea>
#include <QApplication>
#include <QFont>
#include <QLabel>
#include <QPalette>
#include <QRegularExpression>
#include <QStyle>
#include <algorithm>
#include <array>
#include <cstring>

#include "gui/views/window_style.h"

namespace vallecula::gui::theme {
namespace {

struct Colours {
  QColor ground, panel, track, text, faint, within, over, target, device, bad, accent, new_line, gone_line;
};

/// A colour of the style sheet, on each ground.
struct Shade {
  const char *name, *dark, *light;
};

const Colours kDark{{22, 26, 31},   {31, 36, 43},  {52, 58, 67},   {232, 236, 240}, {150, 158, 168},
                    {0, 158, 115},  {230, 159, 0}, {240, 228, 66}, {86, 180, 233},  {213, 94, 0},
                    {58, 130, 200}, {23, 74, 60},  {90, 45, 18}};
// The same hues, dark enough to be read on white (4.5 to 1 where they colour text: WCAG 2.1, 1.4.3).
const Colours kLight{{238, 241, 244}, {255, 255, 255}, {209, 215, 222}, {24, 29, 35},  {86, 95, 106},
                     {0, 121, 90},    {150, 94, 0},    {122, 104, 0},   {0, 104, 158}, {176, 66, 0},
                     {28, 98, 168},   {205, 236, 224}, {246, 221, 204}};

constexpr std::array<Shade, 24> kShades{{{"panel", "#1f242b", "#ffffff"},
                                         {"dialog", "#1d2228", "#f5f7f9"},
                                         {"dialog-edge", "#7d8896", "#7f8a96"},
                                         {"off", "#262b32", "#e6e9ed"},
                                         {"head", "#262c34", "#e1e6eb"},
                                         {"grid", "#2b323b", "#e1e6eb"},
                                         {"chosen", "#2f5f8c", "#1c62a8"},
                                         {"chosen-text", "#ffffff", "#ffffff"},
                                         {"primary", "#2f78ba", "#1c62a8"},
                                         {"accent", "#3a82c8", "#1c62a8"},
                                         {"primary-lit", "#3a88cc", "#2f78ba"},
                                         {"primary-off", "#2a3b4b", "#c3d3e2"},
                                         {"primary-off-text", "#7f8892", "#667482"},
                                         {"track", "#343a43", "#d1d7de"},
                                         {"button", "#343b45", "#f7f9fa"},
                                         {"line", "#3a424d", "#b9c2cc"},
                                         {"button-lit", "#3f4854", "#e3ebf3"},
                                         {"edge", "#4a535f", "#9aa5b1"},
                                         {"focus", "#56b4e9", "#0068ba"},
                                         {"focus-on-primary", "#bfe3fb", "#08243e"},
                                         {"off-text", "#69717b", "#8a949f"},
                                         {"down", "#1d5f4c", "#00795a"},
                                         {"down-edge", "#009e73", "#005c44"},
                                         {"faint", "#969ea8", "#565f6a"}}};

const char* const kSheet = R"(
    QDialog { background: @dialog@; border: 1px solid @dialog-edge@; }
    QPushButton { color: @text@; background: @button@; border: 1px solid @edge@; border-radius: 5px; padding: 7px 16px; }
    QPushButton:hover { background: @button-lit@; }
    QPushButton:focus { border: 1px solid @focus@; }
    QPushButton:disabled { background: @off@; color: @off-text@; border-color: @button@; }
    QPushButton#primary { color: white; background: @primary@; border-color: @accent@; font-weight: bold; }
    QPushButton#primary:hover { background: @primary-lit@; }
    QPushButton#primary:disabled { background: @primary-off@; color: @primary-off-text@; border-color: @button@; }
    QPushButton[role="choice"] { border-radius: 9px; }
    QPushButton[role="first-choice"] { background: @primary@; border-color: @accent@; border-radius: 9px; }
    QPushButton[role="first-choice"]:hover { background: @primary-lit@; }
    QPushButton[role="first-choice"]:focus { border: 2px solid @focus-on-primary@; }
    QPushButton[role="first-choice"] QLabel { color: white; }
    QPushButton:pressed { color: white; background: @down@; border-color: @down-edge@; }
    QPushButton:checked { color: white; background: @down@; border-color: @down-edge@; }
    QToolButton { background: @button@; border: 1px solid @edge@; border-radius: 5px; padding: 5px 10px; }
    QToolButton:hover { background: @button-lit@; }
    QToolButton:focus { border: 1px solid @focus@; }
    QToolButton:checked { background: @chosen@; border-color: @focus@; color: @chosen-text@; }
    QToolButton:disabled { background: @off@; color: @off-text@; border-color: @button@; }
    QToolButton[role="section"], QToolButton[role="section"]:checked { background: transparent; border: none; font-weight: bold; padding: 4px 0; color: @text@; }
    QToolButton[role="section"]:focus { color: @focus@; }
    QCheckBox::indicator:unchecked, QTreeView::indicator:unchecked { background: @panel@; border: 1px solid @faint@; border-radius: 3px; }
    QCheckBox::indicator:unchecked:focus { border-color: @focus@; }
    QCheckBox::indicator:unchecked:disabled { border-color: @edge@; }
    QRadioButton::indicator { width: 13px; height: 13px; border-radius: 7px; border: 1px solid @faint@; background: @panel@; }
    QRadioButton::indicator:checked { width: 9px; height: 9px; background: @focus@; border: 3px solid @panel@; }
    QRadioButton::indicator:focus { border-color: @focus@; }
    QLineEdit { background: @panel@; border: 1px solid @line@; border-radius: 4px; padding: 4px; }
    QLineEdit:focus { border: 1px solid @focus@; }
    QAbstractSpinBox QLineEdit { border: none; padding: 1px; }
    QTableView, QTreeView { background: @panel@; border: 1px solid @line@; border-radius: 5px; gridline-color: @grid@; }
    QTableView::item { padding: 3px 6px; border: 0; }
    QTreeView::item { padding: 3px; }
    QTableView::item:selected, QTreeView::item:selected { background: @chosen@; color: @chosen-text@; }
    QHeaderView::section { background: @head@; border: none; border-right: 1px solid @line@; padding: 4px 6px; }
    QTabWidget::pane { border: none; }
    QTabBar::tab { background: @head@; padding: 6px 14px; border-top-left-radius: 5px; border-top-right-radius: 5px; margin-right: 2px; }
    QTabBar::tab:selected { background: @chosen@; color: @chosen-text@; }
    QListWidget, QTextBrowser { background: @panel@; border: 1px solid @line@; border-radius: 5px; padding: 4px; }
    QComboBox QLineEdit, QComboBox QLineEdit:focus { background: transparent; border: none; padding: 1px; }
    QCalendarWidget QWidget#qt_calendar_navigationbar { background: @head@; }
    QCalendarWidget QToolButton { color: @text@; }
    QComboBox QAbstractItemView { background: @panel@; color: @text@; border: 1px solid @line@; border-radius: 0; padding: 1px; selection-background-color: @chosen@; selection-color: @chosen-text@; }
    QListWidget::item { padding: 9px 8px; border-radius: 4px; }
    QListWidget::item:selected { background: @chosen@; color: @chosen-text@; }
    QLabel#title { font-size: @19pt@; font-weight: bold; }
    QLabel#heading { font-size: @12pt@; font-weight: bold; }
    QLabel#faint, QLabel[role="faint"] { color: @faint@; }
    QLabel[role="figure"] { font-size: @22pt@; font-weight: bold; }
    QLabel[role="warning"] { color: @over@; }
    QLabel[role="good"] { color: @within@; }
    QFrame#panel { background: @panel@; border-radius: 7px; }
    QDockWidget { font-weight: bold; }
    QDockWidget::title { background: transparent; padding: 3px 2px; text-align: left; }
    QMainWindow::separator { background: transparent; width: 6px; height: 4px; }
    QProgressBar { background: @track@; border: none; border-radius: 5px; height: 14px; text-align: center; }
    QProgressBar::chunk { background: @accent@; border-radius: 5px; }
  )";

/// What scrolls measures all it holds as soon as its style changes, a hidden page's whole form too: a third of what a
/// new look costs. While this lives, a scrolled view that nobody sees is spared; it measures when it is shown.
class MeasuredWhenSeen : public QObject {
 public:
  MeasuredWhenSeen() { qApp->installEventFilter(this); }
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (event->type() != QEvent::StyleChange) return false;
    auto* scrolled = qobject_cast<QAbstractScrollArea*>(watched);
    const QWidget* around = scrolled == nullptr ? nullptr : scrolled->parentWidget();
    // What is hidden on a page that is seen, as a table's numbers of rows, may never be shown and is measured all the
    // same.
    if (scrolled == nullptr || scrolled->isVisible() || (around != nullptr && around->isVisible())) return false;
    static OnceShown once_shown;
    scrolled->installEventFilter(&once_shown);  // once, however often the look changes meanwhile
    return true;
  }

 private:
  struct OnceShown : QObject {
    bool eventFilter(QObject* watched, QEvent* event) override {
      if (event->type() != QEvent::Show) return false;
      watched->removeEventFilter(this);
      QEvent style(QEvent::StyleChange);
      QApplication::sendEvent(watched, &style);
      return false;
    }
  };
};

Look applied;
const Colours* colours = &kDark;

constexpr const char *kOwnSheet = "theme_sheet", *kOwnWidth = "theme_width", *kOwnHeight = "theme_height";

/// The look's colours and sizes in their places: "@over@", "@19pt@" (of a text scale of one).
QString filled(QString sheet) {
  for (const Shade& shade : kShades)
    sheet.replace('@' + QString(shade.name) + '@', applied.ground == Ground::dark ? shade.dark : shade.light);
  for (const auto& [name, colour] : {std::pair{"text", colours->text},
                                     {"over", colours->over},
                                     {"bad", colours->bad},
                                     {"within", colours->within},
                                     {"device", colours->device}})
    sheet.replace('@' + QString(name) + '@', colour.name());
  static const QRegularExpression size("@(\\d+)pt@");
  for (auto found = size.match(sheet); found.hasMatch(); found = size.match(sheet))
    sheet.replace(found.capturedStart(), found.capturedLength(),
                  QString("%1pt").arg(points(found.captured(1).toDouble()), 0, 'f', 1));
  return sheet;
}

/// A link keeps the colour it was read with, and a widget the sheet and the size it was given.
void bring_along(QWidget& widget) {
  if (const QVariant own = widget.property(kOwnSheet); own.isValid()) widget.setStyleSheet(filled(own.toString()));
  if (const QVariant wide = widget.property(kOwnWidth); wide.isValid()) keep_wide(widget, wide.toInt());
  if (const QVariant high = widget.property(kOwnHeight); high.isValid()) keep_high(widget, high.toInt());
  auto* label = qobject_cast<QLabel*>(&widget);
  if (label == nullptr || !label->text().contains("<a ")) return;
  const QString text = label->text();
  label->clear();
  label->setText(text);
}

}  // namespace

const QColor& ground() { return colours->ground; }
const QColor& panel() { return colours->panel; }
const QColor& track() { return colours->track; }
const QColor& text() { return colours->text; }
const QColor& faint() { return colours->faint; }
const QColor& within() { return colours->within; }
const QColor& over() { return colours->over; }
const QColor& target() { return colours->target; }
const QColor& device() { return colours->device; }
const QColor& bad() { return colours->bad; }
const QColor& accent() { return colours->accent; }
const QColor& new_line() { return colours->new_line; }
const QColor& gone_line() { return colours->gone_line; }
double points(double at_scale_one) { return at_scale_one * applied.text_scale; }
const Look& look() { return applied; }
QColor shade(const char* name) {
  for (const Shade& one : kShades)
    if (std::strcmp(one.name, name) == 0) return applied.ground == Ground::dark ? one.dark : one.light;
  return Qt::black;
}

void dress(QWidget& widget, const QString& sheet) {
  widget.setProperty(kOwnSheet, sheet);
  widget.setStyleSheet(filled(sheet));
}

void keep_wide(QWidget& widget, int pixels) {
  widget.setProperty(kOwnWidth, pixels);
  widget.setFixedWidth(static_cast<int>(points(pixels)));
}

void keep_high(QWidget& widget, int pixels) {
  widget.setProperty(kOwnHeight, pixels);
  widget.setFixedHeight(static_cast<int>(points(pixels)));
}

QColor of_this_ground(const QColor& colour) {
  const Colours& other = colours == &kDark ? kLight : kDark;
  for (const auto part : {&Colours::text, &Colours::faint, &Colours::within, &Colours::over, &Colours::target,
                          &Colours::device, &Colours::bad, &Colours::accent})
    if (other.*part == colour) return colours->*part;
  return colour;
}

QImage of_this_ground(const QImage& on_paper) {
  if (applied.ground == Ground::light) return on_paper;
  QImage image = on_paper.convertToFormat(QImage::Format_RGB32);
  const QColor& paper = panel();
  // White becomes the panel's colour and not black.
  const auto between = [](int value, int paper) { return paper + value * (255 - paper) / 255; };
  for (int y = 0; y < image.height(); ++y) {
    auto* line = reinterpret_cast<QRgb*>(image.scanLine(y));
    for (int x = 0; x < image.width(); ++x) {
      const int red = qRed(line[x]), green = qGreen(line[x]), blue = qBlue(line[x]);
      // To each channel alike: of hue, saturation and lightness only the last changes, to one less itself.
      const int turn = 255 - std::max({red, green, blue}) - std::min({red, green, blue});
      line[x] = qRgb(between(red + turn, paper.red()), between(green + turn, paper.green()),
                     between(blue + turn, paper.blue()));
    }
  }
  return image;
}

void apply(QApplication& application, const Look& look) {
  applied = {look.ground, std::clamp(look.text_scale, kLeastTextScale, kMostTextScale)};
  colours = applied.ground == Ground::dark ? &kDark : &kLight;
  const MeasuredWhenSeen spared;
  // Without a style sheet the others are laid under every widget of every page in a tenth of the time, and a sheet put
  // on where there is none touches only what has been seen.
  application.setStyleSheet({});
  if (qobject_cast<WindowStyle*>(application.style()) == nullptr) application.setStyle(new WindowStyle);
  QPalette palette;
  palette.setColor(QPalette::Window, ground());
  palette.setColor(QPalette::WindowText, text());
  palette.setColor(QPalette::Base, panel());
  palette.setColor(QPalette::AlternateBase, ground());
  palette.setColor(QPalette::Text, text());
  palette.setColor(QPalette::Button, panel());
  palette.setColor(QPalette::ButtonText, text());
  palette.setColor(QPalette::ToolTipBase, panel());
  palette.setColor(QPalette::ToolTipText, text());
  palette.setColor(QPalette::Highlight, accent());
  palette.setColor(QPalette::HighlightedText, Qt::white);
  for (const auto role : {QPalette::Link, QPalette::LinkVisited}) palette.setColor(role, device());
  const QColor off = applied.ground == Ground::dark ? faint().darker(130) : faint().lighter(150);
  palette.setColor(QPalette::Disabled, QPalette::ButtonText, off);
  palette.setColor(QPalette::Disabled, QPalette::WindowText, off);
  palette.setColor(QPalette::Disabled, QPalette::Text, off);
  palette.setColor(QPalette::Disabled, QPalette::Light, panel());  // no second, brighter copy beneath a menu's words
  application.setPalette(palette);
  QFont font("DejaVu Sans");
  font.setPointSizeF(points(10.0));
  application.setFont(font);
  application.setStyleSheet(filled(kSheet));
  for (QWidget* widget : QApplication::allWidgets()) bring_along(*widget);
}

}  // namespace vallecula::gui::theme
