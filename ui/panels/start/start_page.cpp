// Buttons and list of the page.
#include "ui/panels/start/start_page.h"

#include "core/base/sha256.h"
#include "core/base/utc_time.h"
#include "core/base/version.h"
#include "core/base/whole_file.h"
#include "core/edges/gray/gray.h"
#include "core/files/open_save/open_scan.h"
#include "core/inspect/session_file/session_file.h"
#include "core/scan/grid/acquisition.h"
#include "ui/base/count_text.h"
#include "ui/base/icons.h"
#include "ui/base/scrolled.h"
#include "ui/base/shown_text.h"
#include "ui/base/themes.h"
#include "ui/engine/worker_bridge/in_background.h"

#include <QApplication>
#include <QBuffer>
#include <QCommandLinkButton>
#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QIcon>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

#include <algorithm>
#include <filesystem>
#include <new>
#include <optional>
#include <span>
#include <utility>

namespace edgescan::ui {
namespace {

const QString kWordsKey = QStringLiteral("EdgeScanWords");

/// File name in the cache: another content, or another version of the program, gives another name.
QString cacheName(const QString& path) {
    const std::filesystem::path file = exactBytes(absolutePath(path));
    std::error_code gone;
    const auto size = std::filesystem::file_size(file, gone);
    const auto modified = std::filesystem::last_write_time(file, gone).time_since_epoch().count();
    const std::string key = file.string() + "\n" + std::to_string(size) + "\n" + std::to_string(modified) + "\n" +
                            QCoreApplication::applicationVersion().toStdString() + "\n" +
                            languageInUse().toStdString(); // the words are stored in the picture
    return exactText(sha256Hex(std::as_bytes(std::span(key)))) + ".png";
}

QString wordsOf(const Scan& scan) {
    QStringList words;
    const Acquisition measured = scan.acquisition ? *scan.acquisition : Acquisition{};
    if (const auto seconds = parseUtc(measured.startUtc)) words << shownText(utcText(*seconds)).left(16).replace('T', ' ') + " UTC";
    const bool some = measured.linesExpected > scan.lines();
    words << (some ? QString("%1 / %2").arg(countText(scan.lines()), countText(measured.linesExpected)) : countText(scan.lines())) + " × " +
                 countText(scan.beams());
    const bool recorded = scan.format == "recording" || scan.format == "sweep";
    words << (recorded ? QObject::tr("RECORDED") : QObject::tr("FILE"));
    if (some) words << QObject::tr("✕ INCOMPLETE");
    return words.join(QString::fromUtf8(" · "));
}

QImage pictureOf(const Scan& scan) {
    const auto levels = edges::grayImage(scan, edges::Settings{}).levels;
    QImage image(levels.beams, levels.lines, QImage::Format_Grayscale8);
    for (int line = 0; line < levels.lines; ++line) {
        uchar* row = image.scanLine(line);
        for (int beam = 0; beam < levels.beams; ++beam)
            row[beam] = scan.state.at(line, beam) == CellState::Valid ? levels.at(line, beam) : uchar{0};
    }
    if (image.width() <= kThumbnailPx && image.height() <= kThumbnailPx) return image;
    return image.scaled(kThumbnailPx, kThumbnailPx, Qt::KeepAspectRatio, Qt::SmoothTransformation);
}

void keep(QImage picture, const QString& words, const QString& path) {
    picture.setText(kWordsKey, exactText(words.toUtf8().toBase64().toStdString()));
    QByteArray png;
    QBuffer buffer(&png);
    buffer.open(QIODevice::WriteOnly);
    picture.save(&buffer, "PNG");
    QDir().mkpath(QFileInfo(path).path());
    // If storing fails, the picture is made again the next time.
    (void)writeWholeFile(exactBytes(path), std::as_bytes(std::span(png.constData(), static_cast<std::size_t>(png.size()))));
}

} // namespace

RecentScan recentScan(const QString& path, const QString& cache, const std::function<bool()>& goOn) {
    RecentScan found{path, false, {}, {}};
    found.exists = isFile(path);
    if (!found.exists) return found;
    const QString kept = cache.isEmpty() ? QString() : cache + "/" + cacheName(path);
    if (!kept.isEmpty() && found.picture.load(kept, "PNG")) {
        found.words = QString::fromUtf8(QByteArray::fromBase64(found.picture.text(kWordsKey).toLatin1()));
        if (!found.words.isEmpty()) return found;
    }
    ReadingOptions options;
    options.progress = [&goOn](const char*, double) { return goOn(); };
    try {
        const Result<Scan> scan = files::openScan(exactBytes(path), options);
        if (!scan) {
            found.words = shownText(scan.error().what);
            return found;
        }
        found.words = wordsOf(*scan);
        found.picture = pictureOf(*scan);
    } catch (const std::bad_alloc&) {
        return found; // too large for a preview
    }
    if (!kept.isEmpty()) keep(found.picture, found.words, kept);
    return found;
}

void trimThumbnails(const QString& cache, int most) {
    if (cache.isEmpty()) return;
    const QFileInfoList files = QDir(cache).entryInfoList({"*.png"}, QDir::Files, QDir::Time);
    for (const QFileInfo& file : files.mid(most)) QFile::remove(file.absoluteFilePath());
}

namespace {

constexpr int kMostThumbnails = 100;
constexpr int kButtonHigh = 56;          // px; higher where its description needs two lines
constexpr int kLow = 580;                // px of the page
constexpr int kSign = 28, kAppSign = 72; // px
constexpr int kTop = 52, kAbove = 8;     // px: where it has room, a note or the tour comes above the content and moves nothing
constexpr int kTopForGloves = 104;       // px: a note of a low cab has two rows
constexpr int kThere = Qt::UserRole + 1;

QCommandLinkButton* addButton(QVBoxLayout& column, const char* name, const char* sign, const QString& text, const QString& more) {
    auto* button = new QCommandLinkButton(text, more);
    button->setObjectName(name);
    button->setIcon(toolIcon(sign));
    button->setIconSize({kSign, kSign});
    button->setMinimumHeight(kButtonHigh);
    column.addWidget(button);
    return button;
}

} // namespace

StartPage::StartPage(const QString& cache, QWidget* parent)
    : QFrame(parent), cache_(cache), list_(new QListWidget), none_(new QLabel), clear_(new QPushButton(tr("Clear"))) {
    setObjectName("start-page");
    setAutoFillBackground(true);
    auto* begin = new QWidget;
    auto* left = new QVBoxLayout(begin);
    left->setContentsMargins(0, 0, 0, 0);
    left->setSpacing(8);
    left->addWidget(title_ = makeTitle());
    open_ = addButton(*left, "start-open", "open", tr("Open a scan…"), QString());
    connect(open_, &QPushButton::clicked, this, &StartPage::openRequested);
    connect_ = addButton(*left, "start-connect", "connect", tr("Connect to the scanner…"), QString());
    connect(connect_, &QPushButton::clicked, this, &StartPage::connectRequested);
    session_ = addButton(*left, "start-session", "session", tr("Go on with the last session"), QString());
    connect(session_, &QPushButton::clicked, this, &StartPage::continueRequested);
    connect(addButton(*left, "start-demo", "demo", tr("Demo draw-bell"), tr("no scanner, no files needed")), &QPushButton::clicked, this,
            &StartPage::demoRequested);
    connect(addButton(*left, "start-demo-pair", "ab", tr("Demo before and after a blast"), tr("both, and what changed between them")),
            &QPushButton::clicked, this, &StartPage::demoPairRequested);

    auto* right = new QVBoxLayout;
    auto* head = new QHBoxLayout;
    auto* recent = new QLabel(tr("Recent"));
    QFont bold = recent->font();
    bold.setBold(true);
    recent->setFont(bold);
    clear_->setObjectName("start-clear");
    connect(clear_, &QPushButton::clicked, this, &StartPage::clearRequested);
    head->addWidget(recent, 1);
    head->addWidget(clear_);
    right->addLayout(head);
    list_->setObjectName("start-recent");
    list_->setIconSize(QSize(kThumbnailPx / 2, kThumbnailPx / 2));
    list_->setSpacing(3);
    list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    list_->setTextElideMode(Qt::ElideMiddle);
    list_->setAccessibleName(recent->text());
    connect(list_, &QListWidget::itemActivated, this, [this](QListWidgetItem* item) {
        const QString path = item->data(Qt::UserRole).toString();
        item->data(kThere).toBool() ? emit scanRequested(path) : emit locateRequested(path);
    });
    connect(list_, &QListWidget::itemClicked, list_, &QListWidget::itemActivated);
    right->addWidget(list_, 1);
    none_->setText(tr("Scans that were open are listed here."));
    right->addWidget(none_, 1, Qt::AlignTop);

    auto* row = row_ = new QHBoxLayout;
    row->addWidget(begin, 2, Qt::AlignTop);
    row->addLayout(right, 3);
    auto* content = new QWidget;
    auto* all = all_ = new QVBoxLayout(content);
    all->setSpacing(12);
    all->addLayout(row, 1);
    all->addWidget(foot_ = makeFoot());
    auto* around = new QVBoxLayout(this);
    around->setContentsMargins(0, 0, 0, 0);
    around->addWidget(scrolled(*content)); // on a small screen nothing is squeezed
    setFocusProxy(open_);
    followColours(*this, [this](const Theme& theme) {
        setStyleSheet(QString("QCommandLinkButton { background: %1; color: %2; border: 1px solid %3; border-radius: 4px; padding: 0px; }"
                              "QCommandLinkButton:hover { background: %4; }"
                              "QCommandLinkButton:disabled { background: %5; color: %6; }")
                          .arg(theme.button.name(), theme.text.name(), theme.edge.name(), theme.panel.name(), theme.window.name(),
                               theme.unusable.name()));
    });
}

/// In a low cab the buttons have all the room: each of them is whole.
void StartPage::fit() {
    const bool low = forTouch_ && height() < kLow;
    for (QWidget* each : {title_, foot_}) each->setHidden(low);
    all_->setContentsMargins(low ? QMargins(12, 0, 12, 8) : QMargins(40, kAbove, 40, 20));
    row_->setSpacing(low ? 16 : 40);
    row_->setStretch(1, low ? 2 : 3);
    row_->itemAt(0)->widget()->layout()->setSpacing(low ? 4 : 8);
    const int wide = all_->parentWidget()->width();
    const int high = all_->hasHeightForWidth() ? all_->totalHeightForWidth(wide) : all_->totalMinimumSize().height();
    setContentsMargins(0, std::max(low ? std::clamp(height() - high, kAbove, kTopForGloves) : kTop, covered_), 0, 0);
}

void StartPage::setTopCovered(int pixels) {
    if (std::exchange(covered_, pixels) != pixels) fit();
}

void StartPage::resizeEvent(QResizeEvent* event) {
    QFrame::resizeEvent(event);
    fit();
}

QWidget* StartPage::makeTitle() {
    auto* whole = new QWidget;
    auto* sign = new QLabel;
    sign->setPixmap(QApplication::windowIcon().pixmap(kAppSign));
    auto* name = new QLabel("EdgeScan");
    QFont large = name->font();
    large.setPointSizeF(2.0 * large.pointSizeF());
    large.setBold(true);
    name->setFont(large);
    auto* words = new QVBoxLayout;
    words->setSpacing(2);
    words->addWidget(name, 0, Qt::AlignBottom);
    auto* what = new QLabel(tr("The edges of rocks in a laser range scan"));
    what->setWordWrap(true);
    words->addWidget(what, 0, Qt::AlignTop);
    auto* row = new QHBoxLayout(whole);
    row->setContentsMargins(0, 0, 0, 12);
    row->setSpacing(16);
    row->addWidget(sign);
    row->addLayout(words, 1);
    return whole;
}

QWidget* StartPage::makeFoot() {
    auto* whole = new QWidget;
    auto* words = new QLabel(tr("Reads raw grids, recordings (.mcap), ROS bags, PCD, PLY, E57, LAS, PTX, CSV, XYZ and others.") + "\n" +
                             tr("EdgeScan sends only read requests and one subscription to the scanner.") + " " + exactText(version()));
    words->setWordWrap(true);
    auto* cab = cab_ = new QPushButton(toolIcon("cab-mode"), tr("Cab mode"));
    cab->setObjectName("start-cab");
    connect(cab, &QPushButton::clicked, this, &StartPage::cabRequested);
    auto* keys = keys_ = new QPushButton(tr("Keys and mouse"));
    keys->setObjectName("start-keys");
    connect(keys, &QPushButton::clicked, this, &StartPage::keysRequested);
    auto* row = new QHBoxLayout(whole);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(12);
    row->addWidget(words, 1);
    row->addWidget(cab);
    row->addWidget(keys);
    return whole;
}

void StartPage::setForTouch(bool on) {
    open_->setDescription(on ? tr("a file on this computer or on a stick") : tr("Ctrl+O, or drop files anywhere in this window"));
    connect_->setDescription(on ? tr("a SICK LMS, or a robot with ROS as ws://ROBOT")
                                : tr("Ctrl+L; a SICK LMS, or a robot with ROS as ws://ROBOT"));
    for (QPushButton* each : {cab_, keys_}) each->setHidden(on);
    forTouch_ = on;
    fit();
}

void StartPage::showRecent(const QStringList& paths) {
    list_->clear();
    waiting_ = paths;
    none_->setVisible(paths.isEmpty());
    list_->setVisible(!paths.isEmpty());
    clear_->setVisible(!paths.isEmpty());
    for (const QString& path : paths) {
        auto* item = new QListWidgetItem(shownName(QFileInfo(path).fileName()) + "\n…");
        item->setData(Qt::UserRole, path);
        item->setData(kThere, true);
        item->setToolTip(shownText(path));
        item->setSizeHint(QSize(100, kThumbnailPx / 2 + 10));
        list_->addItem(item);
    }
    lookAtNext();
}

void StartPage::lookAtNext() {
    if (looking_ || waiting_.isEmpty()) return;
    looking_ = true;
    inBackground(
        this,
        [this, path = waiting_.takeFirst()]() -> std::function<void()> {
            RecentScan scan = recentScan(path, cache_, [this] { return !ending_; });
            trimThumbnails(cache_, kMostThumbnails);
            return [this, scan = std::move(scan)] { showPreview(scan); };
        },
        [](const QString&) {}, // continues without a picture
        [this] {
            looking_ = false;
            lookAtNext();
        });
}

void StartPage::showPreview(const RecentScan& scan) {
    for (int row = 0; row < list_->count(); ++row) {
        QListWidgetItem* item = list_->item(row);
        if (item->data(Qt::UserRole).toString() != scan.path) continue;
        const QFileInfo file(scan.path);
        item->setData(kThere, scan.exists);
        item->setText(shownName(file.fileName()) + "\n" +
                      (scan.exists ? scan.words : tr("✕ not found: it was moved, or its disk is missing. Locate…")));
        if (!scan.picture.isNull()) item->setIcon(QIcon(QPixmap::fromImage(scan.picture)));
    }
}

void StartPage::showSession(const QString& path) {
    session_->setEnabled(!path.isEmpty());
    session_->setDescription(path.isEmpty() ? tr("there is none yet") : QString("…"));
    if (path.isEmpty()) return;
    inBackground(
        this,
        [this, path]() -> std::function<void()> {
            const auto read = inspect::readSession(exactBytes(path));
            QString words;
            if (read)
                words = tr("%1, %2, %3 UTC")
                            .arg(shownName(exactText(read->state.scan.identity.name)))
                            .arg(targetCount(read->state.targets.notebook.targets.size()))
                            .arg(shownText(read->savedUtc).left(16).replace('T', ' '));
            return [this, words] { words.isEmpty() ? session_->setEnabled(false) : session_->setDescription(words); };
        },
        [](const QString&) {});
}

} // namespace edgescan::ui

#include "moc_start_page.cpp"
