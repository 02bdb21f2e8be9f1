// Asks what a report says besides the scan: site, author, remark, logo; and for its format.
#pragma once

#include <QDialog>

class QCheckBox;
class QComboBox;
class QLineEdit;
class QPlainTextEdit;

namespace edgescan::ui {

struct ReportWords {
    QString site{}, author{}, remark{};
    QString logo{};              ///< path of a PNG picture; empty: none
    QString extension = ".html"; ///< or ".pdf"
    bool rocks = true;           ///< false: the page leaves out those that are shown
};

class ReportForm : public QDialog {
    Q_OBJECT
public:
    explicit ReportForm(const ReportWords& words, QWidget* parent = nullptr);

    [[nodiscard]] ReportWords words() const;

private:
    [[nodiscard]] QWidget* logoRow();

    QLineEdit* site_;
    QLineEdit* author_;
    QPlainTextEdit* remark_;
    QLineEdit* logo_;
    QComboBox* format_;
    QCheckBox* rocks_;
};

} // namespace edgescan::ui
