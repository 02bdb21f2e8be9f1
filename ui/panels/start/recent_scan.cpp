// Small pictures of scans.
#include "ui/panels/start/recent_scan.h"

#include "core/base/sha256.h"
#include "core/base/utc_time.h"
#include "core/base/whole_file.h"
#include "core/edges/gray/gray.h"
#include "core/files/open_save/open_scan.h"
#include "core/scan/grid/acquisition.h"
#include "ui/base/count_text.h"
#include "ui/base/shown_text.h"

#include <QBuffer>
#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QStringList>

#include <filesystem>
#include <new>
#include <span>

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

} // namespace edgescan::ui
