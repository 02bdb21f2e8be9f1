// The line above the views.
#include "ui/base/notice_bar.h"

#include "ui/base/core_words.h"
#include "ui/base/elided_label.h"
#include "ui/base/shown_text.h"
#include "ui/base/themes.h"
#include "ui/base/undo_step.h"

#include <QApplication>
#include <QBoxLayout>
#include <QClipboard>
#include <QDesktopServices>
#include <QDir>
#include <QFileInfo>
#include <QHideEvent>
#include <QLabel>
#include <QRegularExpression>
#include <QScrollArea>
#include <QToolButton>
#include <QUndoStack>
#include <QUrl>

#include <algorithm>
#include <utility>
#include <vector>

namespace edgescan::ui {
namespace {

constexpr std::size_t kMostEarlier = 9;
constexpr int kLeastText = 160;        // px of the line, next to the button of a note
constexpr double kMostOfWindow = 0.25; // of its height, for all of the text
constexpr int kLongName = 28;          // letters of it
constexpr int kNameEnd = 10;           // letters at each end of a long name
constexpr double kWholeFrom = 100.0;   // kB, of a file's size
constexpr int kUndoneMs = 8000, kTouchedMs = 1000;

} // namespace

NoticeBar::NoticeBar(QWidget* parent)
    : QFrame(parent), line_(new ElidedLabel), text_(new QLabel), all_(new QScrollArea), details_(new QWidget), head_(new QHBoxLayout),
      below_(new QVBoxLayout), action_(new QToolButton), folder_(new QToolButton), unfold_(new QToolButton), more_(new QToolButton),
      close_(new QToolButton) {
    setObjectName("notice-bar");
    QSizePolicy stays(QSizePolicy::Preferred, QSizePolicy::Fixed);
    stays.setRetainSizeWhenHidden(true);
    setSizePolicy(stays);
    line_->setObjectName("notice-line");
    action_->setObjectName("notice-action");
    folder_->setObjectName("notice-folder");
    folder_->setText(tr("Open folder"));
    folder_->hide();
    connect(folder_, &QToolButton::clicked, this, [this] { openPath(folderOf_); });
    QFont bold = unfold_->font();
    bold.setBold(true);
    unfold_->setFont(bold);
    unfold_->setAutoRaise(true);
    unfold_->setToolTip(tr("Details"));
    text_->setObjectName("notice-text");
    text_->setWordWrap(true);
    text_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred); // a long path must not widen the window
    text_->setAlignment(Qt::AlignTop);
    text_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    text_->setTextFormat(Qt::PlainText);
    all_->setFrameShape(QFrame::NoFrame);
    all_->setWidgetResizable(true);
    all_->setWidget(text_);
    all_->viewport()->setAutoFillBackground(false);
    auto* copy = new QToolButton;
    copy->setText(tr("Copy"));
    connect(copy, &QToolButton::clicked, this, [this] { QApplication::clipboard()->setText(words_); });
    close_->setText(QString::fromUtf8("✕"));
    close_->setToolTip(tr("Close"));
    close_->setAccessibleName(tr("Close"));
    close_->setObjectName("notice-close");
    connect(close_, &QToolButton::clicked, this, &NoticeBar::closeShown);
    connect(action_, &QToolButton::clicked, this, [this] {
        used_ = true;
        if (const auto action = onAction_) action(); // which may show another note
    });
    unfold_->setObjectName("notice-unfold");
    unfold_->setCheckable(true);
    connect(unfold_, &QToolButton::toggled, this, &NoticeBar::unfold);
    more_->setObjectName("notice-earlier");
    more_->setToolTip(tr("Shows the next of the notes that were not closed"));
    more_->hide();
    connect(more_, &QToolButton::clicked, this, &NoticeBar::showEarlier);
    head_->addWidget(unfold_);
    head_->addWidget(line_, 1);
    for (QWidget* each : {action_, close_}) head_->addWidget(each);
    for (QWidget* each : std::initializer_list<QWidget*>{more_, folder_, copy}) below_->addWidget(each);
    below_->addStretch(1);
    auto* inner = new QHBoxLayout(details_);
    inner->setContentsMargins(0, 0, 0, 4);
    inner->addWidget(all_, 1);
    inner->addLayout(below_);
    details_->hide();
    setFixedHeight(heightOfLine());
    auto* rows = new QVBoxLayout(this);
    rows->setContentsMargins(10, 2, 6, 2);
    rows->addLayout(head_);
    rows->addWidget(details_);
    for (QToolButton* each : findChildren<QToolButton*>()) connect(each, &QToolButton::pressed, this, [this] { touched_.start(); });
    hide();
    leaves_.setParent(this);
    leaves_.setObjectName("notice-leaves");
    leaves_.setInterval(kUndoneMs);
    connect(&leaves_, &QTimer::timeout, this, &NoticeBar::leave);
    followColours(*this, [this](const Theme&) { paintKind(); });
}

/// The same with any buttons, and while it is hidden.
int NoticeBar::heightOfLine() const {
    constexpr int kForGloves = 52; // px
    constexpr int kAround = 11;    // px, of the letters of a button
    return large_ ? std::max(kForGloves, 2 * fontMetrics().height() + 4) : fontMetrics().height() + kAround;
}

// A strip and an icon have the colour of the kind of notice; the text has the normal colour. The text names the kind as well.
void NoticeBar::paintKind() {
    const Theme& theme = themeInUse();
    const QColor colour = kind_ == Kind::Error ? theme.bad : kind_ == Kind::Warning ? theme.warn : theme.text;
    setStyleSheet(
        QString("#notice-bar { background: %1; border: none; border-left: 6px solid %2; }").arg(theme.panel.name(), colour.name()));
    QPalette letters = unfold_->palette();
    letters.setColor(QPalette::ButtonText, colour);
    unfold_->setPalette(letters);
}

/// Two lines where the text has two: it needs the width.
void NoticeBar::showSign() {
    const QString sign = QString::fromUtf8(kind_ == Kind::Error ? "✕" : kind_ == Kind::Warning ? "▲" : "✓");
    const QString word = kind_ == Kind::Error ? tr("Error") : kind_ == Kind::Warning ? tr("Note") : tr("Done");
    const QString more = (earlier_.empty() ? QString() : QString(" (%1)").arg(earlier_.size() + 1)) + QString::fromUtf8(" ▾");
    unfold_->setText(large_ ? sign + more + '\n' + word : sign + ' ' + word + more);
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
    unfold(false);
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
    more_->setHidden(earlier_.empty());
    showSign();
}

void NoticeBar::put(const Note& note) {
    kind_ = note.kind;
    passes_ = false;
    leaves_.stop();
    paintKind();
    setWords(note.text);
    brief_ = note.brief;
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

bool NoticeBar::fold() {
    const bool open = isVisible() && unfold_->isChecked();
    if (open) unfold(false);
    return open;
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
    fit(); // unfolded or not, as the operator left it
}

/// A closed notice counts as read. Minimising the window does not close the notice.
void NoticeBar::hideEvent(QHideEvent* event) {
    if (!event->spontaneous() && isHidden()) {
        unfold(false); // the place that stays is that of one line
        earlier_.clear();
        more_->hide();
        leaves_.stop();
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

/// Next to the line, or with the details where the line has no room for it.
void NoticeBar::placeAction() {
    int others = action_->sizeHint().width() + kLeastText + 4 * head_->spacing();
    for (const QWidget* each : std::initializer_list<const QWidget*>{unfold_, close_}) others += each->sizeHint().width();
    const bool fits = width() >= others;
    if (fits == (head_->indexOf(action_) >= 0)) return;
    (fits ? below_ : head_)->removeWidget(action_);
    fits ? head_->insertWidget(2, action_) : below_->insertWidget(0, action_);
}

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
    fit();
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
    details_->setVisible(on);
    setFixedHeight(heightOfLine());
    if (on) setMaximumHeight(QWIDGETSIZE_MAX);
    fit();
    for (const QWidget* each = this; each != nullptr; each = each->parentWidget()) // at once: the next click is on what is there
        if (each->layout() != nullptr) each->layout()->activate();
}

/// Where the line is too short for a path, its folders are left out, and the middle of a long name: its ends are read.
void NoticeBar::fitLine(int room) {
    static const QRegularExpression kFolders(R"((?<![:/\w])(?:…?/[^/\s]+)+/(?=[^/\s]))");
    const QString all = brief_.isEmpty() ? words_ : brief_, first = all.section('\n', 0, 0).simplified();
    if (unfolded()) return line_->setText({});                                                 // all of it is below
    const QString shown = first == all.simplified() ? first : first + QString::fromUtf8(" …"); // the worst comes first
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

void NoticeBar::fit() {
    placeAction();
    layout()->activate();
    fitLine(line_->width());
    line_->setToolTip(line_->text() == words_.simplified() && line_->fits(line_->width()) ? QString() : words_);
    const int needed = std::max(0, text_->heightForWidth(std::max(1, all_->viewport()->width())));
    all_->setFixedHeight(std::min(needed, static_cast<int>(kMostOfWindow * window()->height())));
}

void NoticeBar::mousePressEvent(QMouseEvent* event) {
    touched_.start();
    QFrame::mousePressEvent(event);
}

void NoticeBar::resizeEvent(QResizeEvent* event) {
    QFrame::resizeEvent(event);
    fit();
}

bool NoticeBar::unfolded() const { return unfold_->isChecked(); }

void NoticeBar::setBrief(bool on) {
    large_ = on;
    setWords(words_);
    showSign();
    showFolder();
    line_->setLines(on ? 2 : 1);
    unfold(unfolded());
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
