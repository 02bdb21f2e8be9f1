// The badge with the source of the picture.
#include "ui/controllers/files/source.h"

#include "core/base/utc_time.h"
#include "core/scan/georef/placed_points.h"
#include "core/scan/grid/acquisition.h"
#include "core/scan/grid/placement.h"
#include "ui/base/core_words.h"
#include "ui/base/shown_text.h"
#include "ui/panels/live/scanner_link.h"

#include <QObject>

#include <algorithm>
#include <cmath>

namespace edgescan::ui {

QString timeWords(const std::string& utc) {
    const auto seconds = parseUtc(utc);
    if (!seconds) return {};
    return shownText(utcText(*seconds)).left(19).replace('T', ' ') + " UTC";
}

namespace {

constexpr int kLongestName = 28; // characters

QString agoWords(const std::string& utc) {
    const double seconds = utcNow() - parseUtc(utc).value_or(std::nan(""));
    if (!(seconds >= 0.0)) return {}; // unknown, or the clocks disagree
    if (seconds < 7200.0) return QObject::tr(", %1 min ago").arg(std::floor(seconds / 60.0), 0, 'f', 0);
    if (seconds < 172800.0) return QObject::tr(", %1 h ago").arg(std::floor(seconds / 3600.0), 0, 'f', 0);
    return QObject::tr(", %1 days ago").arg(std::floor(seconds / 86400.0), 0, 'f', 0);
}

/// The pose and the calibration that placed the scan, by name and SHA-256.
QString placedWords(const Scan& scan) {
    return scan.placement ? "\n" + QObject::tr("Placed by %1").arg(shownText(scan.placement->source)) : QString();
}

/// "HELD", and how far the picture is behind the scanner.
QString heldWords(const Picture& picture, const files::LiveHealth& now) {
    const int sweep = picture.source.growth.sweep + 1, behind = now.row - picture.detection->scan->lines();
    if (sweep != now.sweep) {
        const Scan& scan = *picture.detection->scan;
        const int whole = picture.source.growth.expectedLines; // lines that never came have their places in the scan
        const auto lost = countCells(scan)[static_cast<std::size_t>(CellState::Lost)] / static_cast<std::size_t>(std::max(1, scan.beams()));
        const int lines = scan.lines() - static_cast<int>(lost);
        if (lines < whole) return QObject::tr("HELD, %1 of %2 lines").arg(lines).arg(whole);
        return whole > 0 ? QObject::tr("HELD, whole sweep") : QObject::tr("HELD, sweep %1 grows").arg(now.sweep);
    }
    if (behind <= 0) return QObject::tr("HELD");
    return behind == 1 ? QObject::tr("HELD, 1 line behind") : QObject::tr("HELD, %1 lines behind").arg(behind);
}

/// The badge for the connected scanner, or the last one.
PictureOrigin scannersOwn(const Picture& picture, const ScannerLink& scanner) {
    const auto& acquisition = picture.detection->scan->acquisition;
    const QString last = timeWords(acquisition ? acquisition->endUtc : std::string());
    const QString at = last.isEmpty() ? QObject::tr(" · no time") : " · " + last;
    if (scanner.connected() && scanner.following())
        return {
            signOf(scanner.health().liveness), coreWords(scanner.health().badge) + at,
            QObject::tr("What the scanner sends now, with the time of its newest line. %1").arg(coreSentence(scanner.health().sentence))};
    if (!scanner.connected()) // the words of the strip
        return {signOf(files::Liveness::Stopped), QObject::tr("STOPPED") + at,
                QObject::tr("The connection to the scanner has ended: the time is that of the newest line")};
    if (scanner.health().liveness == files::Liveness::Lost)
        return {signOf(files::Liveness::Lost), coreWords(scanner.health().badge) + " · " + heldWords(picture, scanner.health()) + at,
                coreSentence(scanner.health().sentence)};
    return {StateBadge::Sign::Waiting, heldWords(picture, scanner.health()) + at,
            QObject::tr("The scanner goes on, this picture does not: the time is that of its newest line")};
}

} // namespace

QStringList warningsOf(const Picture& picture) {
    const Scan& scan = *picture.detection->scan;
    QStringList warnings;
    for (const std::vector<std::string>& some : {scan.warnings, placeWarnings(scan)}) {
        for (const std::string& warning : some) {
            if (picture.source.growth.growing && warning.starts_with("INCOMPLETE")) continue;
            warnings << (scan.path.empty() ? scannersWarning(shownText(warning)) : shownText(warning));
        }
    }
    // What was guessed comes after what is wrong: a line has room for the first.
    std::stable_partition(warnings.begin(), warnings.end(), [](const QString& each) { return !each.startsWith("GUESS:"); });
    return warnings;
}

namespace {

QString nameOf(const Picture& picture) { return scanName(picture.detection->scan->name); }

/// `other`: of the comparison; null: it is not compared.
PictureOrigin originOf(const Picture* picture, const ScannerLink& scanner, const Picture* other) {
    if (picture == nullptr && scanner.connected())
        return {signOf(scanner.health().liveness), coreWords(scanner.health().badge), coreSentence(scanner.health().sentence)};
    if (picture == nullptr) return {StateBadge::Sign::Off, QObject::tr("NO PICTURE"), QString()};
    const Scan& scan = *picture->detection->scan;
    const Acquisition measured = scan.acquisition ? *scan.acquisition : Acquisition{};
    if (picture->source.stream == scanner.stream()) return scannersOwn(*picture, scanner);
    const QString time = timeWords(measured.startUtc), last = timeWords(measured.endUtc);
    const bool recorded = scan.format == "recording" || scan.format == "sweep";
    if (recorded && !last.isEmpty()) // as of a scanner
        return {StateBadge::Sign::Recorded, QObject::tr("RECORDED") + " " + last + agoWords(measured.endUtc),
                QObject::tr("Last line, by %1").arg(shownText(measured.clockSource)) + placedWords(scan)};
    const QString name = shownApart(nameOf(*picture), other != nullptr ? nameOf(*other) : QString(), kLongestName);
    return {recorded ? StateBadge::Sign::Recorded : StateBadge::Sign::File,
            (recorded ? QObject::tr("RECORDED") : QObject::tr("FILE")) + " " + name + " · " +
                (time.isEmpty() ? QObject::tr("no time") : time),
            (time.isEmpty() ? QObject::tr("The file does not say when it was measured")
                            : QObject::tr("First line, by %1").arg(shownText(measured.clockSource))) +
                placedWords(scan)};
}

PictureOrigin originOf(const Engine& engine, const ScannerLink& scanner, const Picture* other) {
    const Picture* picture = engine.picture().get();
    if (engine.coarse())
        return {StateBadge::Sign::Waiting, QObject::tr("COARSE PICTURE"), QObject::tr("Some points of the scan that is being opened.")};
    PictureOrigin origin = originOf(picture, scanner, other);
    const bool awaited = scanner.connected() && scanner.following() && picture != nullptr && picture->source.stream != scanner.stream();
    if (!engine.replacing() && !awaited) return origin;
    origin.sign = StateBadge::Sign::Waiting;
    origin.badge = QObject::tr("OLD PICTURE") + " · " + origin.badge;
    origin.more = QObject::tr("Another scan is being opened. This is the picture before it.") + "\n" + origin.more;
    return origin;
}

} // namespace

PictureOrigin originOf(const Engine& engine, const ScannerLink& scanner) { return originOf(engine, scanner, nullptr); }

PictureOrigin originOfDrawn(const Engine& engine, const ScannerLink& scanner, const Picture* a, bool drawn) {
    if (a == nullptr || !drawn) return originOf(engine, scanner, a);
    PictureOrigin origin = originOf(a, scanner, engine.picture().get());
    origin.badge = "A · " + origin.badge;
    return origin;
}

} // namespace edgescan::ui
