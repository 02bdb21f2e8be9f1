// The form of a report.
#include "ui/panels/dialogs/report_form.h"

#include "ui/base/scrolled.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace edgescan::ui {
namespace {

constexpr int kLongestLine = 200, kWide = 480, kRemarkLines = 4, kLeastFields = 60, kLettersOfFormat = 20;

QLineEdit* line(const char* name, const QString& text) {
    auto* made = new QLineEdit(text);
    made->setObjectName(name);
    made->setMaxLength(kLongestLine);
    return made;
}

} // namespace

ReportForm::ReportForm(const ReportWords& words, QWidget* parent)
    : QDialog(parent), site_(line("report-site", words.site)), author_(line("report-author", words.author)),
      remark_(new QPlainTextEdit(words.remark)), logo_(line("report-logo", words.logo)), format_(new QComboBox),
      rocks_(new QCheckBox(tr("in the report"))) {
    setObjectName("report-form");
    setWindowTitle(tr("Report"));
    remark_->setObjectName("report-remark");
    remark_->setTabChangesFocus(true);
    remark_->setFixedHeight(remark_->fontMetrics().lineSpacing() * kRemarkLines + 16);
    logo_->setMaxLength(4096);
    logo_->setPlaceholderText(tr("none"));
    format_->setObjectName("report-format");
    format_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon); // a low screen of a cab is narrower than its texts
    format_->setMinimumContentsLength(kLettersOfFormat);
    format_->addItem(tr("HTML: a page for any browser"), ".html");
    format_->addItem(tr("PDF: pages to print and to file"), ".pdf");
    format_->setCurrentIndex(std::max(0, format_->findData(words.extension)));
    auto* fields = new QWidget;
    auto* form = new QFormLayout(fields);
    form->setContentsMargins(0, 0, 0, 0);
    form->addRow(tr("Site"), site_);
    form->addRow(tr("Author"), author_);
    form->addRow(tr("Remark"), remark_);
    form->addRow(tr("Logo (PNG)"), logoRow());
    rocks_->setObjectName("report-rocks");
    rocks_->setChecked(words.rocks);
    form->addRow(tr("Format"), format_);
    form->addRow(tr("Rocks"), rocks_);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Save | QDialogButtonBox::Cancel);
    buttons->button(QDialogButtonBox::Save)->setText(tr("Choose File…"));
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* area = scrolled(*fields); // above the keys of a cab there may be room for one field
    area->setMinimumHeight(kLeastFields);
    auto* column = new QVBoxLayout(this);
    column->addWidget(area, 1);
    column->addWidget(buttons);
    setMinimumWidth(kWide);
}

QWidget* ReportForm::logoRow() {
    auto* both = new QWidget;
    auto* row = new QHBoxLayout(both);
    row->setContentsMargins(0, 0, 0, 0);
    auto* choose = new QToolButton;
    choose->setText(tr("Choose…"));
    row->addWidget(logo_, 1);
    row->addWidget(choose);
    connect(choose, &QToolButton::clicked, this, [this] {
        const QString path = QFileDialog::getOpenFileName(this, tr("Logo"), logo_->text(), tr("PNG picture (*.png)"));
        if (!path.isEmpty()) logo_->setText(path);
    });
    return both;
}

ReportWords ReportForm::words() const {
    return {site_->text().trimmed(), author_->text().trimmed(),         remark_->toPlainText().trimmed(),
            logo_->text().trimmed(), format_->currentData().toString(), rocks_->isChecked()};
}

} // namespace edgescan::ui

#include "moc_report_form.cpp"
