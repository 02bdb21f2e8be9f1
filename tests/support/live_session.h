// A scanner session and a record of its events, for tests; an emulated scanner with few beams.
#pragma once

#include "app/lab/emulator/emulator.h"
#include "app/lab/emulator/telegram.h"
#include "core/scanner/sick_lms/scanner_connection.h"
#include "core/scanner/sick_lms/sweep_feed.h"
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
inline scanner::ScannerTimeouts patient() {
    scanner::ScannerTimeouts timeouts;
    timeouts.connect = timeouts.answer = timeouts.firstScan = timeouts.silence = kPatience;
    timeouts.detect = 3s; // a dialect that the scanner does not speak costs so long
    timeouts.rests = {20ms, 40ms};
    return timeouts;
}

/// Short waits, so that a test of failures is quick.
inline scanner::ScannerTimeouts hasty() {
    scanner::ScannerTimeouts timeouts;
    timeouts.connect = 1s;
    timeouts.detect = 150ms;
    timeouts.answer = 1s;
    timeouts.firstScan = 1s;
    timeouts.silence = 100ms; // ten periods of 25 Hz are longer: 400 ms
    timeouts.rests = {20ms, 40ms};
    return timeouts;
}

/// All events of a session. Destroy the session before this object.
class Listener {
public:
    [[nodiscard]] scanner::ConnectionEvents events() {
        return {[this](const scanner::ConnectionState& state) { add(states_, state); },
                [this](const scanner::ScannerIdentity& who) { add(identities_, who); },
                [this](const scanner::ColaFrame& frame) { add(frames_, frame); },
                [this](const scanner::ColaFrame& frame) { add(sent_, frame); }};
    }

    /// True as soon as `done` is true. `done` is called while this listener is locked.
    template <class Condition>
    [[nodiscard]] bool waitFor(Condition done) {
        std::unique_lock lock(mutex_);
        return changed_.wait_for(lock, kPatience, [&] { return done(*this); });
    }
    [[nodiscard]] bool waitForPhase(scanner::ConnectionPhase phase) {
        return waitFor([phase](const Listener& l) { return l.entered(phase) > 0; });
    }
    [[nodiscard]] bool waitForScans(std::size_t count) {
        return waitFor([count](const Listener& l) { return l.scans_ >= count; });
    }

    // Call these after the session is destroyed, or inside waitFor.
    [[nodiscard]] const std::vector<scanner::ConnectionState>& states() const { return states_; }
    [[nodiscard]] const std::vector<scanner::ScannerIdentity>& identities() const { return identities_; }
    [[nodiscard]] const std::vector<scanner::ColaFrame>& frames() const { return frames_; }
    [[nodiscard]] const std::vector<scanner::ColaFrame>& sent() const { return sent_; }
    [[nodiscard]] long entered(scanner::ConnectionPhase phase) const {
        return std::count_if(states_.begin(), states_.end(),
                             [phase](const scanner::ConnectionState& state) { return state.phase == phase; });
    }
    [[nodiscard]] std::vector<scanner::ScanTelegram> telegrams() const {
        std::vector<scanner::ScanTelegram> telegrams;
        for (const scanner::ColaFrame& frame : frames_) {
            if (auto telegram = scanner::decodeScanTelegram(frame)) telegrams.push_back(std::move(*telegram));
        }
        return telegrams;
    }
    /// "CONNECTING IDENTIFYING LIVE".
    [[nodiscard]] std::string story() const {
        std::string story;
        for (const scanner::ConnectionState& state : states_) {
            if (!story.empty()) story += ' ';
            story += scanner::connectionPhaseName(state.phase);
        }
        return story;
    }
    [[nodiscard]] std::vector<std::string> sentCommands() const {
        std::vector<std::string> commands;
        for (const scanner::ColaFrame& frame : sent_) {
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
            if constexpr (std::is_same_v<T, scanner::ColaFrame>) {
                if (&list == &frames_ && scanner::isScanTelegram(item.payload())) ++scans_;
            }
        }
        changed_.notify_all();
    }

    std::mutex mutex_;
    std::condition_variable changed_;
    std::vector<scanner::ConnectionState> states_;
    std::vector<scanner::ScannerIdentity> identities_;
    std::vector<scanner::ColaFrame> frames_;
    std::vector<scanner::ColaFrame> sent_;
    std::size_t scans_ = 0;
};

/// A scan whose range identifies the cell.
inline Scan countingScan(int lines, int beams) {
    return makeScan(lines, beams, [](int i, int j) { return (i + j) % 17 == 0 ? 0 : 1000 + i * 10 + j; });
}

inline std::unique_ptr<scanner::EmulatedScanner> served(const Scan& scan, const scanner::EmulatedScannerSettings& settings,
                                                        const scanner::TelegramStyle& style = {}) {
    auto telegrams = scanner::telegramsOf(scan, style);
    EXPECT_TRUE(telegrams);
    auto scanner = scanner::serveTelegrams(std::make_shared<const std::vector<scanner::ScanTelegram>>(std::move(*telegrams)), settings);
    EXPECT_TRUE(scanner) << scanner.error().sentence();
    return std::move(*scanner);
}

inline scanner::ConnectionSettings settingsFor(const scanner::EmulatedScanner& scanner,
                                               const scanner::ScannerTimeouts& timeouts = patient()) {
    scanner::ConnectionSettings settings;
    settings.host = "127.0.0.1";
    settings.port = scanner.port();
    settings.timeouts = timeouts;
    return settings;
}

/// The counters of the received telegrams.
struct Account {
    std::int64_t received = 0; ///< without duplicates
    std::int64_t lost = 0;
    std::int64_t duplicates = 0;
    std::int64_t restarts = 0;
    std::int64_t span = 0; ///< from the first counter to the last
};
inline Account accountOf(const std::vector<scanner::ScanTelegram>& telegrams) {
    Account account;
    scanner::LineCounter counter;
    std::int64_t first = 0;
    for (const scanner::ScanTelegram& telegram : telegrams) {
        const scanner::LineStamp stamp = counter.stamp(scanner::countOf(telegram), 0);
        if (stamp.step == scanner::LineStep::First) first = stamp.telegram;
        if (stamp.step == scanner::LineStep::Duplicate) {
            ++account.duplicates;
            continue;
        }
        if (stamp.step == scanner::LineStep::Restart) ++account.restarts;
        ++account.received;
        account.lost += stamp.lost;
        account.span = stamp.telegram - first + 1;
    }
    return account;
}

} // namespace edgescan::test
