// The bar above the views.
#include "ui/base/notice_bar.h"

#include "ui/base/shown_text.h"
#include "ui/base/themes.h"

#include <QClipboard>
#include <QDesktopServices>
#include <QFileInfo>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <QUrl>

namespace edgescan::ui {

NoticeBar::NoticeBar(QWidget* parent) : QFrame(parent), sign_(new QLabel), text_(new QLabel), action_(new QToolButton) {
    setObjectName("notice-bar");
    action_->setObjectName("notice-action");
    auto* line = new QHBoxLayout(this);
    line->setContentsMargins(10, 4, 6, 4);
    QFont bold = sign_->font();
    bold.setBold(true);
    sign_->setFont(bold);
    text_->setWordWrap(true);
    text_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    text_->setTextFormat(Qt::PlainText);
    auto* copy = copy_ = new QToolButton;
    copy->setText(tr("Copy"));
    connect(copy, &QToolButton::clicked, this, [this] { QGuiApplication::clipboard()->setText(text_->text()); });
    auto* close = new QToolButton;
    close->setText(tr("Close"));
    connect(close, &QToolButton::clicked, this, &QWidget::hide);
    connect(action_, &QToolButton::clicked, this, [this] {
        if (onAction_) onAction_();
    });
    line->addWidget(sign_, 0, Qt::AlignTop);
    line->addWidget(text_, 1);
    line->addWidget(action_, 0, Qt::AlignTop);
    line->addWidget(copy, 0, Qt::AlignTop);
    line->addWidget(close, 0, Qt::AlignTop);
    hide();
    followColours(*this, [this](const Theme&) { paintKind(); });
}

// A strip and a sign in the colour of what is abnormal, words in the usual one: the word tells the kind as well as the colour does.
void NoticeBar::paintKind() {
    const Theme& theme = themeInUse();
    const QColor colour = kind_ == Kind::Error ? theme.bad : kind_ == Kind::Warning ? theme.warn : theme.text;
    setStyleSheet(
        QString("#notice-bar { background: %1; border: none; border-left: 6px solid %2; }").arg(theme.panel.name(), colour.name()));
    QPalette letters = sign_->palette();
    letters.setColor(QPalette::WindowText, colour);
    sign_->setPalette(letters);
}

void NoticeBar::showNotice(Kind kind, const QString& text) {
    kind_ = kind;
    sign_->setText(kind == Kind::Error ? "✕ " + tr("Error") : kind == Kind::Warning ? "▲ " + tr("Note") : "✓ " + tr("Done"));
    paintKind();
    text_->setText(shownText(text));
    action_->hide();
    onAction_ = {};
    show();
}

void NoticeBar::tellSaved(const QString& path, const QString& content) {
    const QFileInfo file(path);
    showNotice(Kind::Done,
               tr("Saved %1%2, %3 kB.").arg(path, content.isEmpty() ? QString() : ": " + content).arg((file.size() + 999) / 1000));
    offer(tr("Open folder"), [folder = file.absolutePath()] { QDesktopServices::openUrl(QUrl::fromLocalFile(folder)); });
}

void NoticeBar::offer(const QString& label, std::function<void()> action) {
    action_->setText(label);
    onAction_ = std::move(action);
    action_->show();
}

void NoticeBar::setBrief(bool on) { copy_->setVisible(!on); }

QString NoticeBar::text() const { return text_->text(); }

} // namespace edgescan::ui
