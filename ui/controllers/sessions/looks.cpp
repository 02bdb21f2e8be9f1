// The looks of a session, and its sweep in a recording.
#include "ui/controllers/sessions/parts.h"

#include "ui/base/shown_text.h"
#include "ui/controllers/comparing.h"
#include "ui/controllers/confidence.h"
#include "ui/controllers/live.h"
#include "ui/controllers/saved_views.h"
#include "ui/controllers/scan_look.h"
#include "ui/controllers/sessions/sessions.h"
#include "ui/engine/linked_views/linked_views.h"
#include "ui/engine/worker_bridge/engine.h"
#include "ui/panels/live/timeline.h"
#include "ui/views/cloud/cloud_view.h"

#include <QString>
#include <QStringList>

#include <algorithm>
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

QString colourText(ScanLook& look) { return colourKey(look.colourBy()); }

void useColour(ScanLook& look, QStringList words) {
    if (const auto by = colourOfKey(words.join(' ').toStdString())) look.setColourBy(*by);
}

QString rangeText(ScanLook& look) {
    const auto& window = look.rangeWindow();
    if (!window) return "automatic";
    return numberText(window->nearM) + " " + numberText(window->farM) + (look.rangeLocked() ? " locked" : "");
}

void useRange(ScanLook& look, QStringList words) {
    if (words == QStringList{"automatic"}) return look.setRangeWindow(std::nullopt, false);
    const bool locked = words.removeAll("locked") > 0;
    const auto ends = numbersIn(words);
    if (ends && ends->size() == 2 && (*ends)[0] >= 0.0 && (*ends)[1] > (*ends)[0])
        look.setRangeWindow(RangeSpan{(*ends)[0], (*ends)[1]}, locked);
}

QString pointText(CloudView& cloud) {
    if (const auto factor = cloud.pointSizeFactor()) return "spacing " + numberText(*factor);
    return numberText(cloud.pointSize());
}

void usePoints(CloudView& cloud, QStringList words) {
    const bool follows = words.removeAll("spacing") > 0;
    const auto size = numbersIn(words);
    if (!size || size->size() != 1 || size->front() <= 0.0) return;
    if (follows)
        cloud.setPointSizeFollows(true, size->front());
    else
        cloud.setPointSize(size->front());
}

QString clipText(CloudView& cloud) { return numberText(cloud.clip().nearShare) + " " + numberText(cloud.clip().farShare); }

void useClip(CloudView& cloud, QStringList words) {
    if (const auto shares = numbersIn(words); shares && shares->size() == 2) cloud.setClip({(*shares)[0], (*shares)[1]});
}

QString viewsText(SavedViews& saved) { return saved.text(); }

void useViews(SavedViews& saved, QStringList words) { saved.use(words.join(' ')); }

QString leastText(Confidence& confidence) { return QString::number(confidence.least()); }

void useLeast(Confidence& confidence, QStringList words) {
    if (const auto least = numbersIn(words); least && least->size() == 1)
        confidence.setLeast(static_cast<int>(std::clamp(least->front(), 0.0, 100.0)));
}

QString changesText(Comparing& comparing) {
    QString text;
    for (const bool on : comparing.rows()) text += on ? '1' : '0';
    return text;
}

void useChanges(Comparing& comparing, QStringList words) {
    ChangeRows rows{};
    if (words.size() != 1 || words[0].size() != kChangeRows) return;
    for (int n = 0; n < kChangeRows; ++n) rows[static_cast<std::size_t>(n)] = words[0][n] == '1';
    comparing.setRows(rows);
}

/// `key`: in the session. Opening a scan puts some looks back: those are given back once more when it is open.
template <class Of, class... Signals>
StatePart lookPart(const char* key, Of& of, QString (*read)(Of&), void (*use)(Of&, QStringList), GivenBack when, Signals... changes) {
    return {[key, &of, read](inspect::ViewerState& state) { state.looks[key] = read(of).toStdString(); },
            [key, &of, use](const inspect::ViewerState& state) {
                if (const auto found = state.looks.find(key); found != state.looks.end()) use(of, exactText(found->second).split(' '));
            },
            when, changesOf(of, changes...)};
}

} // namespace

std::vector<StatePart> looksParts(ScanLook& look, LinkedViews& views, SavedViews& saved, Confidence& confidence, Comparing& comparing) {
    CloudView& cloud = views.cloud();
    return {
        lookPart("cloud-colour", look, colourText, useColour, GivenBack::BeforeScan, &ScanLook::changed),
        lookPart("range-window-m", look, rangeText, useRange, GivenBack::Both),
        lookPart("point-size", cloud, pointText, usePoints, GivenBack::BeforeScan),
        lookPart("clip-shares", cloud, clipText, useClip, GivenBack::Both),
        lookPart("stored-views", saved, viewsText, useViews, GivenBack::OnScan, &SavedViews::changed),
        lookPart("least-confidence-percent", confidence, leastText, useLeast, GivenBack::BeforeScan, &Confidence::changed),
        lookPart("changes-shown", comparing, changesText, useChanges, GivenBack::BeforeScan),
    };
}

/// False: it is another recording, or one without other sweeps.
bool Sessions::lookInSweeps() {
    const inspect::SessionScan& scan = wanted_->state.scan;
    const std::string& sha256 = scan.identity.sha256;
    if (scan.kind != inspect::SessionScan::Kind::Recording || nextSweep_) return false;
    if (!sha256.empty() && sha256 != engine_.picture()->detection->scan->sha256) return false;
    nextSweep_ = 0;
    if (live_.timeline().active()) lookInNextSweep(); // else when it was read
    return true;
}

void Sessions::lookInNextSweep() {
    Timeline& timeline = live_.timeline();
    while (*nextSweep_ < timeline.contents().sweeps.size()) {
        const int end = timeline.endOf((*nextSweep_)++);
        if (end != timeline.home()) return timeline.goTo(end);
    }
    nextSweep_.reset();
    timeline.goTo(timeline.home());
    refuseScan();
}

void Sessions::lookAt(const ReplayedSweep& at) {
    if (!wanted_ || !nextSweep_ || found_ || *nextSweep_ == 0 || at.position != live_.timeline().endOf(*nextSweep_ - 1)) return;
    if (at.sweep.scan && inspect::isSweepOf(wanted_->state.scan, *at.sweep.scan))
        found_ = at.sweep.scan; // given back when it is on the screen
    else
        lookInNextSweep();
}

} // namespace edgescan::ui
