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
    /// The name in a long text is shortened (…) where there is no room for it. Otherwise the badge always has room for all of it.
    void setShrinks();
    /// A text that one line has no room for takes two, or three if the second has no room for the time. A tap is a click.
    void setTwoLines();
    /// What it shows of its text, in this many px.
    [[nodiscard]] QStringList linesIn(int width) const;
    [[nodiscard]] QSize minimumSizeHint() const override;

signals:
    void clicked();

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;

private:
    [[nodiscard]] QStringList brokenIn(int width) const;

    Sign sign_ = Sign::Off;
    QString text_;
    bool twoLines_ = false;
};

[[nodiscard]] StateBadge::Sign signOf(files::Liveness liveness);
[[nodiscard]] StateBadge::Sign signOf(files::Condition condition);

} // namespace edgescan::ui
