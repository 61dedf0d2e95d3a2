#include "gui/authoring/text_field.h"

#include <QHBoxLayout>
#include <QInputDialog>
#include <QLabel>
#include <QLocale>
#include <QPlainTextEdit>
#include <QRegularExpression>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QTabBar>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "gui/report/markdown.h"

namespace vallecula::gui {

namespace {

QString language_name(const QString& code) {
  const QLocale locale(code);
  const QString name = QLocale::languageToString(locale.language());
  return locale.language() == QLocale::C ? code : name + " (" + code + ")";
}

}  // namespace

TextField::TextField(const QString& name, QWidget* parent) : QWidget(parent) {
  languages_ = new QTabBar(this);
  languages_->setExpanding(false);
  languages_->setAccessibleName(tr("%1: language").arg(name));
  add_ = new QToolButton(this);
  add_->setText(tr("Add a language ..."));
  connect(add_, &QToolButton::clicked, this, &TextField::add_language);
  remove_ = new QToolButton(this);
  remove_->setText(tr("Remove it"));
  connect(remove_, &QToolButton::clicked, this, &TextField::remove_language);
  editor_ = new QPlainTextEdit(this);
  editor_->setObjectName("text");
  editor_->setAccessibleName(name);
  editor_->setTabChangesFocus(true);
  setFocusProxy(editor_);
  editor_->setMinimumHeight(90);
  preview_ = new QLabel(this);
  preview_->setWordWrap(true);
  preview_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  preview_->setTextInteractionFlags(Qt::NoTextInteraction);
  preview_->setToolTip(tr("As the trainee will read it"));
  auto* seen = new QScrollArea(this);
  seen->setWidget(preview_);
  seen->setWidgetResizable(true);
  seen->setFocusPolicy(Qt::NoFocus);
  seen->setFrameShape(QFrame::NoFrame);
  auto* head = new QHBoxLayout;
  head->addWidget(languages_);
  head->addWidget(add_);
  head->addWidget(remove_);
  head->addStretch(1);
  auto* seen_title = new QLabel(tr("As the trainee reads it"), this);
  seen_title->setObjectName("faint");
  head->addWidget(seen_title);
  auto* row = new QHBoxLayout;
  row->addWidget(editor_, 1);
  row->addWidget(seen, 1);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addLayout(head);
  column->addLayout(row);
  connect(languages_, &QTabBar::currentChanged, this, &TextField::show_language);
  connect(editor_, &QPlainTextEdit::textChanged, this, [this] {
    const int tab = languages_->currentIndex();
    if (tab < 0) return;
    texts_[static_cast<std::size_t>(tab)].second = editor_->toPlainText();
    preview();
    emit edited();
  });
}

void TextField::show_value(const curricula::YamlNode* value) {
  std::vector<std::pair<QString, QString>> texts;
  if (value != nullptr && value->kind == curricula::YamlNode::Kind::group) {
    for (const auto& one : value->children)
      texts.emplace_back(QString::fromStdString(one.key), QString::fromStdString(one.value));
  } else {
    texts.emplace_back("en", value == nullptr ? QString() : QString::fromStdString(value->value));
  }
  if (texts.empty()) texts.emplace_back("en", QString());  // a group with nothing in it
  ends_with_newline_ = texts[0].second.endsWith('\n');
  for (auto& [code, text] : texts)
    if (text.endsWith('\n')) text.chop(1);
  const bool same_languages = std::equal(texts.begin(), texts.end(), texts_.begin(), texts_.end(),
                                         [](const auto& a, const auto& b) { return a.first == b.first; });
  texts_ = std::move(texts);
  if (!same_languages) {
    const QSignalBlocker quiet(languages_);
    const int tab = std::max(0, languages_->currentIndex());
    while (languages_->count() > 0) languages_->removeTab(0);
    for (const auto& [code, text] : texts_) languages_->addTab(language_name(code));
    languages_->setCurrentIndex(std::min(tab, languages_->count() - 1));
  }
  show_language(languages_->currentIndex());
}

void TextField::show_language(int tab) {
  if (tab < 0 || tab >= static_cast<int>(texts_.size())) return;
  const auto& [code, text] = texts_[static_cast<std::size_t>(tab)];
  remove_->setVisible(code != "en" && texts_.size() > 1);
  if (editor_->toPlainText() != text) {
    const QSignalBlocker quiet(editor_);
    editor_->setPlainText(text);
  }
  preview();
}

void TextField::preview() {
  const int tab = languages_->currentIndex();
  if (tab >= 0) preview_->setText(html_of(curricula::Text(texts_[static_cast<std::size_t>(tab)].second.toStdString())));
}

void TextField::add_language() {
  bool given = false;
  const QString code = QInputDialog::getText(this, tr("Add a language"), tr("Its code, like de, fr or pt-BR:"),
                                             QLineEdit::Normal, {}, &given)
                           .trimmed();
  static const QRegularExpression pattern("^[a-z]{2}(-[A-Z]{2})?$");
  const bool known = std::any_of(texts_.begin(), texts_.end(), [&](const auto& one) { return one.first == code; });
  if (!given || known || !pattern.match(code).hasMatch()) return;
  texts_.emplace_back(code, texts_[0].second);  // to be translated where it stands
  {
    const QSignalBlocker quiet(languages_);
    languages_->setCurrentIndex(languages_->addTab(language_name(code)));
  }
  show_language(languages_->currentIndex());
  emit edited();
}

void TextField::remove_language() {
  const int tab = languages_->currentIndex();
  if (tab < 0 || texts_.size() < 2 || texts_[static_cast<std::size_t>(tab)].first == "en") return;
  texts_.erase(texts_.begin() + tab);
  {
    const QSignalBlocker quiet(languages_);
    languages_->removeTab(tab);
  }
  show_language(languages_->currentIndex());
  emit edited();
}

QString TextField::ended(const QString& text) const {
  return ends_with_newline_ && !text.isEmpty() ? text + "\n" : text;
}

curricula::YamlNode TextField::value() const {
  if (texts_.size() == 1 && texts_[0].first == "en") return curricula::yaml_text(ended(texts_[0].second).toStdString());
  std::vector<std::pair<std::string, curricula::YamlNode>> group;
  for (const auto& [code, text] : texts_)
    group.emplace_back(code.toStdString(), curricula::yaml_text(ended(text).toStdString()));
  return curricula::yaml_group(std::move(group));
}

}  // namespace vallecula::gui
