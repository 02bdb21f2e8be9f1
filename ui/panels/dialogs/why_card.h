// A card beside the window that says why a cell is an edge, or why it is none.
#pragma once

#include "core/edges/explain/edge_profile.h"

#include <QDialog>

class QLabel;
class QPushButton;

namespace edgescan::ui {

/// The surface across the cell: its points, and a line through either side.
class ProfileView : public QWidget {
    Q_OBJECT
public:
    using QWidget::QWidget;
    void show(const EdgeProfile& profile);
    [[nodiscard]] const EdgeProfile& profile() const { return profile_; }
    [[nodiscard]] QSize sizeHint() const override { return {420, 130}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    EdgeProfile profile_;
};

/// GUI thread only. Not modal; the next cell takes its place.
class WhyCard : public QDialog {
    Q_OBJECT
public:
    explicit WhyCard(QWidget* parent);

    void tell(const QString& text) { tell(text, {}, {}); }
    /// The verdict first, then the picture, then the numbers; each may be empty.
    void tell(const QString& verdict, const EdgeProfile& profile, const QString& numbers);
    /// A button that asks the same of the edge next to this cell, so many cells away; 0: there is none, or this is one.
    void offerBeside(int cells);
    /// Numbers and verdict.
    [[nodiscard]] QString text() const;
    [[nodiscard]] QString verdict() const;
    [[nodiscard]] const ProfileView& picture() const { return *picture_; }

signals:
    void besideWanted();

private:
    QLabel *verdict_, *numbers_, *below_;
    QPushButton* beside_;
    ProfileView* picture_;
};

} // namespace edgescan::ui
