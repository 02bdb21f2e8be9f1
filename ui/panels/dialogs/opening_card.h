// "Does this look right?": how the scan was read, evidence against it, and other readings to preview and to adopt. Not modal.
#pragma once

#include "core/files/plausibility/opening_check.h"

#include <QDialog>

class QLabel;
class QPushButton;
class QTreeWidget;

namespace edgescan::ui {

/// In the language of the window; numbers and texts from the file are unchanged.
[[nodiscard]] QString shownSentence(const files::Sentence& sentence);

/// GUI thread only. Displays the values it is given and signals the operator's choices.
class OpeningCard : public QDialog {
    Q_OBJECT
public:
    explicit OpeningCard(QWidget* parent);

    void showPoints(const QString& scan, const std::vector<files::OpeningPoint>& points);
    /// A sentence about the scan on the screen in place of that about the list; empty: that about the list.
    void showState(const QString& words);
    /// Rows of the first level are questions; the rows below them are other readings, in order.
    [[nodiscard]] QTreeWidget* list() const { return list_; }
    [[nodiscard]] QPushButton* adopt() const { return adopt_; }
    [[nodiscard]] QString verdict() const;

signals:
    void previewRequested(int point, int other);
    void adoptRequested(int point, int other);

protected:
    void showEvent(QShowEvent* event) override;

private:
    void placeAtRight();
    void fitRows();
    [[nodiscard]] bool chosen(int& point, int& other) const;

    QLabel *verdict_, *about_;
    QTreeWidget* list_;
    QPushButton* adopt_;
};

} // namespace edgescan::ui
