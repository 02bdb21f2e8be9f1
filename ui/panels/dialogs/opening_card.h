// "Does this look right?": how the scan was read, what speaks against it, and other ways to look at and to take. Not modal.
#pragma once

#include "core/files/plausibility/opening_check.h"

#include <QDialog>

class QLabel;
class QPushButton;
class QTreeWidget;

namespace edgescan::ui {

/// In the language of the window; numbers and what the file says of itself as they are.
[[nodiscard]] QString shownSentence(const Sentence& sentence);

/// GUI thread only. Shows what it is told and says what the operator wants.
class OpeningCard : public QDialog {
    Q_OBJECT
public:
    explicit OpeningCard(QWidget* parent);

    void tell(const QString& scan, const std::vector<OpeningPoint>& points);
    /// In words, below the list: what is on the screen.
    void showState(const QString& words);
    /// Rows of the first level are points, those below them other readings, in order.
    [[nodiscard]] QTreeWidget* list() const { return list_; }
    [[nodiscard]] QPushButton* adopt() const { return adopt_; }
    [[nodiscard]] QString verdict() const;

signals:
    void previewWanted(int point, int other);
    void adoptWanted(int point, int other);

protected:
    void showEvent(QShowEvent* event) override;

private:
    void fitRows();
    [[nodiscard]] bool chosen(int& point, int& other) const;

    QLabel *verdict_, *state_;
    QTreeWidget* list_;
    QPushButton* adopt_;
};

} // namespace edgescan::ui
