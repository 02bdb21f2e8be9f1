// The tables of words, of parts of sentences, and of flags.
#include "ui/base/core_words.h"

#include "core/scan/georef/place_form.h"
#include "core/scan/grid/assumed_mounting.h"
#include "core/scan/grid/reading_options.h"
#include "ui/base/language/languages.h"
#include "ui/base/shown_text.h"

#include <QObject>
#include <QRegularExpression>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace edgescan::ui {
namespace {

// Whole texts of the live strip. %1 and %2 are numbers, or texts of this table again.
constexpr std::array kWholeTexts{
    QT_TRANSLATE_NOOP("QObject", "CONNECTING"),
    QT_TRANSLATE_NOOP("QObject", "LIVE"),
    QT_TRANSLATE_NOOP("QObject", "STALE"),
    QT_TRANSLATE_NOOP("QObject", "STALE %1"),
    QT_TRANSLATE_NOOP("QObject", "NOT CONNECTED"),
    QT_TRANSLATE_NOOP("QObject", "LOST %1"),
    QT_TRANSLATE_NOOP("QObject", "STOPPED"),
    QT_TRANSLATE_NOOP("QObject", "STOPPED %1"),
    QT_TRANSLATE_NOOP("QObject", "%1, COUNTERS IN DOUBT"),
    QT_TRANSLATE_NOOP("QObject", "INCOMPLETE %1 lines"),
    QT_TRANSLATE_NOOP("QObject", "%1 lost: %2"),
    QT_TRANSLATE_NOOP("QObject", "%1 lines"),
    QT_TRANSLATE_NOOP("QObject", "line %1"),
    QT_TRANSLATE_NOOP("QObject", "lines %1 and others"),
    QT_TRANSLATE_NOOP("QObject", "lines %1"),
    QT_TRANSLATE_NOOP("QObject", "no return %1 %"),
    QT_TRANSLATE_NOOP("QObject", "COUNTERS IN DOUBT"),
    QT_TRANSLATE_NOOP("QObject", "MOUNTING ASSUMED"),
    QT_TRANSLATE_NOOP("QObject", "MOUNTING FROM RANGES"),
    QT_TRANSLATE_NOOP("QObject", "FIRST ANGLE ASSUMED"),
    QT_TRANSLATE_NOOP("QObject", "STEP ASSUMED %1°"),
    QT_TRANSLATE_NOOP("QObject", "START ASSUMED"),
    QT_TRANSLATE_NOOP("QObject", "1 remark"),
    QT_TRANSLATE_NOOP("QObject", "%1 remarks"),
    QT_TRANSLATE_NOOP("QObject", "%1 earlier in this sweep"),
    QT_TRANSLATE_NOOP("QObject", "WINDOW TOO DIRTY"),
    QT_TRANSLATE_NOOP("QObject", "WINDOW DIRTY"),
    QT_TRANSLATE_NOOP("QObject", "window clean"),
    QT_TRANSLATE_NOOP("QObject", "device ok"),
    QT_TRANSLATE_NOOP("QObject", "DEVICE ERROR"),
    QT_TRANSLATE_NOOP("QObject", "pose of unknown age"),
    QT_TRANSLATE_NOOP("QObject", "pose %1 old"),
    QT_TRANSLATE_NOOP("QObject", "sweep complete"),
    QT_TRANSLATE_NOOP("QObject", "sweep ended"),
    QT_TRANSLATE_NOOP("QObject", "%1 left"),
    QT_TRANSLATE_NOOP("QObject", "%1, %2 ago"),
    QT_TRANSLATE_NOOP("QObject", "recording %1 MB, %2"),
    QT_TRANSLATE_NOOP("QObject", "recording %1 MB"),
    QT_TRANSLATE_NOOP("QObject", "the disk is %1 s behind (%2 MB)"),
    QT_TRANSLATE_NOOP("QObject", "RECORDING ENDED: %1"),
    QT_TRANSLATE_NOOP("QObject", "RECORDING HAS GAPS: %1"),
    // How two scans were lined up.
    QT_TRANSLATE_NOOP("QObject", "%1; other cells: points of one moved to the grid of the other"),
    QT_TRANSLATE_NOOP("QObject", "one scan with two settings"),
    QT_TRANSLATE_NOOP("QObject", "lined up by their poses"),
    QT_TRANSLATE_NOOP("QObject", "lined up by given positions of the scanner, not in the mine grid"),
    QT_TRANSLATE_NOOP("QObject", "no pose: lined up by their surfaces"),
    // An angle.
    QT_TRANSLATE_NOOP("QObject", "not resolved"),
};

// Names of scans that have no file of their own.
constexpr std::array kScanNames{
    QT_TRANSLATE_NOOP("QObject", "sweep %1"),
    QT_TRANSLATE_NOOP("QObject", "demo draw-bell after the blast"),
    QT_TRANSLATE_NOOP("QObject", "demo draw-bell"),
};

// Parts of sentences of the window itself, and of groups of the core whose sentences resources/languages/collect does not collect.
constexpr std::array kParts{
    QT_TRANSLATE_NOOP("QObject", "INCOMPLETE %1 lines"),
    QT_TRANSLATE_NOOP("QObject", "there is not enough memory for this scan"),
    QT_TRANSLATE_NOOP("QObject", "close other programs or open a smaller scan"),
    QT_TRANSLATE_NOOP("QObject", "there is not enough memory to show the scan in its place"),
    QT_TRANSLATE_NOOP("QObject", "there is not enough memory for this layer"),
    QT_TRANSLATE_NOOP("QObject", "there is not enough memory for a second picture"),
    QT_TRANSLATE_NOOP("QObject", "there is not enough memory for a second scan"),
    QT_TRANSLATE_NOOP("QObject", "there is not enough memory for these scans"),
    QT_TRANSLATE_NOOP("QObject", "there is not enough memory to play this recording"),
    QT_TRANSLATE_NOOP("QObject", "hide or remove other layers, or choose a smaller scan"),
    QT_TRANSLATE_NOOP("QObject", "close other programs or choose a smaller scan"),
    QT_TRANSLATE_NOOP("QObject", "close other programs or choose a smaller one"),
    QT_TRANSLATE_NOOP("QObject", "close other programs or use fewer scans"),
    QT_TRANSLATE_NOOP("QObject", "close other programs or use a smaller scan"),
    QT_TRANSLATE_NOOP("QObject", "another program has changed this file, so it was not removed"),
    QT_TRANSLATE_NOOP("QObject", "open the scan again to see its edits"),
    QT_TRANSLATE_NOOP("QObject", "it could not be opened (%1)"),
    QT_TRANSLATE_NOOP("QObject", "auto is not a number"),
    QT_TRANSLATE_NOOP("QObject", "tick auto next to the box"),
    QT_TRANSLATE_NOOP("QObject", "the layer has another content than when it was placed"),
    QT_TRANSLATE_NOOP("QObject", "remove it and add it again"),
    QT_TRANSLATE_NOOP("QObject", "it is not a regular file, so settings are not read and nothing of this window is stored"),
    QT_TRANSLATE_NOOP("QObject", "remove it and start again"),
    QT_TRANSLATE_NOOP("QObject", "not all settings in this file can be read"),
    QT_TRANSLATE_NOOP("QObject", "what it held is in "),
    QT_TRANSLATE_NOOP("QObject", "choose another scan"),
    QT_TRANSLATE_NOOP("QObject", " (line "),
    // Of a pose, of several stations, and of a scan before and after.
    QT_TRANSLATE_NOOP("QObject", "Both are one scan: the files are the same."),
    QT_TRANSLATE_NOOP("QObject", "Near and far leave no depth between them: the gray image is blank and has no edge."),
    QT_TRANSLATE_NOOP("QObject", " edge cells lie on filled ranges and are not in this file; %1 writes them."),
    QT_TRANSLATE_NOOP("QObject", "OUT OF SPEC: whether the surfaces of \"%1\" fit cannot be seen."),
    QT_TRANSLATE_NOOP("QObject", "OUT OF SPEC: the surfaces of \"%1\" are %2 mm from those of the first scan at best."),
    QT_TRANSLATE_NOOP("QObject", "OUT OF SPEC: the base moved while \"%1\" was taken: one place fits it badly."),
    QT_TRANSLATE_NOOP("QObject", "OUT OF SPEC: without a pose of both, the two scans are lined up by their surfaces alone."),
    QT_TRANSLATE_NOOP("QObject",
                      "OUT OF SPEC: the surfaces of the two scans do not lie where their poses put them: %1 apart, and %2 if one "
                      "is moved by "),
    QT_TRANSLATE_NOOP("QObject",
                      "OUT OF SPEC: the surfaces of the two scans lie %1 apart at best, so most of the place changed or they are "
                      "not scans of one place. No areas of change are given."),
    QT_TRANSLATE_NOOP("QObject", "OUT OF SPEC: whether the poses fit cannot be seen, "),
    QT_TRANSLATE_NOOP("QObject", "OUT OF SPEC: the poses do not fit the surfaces, so the earlier scan was moved by its surfaces, by "),
};

/// Where the window sets what a flag sets. The flags of reading are fields of one dialog.
constexpr std::array<std::pair<const char*, const char*>, 8> kPlaces{{
    {"straighten", QT_TRANSLATE_NOOP("QObject", "Scan > Straighten Beams")},
    {"keep-repeated", QT_TRANSLATE_NOOP("QObject", "Scan > Keep Repeated Values")},
    {"frame", QT_TRANSLATE_NOOP("QObject", "the coordinates in the export dialog")},
    {"include-attached", QT_TRANSLATE_NOOP("QObject", "the points behind others in the export dialog")},
    {"with-filled", QT_TRANSLATE_NOOP("QObject", "the filled cells in the export dialog")},
    {"comments", QT_TRANSLATE_NOOP("QObject", "the comments in the export dialog")},
    {"fill", QT_TRANSLATE_NOOP("QObject", "the filling of gaps in the Edges panel")},
    {"picture-outlines", QT_TRANSLATE_NOOP("QObject", "the outlines in the picture")},
}};
constexpr std::array kFieldsOfReading{"beam-start", "beam-step", "line-start", "line-step", "unit", "grid-step",  "axis",
                                      "sensor",     "project",   "scan",       "columns",   "pose", "calibration"};

/// Patterns of the core and those above, the longer ones first: one may hold another.
QStringList sentenceParts() {
    QStringList parts = sentencesOfTheCore() + QStringList(kParts.begin(), kParts.end());
    std::stable_sort(parts.begin(), parts.end(), [](const QString& a, const QString& b) { return a.size() > b.size(); });
    return parts;
}

QString wordsOf(const QString& text) {
    static const CoreTexts texts(QStringList(kWholeTexts.begin(), kWholeTexts.end()), true);
    return texts.translated(text, wordsOf);
}

/// Null: the flag is not one of reading.
const ReadingOption* optionOf(const QString& flag) {
    const auto table = readingOptionTable();
    const auto option = std::ranges::find_if(table, [&](const ReadingOption& each) { return flag == QLatin1String(each.key); });
    return option == table.end() ? nullptr : &*option;
}

/// "unit" and "cm" -> "“unit: cm” in Scan > How the Scan Is Read".
QString placeOf(const QString& flag, const QString& value) {
    const auto known = std::ranges::find_if(kPlaces, [&](const auto& each) { return flag == QLatin1String(each.first); });
    const QString valued = value.isEmpty() ? QString() : ": " + value;
    if (known != kPlaces.end()) return QObject::tr(known->second) + valued;
    if (std::ranges::any_of(kFieldsOfReading, [&](const char* field) { return flag == QLatin1String(field); })) {
        static const QRegularExpression unit("\\s*\\[.*$");
        const ReadingOption* option = optionOf(flag);
        const bool isNamed = option != nullptr && option->kind == ReadingOption::Kind::Number; // by its label
        return QObject::tr("“%1” in Scan > How the Scan Is Read").arg((isNamed ? QObject::tr(option->help).remove(unit) : flag) + valued);
    }
    return QObject::tr("“%1”").arg(QString(flag).replace('-', ' ') + valued);
}

/// A number, or one of the words that the flag takes; other words go on with the sentence.
bool isValueOf(const QString& flag, const QString& word) {
    const ReadingOption* option = optionOf(flag);
    const bool isNumber = !word.isEmpty() && (word.front().isDigit() || word.front() == '-');
    return isNumber || (option != nullptr && std::ranges::find(option->words, exactBytes(word)) != option->words.end());
}

/// The flags of all angles, which are fields of one dialog.
constexpr const char* kAngleFlags = "--beam-start --beam-step --line-start --line-step --axis";

QString withoutFlags(QString text) {
    text.replace(kAngleFlags, QObject::tr("the angles of beams and lines and the axis in Scan > How the Scan Is Read"));
    // A flag, what its value is called, or a word that may be one, and the place in the window that some texts name themselves.
    static const QRegularExpression flag("(?<![\\w-])--([a-z][a-z-]*)(?: [A-Z][A-Z,.a-z]*(?:\\.json)?)?( \\([^)]* > [^)]*\\))?"
                                         "(?: (-?[0-9](?:[0-9.,-]*[0-9])?|[a-z]+))?");
    for (auto found = flag.match(text); found.hasMatch(); found = flag.match(text)) {
        const QString named = found.captured(2).mid(2).chopped(1);
        const QString value = isValueOf(found.captured(1), found.captured(3)) ? found.captured(3) : QString();
        const QString place = named.isEmpty() ? placeOf(found.captured(1), value) : QObject::tr(exactBytes(named).c_str());
        const int end = !value.isEmpty() || found.captured(3).isEmpty() ? found.capturedEnd() : found.capturedStart(3) - 1;
        text.replace(found.capturedStart(), end - found.capturedStart(), place);
    }
    return text;
}

/// The label in the form, without its unit and its list of axes.
QString fieldOf(const PlaceField& field) {
    static const QRegularExpression rest("(\\[|\\s*: ).*$");
    return QObject::tr("“%1”").arg(QObject::tr(field.label).remove(rest).trimmed());
}

/// "talin.in_robot_m" of a pose or calibration file -> "“Lever arm of TALIN in the robot”", as in Scan > Pose and Mounting.
QString withoutKeys(QString text) {
    for (const std::span<const PlaceField> form : {poseFields(), mountingFields()}) {
        for (const PlaceField& field : form) {
            const QString key = QString("%1.%2").arg(field.group, field.key);
            if (*field.group == '\0' || !text.contains(key)) continue;
            text.replace(QRegularExpression("\"?\\b" + QRegularExpression::escape(key) + "\\b\"?"), fieldOf(field));
        }
    }
    return text;
}

/// "1 to 996, 998 to 1993" of a value.
QString withRanges(QString value) {
    static const QRegularExpression range("\\b(\\d+) to (\\d+)\\b");
    return value.replace(range, QObject::tr("%1 to %2").arg("\\1", "\\2"));
}

} // namespace

CoreTexts::CoreTexts(const QStringList& sources, bool whole) : whole_(whole) {
    static const QRegularExpression place("%[1-9n]"), letter("\\w");
    for (const QString& source : sources) {
        Text text{source.toUtf8(), {}, {}, {}};
        QString match;
        int at = 0;
        const auto addWords = [&](const QString& words) {
            match += QRegularExpression::escape(words);
            if (words.size() > text.words.size()) text.words = words;
        };
        for (auto all = place.globalMatch(source); all.hasNext();) {
            const auto found = all.next();
            addWords(source.mid(at, found.capturedStart() - at));
            text.places << found.captured();
            // In front of a sentence there may be another: its value is one word then, or a text in quotes.
            const bool isFirst = found.capturedStart() == 0 && !whole;
            match += found.captured() == "%n" ? "(\\d+)" : isFirst ? "(\"[^\"]*\"|\\S+)" : "(.*?)";
            at = found.capturedEnd();
        }
        addWords(source.mid(at));
        if (whole) match = "^" + match + "$";
        if (!whole && letter.match(source.left(1)).hasMatch()) match.prepend("(?<![\\w-])");
        if (!whole && letter.match(source.right(1)).hasMatch() && at < source.size()) match += "(?![\\w-]|\\.\\w)";
        text.match.setPattern(match);
        texts_.push_back(text);
    }
}

QString CoreTexts::filled(const Text& text, const QRegularExpressionMatch& found, QString (*inner)(const QString&)) {
    static const QRegularExpression place("%[1-9n]");
    const QString words = QObject::tr(text.source.constData());
    QString result;
    int at = 0;
    for (auto all = place.globalMatch(words); all.hasNext();) {
        const auto each = all.next();
        const QString value = found.captured(1 + text.places.indexOf(each.captured()));
        result += words.mid(at, each.capturedStart() - at) + withRanges(inner == nullptr ? value : inner(value));
        at = each.capturedEnd();
    }
    return result + words.mid(at);
}

QRegularExpressionMatch CoreTexts::found(const Text& text, const QString& in, int from) {
    auto found = text.match.match(in, from);
    if (text.source.startsWith('%')) return found;
    // A value does not hold the beginning of the sentence again: of "about z ..., about y 3 lines", the second.
    for (auto later = found; later.hasMatch() && later.capturedEnd() <= found.capturedEnd();) {
        found = later;
        later = text.match.match(in, later.capturedStart() + 1);
    }
    return found;
}

QString CoreTexts::translated(QString text, QString (*inner)(const QString&)) const {
    for (const Text& each : texts_) {
        if (!text.contains(each.words)) continue;
        int at = 0; // behind what is translated already
        for (auto match = found(each, text, 0); match.hasMatch(); match = found(each, text, at)) {
            const QString part = filled(each, match, inner);
            if (whole_) return part;
            text.replace(match.capturedStart(), match.capturedLength(), part);
            at = match.capturedStart() + part.size();
        }
    }
    return text;
}

std::string inLanguage(const char* text) { return exactBytes(QObject::tr(text)); }

QString coreWords(const std::string& text) { return wordsOf(shownText(text)); }

QString cellStateText(CellState state) {
    static constexpr std::array<const char*, kCellStates> kStates{
        QT_TRANSLATE_NOOP("QObject", "valid"),         QT_TRANSLATE_NOOP("QObject", "no return"),
        QT_TRANSLATE_NOOP("QObject", "device status"), QT_TRANSLATE_NOOP("QObject", "out of window"),
        QT_TRANSLATE_NOOP("QObject", "masked"),        QT_TRANSLATE_NOOP("QObject", "lost")};
    return QObject::tr(kStates[static_cast<std::size_t>(state)]);
}

QString scanName(const std::string& name, int mostCharacters) {
    static const CoreTexts texts(QStringList(kScanNames.begin(), kScanNames.end()), true);
    return shownName(texts.translated(exactText(name)), mostCharacters);
}

QString coreSentence(const QString& text) {
    if (sentencesOfTheCore().isEmpty()) return withoutKeys(withoutFlags(text)); // English
    static const CoreTexts parts(sentenceParts(), false);                       // those of all languages have one source
    return withoutKeys(withoutFlags(parts.translated(text)));
}

QString coreSentence(const std::string& text) { return coreSentence(shownText(text)); }

QString scannersWarning(QString warning) {
    static const QRegularExpression advice("Give --[^.]* where that is wrong\\.");
    return warning.replace(advice, QObject::tr("Scan > Sweep… takes what is right."));
}

QString assumedText(const Scan& scan) {
    switch (assumedIn(scan)) {
    case Assumed::Nothing:
    case Assumed::Direction: // coordinates have a warning of their own
        break;
    case Assumed::SeenAxis:
        return QObject::tr("▲ mounting from the ranges");
    case Assumed::Step:
        return QObject::tr("▲ step assumed");
    case Assumed::Mounting:
        return QObject::tr("▲ mounting assumed");
    }
    return {};
}

} // namespace edgescan::ui
