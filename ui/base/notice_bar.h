// The line next to the menus, in a cab above the views: which fault or assumption, where, and what to do. Its place is there while it is
// hidden: no view moves when a note comes or goes. Its sign opens the details: all of the text, the notes that a later one replaced, Copy,
// and the folder of a written file.
#pragma once

#include "core/base/result.h"
#include "ui/base/shown_text.h"

#include <QElapsedTimer>
#include <QFrame>
#include <QStringList>
#include <QTimer>

#include <deque>
#include <functional>

class QBoxLayout;
class QLabel;
class QScrollArea;
class QToolButton;
class QUndoStack;

namespace edgescan::ui {

class ElidedLabel;

class NoticeBar : public QFrame {
    Q_OBJECT
public:
    enum class Kind { Error, Warning, Done };

    explicit NoticeBar(QWidget* parent = nullptr);

    void showNotice(Kind kind, const QString& text);
    /// The same, but a note whose button was not pressed stays in front of it. Returns the text as it is shown.
    QString showBehind(Kind kind, const QString& text);
    void showError(const Error& error) { showNotice(Kind::Error, exactText(error.sentence())); }
    /// Of a step that did not succeed, with what to do: it passes with the next step.
    void showHint(const QString& text);
    /// A step was made or undone: a hint or a success is no longer about what is on the screen. An earlier note that was not closed is
    /// shown in its place.
    void endPassing();
    /// The shown note counts as read. The one before it is shown then; the last one closes the bar.
    void closeShown();
    /// Shows the line only. False: nothing but the line was shown.
    bool fold();
    /// Removes these notes from the bar and from its earlier ones: they are not about what is on the screen any more.
    void withdraw(const QStringList& texts);
    /// Reports that a file was written, with its content ("12 points", may be empty), a button that opens it (a page) or its
    /// folder, of a page a second one for the folder, and `more` sentences.
    void showSaved(const QString& path, const QString& content = {}, const QString& more = {});
    /// Adds a button to the notice, until the next notice, and one that opens the `folder` of a written file.
    void offer(const QString& label, std::function<void()> action, const QString& folder = {});
    /// Adds a button that takes back the newest step of the stack; the notice passes with the next step.
    void offerUndo(QUndoStack& stack);
    /// Names what the newest step of the stack removed, with a button that brings it back, and `more` sentences.
    void showRemoved(QUndoStack& stack, const QString& what, const QString& more = {});
    /// Names the step that was undone last, or the one that was done `again`, with a button that does the next one again. It leaves by
    /// itself, unless the pointer or the focus is on it.
    void showUndone(QUndoStack& stack, bool again = false);
    [[nodiscard]] QString text() const;
    /// For windows with large buttons: the line may be two.
    void setBrief(bool on);
    /// Only what fits: a note never makes its window wider.
    [[nodiscard]] QSize minimumSizeHint() const override { return {0, QFrame::minimumSizeHint().height()}; }
    [[nodiscard]] Kind kind() const { return kind_; }
    /// Shows all lines, or only the first.
    void unfold(bool on);
    [[nodiscard]] bool unfolded() const;
    /// Number of notes and errors that were replaced before the operator closed the bar.
    [[nodiscard]] std::size_t earlier() const { return earlier_.size(); }

signals:
    /// The operator closed this note.
    void closed(const QString& text);

protected:
    void hideEvent(QHideEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;

private:
    struct Note {
        Kind kind = Kind::Done;
        QString text, label; // `label`: text of the button; empty: no button
        std::function<void()> action;
        QString brief{};    // for the line; empty: the text
        bool saved = false; // it names a written file
        bool waits = false; // its button was not pressed
        QString folder{};   // of a written file, which a second button opens; empty: no such button
    };
    [[nodiscard]] static Note noteOf(Kind kind, const QString& text);
    void showNote(const Note& note, bool passes = false);
    [[nodiscard]] int heightOfLine() const;
    void paintKind();
    void showSign();
    void put(const Note& note);
    void setWords(const QString& words);
    void keepShown();
    void keep(const Note& note);
    [[nodiscard]] bool waits() const;
    void countEarlier();
    void showEarlier();
    void bringBack();
    void fit();
    void fitLine(int room);
    void leave();
    void showFolder();
    void placeAction();
    void openPath(const QString& path);

    Kind kind_ = Kind::Done;
    bool passes_ = false;      // with the next step
    bool used_ = false;        // its button was pressed
    bool saved_ = false;       // it names a written file
    bool large_ = false;       // the buttons are: fewer of them
    std::deque<Note> earlier_; // the newest at the end
    std::size_t place_ = 1;    // of the shown note among all of them
    ElidedLabel* line_;        // the text in one line, in a cab in two
    QLabel* text_;             // all of it, on request
    QScrollArea* all_;         // around it
    QWidget* details_;         // below the line
    QBoxLayout *head_, *below_;
    QString words_; // as given
    QToolButton* action_;
    QToolButton* folder_;
    QToolButton* unfold_;
    QToolButton* more_;
    QToolButton* close_;
    std::function<void()> onAction_;
    QString brief_, folderOf_; // of the shown note
    QTimer leaves_;            // runs while the shown note is one that leaves by itself
    QElapsedTimer touched_;
};

} // namespace edgescan::ui
