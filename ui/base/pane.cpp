// A view with its title.
#include "ui/base/pane.h"

#include "ui/base/icons.h"

#include <QEvent>
#include <QFocusEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QStringList>
#include <QToolButton>
#include <QVBoxLayout>

namespace edgescan::ui {
namespace {

constexpr int kAloneIcon = 14; // px
constexpr int kFocusLine = 2;  // px

} // namespace

/// A note that uses the available width. Numbers are never cut: facts are separated by "·", and the last facts are left out first.
class PaneNote : public QWidget {
public:
    PaneNote() {
        setForegroundRole(QPalette::PlaceholderText);
        setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    }
    void setText(const QString& text) {
        if (text == text_) return;
        text_ = text;
        setToolTip(text);
        update();
    }
    [[nodiscard]] const QString& text() const { return text_; }
    [[nodiscard]] QSize sizeHint() const override { return {fontMetrics().horizontalAdvance(text_), fontMetrics().height()}; }

protected:
    void paintEvent(QPaintEvent*) override {
        QPainter painter(this);
        painter.setPen(palette().color(QPalette::PlaceholderText));
        painter.drawText(rect(), Qt::AlignVCenter | Qt::AlignLeft, shown());
    }

private:
    [[nodiscard]] QString shown() const {
        QStringList facts = text_.split(" · ");
        while (!facts.isEmpty() && fontMetrics().horizontalAdvance(facts.join(" · ")) > width()) facts.removeLast();
        return facts.join(" · ");
    }

    QString text_;
};

Pane::Pane(const QString& title, QWidget* content, QWidget* parent)
    : QFrame(parent), bar_(new QWidget), title_(new QLabel(title)), note_(new PaneNote), remark_(new QLabel), alone_(new QToolButton),
      content_(content) {
    for (QWidget* each : {bar_, content_}) each->installEventFilter(this);
    bar_->setToolTip(tr("Double-click: in exchange for the cloud, and back"));
    alone_->setObjectName("pane-alone");
    alone_->setAutoRaise(true);
    alone_->setIcon(toolIcon("alone"));
    alone_->setIconSize(QSize(kAloneIcon, kAloneIcon));
    alone_->setCheckable(true);
    alone_->setFocusPolicy(Qt::NoFocus);
    showAlone(false);
    connect(alone_, &QToolButton::clicked, this, &Pane::maximiseRequested);
    auto* line = new QHBoxLayout(bar_);
    line->setContentsMargins(6, 1, 4, 1);
    line->setSpacing(8);
    line->addWidget(title_);
    line->addWidget(note_, 1);
    line->addWidget(remark_);
    line->addWidget(alone_);
    QFont bold = title_->font();
    bold.setBold(true);
    title_->setFont(bold);
    // Not that of the remark, which fit() hides.
    bar_->setMinimumWidth(title_->sizeHint().width() + alone_->sizeHint().width() + 3 * line->spacing() + line->contentsMargins().left() +
                          line->contentsMargins().right());
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(bar_);
    column->addWidget(content, 1);
}

void Pane::setNote(const QString& text) {
    note_->setText(text);
    fit();
}

void Pane::setRemark(const QString& text) {
    remark_->setText(text);
    fit();
}

void Pane::showAlone(bool on) {
    alone_->setChecked(on);
    alone_->setToolTip(on ? tr("All views again") : tr("This view alone"));
}

void Pane::setTitled(bool on) { bar_->setVisible(on); }

QString Pane::title() const { return title_->text(); }

QString Pane::note() const { return note_->text(); }

QString Pane::remark() const { return remark_->text(); }

/// The note has priority over the remark.
void Pane::fit() {
    const QLayout& line = *bar_->layout();
    const int others = title_->sizeHint().width() + note_->sizeHint().width() + alone_->sizeHint().width() + 3 * line.spacing() +
                       line.contentsMargins().left() + line.contentsMargins().right();
    remark_->setMinimumWidth(remark_->sizeHint().width()); // shown whole or not at all
    remark_->setVisible(!remark_->text().isEmpty() && others + remark_->sizeHint().width() <= width());
}

void Pane::resizeEvent(QResizeEvent* event) {
    QFrame::resizeEvent(event);
    fit();
}

bool Pane::eventFilter(QObject* watched, QEvent* event) {
    if (watched == bar_ && event->type() == QEvent::MouseButtonDblClick) {
        emit swapRequested();
        return true;
    }
    if (watched == bar_ && event->type() == QEvent::Paint && focused_)
        QPainter(bar_).fillRect(0, bar_->height() - kFocusLine, bar_->width(), kFocusLine, palette().color(QPalette::Link));
    if (watched == content_ && (event->type() == QEvent::FocusIn || event->type() == QEvent::FocusOut)) {
        const Qt::FocusReason reason = static_cast<QFocusEvent*>(event)->reason();
        focused_ = event->type() == QEvent::FocusIn &&
                   (reason == Qt::TabFocusReason || reason == Qt::BacktabFocusReason || reason == Qt::ShortcutFocusReason);
        bar_->update();
    }
    return QFrame::eventFilter(watched, event);
}

} // namespace edgescan::ui

#include "moc_pane.cpp"
