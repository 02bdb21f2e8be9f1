// The bar above the views: what went wrong or was assumed, where, what to do. Stays until it is closed; what another notice replaced is a
// button away.
#pragma once

#include "core/base/result.h"
#include "ui/base/shown_text.h"

#include <QFrame>

#include <deque>
#include <functional>

class QLabel;
class QToolButton;

namespace edgescan::ui {

class NoticeBar : public QFrame {
    Q_OBJECT
public:
    enum class Kind { Error, Warning, Done };

    explicit NoticeBar(QWidget* parent = nullptr);

    void showNotice(Kind kind, const QString& text);
    void tell(const Error& error) { showNotice(Kind::Error, exactText(error.sentence())); }
    /// That a file was written, what is in it ("12 points", may be empty), and a button that opens its folder.
    void tellSaved(const QString& path, const QString& content = {});
    /// A button beside the text, until the next notice.
    void offer(const QString& label, std::function<void()> action);
    [[nodiscard]] QString text() const;
    /// Without Copy, where every button is large.
    void setBrief(bool on);
    [[nodiscard]] Kind kind() const { return kind_; }
    /// Notes and errors that others replaced before the bar was closed.
    [[nodiscard]] std::size_t earlier() const { return earlier_.size(); }

protected:
    void hideEvent(QHideEvent* event) override;

private:
    struct Note {
        Kind kind = Kind::Done;
        QString text, label; // of the button; empty: none
        std::function<void()> action;
    };
    void paintKind();
    void put(const Note& note);
    void keepShown();
    void showEarlier();

    Kind kind_ = Kind::Done;
    std::deque<Note> earlier_; // the last one at the end
    QLabel* sign_;
    QLabel* text_;
    QToolButton* action_;
    QToolButton* more_;
    QToolButton* copy_ = nullptr;
    std::function<void()> onAction_;
};

} // namespace edgescan::ui
