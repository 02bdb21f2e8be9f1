// Why a cell is an edge.
#include "ui/main/why_card.h"

#include <QDialogButtonBox>
#include <QLabel>
#include <QVBoxLayout>

namespace edgescan::ui {

WhyCard::WhyCard(QWidget* parent) : QDialog(parent) {
    setObjectName("why-card");
    setWindowTitle(tr("Why is this cell an edge, or none?"));
    text_ = new QLabel;
    text_->setWordWrap(true);
    text_->setMinimumWidth(420);
    text_->setTextFormat(Qt::PlainText);
    text_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(text_);
    layout->addWidget(buttons);
}

void WhyCard::tell(const QString& text) {
    text_->setText(text);
    adjustSize();
    show();
    raise();
}

QString WhyCard::text() const { return text_->text(); }

} // namespace edgescan::ui
