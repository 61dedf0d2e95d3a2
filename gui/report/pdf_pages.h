// HTML on A4 pages as a PDF file.
#pragma once

#include <QImage>
#include <QString>
#include <filesystem>
#include <map>

namespace vallecula::gui {

struct PdfPages {
  QString title;   ///< of the document, and on the left above every page
  QString person;  ///< on the right above every page; empty: nobody is named
  QString html;    ///< what QTextDocument knows of it
  std::map<QString, QImage> pictures;  ///< by the name in <img src="...">; widths in the HTML are of 96 to the inch
};

/// The width between the margins in the HTML's pixels.
constexpr int kPdfWidthPx = 650;

/// Written whole; with page numbers, and below every page that no target is an injury threshold and no pass mark
/// validated. Needs a QGuiApplication (fonts). Throws std::runtime_error naming the file.
void write_pdf(const std::filesystem::path& file, const PdfPages& pages);

}  // namespace vallecula::gui
