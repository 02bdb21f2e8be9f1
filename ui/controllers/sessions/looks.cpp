// The table of display settings, and reading and restoring with it.
#include "ui/controllers/sessions/looks.h"

#include "ui/base/shown_text.h"
#include "ui/controllers/comparing.h"
#include "ui/controllers/confidence.h"
#include "ui/controllers/scan_look.h"
#include "ui/controllers/sessions/desk.h"
#include "ui/engine/linked_views/linked_views.h"
#include "ui/views/cloud/cloud_view.h"

#include <QString>
#include <QStringList>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

namespace edgescan::ui {
namespace {

QString numberText(double number) { return QString::number(number, 'g', 9); }

/// All words as numbers; empty if one is not a number.
std::optional<std::vector<double>> numbersIn(const QStringList& words) {
    std::vector<double> numbers;
    for (const QString& word : words) {
        bool good = false;
        numbers.push_back(word.toDouble(&good));
        if (!good || !std::isfinite(numbers.back())) return std::nullopt;
    }
    return numbers;
}

QString colourText(const Desk& desk) { return colourKey(desk.look.colourBy()); }

void useColour(const Desk& desk, QStringList words) {
    if (const auto by = colourOfKey(words.join(' ').toStdString())) desk.look.setColourBy(*by);
}

QString rangeText(const Desk& desk) {
    const auto& window = desk.views.rangeWindow();
    if (!window) return "automatic";
    return numberText(window->nearM) + " " + numberText(window->farM) + (desk.look.rangeLocked() ? " locked" : "");
}

void useRange(const Desk& desk, QStringList words) {
    if (words == QStringList{"automatic"}) return desk.look.setRangeWindow(std::nullopt, false);
    const bool locked = words.removeAll("locked") > 0;
    const auto ends = numbersIn(words);
    if (ends && ends->size() == 2 && (*ends)[0] >= 0.0 && (*ends)[1] > (*ends)[0])
        desk.look.setRangeWindow(RangeSpan{(*ends)[0], (*ends)[1]}, locked);
}

QString pointText(const Desk& desk) {
    const CloudView& cloud = desk.views.cloud();
    if (const auto factor = cloud.pointSizeFactor()) return "spacing " + numberText(*factor);
    return numberText(cloud.pointSize());
}

void usePoints(const Desk& desk, QStringList words) {
    const bool follows = words.removeAll("spacing") > 0;
    const auto size = numbersIn(words);
    if (!size || size->size() != 1 || size->front() <= 0.0) return;
    if (follows)
        desk.views.cloud().setPointSizeFollows(true, size->front());
    else
        desk.views.cloud().setPointSize(size->front());
}

QString clipText(const Desk& desk) {
    const CloudClip& clip = desk.views.cloud().clip();
    return numberText(clip.nearShare) + " " + numberText(clip.farShare);
}

void useClip(const Desk& desk, QStringList words) {
    if (const auto shares = numbersIn(words); shares && shares->size() == 2) desk.views.cloud().setClip({(*shares)[0], (*shares)[1]});
}

QString leastText(const Desk& desk) { return QString::number(desk.confidence.least()); }

void useLeast(const Desk& desk, QStringList words) {
    if (const auto least = numbersIn(words); least && least->size() == 1)
        desk.confidence.setLeast(static_cast<int>(std::clamp(least->front(), 0.0, 100.0)));
}

QString changesText(const Desk& desk) {
    QString text;
    for (const bool on : desk.comparing.rows()) text += on ? '1' : '0';
    return text;
}

void useChanges(const Desk& desk, QStringList words) {
    ChangeRows rows{};
    if (words.size() != 1 || words[0].size() != kChangeRows) return;
    for (int n = 0; n < kChangeRows; ++n) rows[static_cast<std::size_t>(n)] = words[0][n] == '1';
    desk.comparing.setRows(rows);
}

struct Look {
    const char* key;
    QString (*taken)(const Desk& desk);
    void (*use)(const Desk& desk, QStringList words);
    bool ofScan; ///< restored when the scan is opened
};

const std::array kLooks{
    Look{"cloud-colour", colourText, useColour, false},
    Look{"range-window-m", rangeText, useRange, true},
    Look{"point-size", pointText, usePoints, false},
    Look{"clip-shares", clipText, useClip, true},
    Look{"least-confidence-percent", leastText, useLeast, false},
    Look{"changes-shown", changesText, useChanges, false},
};

void use(const Desk& desk, const std::map<std::string, std::string>& looks, bool ofScanAlone) {
    for (const Look& look : kLooks) {
        const auto found = looks.find(look.key);
        if (found != looks.end() && (look.ofScan || !ofScanAlone)) look.use(desk, exactText(found->second).split(' '));
    }
}

} // namespace

std::map<std::string, std::string> looksOf(const Desk& desk) {
    std::map<std::string, std::string> looks;
    for (const Look& look : kLooks) looks[look.key] = look.taken(desk).toStdString();
    return looks;
}

void useLooks(const Desk& desk, const std::map<std::string, std::string>& looks) { use(desk, looks, false); }

void useLooksOfScan(const Desk& desk, const std::map<std::string, std::string>& looks) { use(desk, looks, true); }

} // namespace edgescan::ui
