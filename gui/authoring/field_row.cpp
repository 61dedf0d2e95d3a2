#include "gui/authoring/field_row.h"

#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <QWheelEvent>

#include "gui/authoring/number_box.h"
#include "gui/authoring/text_field.h"
#include "gui/session/words_from_below.h"
#include "gui/views/capitalised.h"
#include "gui/views/theme.h"

namespace vallecula::gui {

using curricula::FieldRule;
using curricula::YamlNode;
using Kind = curricula::FieldRule::Kind;

namespace {

constexpr int kLabelWidth = 210;
constexpr double kLeastHint = 210.0;  // pixels at a text scale of one

/// A wheel over a closed list scrolls the form.
class WordBox : public QComboBox {
 public:
  explicit WordBox(QWidget* parent) : QComboBox(parent) { setFocusPolicy(Qt::StrongFocus); }

 protected:
  void wheelEvent(QWheelEvent* event) override { event->ignore(); }
};

QString text_of(const YamlNode* value) { return value == nullptr ? QString() : QString::fromStdString(value->value); }

QString remark(const FieldRule& rule) {
  QStringList parts;
  if (!rule.allowed().isEmpty() && rule.kind != Kind::text) parts << in_words(rule.allowed().toStdString());
  if (!rule.help.isEmpty()) parts << rule.help;
  if (!rule.left_out.isEmpty()) parts << QCoreApplication::translate("FieldRow", "left out: %1").arg(rule.left_out);
  return parts.join("; ");
}

}  // namespace

FieldRow::FieldRow(const FieldRule& rule, const QString& path, const QStringList& choices, QWidget* parent)
    : QWidget(parent), rule_(rule), path_(path) {
  auto* label = new QLabel(rule.label + (rule.required ? " *" : ""), this);
  label->setFixedWidth(kLabelWidth);
  label->setWordWrap(true);
  label->setToolTip(tr("In the file: %1").arg(rule.name));
  help_ = new QLabel(remark(rule), this);
  help_->setObjectName("faint");
  help_->setWordWrap(true);
  problem_ = new QLabel(this);
  problem_->setWordWrap(true);
  problem_->setProperty("role", "warning");
  problem_->hide();
  make_editor(choices);
  editor_->setObjectName(path);
  if (editor_->accessibleName().isEmpty()) editor_->setAccessibleName(rule.label);
  editor_->setToolTip(remark(rule));
  const bool small = rule.kind == Kind::number || rule.kind == Kind::whole_number || rule.kind == Kind::range ||
                     rule.kind == Kind::word || rule.kind == Kind::truth;
  row_ = new QHBoxLayout;
  row_->addWidget(label, 0, Qt::AlignTop);
  row_->addWidget(editor_, small ? 0 : 1, small ? Qt::AlignTop : Qt::Alignment());
  if (small) {
    unit_ = new QLabel(rule.unit, this);
    theme::keep_wide(*unit_, 58);
    row_->addWidget(unit_);
    row_->addWidget(help_, 1);
  }
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 2, 0, 2);
  column->setSpacing(2);
  column->addLayout(row_);
  for (QLabel* below : {help_, problem_}) {
    auto* line = new QHBoxLayout;
    line->addSpacing(kLabelWidth + 6);
    if (below == help_) below_ = line;
    if (below == problem_ || !small) line->addWidget(below, 1);
    column->addLayout(line);
  }
  help_->setVisible(!help_->text().isEmpty());
}

void FieldRow::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  if (unit_ == nullptr || help_->text().isEmpty()) return;
  // A hint of two words a line is not read: where there is too little room beside the editor, it stands below.
  const double left = width() - kLabelWidth - editor_->sizeHint().width() - unit_->width() - 24;
  const bool below = left < theme::points(kLeastHint) + (help_is_below_ ? 30.0 : 0.0);
  if (below == help_is_below_) return;
  help_is_below_ = below;
  (below ? row_ : below_)->removeWidget(help_);
  (below ? below_ : row_)->addWidget(help_, 1);
}

void FieldRow::make_editor(const QStringList& choices) {
  switch (rule_.kind) {
    case Kind::number:
    case Kind::whole_number:
      return make_number();
    case Kind::range:
      return make_range();
    case Kind::word:
      return make_word();
    case Kind::truth:
      return rule_.left_out == "true" || rule_.left_out == "false" ? make_truth() : make_word();
    case Kind::words:
      return make_words(rule_.words.isEmpty() ? choices : rule_.words);
    case Kind::text:
      return make_text();
    default:
      return make_line();
  }
}

void FieldRow::tell(const QString& scalar, bool is_text) {
  if (scalar.isEmpty() && !rule_.required)
    emit left_out(path_);
  else
    emit edited(path_, is_text || scalar.isEmpty() ? curricula::yaml_text(scalar.toStdString())
                                                   : curricula::yaml_plain(scalar.toStdString()));
}

void FieldRow::make_number() {
  auto* box = new NumberBox(rule_, this);
  connect(box, &NumberBox::edited, this, [this, box] { tell(box->value(), false); });
  show_ = [box](const YamlNode* value) { box->set_value(text_of(value)); };
  editor_ = box;
}

void FieldRow::make_range() {
  auto* both = new QWidget(this);
  auto *from = new NumberBox(rule_, both), *to = new NumberBox(rule_, both);
  for (NumberBox* box : {from, to}) box->setFixedWidth(90);
  from->setAccessibleName(tr("%1: from").arg(rule_.label));
  to->setAccessibleName(tr("%1: to").arg(rule_.label));
  auto* row = new QHBoxLayout(both);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(from);
  row->addWidget(new QLabel(tr("to"), both));
  row->addWidget(to);
  both->setFocusProxy(from);
  const auto changed = [this, from, to] {
    if (from->value().isEmpty() && to->value().isEmpty()) return void(emit left_out(path_));
    std::vector<YamlNode> items;
    for (const NumberBox* box : {from, to})
      if (!box->value().isEmpty()) items.push_back(curricula::yaml_plain(box->value().toStdString()));
    emit edited(path_, curricula::yaml_list(std::move(items)));
  };
  connect(from, &NumberBox::edited, this, changed);
  connect(to, &NumberBox::edited, this, changed);
  show_ = [from, to](const YamlNode* value) {
    const auto at = [value](std::size_t i) {
      return value != nullptr && i < value->children.size() ? text_of(&value->children[i]) : QString();
    };
    // A single number may be the second one, whose first is still to be typed.
    if (value != nullptr && value->children.size() == 1 && from->value().isEmpty() && to->value() == at(0)) return;
    from->set_value(at(0));
    to->set_value(at(1));
  };
  editor_ = both;
}

void FieldRow::make_word() {
  auto* box = new WordBox(this);
  box->setMinimumWidth(200);
  if (!rule_.required)
    box->addItem(rule_.left_out.isEmpty() ? tr("(left out)") : tr("(left out: %1)").arg(rule_.left_out), QString());
  if (rule_.kind == Kind::truth) {
    box->addItem(tr("yes"), "true");
    box->addItem(tr("no"), "false");
  } else {
    for (QString word : rule_.words) box->addItem(capitalised(QString(word).replace('-', ' ')), word);
  }
  const int known = box->count();
  const bool is_text = rule_.words_are_text;
  connect(box, qOverload<int>(&QComboBox::activated), this,
          [this, box, is_text] { tell(box->currentData().toString(), is_text); });
  show_ = [box, known](const YamlNode* value) {
    while (box->count() > known) box->removeItem(known);
    const int index = box->findData(text_of(value));
    if (index < 0) box->addItem(text_of(value), text_of(value));  // what is not allowed is still shown
    box->setCurrentIndex(index < 0 ? known : index);
  };
  editor_ = box;
}

void FieldRow::make_truth() {
  auto* box = new QCheckBox(this);
  connect(box, &QCheckBox::clicked, this, [this](bool on) { tell(on ? "true" : "false", false); });
  show_ = [this, box](const YamlNode* value) {
    box->setChecked((value == nullptr ? rule_.left_out : text_of(value)) == "true");
  };
  editor_ = box;
}

void FieldRow::make_words(const QStringList& choices) {
  auto* all = new QWidget(this);
  auto* column = new QVBoxLayout(all);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(2);
  QList<QCheckBox*> boxes;
  for (const QString& word : choices) {
    auto* box = new QCheckBox(rule_.words.isEmpty() ? word : capitalised(QString(word).replace('-', ' ')), all);
    box->setProperty("word", word);
    box->setObjectName(path_ + ":" + word);
    column->addWidget(box);
    boxes << box;
  }
  if (!boxes.isEmpty()) all->setFocusProxy(boxes.first());
  for (QCheckBox* box : boxes)
    connect(box, &QCheckBox::clicked, this, [this, boxes] {
      std::vector<YamlNode> words;
      for (const QCheckBox* one : boxes)
        if (one->isChecked()) words.push_back(curricula::yaml_text(one->property("word").toString().toStdString()));
      if (words.empty())
        emit left_out(path_);
      else
        emit edited(path_, curricula::yaml_list(std::move(words)));
    });
  show_ = [boxes](const YamlNode* value) {
    QStringList words;
    if (value != nullptr)
      for (const YamlNode& one : value->children) words << text_of(&one);
    for (QCheckBox* box : boxes) box->setChecked(words.contains(box->property("word").toString()));
  };
  editor_ = all;
}

void FieldRow::make_line() {
  auto* line = new QLineEdit(this);
  // An id is named elsewhere as well: it changes when it is whole.
  if (rule_.name == "id")
    connect(line, &QLineEdit::editingFinished, this, [this, line] {
      if (line->isModified()) tell(line->text(), true);
      line->setModified(false);
    });
  else
    connect(line, &QLineEdit::textEdited, this, [this](const QString& text) { tell(text, true); });
  show_ = [line](const YamlNode* value) {
    QString text = text_of(value);
    while (text.endsWith('\n')) text.chop(1);
    if (line->text() != text) line->setText(text);
  };
  editor_ = line;
}

void FieldRow::make_text() {
  auto* field = new TextField(rule_.label, this);
  connect(field, &TextField::edited, this, [this, field] {
    const YamlNode value = field->value();
    if (value.value.empty() && value.children.empty() && !rule_.required)
      emit left_out(path_);
    else
      emit edited(path_, value);
  });
  show_ = [field](const YamlNode* value) { field->show_value(value); };
  editor_ = field;
}

void FieldRow::show_value(const YamlNode* value) { show_(value); }

void FieldRow::show_problem(const QString& problem) {
  problem_->setText(problem);
  problem_->setVisible(!problem.isEmpty());
}

QString FieldRow::problem() const { return problem_->text(); }

}  // namespace vallecula::gui
