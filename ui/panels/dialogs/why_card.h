// A card next to the window that explains why a cell is an edge or is not an edge.
#pragma once

#include "core/edges/explain/edge_profile.h"

#include <QDialog>
#include <QPoint>
#include <QVector>

class QLabel;
class QPushButton;
class QScrollArea;

namespace edgescan::ui {

/// The surface across the cell: its points, and a fitted line on each side.
class ProfileView : public QWidget {
    Q_OBJECT
public:
    using QWidget::QWidget;
    void show(const edges::EdgeProfile& profile);
    [[nodiscard]] const edges::EdgeProfile& profile() const { return profile_; }
    [[nodiscard]] QSize sizeHint() const override { return {420, 130}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    edges::EdgeProfile profile_;
};

/// GUI thread only. Not modal; another cell replaces its content. It has one size and place while it is open, over the views and not over
/// the panels next to them; a long text scrolls. The answer alone, until More shows the verdict in the method's terms, the picture and the
/// numbers: the next cell to click is then rarely below the card.
class WhyCard : public QDialog {
    Q_OBJECT
public:
    explicit WhyCard(QWidget* parent);

    /// The answer in one sentence without terms, above the rest; empty: none.
    void showPlain(const QString& sentence);
    /// Which cell is explained, and where it and the `others` that are marked are on the screen: the card does not cover it.
    void showCell(const QString& words, const QVector<QPoint>& places, const QVector<QPoint>& others = {});
    void showExplanation(const QString& text) { showExplanation(text, {}, {}); }
    /// Shows the verdict, the picture and the numbers; each may be empty.
    void showExplanation(const QString& verdict, const edges::EdgeProfile& profile, const QString& numbers);
    /// A button that explains the nearest edge instead, so many cells away; 0: no edge is near, or this cell is one.
    void offerNearestEdge(int cells);
    /// The verdict and the numbers.
    [[nodiscard]] QString text() const;
    [[nodiscard]] QString verdict() const;
    [[nodiscard]] QString cell() const;
    [[nodiscard]] const ProfileView& picture() const { return *picture_; }

signals:
    void nearestEdgeRequested();

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void fit();
    void showParts();
    void showMore();
    void endWithWholeLine();
    void endWithWholeLineSoon();
    void placeNextToCell();

    QScrollArea* content_ = nullptr;
    QLabel *plain_, *cell_, *verdict_, *title_, *numbers_, *below_;
    QPushButton *beside_, *more_;
    ProfileView* picture_;
    QVector<QPoint> places_, others_; // of the cell and of targets, on the screen
};

} // namespace edgescan::ui
