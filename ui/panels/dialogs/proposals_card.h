// Settings that agree with the marked cells: a list for preview and adoption. Not modal.
#pragma once

#include <QDialog>
#include <QStringList>

class QLabel;
class QListWidget;
class QProgressBar;
class QPushButton;

namespace edgescan::ui {

/// GUI thread only. Displays the values it is given and signals the operator's choices.
class ProposalsCard : public QDialog {
    Q_OBJECT
public:
    explicit ProposalsCard(QWidget* parent);

    /// The computation is running and the list is empty. Closing cancels it.
    void begin();
    void showStage(const QString& words, int done, int of);
    [[nodiscard]] bool working() const { return working_; }
    /// `verdict`: one line. The rows stay in this order; no row is selected.
    void showProposals(const QString& verdict, const QStringList& rows);
    [[nodiscard]] QListWidget* list() const { return list_; }
    [[nodiscard]] QPushButton* adopt() const { return adopt_; }
    [[nodiscard]] QString verdict() const;

signals:
    void previewRequested(int row);
    void adoptRequested(int row);

private:
    QLabel* verdict_;
    QProgressBar* progress_;
    bool working_ = false;
    QListWidget* list_;
    QPushButton* adopt_;
};

} // namespace edgescan::ui
