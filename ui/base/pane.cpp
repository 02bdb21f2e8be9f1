// A view with its title.
#include "ui/base/pane.h"

#include "ui/base/icons.h"

#include <QAction>
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

void setLook(QToolButton& button, const char* icon) {
    button.setAutoRaise(true);
    button.setIcon(toolIcon(icon));
    button.setIconSize(QSize(kAloneIcon, kAloneIcon));
    button.setFocusPolicy(Qt::NoFocus);
}

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
    setLook(*alone_, "alone");
    alone_->setCheckable(true);
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
    fitButtons();
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(bar_);
    column->addWidget(content, 1);
}

void Pane::add(QAction& action, const char* icon) {
    auto* button = new QToolButton;
    button->setObjectName(QString("pane-") + icon);
    button->setToolTip(action.text().remove('&'));
    setLook(*button, icon);
    connect(button, &QToolButton::clicked, &action, &QAction::trigger);
    static_cast<QBoxLayout*>(bar_->layout())->insertWidget(bar_->layout()->count() - 1, button);
    fitButtons();
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

/// Px of title and buttons, with what is around them.
void Pane::fitButtons() {
    const QLayout& line = *bar_->layout();
    int px = line.contentsMargins().left() + line.contentsMargins().right() + (line.count() - 1) * line.spacing();
    for (int n = 0; n < line.count(); ++n) {
        const QWidget* part = line.itemAt(n)->widget();
        if (part != note_ && part != remark_) px += part->sizeHint().width();
    }
    bar_->setMinimumWidth(px);
}

/// The note has priority over the remark.
void Pane::fit() {
    const int needed = bar_->minimumWidth() + note_->sizeHint().width() + remark_->sizeHint().width();
    remark_->setMinimumWidth(remark_->sizeHint().width()); // shown whole or not at all
    remark_->setVisible(!remark_->text().isEmpty() && needed <= width());
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
