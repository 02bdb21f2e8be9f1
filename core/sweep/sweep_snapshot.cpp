// What a sweep looks like so far: as a scan and in words.
#include "core/sweep/sweep.h"

#include "core/sweep/sweep_acquisition.h"

#include <algorithm>

namespace edgescan {

std::string SweepProgress::text() const {
    const std::string of = std::to_string(received) + "/" + std::to_string(expected > 0 ? expected : lines) + " lines";
    return complete() ? of : "INCOMPLETE " + of;
}

std::string rowsText(const std::vector<int>& rows, int groups) {
    std::string text = rows.size() == 1 ? "line " : "lines ";
    int told = 0;
    for (std::size_t i = 0; i < rows.size();) {
        std::size_t last = i;
        while (last + 1 < rows.size() && rows[last + 1] == rows[last] + 1) ++last;
        if (told++ == groups) return text + " and others";
        if (told > 1) text += ", ";
        text += std::to_string(rows[i]);
        if (last > i) text += " to " + std::to_string(rows[last]);
        i = last + 1;
    }
    return text;
}

SweepProgress SweepAssembler::progress() const {
    SweepProgress progress;
    if (sweep_) {
        progress.lines = sweep_->wholeRows();
        for (int row = 0; row < progress.lines; ++row) {
            if (sweep_->missing()[static_cast<std::size_t>(row)] != 0) progress.lost.push_back(row);
        }
        progress.received = progress.lines - static_cast<int>(progress.lost.size());
        progress.cells = sweep_->grid().counts(progress.lines);
        progress.angleSource = angleSourceOf(sweep_->facts(), settings_);
        progress.deviceEver = sweep_->deviceEver();
        progress.number = number_;
    } else {
        progress = finishedProgress_;
    }
    progress.expected = settings_.expectedLines;
    progress.growing = sweep_ && (progress.expected == 0 || progress.lines < progress.expected);
    if (last_) progress.newestNs = last_->hostNs;
    progress.device = device_;
    progress.duplicates = duplicates_;
    progress.misfits = misfits_;
    progress.restarts = restarts_;
    return progress;
}

std::shared_ptr<const Scan> SweepAssembler::snapshot() {
    if (!changed_ || !sweep_) return snapshot_;
    changed_ = false;
    const int rows = sweep_->wholeRows();
    if (rows == 0 || sweep_->grid().beams() == 0) return snapshot_ = nullptr;
    const std::shared_ptr<Scan> scan = sweep_->grid().scan(rows);
    describe(*scan);
    return snapshot_ = scan;
}

/// Everything but ranges and states; the scan may have been another snapshot before.
void SweepAssembler::describe(Scan& scan) {
    const SweepProgress now = progress();
    const auto rows = static_cast<std::size_t>(now.lines);
    LineAngles angles = lineAngles(sweep_->facts().first(rows), settings_);
    PolarGeometry polar;
    polar.beamDeg = sweep_->beams().beamDeg();
    polar.lineDeg = std::move(angles.lineDeg);
    polar.axis = settings_.axis;
    polar.lineDirection = settings_.lineDirection;
    polar.lineSkewDeg = lineSkewDeg(polar.beamDeg, sweep_->turnsOf(), angles.degPerTurn, settings_.indexDeg);
    scan.geometry = std::move(polar);
    scan.format = "sweep";
    scan.name = "sweep " + std::to_string(number_ + 1);
    scan.unitMm = sweep_->unitMm();
    scan.noReturnCodes = {0};
    scan.statusCodes = sweep_->statusCodes();
    scan.acquisition = sweepAcquisition(*sweep_, rows, settings_);
    scan.warnings.clear();
    const auto warn = [&](std::string sentence) { scan.warnings.push_back(std::move(sentence)); };
    if (!now.complete()) warn(now.text() + ".");
    if (!now.lost.empty()) warn("Telegrams were lost: " + rowsText(now.lost) + " (" + std::to_string(now.lost.size()) + " in all).");
    if (angles.source == AngleSource::Time) warn("The line angles are reckoned from time alone: a change of speed bends the cloud.");
    if (encoderWithoutScale_) warn("The telegrams carry encoder counts, but nobody said how many make a degree: they are not used.");
    if (encoderWasReset_) warn("The scanner lost its encoder count when it started anew: line angles behind that are reckoned.");
    const DeviceFlags& ever = now.deviceEver;
    const std::string from = " (from line " + std::to_string(std::max(0, sweep_->firstFlagged())) + " on).";
    if (ever.error) warn("The scanner reported an error or was not ready" + from);
    if (ever.contaminationError) warn("The scanner reported a window too dirty to measure through" + from);
    if (ever.contaminationWarning) warn("The scanner reported a dirty window" + from);
}

} // namespace edgescan
