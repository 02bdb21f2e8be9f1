// One word about a state, shown by text, shape and colour (NE 107: colour is never the only sign).
#pragma once

#include "core/files/live_feed/live_health.h"

#include <QWidget>

namespace edgescan::ui {

class StateBadge : public QWidget {
    Q_OBJECT
public:
    /// Shapes: disc, two bars, triangle, cross, bar; triangle to the right, sheet.
    enum class Sign { Good, Waiting, Doubtful, Failed, Off, Recorded, File };

    explicit StateBadge(QWidget* parent = nullptr);

    void showState(Sign sign, const QString& text);
    [[nodiscard]] Sign sign() const { return sign_; }
    [[nodiscard]] QString text() const { return text_; }
    [[nodiscard]] QSize sizeHint() const override;
    /// The middle of a long text is cut out (…) where there is no room for it. Otherwise the badge always has room for all of it.
    void setShrinks();
    /// A text that one line has no room for takes two.
    void setTwoLines();
    /// What it shows of its text, in this many px.
    [[nodiscard]] QStringList linesIn(int width) const;
    [[nodiscard]] QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    Sign sign_ = Sign::Off;
    QString text_;
    bool twoLines_ = false;
};

[[nodiscard]] StateBadge::Sign signOf(files::Liveness liveness);
[[nodiscard]] StateBadge::Sign signOf(files::Condition condition);

} // namespace edgescan::ui
