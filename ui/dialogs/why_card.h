// A card beside the window that says why a cell is an edge, or why it is none.
#pragma once

#include "core/explain/edge_profile.h"

#include <QDialog>

class QLabel;

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
    /// Numbers and verdict.
    [[nodiscard]] QString text() const;
    [[nodiscard]] QString verdict() const;
    [[nodiscard]] const ProfileView& picture() const { return *picture_; }

private:
    QLabel *verdict_, *numbers_, *below_;
    ProfileView* picture_;
};

} // namespace edgescan::ui
