// Why a cell is an edge.
#include "ui/dialogs/why_card.h"

#include <QDialogButtonBox>
#include <QLabel>
#include <QVBoxLayout>

namespace edgescan::ui {
namespace {

constexpr int kFromRight = 12, kFromTop = 90; // px, of the window's frame

} // namespace

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
    if (!isVisible() && parentWidget() != nullptr) { // over the panel, not over the cell that it speaks of
        const QRect window = parentWidget()->frameGeometry();
        move(window.right() - width() - kFromRight, window.top() + kFromTop);
    }
    show();
    raise();
}

QString WhyCard::text() const { return text_->text(); }

} // namespace edgescan::ui
