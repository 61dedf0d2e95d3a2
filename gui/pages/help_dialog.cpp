#include "gui/pages/help_dialog.h"

#include <QDialogButtonBox>
#include <QFile>
#include <QHBoxLayout>
#include <QImage>
#include <QListWidget>
#include <QResizeEvent>
#include <QScrollBar>
#include <QTextBrowser>
#include <QTextStream>
#include <QTimer>
#include <QUrl>
#include <QVBoxLayout>
#include <algorithm>
#include <map>

#include "gui/session/languages.h"
#include "gui/views/theme.h"

/// The files lie in a static library: without this the linker leaves them out. Must not stand in a namespace.
static void reach_help() { Q_INIT_RESOURCE(help); }

namespace vallecula::gui {
namespace {

/// In the window's language where somebody has written it, else in English.
QString file_of(const QString& chapter) {
  const QString ours = ":/help/" + language() + '/' + chapter + ".md";
  return QFile::exists(ours) ? ours : ":/help/" + chapter + ".md";
}

/// A chapter's first line is its heading.
QString title_of(const QString& chapter) {
  QFile file(file_of(chapter));
  if (!file.open(QIODevice::ReadOnly | QIODevice::Text)) return chapter;
  QTextStream text(&file);
  text.setCodec("UTF-8");
  return text.readLine().mid(2);
}

/// Its pictures are no wider than it is.
class HelpText : public QTextBrowser {
 public:
  explicit HelpText(QWidget* parent) : QTextBrowser(parent) {
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn);  // else it comes and goes with the pictures' height
    soon_.setSingleShot(true);
    soon_.setInterval(0);  // never while a text is being read in, which itself makes the view narrower
    connect(&soon_, &QTimer::timeout, this, [this] {
      if (scaled_to_ == viewport()->width()) return;
      const int at = verticalScrollBar()->value();
      reload();
      verticalScrollBar()->setValue(at);
    });
  }

 protected:
  QVariant loadResource(int type, const QUrl& name) override {
    const QVariant found = QTextBrowser::loadResource(type, name);
    if (type != QTextDocument::ImageResource) return found;
    const QImage picture =
        found.type() == QVariant::ByteArray ? QImage::fromData(found.toByteArray()) : found.value<QImage>();
    scaled_to_ = viewport()->width();
    const int room = scaled_to_ - static_cast<int>(2.0 * document()->documentMargin());
    return picture.width() <= room ? picture : picture.scaledToWidth(std::max(1, room), Qt::SmoothTransformation);
  }
  void resizeEvent(QResizeEvent* event) override {
    QTextBrowser::resizeEvent(event);
    if (scaled_to_ != viewport()->width()) soon_.start();
  }

 private:
  QTimer soon_;
  int scaled_to_ = 0;  ///< px: the width that the pictures were made for
};

}  // namespace

QStringList help_chapters() {
  reach_help();
  return {"first-laryngoscopy", "trial-page", "score",          "import", "courses", "records",
          "instructor",         "devices",    "troubleshooting"};
}

QString help_chapter_of(const QString& page) {
  static const std::map<QString, QString> chapters = {{"home", "first-laryngoscopy"},
                                                      {"start", "courses"},
                                                      {"records", "records"},
                                                      {"devices", "devices"},
                                                      {"import", "import"},
                                                      {"authoring", "courses"},
                                                      {"trial", "trial-page"},
                                                      {"rating", "score"},
                                                      {"result", "score"},
                                                      {"replay", "score"},
                                                      {"prepare", "troubleshooting"}};
  const auto found = chapters.find(page);
  return found == chapters.end() ? help_chapters().front() : found->second;
}

HelpDialog::HelpDialog(QWidget* parent) : QDialog(parent) {
  setWindowTitle(tr("Help"));
  list_ = new QListWidget(this);
  list_->setObjectName("chapters");
  list_->setAccessibleName(tr("Chapters"));
  for (const QString& chapter : help_chapters()) {
    auto* item = new QListWidgetItem(title_of(chapter), list_);
    item->setData(Qt::UserRole, chapter);
  }
  theme::keep_wide(*list_, 230);
  list_->setWordWrap(true);
  text_ = new HelpText(this);
  text_->setObjectName("help_text");
  text_->setAccessibleName(tr("Text of the chapter"));
  text_->setOpenExternalLinks(true);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* columns = new QHBoxLayout;
  columns->addWidget(list_);
  columns->addWidget(text_, 1);
  auto* all = new QVBoxLayout(this);
  all->addLayout(columns, 1);
  all->addWidget(buttons);
  connect(list_, &QListWidget::currentItemChanged, this, [this](const QListWidgetItem* item) {
    if (item != nullptr)
      text_->setSource(QUrl("qrc" + file_of(item->data(Qt::UserRole).toString())), QTextDocument::MarkdownResource);
  });
  resize(1040, 720);
}

void HelpDialog::show_chapter(const QString& name) {
  for (int row = 0; row < list_->count(); ++row)
    if (list_->item(row)->data(Qt::UserRole).toString() == name) list_->setCurrentRow(row);
}

QString HelpDialog::chapter() const {
  return list_->currentItem() == nullptr ? QString() : list_->currentItem()->data(Qt::UserRole).toString();
}

}  // namespace vallecula::gui
