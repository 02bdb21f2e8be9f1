// The list of proposals.
#include "ui/panels/dialogs/proposals_card.h"

#include <QDialogButtonBox>
#include <QLabel>
#include <QListWidget>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>

namespace edgescan::ui {

ProposalsCard::ProposalsCard(QWidget* parent)
    : QDialog(parent), verdict_(new QLabel), progress_(new QProgressBar), list_(new QListWidget), adopt_(nullptr) {
    setObjectName("proposals");
    setWindowTitle(tr("Settings for these marks"));
    verdict_->setWordWrap(true);
    verdict_->setTextFormat(Qt::PlainText);
    list_->setObjectName("proposals-list");
    list_->setMinimumWidth(520);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    adopt_ = buttons->addButton(tr("&Adopt"), QDialogButtonBox::ApplyRole);
    adopt_->setEnabled(false);
    auto* column = new QVBoxLayout(this);
    column->addWidget(verdict_);
    column->addWidget(progress_);
    progress_->hide();
    column->addWidget(new QLabel(tr("Click a row to see it. Adopt takes it. Close restores the former settings.")));
    column->addWidget(list_, 1);
    column->addWidget(buttons);
    connect(list_, &QListWidget::currentRowChanged, this, [this](int row) {
        adopt_->setEnabled(row >= 0);
        if (row >= 0) emit previewRequested(row);
    });
    connect(adopt_, &QPushButton::clicked, this, [this] {
        if (list_->currentRow() >= 0) emit adoptRequested(list_->currentRow());
    });
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

void ProposalsCard::begin() {
    working_ = true;
    list_->clear();
    adopt_->setEnabled(false);
    progress_->setRange(0, 0);
    progress_->show();
    show();
    raise();
}

void ProposalsCard::showStage(const QString& words, int done, int of) {
    verdict_->setText(words);
    progress_->setRange(0, of);
    progress_->setValue(done);
}

void ProposalsCard::showProposals(const QString& verdict, const QStringList& rows) {
    working_ = false;
    progress_->hide();
    verdict_->setText(verdict);
    list_->clear();
    list_->addItems(rows);
    list_->setCurrentIndex(QModelIndex()); // after setCurrentRow(-1) the focus would select the first row
    adopt_->setEnabled(false);
    show();
    raise();
}

QString ProposalsCard::verdict() const { return verdict_->text(); }

} // namespace edgescan::ui

#include "moc_proposals_card.cpp"
