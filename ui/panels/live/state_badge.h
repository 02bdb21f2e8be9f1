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
    /// A text that has no room is shortened (…) at the end of its name; the time stays whole. Otherwise the badge has room for all of it.
    void setShrinks();
    /// It shrinks, and is so wide whatever it says.
    void setRoom(int pixels);
    /// A text that one line has no room for takes two; without a fixed room three, if the second has no room for the time. A tap is a
    /// click.
    void setTwoLines();
    /// What it shows of its text, in this many px.
    [[nodiscard]] QStringList linesIn(int width) const;
    /// What it shows of its text now.
    [[nodiscard]] QStringList lines() const;
    /// Its own width, with this text.
    [[nodiscard]] int widthFor(const QString& text) const;
    [[nodiscard]] QSize minimumSizeHint() const override;

signals:
    void clicked();

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;

private:
    [[nodiscard]] QStringList brokenIn(int width) const;
    [[nodiscard]] QRect textPlace() const;

    Sign sign_ = Sign::Off;
    QString text_;
    int room_ = 0; // px; 0: that of its text
    bool twoLines_ = false;
};

[[nodiscard]] StateBadge::Sign signOf(files::Liveness liveness);
[[nodiscard]] StateBadge::Sign signOf(files::Condition condition);

} // namespace edgescan::ui
