// Settings that agree with marked cells: a list to look through and to adopt from. Not modal.
#pragma once

#include <QDialog>
#include <QStringList>

class QLabel;
class QListWidget;
class QProgressBar;
class QPushButton;

namespace edgescan::ui {

/// GUI thread only. Shows what it is told and says what the operator wants.
class ProposalsCard : public QDialog {
    Q_OBJECT
public:
    explicit ProposalsCard(QWidget* parent);

    /// It is being worked out: nothing to choose yet. Closing gives up.
    void begin();
    void showStage(const QString& words, int done, int of);
    [[nodiscard]] bool working() const { return working_; }
    /// `verdict`: one line. The rows are kept in order; none is chosen.
    void tell(const QString& verdict, const QStringList& rows);
    [[nodiscard]] QListWidget* list() const { return list_; }
    [[nodiscard]] QPushButton* adopt() const { return adopt_; }
    [[nodiscard]] QString verdict() const;

signals:
    void previewWanted(int row);
    void adoptWanted(int row);

private:
    QLabel* verdict_;
    QProgressBar* progress_;
    bool working_ = false;
    QListWidget* list_;
    QPushButton* adopt_;
};

} // namespace edgescan::ui
