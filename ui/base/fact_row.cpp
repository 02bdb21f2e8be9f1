// Rows of facts.
#include "ui/base/fact_row.h"

#include "ui/base/themes.h"

#include <QFontMetrics>
#include <QGridLayout>
#include <QTextDocumentFragment>
#include <QVBoxLayout>

#include <algorithm>
#include <cstring>

namespace edgescan::ui {
QFont fittedFont(QFont letters, const QString& text, int room, int mostPx, int leastPx) {
    letters.setPixelSize(mostPx);
    const int wide = QFontMetrics(letters).horizontalAdvance(text);
    int px = wide > room && wide > 0 ? std::max(leastPx, mostPx * room / wide) : mostPx;
    letters.setPixelSize(px);
    while (px > leastPx && QFontMetrics(letters).horizontalAdvance(text) > room) letters.setPixelSize(--px);
    return letters;
}

FittedLabel::FittedLabel(int mostPx, int leastPx, QWidget* parent) : QLabel(parent), mostPx_(mostPx), leastPx_(leastPx) {
    setTextFormat(Qt::PlainText);
    setMost(mostPx);
    setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
}

void FittedLabel::showText(const QString& text) {
    setText(text);
    fit();
}

void FittedLabel::setMost(int px) {
    mostPx_ = px;
    QFont letters = font();
    letters.setPixelSize(px);
    letters.setBold(true);
    setFont(letters);
    setMinimumHeight(QFontMetrics(letters).height()); // the widgets below do not move
    fit();
}

QSize FittedLabel::minimumSizeHint() const { return {0, minimumHeight()}; }

void FittedLabel::resizeEvent(QResizeEvent* event) {
    QLabel::resizeEvent(event);
    fit();
}

void FittedLabel::fit() {
    const int room = contentsRect().width();
    const QFont letters = fittedFont(font(), text(), room, mostPx_, leastPx_);
    if (letters.pixelSize() != font().pixelSize()) setFont(letters);
    setToolTip(QFontMetrics(letters).horizontalAdvance(text()) > room ? text() : QString());
}

namespace {

constexpr int kNumberPx = 42, kLeastNumberPx = 19;
constexpr int kShortNamePx = 56;

QLabel* valueOf(FactRow::Look look) {
    using Look = FactRow::Look;
    if (look == Look::Number || look == Look::Short) return new FittedLabel(kNumberPx, kLeastNumberPx);
    auto* label = new QLabel;
    label->setTextFormat(Qt::PlainText);
    label->setWordWrap(true);
    return label;
}

void useLetters(QLabel& label, int px, bool bold = false) {
    QFont letters = label.font();
    letters.setPixelSize(px);
    letters.setBold(bold);
    if (letters != label.font()) label.setFont(letters);
}

} // namespace

const Fact* factOf(const Facts& facts, const char* key) {
    const auto found = std::ranges::find_if(facts, [key](const Fact& each) { return std::strcmp(key, each.key) == 0; });
    return found == facts.end() ? nullptr : &*found;
}

FactRow::FactRow(Look look, const QString& name, QWidget* parent)
    : QWidget(parent), look_(look), name_(new QLabel(this)), value_(valueOf(look)), tolerance_(new QLabel(this)) {
    value_->setObjectName(name);
    name_->setObjectName(name + "-name");
    tolerance_->setObjectName(name + "-tolerance");
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setVerticalSpacing(2);
    const bool below = look == Look::Number, alone = look == Look::Words || look == Look::Warning;
    if (!alone) grid->addWidget(name_, 0, 0, look == Look::Line ? Qt::AlignTop : Qt::Alignment());
    grid->addWidget(value_, below ? 1 : 0, below || alone ? 0 : 1, 1, below || alone ? 2 : 1);
    grid->setColumnStretch(below ? 0 : 1, 1);
    if (below) grid->addWidget(tolerance_, 0, 1);
    name_->setHidden(alone);
    const bool inCab = name.startsWith("cab-"); // where the side is narrow
    name_->setWordWrap(below || (look == Look::Line && inCab));
    tolerance_->setHidden(!below);
    if (look == Look::Line) value_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    if (look == Look::Line && !inCab) value_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::LinksAccessibleByMouse);
    if (look == Look::Short) name_->setMinimumWidth(kShortNamePx); // the numbers of a place are below each other
    if (look != Look::Warning) return;
    followColours(*value_, [this](const Theme& theme) {
        QPalette letters = value_->palette();
        letters.setColor(QPalette::WindowText, theme.warn);
        value_->setPalette(letters);
    });
}

void FactRow::show(const Fact& fact) {
    fact_ = fact;
    name_->setText(*fact.unit == '\0' ? fact.name : QString("%1 [%2]").arg(fact.name, fact.unit));
    value_->setTextFormat(fact.links ? Qt::RichText : Qt::PlainText);
    value_->setText(fact.was.isEmpty() ? fact.value : fact.value + "\n" + fact.was);
    tolerance_->setWordWrap(!fact.tolerance.startsWith("±"));
    tolerance_->setText(fact.tolerance);
    if (look_ == Look::Line)
        for (QLabel* label : {name_, value_}) label->setToolTip(fact.tip);
    QLabel& tapped = look_ == Look::Short ? *name_ : *value_;
    QFont letters = tapped.font();
    letters.setUnderline(fact.underlined);
    tapped.setFont(letters);
    setVisible(true);
    layout()->activate(); // those around it know its new height at once
}

void FactRow::setLetters(int namePx, int valuePx) {
    useLetters(*name_, namePx, look_ == Look::Short);
    useLetters(*tolerance_, namePx);
    if (auto* number = dynamic_cast<FittedLabel*>(value_))
        number->setMost(valuePx); // and fits the text
    else
        useLetters(*value_, valuePx);
    layout()->activate();
}

QString FactRow::text() const {
    return name_->text() + ": " + (fact_.links ? QTextDocumentFragment::fromHtml(value_->text()).toPlainText() : value_->text());
}

FactList::FactList(const QString& name, QWidget* parent) : QWidget(parent), name_(name), column_(new QVBoxLayout(this)) {
    column_->setContentsMargins(0, 0, 0, 0);
    column_->setSpacing(2);
    column_->addStretch(1);
}

void FactList::show(const std::vector<Shown>& rows) {
    for (FactRow* each : rows_) hidden_.push_back(each);
    rows_.clear();
    for (const auto& [look, fact] : rows) {
        const auto known = std::ranges::find_if(hidden_, [look = look, key = fact.key](const FactRow* row) {
            return row->look() == look && std::strcmp(row->fact().key, key) == 0;
        });
        FactRow* row = known != hidden_.end() ? *known : new FactRow(look, name_ + fact.key, this);
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

void FactList::show(const Facts& facts) {
    std::vector<Shown> rows;
    for (const Fact& each : facts) rows.push_back({FactRow::Look::Line, each});
    show(rows);
}

QStringList FactList::texts() const {
    QStringList lines;
    for (const FactRow* row : rows_) lines << row->text();
    return lines;
}

} // namespace edgescan::ui

#include "moc_fact_row.cpp"
