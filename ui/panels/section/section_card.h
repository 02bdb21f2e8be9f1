// The window of a section: the plot, what it goes through, its zoom, export and Close.
#pragma once

#include <QDialog>

#include <functional>

class QHBoxLayout;
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

signals:
    void closed();

protected:
    void hideEvent(QHideEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    QPushButton* addButton(QHBoxLayout& row, const char* name, const QString& text, const QString& words,
                           const std::function<void()>& press);

    void showView();
    void showAsked(bool found);
    [[nodiscard]] static QString askedWords(bool found, std::size_t ends);

    QLabel* asked_;
    SectionPlot* plot_;
    QLabel* words_;
    QString about_; // the words, without what depends on the view
    QPushButton* export_;
};

} // namespace edgescan::ui
