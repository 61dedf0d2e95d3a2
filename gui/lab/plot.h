// A figure of the laboratory on one sheet: pictures with captions, line plots with axes and units, and what is seen.
#pragma once

#include <QColor>
#include <QImage>
#include <QString>
#include <filesystem>
#include <functional>
#include <vector>

namespace vallecula::gui {

struct PlotLine {
  QString name;  ///< in the legend; empty: not there
  QColor colour;
  std::vector<double> x, y;  ///< a value that is not finite breaks the line
  double width = 0.16;       ///< of a letter's height
  Qt::PenStyle style = Qt::SolidLine;
};

/// A horizontal line with its meaning written on it.
struct PlotLevel {
  double value = 0.0;
  QString text;
  QColor colour;
};

struct PlotPanel {
  QString axis;  ///< what and in which unit
  std::vector<PlotLine> lines;
  std::vector<PlotLevel> levels;
  double high = 0.0;    ///< 0: from the lines and levels; what lies above is cut off at the frame
  double low = 0.0;     ///< the axis begins here; logarithmic ones need it above 0
  double weight = 1.0;  ///< share of the sheet's height
  bool logarithmic = false;
};

/// A span of time with its name, shaded in all panels.
struct PlotSpan {
  double from = 0.0, to = 0.0;
  QString text;
};

/// Panels over one horizontal axis from 0.
struct Plot {
  QString x_axis;
  double x_end = 1.0;
  std::vector<PlotPanel> panels;
  std::vector<PlotSpan> spans;
};

struct SheetPicture {
  QImage image;
  QString caption;
};

struct SheetKey {
  QColor colour;
  QString text;
};

/// A bar of colours with its numbers.
struct ColourScale {
  QString title;
  double low = 0.0, high = 0.0;
};

struct Sheet {
  QString title;
  std::vector<SheetPicture> pictures;  ///< side by side, all of one size
  std::vector<SheetKey> keys;          ///< what the pictures' colours mean
  ColourScale scale;                   ///< without a title: none
  Plot plot;                           ///< without panels: none
  double plot_height = 0.0;            ///< pixels
  QString seen;                        ///< what is to be seen, in words, at the bottom
};

/// The scale's colour of a share 0..1: dark blue over green to yellow, told apart in grey too.
QColor scale_colour(double share);

/// Black on white, `width` pixels wide, as high as it needs. Needs a QGuiApplication for its fonts.
QImage draw_sheet(const Sheet& sheet, int width = 1600);

/// Throws std::runtime_error naming the file when it cannot be written.
void write_png(const std::filesystem::path& file, const QImage& image);

/// A number as it is said in a text: three significant digits.
QString said(double value);

}  // namespace vallecula::gui
