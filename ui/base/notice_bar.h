// The bar above the views: what went wrong or was assumed, where, what to do. Stays until it is closed or replaced.
#pragma once

#include "core/base/result.h"
#include "ui/base/shown_text.h"

#include <QFrame>

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

private:
    void paintKind();

    Kind kind_ = Kind::Done;
    QLabel* sign_;
    QLabel* text_;
    QToolButton* action_;
    QToolButton* copy_ = nullptr;
    std::function<void()> onAction_;
};

} // namespace edgescan::ui
