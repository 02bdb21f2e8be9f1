// The contact sheet of small pictures.
#include "ui/panels/dialogs/contact_card.h"

#include <QDialogButtonBox>
#include <QGridLayout>
#include <QLabel>
#include <QProgressBar>
#include <QScrollArea>
#include <QToolButton>
#include <QVBoxLayout>

namespace edgescan::ui {
namespace {

constexpr int kColumns = 4;
constexpr QSize kUsual(960, 720);
constexpr QSize kLess(20, 60); // smaller than the window on a small screen, so that the frame fits too

} // namespace

ContactCard::ContactCard(QWidget* parent)
    : QDialog(parent), help_(new QLabel), state_(new QLabel), progress_(new QProgressBar), grid_(new QGridLayout) {
    setObjectName("contact-sheet");
    help_->setWordWrap(true);
    for (QLabel* each : {help_, state_}) each->setTextFormat(Qt::PlainText);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    auto* content = new QWidget;
    content->setLayout(grid_);
    auto* scroll = new QScrollArea;
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidget(content);
    auto* column = new QVBoxLayout(this);
    column->addWidget(help_);
    column->addWidget(scroll, 1);
    column->addWidget(state_);
    column->addWidget(progress_);
    column->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

void ContactCard::begin(const QString& name, int pictures) {
    for (QToolButton* each : buttons_) delete each;
    buttons_.clear();
    words_.clear();
    setWindowTitle(tr("Values of %1").arg(name));
    help_->setText(tr("The same picture at other values of %1. A click takes that value. Ctrl+Z undoes it.").arg(name));
    progress_->setRange(0, pictures);
    progress_->setValue(0);
    progress_->show();
    state_->setText(tr("computing %1 of %2 …").arg(1).arg(pictures));
    state_->show();
    if (!isVisible()) resize(kUsual.boundedTo(parentWidget() == nullptr ? kUsual : parentWidget()->window()->size() - kLess));
    show();
    raise();
}

void ContactCard::add(const QImage& picture, const QString& words) {
    auto* button = new QToolButton;
    const int place = static_cast<int>(buttons_.size());
    button->setObjectName(QString("contact-%1").arg(place));
    button->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
    button->setIcon(QIcon(QPixmap::fromImage(picture)));
    button->setIconSize(picture.size() / picture.devicePixelRatio());
    button->setText(words);
    button->setAccessibleName(words);
    connect(button, &QToolButton::clicked, this, [this, place] { emit chosen(place); });
    grid_->addWidget(button, place / kColumns, place % kColumns);
    buttons_.push_back(button);
    words_.push_back(words);
    progress_->setValue(place + 1);
    state_->setText(tr("computing %1 of %2 …").arg(std::min(place + 2, progress_->maximum())).arg(progress_->maximum()));
}

// Marked with words, so that colour is not the only sign.
void ContactCard::end(const std::vector<bool>& steady, int inUse) {
    for (std::size_t n = 0; n < buttons_.size() && n < steady.size(); ++n) {
        QString words = words_[n];
        QStringList marks;
        if (static_cast<int>(n) == inUse) marks << tr("● now");
        if (steady[n]) marks << tr("▭ steady");
        if (!marks.isEmpty()) words += '\n' + marks.join("  ");
        buttons_[n]->setText(words);
        buttons_[n]->setAccessibleName(words);
        buttons_[n]->setCheckable(steady[n]);
        buttons_[n]->setChecked(steady[n]);
        connect(buttons_[n], &QToolButton::toggled, buttons_[n], [button = buttons_[n]] { button->setChecked(true); });
    }
    progress_->hide();
    state_->hide();
}

bool ContactCard::working() const { return !progress_->isHidden(); }

void ContactCard::hideEvent(QHideEvent* event) {
    QDialog::hideEvent(event);
    if (working()) emit givenUp();
}

} // namespace edgescan::ui

#include "moc_contact_card.cpp"
