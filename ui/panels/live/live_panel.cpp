// The panel of a live scanner.
#include "ui/panels/live/live_panel.h"

#include "core/scanner/cola/host_port.h"
#include "ui/base/core_words.h"
#include "ui/base/elided_label.h"
#include "ui/base/flow_layout.h"
#include "ui/base/icons.h"
#include "ui/base/scrolled.h"
#include "ui/base/shown_text.h"
#include "ui/base/themes.h"
#include "ui/base/window_room.h"
#include "ui/panels/live/state_badge.h"
#include "ui/panels/live/sweep_form.h"
#include "ui/panels/live/topic_menu.h"

#include <QApplication>
#include <QCheckBox>
#include <QDialog>
#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QScrollArea>
#include <QSpinBox>
#include <QToolButton>
#include <QUrl>
#include <QVBoxLayout>

#include <algorithm>

namespace edgescan::ui {
namespace {

constexpr int kBetween = 8; // px between two buttons
constexpr int kAfterStopMs = 1500;
constexpr int kNumberOnly = 700;  // px of a cab: another sweep has its number only
constexpr int kNoWords = 540;     // px of a cab: the button of the recording has a sign
constexpr int kUsualPort = 2112;  // SICK's second CoLa port, the default of sick_scan_xd
constexpr int kBridgePort = 8765; // of foxglove_bridge

QPushButton* button(const char* name, const QString& text, const QString& help) {
    auto* made = new QPushButton(text);
    made->setObjectName(name);
    made->setToolTip(help);
    return made;
}

QString portWord() { return LivePanel::tr("Port") + ' '; }

/// Makes a button wide enough for each of its texts, so that its neighbours do not move under a finger.
void reserveWidth(QPushButton& button, std::initializer_list<QString> texts) {
    const QString now = button.text();
    int widest = 0;
    for (const QString& text : texts) {
        button.setText(text);
        widest = std::max(widest, button.sizeHint().width());
    }
    button.setText(now);
    button.setMinimumWidth(widest);
}

} // namespace

LivePanel::LivePanel(QWidget* parent)
    : QWidget(parent), title_(new QLabel(tr("Scanner"))), host_(new QLineEdit), port_(new QSpinBox),
      connect_(button("live-connect", tr("Connect"), tr("EdgeScan sends only read requests and one subscription to the scanner"))),
      keepRepeated_(new QCheckBox(tr("Keep Repeated Values"))), sweepButton_(new QToolButton), sweepDialog_(new QDialog(this)),
      sweep_(new SweepForm), topics_(new TopicMenu),
      record_(button("live-record", tr("Record"), tr("Write every telegram to a new file, unchanged, as it arrives"))),
      keep_(button("live-keep", tr("Keep last minute"), tr("Write what arrived during the last minute to a new file"))),
      hold_(button("live-hold", tr("Hold"), tr("The picture stays as it is while the scanner goes on."))),
      follow_(button("live-follow", tr("Follow"), tr("The picture grows with the scanner."))), other_(button("live-other", {}, {})),
      close_(new QToolButton), recorded_(new StateBadge), scanner_(new ElidedLabel), strip_(new HealthStrip), otherMenu_(new QMenu(this)) {
    setObjectName("live-panel");
    host_->setObjectName("live-host");
    host_->setPlaceholderText(tr("scanner, or ws://ROBOT"));
    host_->setToolTip(tr("Name or address of the scanner; ws://ROBOT is a robot with ROS on which foxglove_bridge runs"));
    host_->setAccessibleName(tr("Name or address of the scanner"));
    host_->setInputMethodHints(Qt::ImhPreferNumbers); // most scanners have an address, not a name
    port_->setObjectName("live-port");
    port_->setAccessibleName(tr("Port of the scanner"));
    port_->setToolTip(tr("Port of the scanner"));
    port_->setPrefix(portWord());
    port_->setRange(1, 65535);
    port_->setValue(kUsualPort);
    keepRepeated_->setObjectName("live-keep-repeated");
    keepRepeated_->setToolTip(tr("Take a value or point that repeats exactly, far apart from the rest, as measured and not as no return"));
    keepRepeated_->setFocusPolicy(Qt::TabFocus);
    addSweepDialog();
    record_->setCheckable(true);
    recorded_->setObjectName("live-recorded");
    recorded_->hide();
    scanner_->setObjectName("live-scanner");
    otherMenu_->setObjectName("live-others");
    close_->setObjectName("live-close");
    close_->setText(tr("Close"));
    close_->setFocusPolicy(Qt::TabFocus);

    auto* head = new QWidget;
    auto* row = buttons_ = new FlowLayout(head);
    row->setContentsMargins(6, 0, 6, 0);
    row->setSpacing(kBetween);
    for (QWidget* each : std::initializer_list<QWidget*>{title_, host_, port_, keepRepeated_, sweepButton_, connect_, topics_, record_,
                                                         recorded_, keep_, scanner_, close_})
        row->addWidget(each);
    auto* first = stripRow_ = new QHBoxLayout;
    first->setContentsMargins(6, 6, 0, 0);
    first->setSpacing(kBetween);
    for (QPushButton* each : {hold_, follow_, other_}) first->addWidget(each, 0, Qt::AlignTop);
    first->addWidget(strip_, 1);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(head);     // first: the buttons do not move when the strip gets another row
    column->addLayout(first, 1); // spare height, until the panel gives it back, moves no button

    connect(connect_, &QPushButton::clicked, this, [this] {
        if (connected_) {
            sinceStop_.start();
            emit disconnectRequested();
        } else if (!brief_ || !sinceStop_.isValid() || sinceStop_.elapsed() > kAfterStopMs) { // else the second tap of a glove
            emit connectRequested();
        }
    });
    connect(host_, &QLineEdit::textChanged, this, &LivePanel::followAddress);
    connect(host_, &QLineEdit::editingFinished, this, &LivePanel::splitAddress);
    for (QLineEdit* each : {host_, port_->findChild<QLineEdit*>()}) {
        connect(each, &QLineEdit::returnPressed, this, [this] {
            if (!connected_) emit connectRequested();
        });
    }
    connect(record_, &QPushButton::clicked, this, &LivePanel::recordRequested);
    connect(keep_, &QPushButton::clicked, this, &LivePanel::keepRequested);
    connect(hold_, &QPushButton::clicked, this, [this] { emit followRequested(false); });
    connect(follow_, &QPushButton::clicked, this, [this] { emit followRequested(true); });
    connect(other_, &QPushButton::clicked, this, &LivePanel::askOther);
    connect(close_, &QToolButton::clicked, this, &LivePanel::close);
    // A click does not take the keyboard focus. Otherwise Space (play and pause) would press the button again, which may have another
    // meaning by then.
    for (QPushButton* each : {connect_, record_, keep_, hold_, follow_, other_}) {
        each->setFocusPolicy(Qt::TabFocus);
        each->installEventFilter(this);
    }
    for (auto [each, sign] : {std::pair(hold_, "hold"), std::pair(follow_, "play"), std::pair(other_, "play")})
        each->setIcon(toolIcon(sign));
    setConnected(false);
}

/// A dialog, not a menu: a second click, or a tap on the keys of a cab, would close a menu.
void LivePanel::addSweepDialog() {
    sweepButton_->setObjectName("live-sweep");
    sweepButton_->setText(tr("Sweep…"));
    sweepButton_->setToolTip(tr("Lines of a sweep, step per line, mounting"));
    sweepDialog_->setObjectName("sweep-dialog");
    sweepDialog_->setWindowTitle(sweepButton_->toolTip());
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    auto* column = new QVBoxLayout(sweepDialog_);
    column->addWidget(scrolled(*sweep_)); // also on a low screen Close is in sight
    column->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::rejected, sweepDialog_, &QDialog::accept);
    connect(sweepButton_, &QToolButton::clicked, this, &LivePanel::askSweep);
    // One change for all typed values.
    connect(sweepDialog_, &QDialog::finished, this, [this] {
        if (connected_) emit sweepRequested();
    });
}

void LivePanel::setAddress(const QString& host, int port) {
    host_->setText(host);
    if (port > 0 && (!bridge_ || QUrl(host).port() <= 0)) port_->setValue(port);
}

/// A port in the address is the port; else the usual one of scanners gives way to that of bridges, and the other way round.
void LivePanel::followAddress() {
    const QUrl address(host());
    const bool bridge = address.scheme() == "ws";
    const int typed = bridge ? address.port() : -1;
    if (typed > 0)
        port_->setValue(typed);
    else if (bridge != bridge_ && port_->value() == (bridge_ ? kBridgePort : kUsualPort))
        port_->setValue(bridge ? kBridgePort : kUsualPort);
    bridge_ = bridge;
    port_->setEnabled(!connected_ && typed <= 0);
    keepRepeated_->setHidden(!bridge || title_->isHidden());
}

void LivePanel::splitAddress() {
    const auto typed = scanner::hostPort(host().toStdString());
    if (connected_ || !typed || typed->bridge) return;
    if (const QString name = exactText(typed->host); name != host()) host_->setText(name);
    if (typed->portTyped) port_->setValue(typed->port);
}

QString LivePanel::host() const { return host_->text().trimmed(); }
int LivePanel::port() const { return port_->value(); }
bool LivePanel::keepsRepeated() const { return bridge_ && keepRepeated_->isChecked(); }
void LivePanel::setKeepRepeated(bool on) { keepRepeated_->setChecked(on); }
void LivePanel::setSweep(const scanner::SweepSettings& settings) { sweep_->showSettings(settings); }
void LivePanel::showAxisFromRanges(std::optional<Axis> axis) { sweep_->showAxisFromRanges(axis); }
scanner::SweepSettings LivePanel::sweep() const { return sweep_->settings(); }
QString LivePanel::scannerShown() const { return scanner_->text(); }

void LivePanel::askAddress() {
    asking_ = true;
    showFields();
    show();
    host_->setFocus();
    host_->selectAll();
}

void LivePanel::toggleAddress() {
    if (!closeAddress()) askAddress();
}

bool LivePanel::closeAddress() {
    if (connected_ || !asking_ || isHidden()) return false;
    close();
    return true;
}

void LivePanel::close() {
    asking_ = false;
    showFields();
    hide();
    emit closed();
}

/// Esc in one of the fields.
void LivePanel::keyPressEvent(QKeyEvent* event) { event->key() == Qt::Key_Escape && !connected_ ? close() : QWidget::keyPressEvent(event); }

void LivePanel::askSweep() {
    if (!sweepDialog_->isVisible()) {
        constexpr QSize kAround(60, 90); // px, of the dialog round the fields
        sweepDialog_->resize((sweep_->sizeHint() + kAround).boundedTo(roomForDialog(*this)));
        sweep_->begin();
    }
    sweepDialog_->show();
    sweepDialog_->raise();
    sweepDialog_->activateWindow();
}

void LivePanel::setConnected(bool connected) {
    connected_ = connected;
    // What is hidden would pass the focus on, and the next Space would press another button.
    if (QWidget* focused = QApplication::focusWidget(); focused != nullptr && isAncestorOf(focused)) focused->clearFocus();
    connect_->setText(connected ? tr("Stop") : tr("Connect"));
    host_->setEnabled(!connected);
    followAddress();
    for (QWidget* each : std::initializer_list<QWidget*>{record_, keep_}) each->setEnabled(connected);
    others_.clear();
    asking_ = false;
    if (!connected) setRecording(false);
    setFollowing(true);
    strip_->setSteady(connected);
    reserveWidths();
    showFields();
    strip_->setVisible(connected || !strip_->shown().badge.empty());
}

void LivePanel::forgetScanner() {
    strip_->showHealth({});
    strip_->hide();
    scanner_->setText(QString());
    scanner_->setToolTip(QString());
    if (!asking_) hide(); // else the operator opened it for another address
}

void LivePanel::setBrief(bool on) {
    brief_ = on;
    port_->setPrefix(on ? QString() : portWord());
    strip_->setBrief(on);
    int place = 0;
    for (QPushButton* each : {hold_, follow_, other_}) {
        if (on) // large buttons: all of them in one row, so that the strip has the whole width
            buttons_->addWidget(each);
        else
            stripRow_->insertWidget(place++, each, 0, Qt::AlignTop);
    }
    stripRow_->setContentsMargins(6, on ? 0 : 6, 0, 0);
    nameOther();
    nameRecord();
    showFields();
}

/// What the state needs; with gloves on, only what a connected scanner needs, and after Stop the other sweep.
void LivePanel::showFields() {
    const bool few = brief_ && (connected_ || (!others_.isEmpty() && !asking_));
    for (QWidget* each : std::initializer_list<QWidget*>{title_, host_, port_}) each->setHidden(connected_ || few);
    keepRepeated_->setHidden(!bridge_ || connected_ || few);
    sweepButton_->setHidden(few);
    scanner_->setHidden(few || (brief_ && !connected_)); // without words it would push Close into a line of its own
    record_->setHidden(!connected_);
    for (QPushButton* each : {hold_, follow_}) each->setHidden(!connected_);
    other_->setHidden(connected_ || others_.isEmpty());
    // With gloves on, the strip has it.
    QSizePolicy place = recorded_->sizePolicy();
    place.setRetainSizeWhenHidden(connected_ && !brief_);
    recorded_->setSizePolicy(place);
    if (brief_ || !connected_) recorded_->hide();
    topics_->setHidden(!connected_ || !bridge_ || brief_);
    keep_->setHidden(brief_ || !connected_); // it is in the menu
    close_->setHidden(connected_ || few);
}

void LivePanel::reserveWidths() {
    reserveWidth(*connect_, {tr("Stop"), tr("Connect")});
    nameRecord();
    constexpr int kFrame = 24, kUsualField = 220; // px
    const int words = host_->fontMetrics().horizontalAdvance(host_->placeholderText()) + kFrame;
    host_->setMinimumWidth(words);
    host_->setMaximumWidth(std::max(kUsualField, words));
    const QFontMetrics letters(recorded_->font());
    constexpr int kSignAndMargins = 34; // px
    recorded_->setFixedWidth(letters.horizontalAdvance(coreWords("recording 9999.9 MB")) + kSignAndMargins);
}

void LivePanel::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange) reserveWidths();
}

void LivePanel::setRecording(bool recording) {
    record_->setChecked(recording);
    topics_->setEnabled(!recording); // another topic is another connection, which would end the recording
    nameRecord();
}

/// A narrow cab has all buttons in one row: the words of this one are the longest.
void LivePanel::nameRecord() {
    const bool narrow = brief_ && width() < kNoWords;
    const QString start = narrow ? QStringLiteral("● REC") : tr("Record"), end = narrow ? QStringLiteral("■ REC") : tr("Stop recording");
    reserveWidth(*record_, {start, end});
    record_->setText(record_->isChecked() ? end : start);
    record_->setAccessibleName(record_->isChecked() ? tr("Stop recording") : tr("Record"));
}

/// A double tap is one tap: the second one would press what the first one made of the button, as Connect after Stop.
bool LivePanel::eventFilter(QObject* watched, QEvent* event) {
    return event->type() == QEvent::MouseButtonDblClick || QWidget::eventFilter(watched, event);
}

/// Only one of the two buttons can be pressed; while the picture is held, Follow has the colour of what is chosen.
void LivePanel::setFollowing(bool following) {
    const bool held = connected_ && !following;
    hold_->setEnabled(connected_ && following);
    follow_->setEnabled(held);
    QPalette colours;
    if (held) colours.setColor(QPalette::Button, themeInUse().chosen);
    if (held) colours.setColor(QPalette::ButtonText, Qt::white);
    follow_->setPalette(colours);
}

void LivePanel::offerOthers(const QStringList& sweeps, const QString& help) {
    if (connected_) return;
    others_ = sweeps;
    other_->setToolTip(help);
    nameOther();
    showFields();
    if (!sweeps.isEmpty()) show();
}

void LivePanel::nameOther() {
    const QString only = others_.value(0);
    other_->setText(others_.size() != 1 ? tr("Show another sweep…")
                                        : tr("Show %1").arg(brief_ && width() < kNumberOnly ? only.section(':', 0, 0).trimmed() : only));
}

void LivePanel::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    nameOther();
    nameRecord();
}

void LivePanel::askOther() {
    if (others_.size() == 1) return emit otherRequested(0);
    otherMenu_->clear();
    for (int n = 0; n < others_.size(); ++n)
        otherMenu_->addAction(tr("Show %1").arg(others_[n]), this, [this, n] { emit otherRequested(n); });
    otherMenu_->popup(other_->mapToGlobal(other_->rect().bottomLeft()));
}

void LivePanel::showHealth(const files::LiveHealth& health, HealthStrip::Picture picture, const QString& note) {
    strip_->showHealth(health, picture, note);
    strip_->show();
    const bool recording = !health.recording.empty() && health.recorded == files::Condition::Good; // else the strip has the sentence
    const bool present = health.liveness == files::Liveness::Live;
    recorded_->showState(present ? StateBadge::Sign::Good : StateBadge::Sign::Off, coreWords(health.recording));
    recorded_->setToolTip(recorded_->text());
    recorded_->setFixedWidth(std::max(recorded_->minimumWidth(), recorded_->widthFor(recorded_->text()))); // "3 s ago" is whole
    recorded_->setVisible(recording && connected_ && !brief_);
    const QString scanner = shownText(health.scanner);
    if (scanner_->text() == scanner) return;
    scanner_->setText(scanner);
    scanner_->setToolTip(scanner);
}

} // namespace edgescan::ui

#include "moc_live_panel.cpp"
