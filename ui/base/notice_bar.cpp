// The bar above the views.
#include "ui/base/notice_bar.h"

#include "ui/base/core_words.h"
#include "ui/base/elided_label.h"
#include "ui/base/flow_layout.h"
#include "ui/base/shown_text.h"
#include "ui/base/themes.h"
#include "ui/base/undo_step.h"

#include <QApplication>
#include <QClipboard>
#include <QDesktopServices>
#include <QDir>
#include <QFileInfo>
#include <QHideEvent>
#include <QLabel>
#include <QRegularExpression>
#include <QScopedValueRollback>
#include <QToolButton>
#include <QUndoStack>
#include <QUrl>

#include <algorithm>
#include <utility>
#include <vector>

namespace edgescan::ui {
namespace {

constexpr std::size_t kMostEarlier = 9;
constexpr int kLeastText = 200;      // px
constexpr int kLongName = 28;        // letters of it
constexpr int kNameEnd = 10;         // letters at each end of a long name
constexpr double kWholeFrom = 100.0; // kB, of a file's size
constexpr int kUndoneMs = 8000, kTouchedMs = 1000;
constexpr int kNarrow = 480; // px of a bar with large buttons that has no room for the number of notes: Close shows the next one too

} // namespace

NoticeBar::NoticeBar(QWidget* parent)
    : QFrame(parent), sign_(new QLabel), line_(new ElidedLabel), text_(new QLabel), action_(new QToolButton), folder_(new QToolButton),
      unfold_(new QToolButton), more_(new QToolButton) {
    setObjectName("notice-bar");
    line_->setObjectName("notice-line");
    action_->setObjectName("notice-action");
    folder_->setObjectName("notice-folder");
    folder_->setText(tr("Open folder"));
    folder_->hide();
    connect(folder_, &QToolButton::clicked, this, [this] { openPath(folderOf_); });
    auto* line = new FlowLayout(this); // in a narrow window the buttons are below the text
    line->setContentsMargins(10, 4, 6, 4);
    line->keepAtEnd();
    QFont bold = sign_->font();
    bold.setBold(true);
    sign_->setFont(bold);
    text_->setObjectName("notice-text");
    text_->setWordWrap(true);
    text_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred); // a long path must not widen the window
    text_->setMinimumWidth(kLeastText);
    text_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    text_->setTextFormat(Qt::PlainText);
    auto* copy = copy_ = new QToolButton;
    copy->setText(tr("Copy"));
    connect(copy, &QToolButton::clicked, this, [this] { QApplication::clipboard()->setText(words_); });
    auto* close = new QToolButton;
    close->setText(tr("Close"));
    close->setObjectName("notice-close");
    connect(close, &QToolButton::clicked, this, &NoticeBar::closeShown);
    connect(action_, &QToolButton::clicked, this, [this] {
        used_ = true;
        if (onAction_) onAction_();
    });
    unfold_->setObjectName("notice-unfold");
    unfold_->setCheckable(true);
    connect(unfold_, &QToolButton::toggled, this, &NoticeBar::unfold);
    more_->setObjectName("notice-earlier");
    more_->setToolTip(tr("Shows the next of the notes that were not closed"));
    more_->hide();
    connect(more_, &QToolButton::clicked, this, &NoticeBar::showEarlier);
    for (QWidget* each : std::initializer_list<QWidget*>{copy, close}) line->addWidget(each);
    placeButtons();
    for (QToolButton* each : findChildren<QToolButton*>()) connect(each, &QToolButton::pressed, this, [this] { touched_.start(); });
    hide();
    leaves_.setParent(this);
    leaves_.setObjectName("notice-leaves");
    leaves_.setInterval(kUndoneMs);
    connect(&leaves_, &QTimer::timeout, this, &NoticeBar::leave);
    followColours(*this, [this](const Theme&) { paintKind(); });
}

// A strip and an icon have the colour of the kind of notice; the text has the normal colour. The text names the kind as well.
void NoticeBar::paintKind() {
    const Theme& theme = themeInUse();
    const QColor colour = kind_ == Kind::Error ? theme.bad : kind_ == Kind::Warning ? theme.warn : theme.text;
    setStyleSheet(
        QString("#notice-bar { background: %1; border: none; border-left: 6px solid %2; }").arg(theme.panel.name(), colour.name()));
    QPalette letters = sign_->palette();
    letters.setColor(QPalette::WindowText, colour);
    sign_->setPalette(letters);
}

NoticeBar::Note NoticeBar::noteOf(Kind kind, const QString& text) {
    // What was done is shown as it is: it may be a command for a terminal.
    return {kind, kind == Kind::Done ? shownText(text) : coreSentence(shownText(text)), {}, {}};
}

void NoticeBar::showNotice(Kind kind, const QString& text) { showNote(noteOf(kind, text)); }

QString NoticeBar::showBehind(Kind kind, const QString& text) {
    const Note note = noteOf(kind, text);
    if (isHidden() || !waits()) {
        showNote(note);
        return note.text;
    }
    keep(note);
    countEarlier();
    layout()->activate();
    offerMore();
    return note.text;
}

/// A note with a button that was not pressed comes back after a note without one.
void NoticeBar::showNote(const Note& note, bool passes) {
    // Of a written file the note stays too, until the next confirmation.
    if (kind_ != Kind::Done || note.kind != Kind::Done || (waits() && note.label.isEmpty())) keepShown();
    std::erase_if(earlier_, [&](const Note& before) { return note.text.startsWith(before.text); });
    place_ = 1;
    put(note);
    passes_ = passes;
    if (note.label.isEmpty() && note.kind != Kind::Error && std::ranges::any_of(earlier_, &Note::waits)) leaves_.start();
    show();
    layout()->activate();
    offerMore();
}

void NoticeBar::showHint(const QString& text) { showNote({Kind::Warning, coreSentence(shownText(text)), {}, {}}, true); }

void NoticeBar::endPassing() {
    const bool lasts = kind_ != Kind::Done || !action_->isHidden(); // "Saved" has a button
    if (isHidden() || (lasts && !passes_)) return;
    earlier_.empty() ? hide() : bringBack();
}

void NoticeBar::withdraw(const QStringList& texts) {
    std::erase_if(earlier_, [&](const Note& note) { return texts.contains(note.text); });
    countEarlier();
    if (isHidden() || !texts.contains(text())) return;
    setWords({}); // not stored for "earlier"
    earlier_.empty() ? hide() : bringBack();
}

/// What passes is not stored for "earlier", nor confirmations without a button.
void NoticeBar::keepShown() {
    if (isHidden() || (kind_ == Kind::Done && action_->isHidden()) || passes_ || words_.isEmpty()) return;
    keep({kind_, words_, action_->isHidden() ? QString() : action_->text(), onAction_, brief_, saved_, waits(), folderOf_});
}

void NoticeBar::keep(const Note& note) {
    earlier_.push_back(note);
    if (earlier_.size() > kMostEarlier) earlier_.pop_front();
}

/// Its button was offered with a warning or a written file, and not pressed.
bool NoticeBar::waits() const { return !action_->isHidden() && !used_ && !passes_ && (kind_ == Kind::Warning || saved_); }

void NoticeBar::countEarlier() {
    more_->setText(tr("%1 of %2").arg(place_).arg(earlier_.size() + 1));
    more_->setHidden(earlier_.empty() || (large_ && width() < kNarrow));
}

void NoticeBar::put(const Note& note) {
    kind_ = note.kind;
    passes_ = false;
    leaves_.stop();
    sign_->setText(kind_ == Kind::Error ? "✕ " + tr("Error") : kind_ == Kind::Warning ? "▲ " + tr("Note") : "✓ " + tr("Done"));
    paintKind();
    setWords(note.text);
    brief_ = note.brief;
    unfold(false);
    action_->setText(note.label);
    action_->setHidden(note.label.isEmpty());
    onAction_ = note.action;
    used_ = false;
    saved_ = note.saved;
    folderOf_ = note.folder;
    showFolder();
    countEarlier();
}

/// First the newest one with a button that was not pressed.
void NoticeBar::bringBack() {
    const auto waits = std::find_if(earlier_.rbegin(), earlier_.rend(), [](const Note& note) { return note.waits; });
    if (waits != earlier_.rend()) std::rotate(waits.base() - 1, waits.base(), earlier_.end());
    place_ = 0;
    showEarlier();
}

void NoticeBar::closeShown() {
    const QString read = text();
    setWords({}); // not stored for "earlier"
    earlier_.empty() ? hide() : showEarlier();
    emit closed(read);
}

/// Shows the notice before. The shown notice goes to the front of the queue, so that the button cycles through all of them.
void NoticeBar::showEarlier() {
    if (earlier_.empty()) return;
    const Note before = earlier_.back();
    earlier_.pop_back();
    const std::size_t count = earlier_.size();
    keepShown();
    const bool stays = earlier_.size() > count;
    if (stays) std::rotate(earlier_.begin(), earlier_.end() - 1, earlier_.end());
    const std::size_t all = earlier_.size() + 1;
    place_ = stays || place_ == 0 ? place_ % all + 1 : std::min(place_, all);
    put(before);
    layout()->activate();
    offerMore();
}

/// A closed notice counts as read. Minimising the window does not close the notice.
void NoticeBar::hideEvent(QHideEvent* event) {
    if (!event->spontaneous() && isHidden()) {
        earlier_.clear();
        more_->hide();
        leaves_.stop();
        emit left(QRect(mapToGlobal(QPoint()), size()));
    }
    QFrame::hideEvent(event);
}

void NoticeBar::showSaved(const QString& path, const QString& content, const QString& more) {
    const QFileInfo file(path);
    const double kilobytes = std::max(0.1, static_cast<double>(file.size()) / 1000.0);
    const QString size = kilobytes >= 1000.0 ? tr("%1 MB").arg(kilobytes / 1000.0, 0, 'f', 1)
                                             : tr("%1 kB").arg(kilobytes, 0, 'f', kilobytes < kWholeFrom ? 1 : 0);
    const auto words = [&](const QString& shown) {
        return shownText(tr("Saved %1%2, %3.").arg(shown, content.isEmpty() ? QString() : ": " + content, size) +
                         (more.isEmpty() ? QString() : " " + more));
    };
    const QString end = file.absoluteDir().dirName() + '/' + file.fileName(); // the line has room for the end of a path
    const bool isPage = QStringList{"html", "pdf"}.contains(file.suffix().toLower());
    const QString opened = isPage ? file.absoluteFilePath() : file.absolutePath();
    showNote({Kind::Done, words(path), isPage ? tr("Open") : tr("Open folder"), [this, opened] { openPath(opened); },
              path.size() > end.size() + 2 ? words("…/" + end) : QString(), true, false, isPage ? file.absolutePath() : QString()});
}

/// In a cab only the file itself is opened.
void NoticeBar::showFolder() { folder_->setHidden(folderOf_.isEmpty() || large_); }

void NoticeBar::openPath(const QString& path) {
    if (!QDesktopServices::openUrl(QUrl::fromLocalFile(path))) showHint(tr("No program of this computer opened %1.").arg(path));
}

void NoticeBar::offer(const QString& label, std::function<void()> action, const QString& folder) {
    action_->setText(label);
    folderOf_ = folder;
    showFolder();
    onAction_ = std::move(action);
    used_ = false;
    leaves_.stop();
    action_->show();
    layout()->activate();
    offerMore();
}

void NoticeBar::offerUndo(QUndoStack& stack) {
    offer(tr("Undo"), [&stack] { stack.undo(); });
    passes_ = true;
}

void NoticeBar::showRemoved(QUndoStack& stack, const QString& what, const QString& more) {
    showNotice(Kind::Done, tr("Removed: %1.").arg(what) + (more.isEmpty() ? QString() : " " + more));
    offerUndo(stack);
}

void NoticeBar::showUndone(QUndoStack& stack, bool again) {
    const bool came = !again && stack.text(stack.index()).startsWith("removal");
    const auto* step = dynamic_cast<const ScanStep*>(stack.command(stack.index()));
    const QString back = step != nullptr ? step->undoneText() : QString();
    showNotice(Kind::Done,
               (again ? tr("Done again: %1.").arg(stack.undoText()) : tr("Undone: %1.").arg(back.isEmpty() ? stack.redoText() : back)) +
                   (came ? " " + tr("It is back.") : QString()));
    offer(tr("Redo"), [&stack] { stack.redo(); });
    passes_ = true;
    leaves_.start();
}

void NoticeBar::leave() {
    const QWidget* const focus = QApplication::focusWidget();
    const bool touched = touched_.isValid() && touched_.elapsed() < kTouchedMs;
    if (touched || underMouse() || (focus != nullptr && isAncestorOf(focus))) return; // until the next time
    leaves_.stop();
    emit left(QRect(mapToGlobal(QPoint()), size())); // another note may be there now
    if (kind_ == Kind::Done || passes_) return endPassing();
    bringBack(); // the warning is among the earlier ones then
    // A press that is on its way is for the note of before.
    for (QToolButton* each : findChildren<QToolButton*>()) each->setEnabled(false);
    QTimer::singleShot(kTouchedMs, this, [this] {
        for (QToolButton* each : findChildren<QToolButton*>()) each->setEnabled(true);
    });
}

void NoticeBar::unfold(bool on) {
    unfold_->setChecked(on);
    // As wide with each of its words.
    unfold_->setText(on ? tr("More") : tr("Less"));
    const int other = unfold_->sizeHint().width();
    unfold_->setText(on ? tr("Less") : tr("More"));
    unfold_->setMinimumWidth(std::max(other, unfold_->sizeHint().width()));
    text_->setVisible(on);
    line_->setVisible(!on);
    offerMore();
}

/// Where the line is too short for a path, its folders are left out, and the middle of a long name: its ends are read.
void NoticeBar::fitLine(int room) {
    static const QRegularExpression kFolders(R"((?<![:/\w])(?:…?/[^/\s]+)+/(?=[^/\s]))");
    const QString shown = (brief_.isEmpty() ? words_ : brief_).simplified();
    line_->setText(shown);
    if (line_->fits(room)) return;
    QStringList words = QString(shown).replace(kFolders, QString("…/")).split(' ');
    line_->setText(words.join(' '));
    if (line_->fits(room)) return;
    // A name that has room is whole: the text ends after it.
    const auto name = std::find_if(words.rbegin(), words.rend(), [](const QString& each) { return each.size() > kLongName; });
    if (name != words.rend()) {
        const auto count = static_cast<int>(words.rend() - name);
        line_->setText(QStringList(words.mid(0, count)).join(' ') + (count < words.size() ? "…" : ""));
        const bool fits = line_->fits(room);
        line_->setText(words.join(' '));
        if (fits) return;
    }
    for (QString& each : words) {
        if (each.size() > kLongName) each = each.left(kNameEnd) + "…" + each.right(kNameEnd);
    }
    line_->setText(words.join(' '));
}

/// The button is visible only if the line, or in a cab two of them, is not enough.
void NoticeBar::offerMore() {
    if (offering_) return;
    const QScopedValueRollback<bool> once(offering_, true); // to show it places the bar again, which may have another width then
    for (int n = 0; n < 2; ++n) {
        // Measured without the button where it has no place of its own, so that it does not cause itself.
        const bool shares = large_ && !unfold_->isHidden() && unfold_->y() == line_->y();
        const int room = line_->width() + (shares ? unfold_->width() + layout()->spacing() : 0);
        fitLine(room);
        const bool offered = unfolded() || line_->text() != words_.simplified() || !line_->fits(room);
        if (offered != unfold_->isHidden()) return;
        unfold_->setVisible(offered);
        layout()->activate(); // else it would be over the others until the next event
    }
}

void NoticeBar::mousePressEvent(QMouseEvent* event) {
    touched_.start();
    QFrame::mousePressEvent(event);
}

void NoticeBar::resizeEvent(QResizeEvent* event) {
    QFrame::resizeEvent(event);
    countEarlier();
    layout()->activate();
    offerMore();
}

/// Each button has its place at one of the two ends, whichever others are shown. Large buttons have no room to spare: those before the
/// action, which usually is the widest, are next to the text in a narrow window.
void NoticeBar::placeButtons() {
    auto* close = findChild<QToolButton*>("notice-close");
    std::vector<QWidget*> order{more_, sign_, line_, text_, folder_, action_, copy_, unfold_, close};
    if (large_) order = {sign_, line_, text_, unfold_, more_, action_, folder_, copy_, close};
    for (QWidget* each : order) {
        layout()->removeWidget(each);
        layout()->addWidget(each);
    }
    QSizePolicy place = unfold_->sizePolicy();
    place.setRetainSizeWhenHidden(!large_);
    unfold_->setSizePolicy(place);
}

bool NoticeBar::unfolded() const { return unfold_->isChecked(); }

void NoticeBar::setBrief(bool on) {
    copy_->setVisible(!on);
    large_ = on;
    setWords(words_);
    placeButtons();
    showFolder();
    line_->setLines(on ? 2 : 1);
    layout()->setContentsMargins(10, on ? 2 : 4, 6, on ? 0 : 4);
    countEarlier();
    offerMore();
}

QString NoticeBar::text() const { return words_; }

/// A cab breaks long names of files after their signs; elsewhere text is copied from here by the mouse.
void NoticeBar::setWords(const QString& words) {
    static const QRegularExpression longWord("\\S{24,}"), sign("([_/.-])");
    words_ = words;
    QString shown;
    int done = 0;
    for (auto each = longWord.globalMatch(words); large_ && each.hasNext();) {
        const auto found = each.next();
        shown += words.mid(done, found.capturedStart() - done) + found.captured().replace(sign, QStringLiteral("\\1") + QChar(0x200B));
        done = found.capturedEnd();
    }
    text_->setText(shown + words.mid(done));
}

} // namespace edgescan::ui

#include "moc_notice_bar.cpp"
