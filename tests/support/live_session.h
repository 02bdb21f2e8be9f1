// A scanner session and what it told, for tests; an emulated scanner with few beams.
#pragma once

#include "core/scanner/emulator/emulator.h"
#include "core/scanner/emulator/telegram.h"
#include "core/scanner/sick_lms/scanner_session.h"
#include "core/scanner/sweep_assembly/counters.h"
#include "tests/support/scans.h"
#include "tests/support/wait_until.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <condition_variable>
#include <mutex>
#include <vector>

namespace edgescan::test {

using namespace std::chrono_literals;

/// Waits that no busy machine makes too short, for tests of a scanner that answers.
inline ScannerTimeouts patient() {
    ScannerTimeouts timeouts;
    timeouts.connect = timeouts.answer = timeouts.firstScan = timeouts.silence = kPatience;
    timeouts.detect = 3s; // a dialect that the scanner does not speak costs so long
    timeouts.rests = {20ms, 40ms};
    return timeouts;
}

/// Short waits, so that a test of failures is quick.
inline ScannerTimeouts hasty() {
    ScannerTimeouts timeouts;
    timeouts.connect = 1s;
    timeouts.detect = 150ms;
    timeouts.answer = 1s;
    timeouts.firstScan = 1s;
    timeouts.silence = 100ms; // ten periods of 25 Hz are more: 400 ms
    timeouts.rests = {20ms, 40ms};
    return timeouts;
}

/// Everything that a session told. Destroy the session first.
class Listener {
public:
    [[nodiscard]] SessionEvents events() {
        return {[this](const SessionState& state) { add(states_, state); }, [this](const ScannerIdentity& who) { add(identities_, who); },
                [this](const ColaFrame& frame) { add(frames_, frame); }, [this](const ColaFrame& frame) { add(sent_, frame); }};
    }

    /// True as soon as `done` is, which sees this listener locked.
    template <class Condition>
    [[nodiscard]] bool waitFor(Condition done) {
        std::unique_lock lock(mutex_);
        return changed_.wait_for(lock, kPatience, [&] { return done(*this); });
    }
    [[nodiscard]] bool waitForPhase(SessionPhase phase) {
        return waitFor([phase](const Listener& l) { return l.entered(phase) > 0; });
    }
    [[nodiscard]] bool waitForScans(std::size_t count) {
        return waitFor([count](const Listener& l) { return l.scans_ >= count; });
    }

    // After the session is gone, or inside waitFor.
    [[nodiscard]] const std::vector<SessionState>& states() const { return states_; }
    [[nodiscard]] const std::vector<ScannerIdentity>& identities() const { return identities_; }
    [[nodiscard]] const std::vector<ColaFrame>& frames() const { return frames_; }
    [[nodiscard]] const std::vector<ColaFrame>& sent() const { return sent_; }
    [[nodiscard]] long entered(SessionPhase phase) const {
        return std::count_if(states_.begin(), states_.end(), [phase](const SessionState& state) { return state.phase == phase; });
    }
    [[nodiscard]] std::vector<ScanTelegram> telegrams() const {
        std::vector<ScanTelegram> telegrams;
        for (const ColaFrame& frame : frames_) {
            if (auto telegram = decodeScanTelegram(frame)) telegrams.push_back(std::move(*telegram));
        }
        return telegrams;
    }
    /// "CONNECTING IDENTIFYING LIVE".
    [[nodiscard]] std::string story() const {
        std::string story;
        for (const SessionState& state : states_) {
            if (!story.empty()) story += ' ';
            story += sessionPhaseName(state.phase);
        }
        return story;
    }
    [[nodiscard]] std::vector<std::string> sentCommands() const {
        std::vector<std::string> commands;
        for (const ColaFrame& frame : sent_) {
            const ByteView payload = frame.payload();
            std::string text(payload.begin(), payload.end());
            commands.push_back(text.substr(0, text.find(' ', 4)));
        }
        return commands;
    }

private:
    template <class T>
    void add(std::vector<T>& list, const T& item) {
        {
            const std::lock_guard lock(mutex_);
            list.push_back(item);
            if constexpr (std::is_same_v<T, ColaFrame>) {
                if (&list == &frames_ && isScanTelegram(item.payload())) ++scans_;
            }
        }
        changed_.notify_all();
    }

    std::mutex mutex_;
    std::condition_variable changed_;
    std::vector<SessionState> states_;
    std::vector<ScannerIdentity> identities_;
    std::vector<ColaFrame> frames_;
    std::vector<ColaFrame> sent_;
    std::size_t scans_ = 0;
};

/// A scan whose range tells the cell.
inline Scan countingScan(int lines, int beams) {
    return makeScan(lines, beams, [](int i, int j) { return (i + j) % 17 == 0 ? 0 : 1000 + i * 10 + j; });
}

inline std::unique_ptr<EmulatedScanner> served(const Scan& scan, const EmulatedScannerSettings& settings, const TelegramStyle& style = {}) {
    auto telegrams = telegramsOf(scan, style);
    EXPECT_TRUE(telegrams);
    auto scanner = serveTelegrams(std::make_shared<const std::vector<ScanTelegram>>(std::move(*telegrams)), settings);
    EXPECT_TRUE(scanner) << scanner.error().sentence();
    return std::move(*scanner);
}

inline SessionSettings settingsFor(const EmulatedScanner& scanner, const ScannerTimeouts& timeouts = patient()) {
    SessionSettings settings;
    settings.host = "127.0.0.1";
    settings.port = scanner.port();
    settings.timeouts = timeouts;
    return settings;
}

/// What the counters of the received telegrams say.
struct Account {
    std::int64_t received = 0; ///< without duplicates
    std::int64_t lost = 0;
    std::int64_t duplicates = 0;
    std::int64_t restarts = 0;
    std::int64_t span = 0; ///< from the first counter to the last
};
inline Account accountOf(const std::vector<ScanTelegram>& telegrams) {
    Account account;
    LineCounter counter;
    std::int64_t first = 0;
    for (const ScanTelegram& telegram : telegrams) {
        const LineStamp stamp = counter.stamp(telegram, 0);
        if (stamp.step == LineStep::First) first = stamp.telegram;
        if (stamp.step == LineStep::Duplicate) {
            ++account.duplicates;
            continue;
        }
        if (stamp.step == LineStep::Restart) ++account.restarts;
        ++account.received;
        account.lost += stamp.lost;
        account.span = stamp.telegram - first + 1;
    }
    return account;
}

} // namespace edgescan::test
