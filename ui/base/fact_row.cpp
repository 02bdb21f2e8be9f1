// Rows of facts.
#include "ui/base/fact_row.h"

#include <QApplication>
#include <QEvent>
#include <QHBoxLayout>
#include <QTextDocumentFragment>
#include <QVBoxLayout>

#include <algorithm>
#include <cstring>

namespace edgescan::ui {
LargeLabel::LargeLabel(double factor, QWidget* parent) : QLabel(parent), factor_(factor) { fit(); }

bool LargeLabel::event(QEvent* event) {
    const bool used = QLabel::event(event);
    if (event->type() == QEvent::ApplicationFontChange || event->type() == QEvent::StyleChange) fit();
    return used;
}

void LargeLabel::fit() {
    QFont letters = QApplication::font();
    letters.setPointSizeF(factor_ * letters.pointSizeF());
    letters.setBold(true);
    setFont(letters);
}

FactRow::FactRow(QWidget* parent) : QWidget(parent), name_(new QLabel(this)), value_(new QLabel(this)) {
    value_->setTextFormat(Qt::PlainText);
    value_->setWordWrap(true);
    value_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    value_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::LinksAccessibleByMouse);
    auto* line = new QHBoxLayout(this);
    line->setContentsMargins(0, 0, 0, 0);
    line->addWidget(name_, 0, Qt::AlignTop);
    line->addWidget(value_, 1);
}

void FactRow::show(const Fact& fact) {
    fact_ = fact;
    name_->setText(*fact.unit == '\0' ? fact.name : QString("%1 [%2]").arg(fact.name, fact.unit));
    value_->setObjectName(fact.key);
    value_->setTextFormat(fact.links ? Qt::RichText : Qt::PlainText);
    value_->setText(fact.was.isEmpty() ? fact.value : fact.value + "\n" + fact.was);
    for (QLabel* label : {name_, value_}) label->setToolTip(fact.tip);
    setVisible(true);
    layout()->activate(); // those around it know its new height at once
}

QString FactRow::text() const {
    return name_->text() + ": " + (fact_.links ? QTextDocumentFragment::fromHtml(value_->text()).toPlainText() : value_->text());
}

FactList::FactList(QWidget* parent) : QWidget(parent), column_(new QVBoxLayout(this)) {
    column_->setContentsMargins(0, 0, 0, 0);
    column_->setSpacing(2);
    column_->addStretch(1);
}

void FactList::show(const Facts& facts) {
    for (FactRow* each : rows_) hidden_.push_back(each);
    rows_.clear();
    for (const Fact& fact : facts) {
        const auto known =
            std::ranges::find_if(hidden_, [&fact](const FactRow* row) { return std::strcmp(row->fact().key, fact.key) == 0; });
        FactRow* row = known != hidden_.end() ? *known : new FactRow(this);
        if (known != hidden_.end())
            hidden_.erase(known);
        else // what a link leads to replaces the text that it is in: only after the click
            connect(&row->value(), &QLabel::linkActivated, this, &FactList::linked, Qt::QueuedConnection);
        const auto at = static_cast<int>(rows_.size());
        if (column_->indexOf(row) != at) column_->insertWidget(at, row);
        row->show(fact);
        rows_.push_back(row);
    }
    for (FactRow* each : hidden_) each->hide();
}

QStringList FactList::texts() const {
    QStringList lines;
    for (const FactRow* row : rows_) lines << row->text();
    return lines;
}

} // namespace edgescan::ui

#include "moc_fact_row.cpp"
