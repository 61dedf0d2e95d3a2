#include "gui/report/pdf_pages.h"

#include <QAbstractTextDocumentLayout>
#include <QBuffer>
#include <QFontMetricsF>
#include <QPainter>
#include <QPdfWriter>
#include <QTextDocument>
#include <QUrl>
#include <stdexcept>

#include "gui/session/files.h"

namespace vallecula::gui {
namespace {

constexpr double kSideMm = 19.0, kTopMm = 14.0, kBottomMm = 14.0;
constexpr double kHeadMm = 9.0, kFootMm = 11.0;  ///< kept free of the text
constexpr int kDotsPerInch = 300;
constexpr double kMmPerInch = 25.4;

constexpr const char* kFoot =
    "Vallecula is a training tool, not a medical device. Targets and limits are training targets, not injury "
    "thresholds; no pass mark is validated.";

}  // namespace

void write_pdf(const std::filesystem::path& file, const PdfPages& pages) {
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  {
    QPdfWriter writer(&buffer);
    writer.setResolution(kDotsPerInch);
    writer.setPageSize(QPageSize(QPageSize::A4));
    writer.setPageMargins(QMarginsF(kSideMm, kTopMm, kSideMm, kBottomMm), QPageLayout::Millimeter);
    writer.setTitle(pages.title);
    writer.setCreator("Vallecula");
    const double mm = kDotsPerInch / kMmPerInch;
    const QSizeF body(writer.width(), writer.height() - (kHeadMm + kFootMm) * mm);

    QTextDocument document;
    document.documentLayout()->setPaintDevice(&writer);
    QFont font("DejaVu Sans");
    font.setPointSizeF(8.5);
    document.setDefaultFont(font);
    document.setDocumentMargin(0.0);
    QString html = pages.html;
    for (const auto& [name, picture] : pages.pictures) {
      document.addResource(QTextDocument::ImageResource, QUrl(name), picture);
      // With its height: a screen's own resolution would else stretch it.
      const QString source = "src=\"" + name + "\"";
      html.replace(source, source + QString(" height=\"%1\"").arg(kPdfWidthPx * picture.height() / picture.width()));
    }
    document.setHtml(html);
    document.setPageSize(body);

    QPainter painter(&writer);
    if (!painter.isActive()) throw std::runtime_error(file.string() + ": the PDF could not be begun");
    QFont small = font;
    small.setPointSizeF(7.0);
    const int count = document.pageCount();
    for (int page = 0; page < count; ++page) {
      if (page > 0 && !writer.newPage()) throw std::runtime_error(file.string() + ": a page of the PDF could not be begun");
      painter.setFont(small);
      painter.setPen(QColor(0x55, 0x55, 0x55));
      const QRectF head(0, 0, writer.width(), 5.0 * mm);
      painter.drawText(head, Qt::AlignLeft | Qt::AlignTop, pages.title);
      painter.drawText(head, Qt::AlignRight | Qt::AlignTop, pages.person);
      painter.drawLine(QPointF(0, 5.5 * mm), QPointF(writer.width(), 5.5 * mm));
      const QRectF foot(0, writer.height() - 7.5 * mm, writer.width(), 7.5 * mm);
      const double number_width = 24.0 * mm;
      painter.drawText(foot.adjusted(0, 0, -number_width, 0), Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap, kFoot);
      painter.drawText(foot, Qt::AlignRight | Qt::AlignTop, QString("Page %1 of %2").arg(page + 1).arg(count));
      painter.save();
      painter.translate(0.0, kHeadMm * mm - page * body.height());
      // Not drawContents(): that takes the application's palette, and the window's text is light on dark.
      QAbstractTextDocumentLayout::PaintContext ink;
      ink.palette.setColor(QPalette::Text, Qt::black);
      ink.clip = QRectF(QPointF(0, page * body.height()), body);
      painter.setClipRect(ink.clip);
      document.documentLayout()->draw(&painter, ink);
      painter.restore();
    }
  }
  write_file_whole(file, bytes.toStdString());
}

}  // namespace vallecula::gui
