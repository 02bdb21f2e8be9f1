// The window of a section: the plot, what it goes through, and its export.
#pragma once

#include <QDialog>

class QLabel;
class QPushButton;

namespace edgescan::ui {

class SectionPlot;

/// GUI thread only.
class SectionCard : public QDialog {
    Q_OBJECT
public:
    explicit SectionCard(QWidget* parent);

    [[nodiscard]] SectionPlot& plot() const { return *plot_; }
    void setWords(const QString& words);
    [[nodiscard]] QString words() const;
    [[nodiscard]] QPushButton* exportButton() const { return export_; }

private:
    SectionPlot* plot_;
    QLabel* words_;
    QPushButton* export_;
};

} // namespace edgescan::ui
