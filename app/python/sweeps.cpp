// Growing sweeps in Python: recordings and live scanners as iterators.
#include "app/python/module.h"

#include "app/shared/options.h"
#include "core/base/foreign_text.h"
#include "core/base/number_text.h"
#include "core/base/physical_limits.h"
#include "core/files/live_feed/live_feed.h"
#include "core/files/open_save/open_scan.h"
#include "core/scanner/cola/host_port.h"

#include <chrono>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>

namespace edgescan::python {
namespace {

using Clock = std::chrono::steady_clock;

/// The state of a sweep at one moment.
struct SweepObject {
    ScanPtr scan;
    scanner::SweepProgress progress;
    bool finished = false; ///< all expected lines arrived, or the next sweep began
};

/// Sleeps without the lock until `end`, or until Ctrl+C raises an exception.
void sleepUntil(Clock::time_point end) {
    constexpr auto kPiece = std::chrono::milliseconds(100);
    while (Clock::now() < end) {
        unlocked([&] {
            std::this_thread::sleep_until(std::min(end, Clock::now() + kPiece));
            return Done{};
        });
        if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    }
}

/// Plays a recording: yields the sweep after every `every` lines, and once more when it is finished.
class ReplayObject {
public:
    ReplayObject(const std::string& path, std::int64_t every, double speed, const std::string& pose, const std::string& calibration)
        : path_(path), every_(every), speed_(speed) {
        if (every < 1) throw Refused{{std::to_string(every) + " lines are not a step", "every", "give 1 or more"}};
        if (!(speed >= 0 && speed <= 1e6)) throw Refused{{"the speed is out of reason", "speed", "give 0 to 1000000"}};
        options_.pose = pose;
        options_.calibration = calibration;
        replay_.emplace(unlocked([&] { return files::Replay(valueOf(files::Recording::open(path)), options_); }));
        if (replay_->lines() == 0)
            throw Refused{
                {"this recording holds no scan telegram" + replay_->recording().whatWasLeftOut(), path, "choose another recording"}};
        started_ = Clock::now();
    }

    SweepObject next() {
        while (true) {
            if (!waiting_.empty()) {
                SweepObject sweep = std::move(waiting_.front());
                waiting_.pop_front();
                return sweep;
            }
            if (replay_->atEnd()) throw py::stop_iteration();
            if (speed_ > 0 && replay_->position() > 0 && replay_->position() < replay_->lines()) sleepUntil(due());
            unlocked([&] {
                step();
                return Done{};
            });
            if (PyErr_CheckSignals() != 0) throw py::error_already_set();
        }
    }

    [[nodiscard]] std::string text() const {
        return "<edgescan.Replay of " + printable(path_) + ": line " + std::to_string(replay_->position()) + " of " +
               std::to_string(replay_->lines()) + ">";
    }

private:
    [[nodiscard]] Clock::time_point due() const {
        const double ns = static_cast<double>(replay_->timeNs(replay_->position()) - replay_->timeNs(0)) / speed_;
        return started_ + std::chrono::nanoseconds(static_cast<std::int64_t>(std::max(0.0, ns)));
    }
    void step() {
        const int before = replay_->position();
        replay_->step();
        scanner::SweepAssembler& assembler = replay_->feed().assembler();
        for (scanner::FinishedSweep& sweep : assembler.popFinished()) add(sweep.scan, std::move(sweep.progress), true);
        if (replay_->position() == before || replay_->position() % every_ != 0 || replay_->atEnd()) return;
        if (const auto scan = replay_->snapshot()) add(scan, replay_->progress(), false);
    }
    void add(const ScanPtr& scan, scanner::SweepProgress progress, bool finished) {
        Scan described = valueOf(files::describedSweep(*scan, replay_->recording(), path_, options_));
        waiting_.push_back({std::make_shared<const Scan>(std::move(described)), std::move(progress), finished});
    }

    const std::string path_;
    const std::int64_t every_;
    const double speed_;
    ReadingOptions options_;
    std::optional<files::Replay> replay_;
    std::deque<SweepObject> waiting_;
    Clock::time_point started_;
};

/// A live scanner: yields the newest state of the sweep after each change, and each finished sweep.
class ConnectionObject {
public:
    ConnectionObject(const std::string& address, const scanner::SweepSettings& sweep, const std::string& record, double timeout)
        : address_(address), timeout_(timeout) {
        const scanner::HostPort typed = valueOf(scanner::hostPort(address));
        scanner::ConnectionSettings scanner;
        scanner.host = typed.host;
        scanner.port = typed.port;
        scanner.bridge = typed.bridge;
        feed_ = std::make_unique<files::LiveFeed>(scanner, sweep, [this] {
            {
                const std::lock_guard lock(mutex_);
                changed_ = true;
            }
            wake_.notify_all();
        });
        if (!record.empty()) {
            valueOf(unlocked([&] { return feed_->startRecording(record); }));
            recording_ = true;
        }
    }
    ~ConnectionObject() {
        const py::gil_scoped_release released;
        feed_.reset();
    }
    ConnectionObject(const ConnectionObject&) = delete;
    ConnectionObject& operator=(const ConnectionObject&) = delete;

    /// Error: no line came; a recording without a byte of the scanner is removed.
    void waitForFirstLine() {
        const auto end = ownEnd();
        while (feed_->status().lines == 0) {
            if (Clock::now() >= end && feed_->status().statistics.stream.bytes == 0) {
                unlocked([&] {
                    feed_->discardRecording();
                    return Done{};
                });
            }
            waitUntil(end);
        }
    }

    SweepObject next(std::optional<double> timeout = {}) {
        const auto end = timeout ? endOf(*timeout) : ownEnd();
        while (true) {
            if (stopped_) throw py::stop_iteration(); // a loop in which it was closed ends
            if (std::optional<SweepObject> sweep = unlocked([&] { return newest(); })) return std::move(*sweep);
            waitUntil(end);
        }
    }

    /// Error: the session has ended.
    void checkOpen() const {
        if (stopped_) throw Refused{{"the connection is closed", address_, "connect() again"}};
    }

    void stop() {
        const Result<files::RecordingState> closed = unlocked([&]() -> Result<files::RecordingState> {
            feed_->stop();
            return recording_ ? feed_->stopRecording() : Result<files::RecordingState>(files::RecordingState{});
        });
        stopped_ = true;
        recording_ = false;
        valueOf(closed);
    }

    [[nodiscard]] std::string text() const {
        const files::LiveStatus status = unlocked([&] { return feed_->status(); });
        return "<edgescan.Connection to " + printable(address_) + ": " + scanner::connectionPhaseName(status.connection.phase) + ", " +
               std::to_string(status.lines) + " lines>";
    }
    [[nodiscard]] py::dict status() const {
        const files::LiveStatus status = unlocked([&] { return feed_->status(); });
        py::dict dict;
        dict["phase"] = scanner::connectionPhaseName(status.connection.phase);
        dict["sentence"] = nameOf(status.connection.sentence);
        dict["scanner"] = status.scanner ? py::object(nameOf(status.scanner->words())) : py::object(py::none());
        dict["lines"] = status.lines;
        dict["undecodable"] = status.undecodable;
        dict["reconnects"] = status.statistics.reconnects;
        dict["sweep"] = status.sweep.text();
        dict["recording"] = status.recording.has_value();
        return dict;
    }

private:
    static Clock::time_point endOf(double seconds) {
        return Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
    }
    [[nodiscard]] Clock::time_point ownEnd() const { return timeout_ == 0 ? Clock::time_point::max() : endOf(timeout_); }
    /// Waits for a change, and logs each new problem of the connection. Error: `end` has passed.
    void waitUntil(Clock::time_point end) {
        const scanner::ConnectionState session = feed_->status().connection;
        if (Clock::now() >= end) throw Refused{scanner::noLinesError(session, address_)};
        if (const std::string problem = session.problem ? session.problem->sentence() : std::string(); problem != logged_) {
            logged_ = problem;
            if (!problem.empty()) logWarning(problem);
        }
        unlocked([&] { return wait(end); });
        if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    }
    std::optional<SweepObject> newest() {
        for (scanner::FinishedSweep& sweep : feed_->popFinished()) {
            const bool yielded = sweep.progress.number == yielded_.number && sweep.progress.received == yielded_.received;
            if (!yielded) finished_.push_back({sweep.scan, std::move(sweep.progress), true});
        }
        SweepObject object;
        if (!finished_.empty()) {
            object = std::move(finished_.front());
            finished_.pop_front();
        } else {
            scanner::SweepState sweep = feed_->sweep();
            if (!sweep.scan || sweep.scan == shown_) return std::nullopt;
            // The feed ends a sweep when the next one begins; a sweep with all its lines is yielded without that wait.
            const bool whole = !sweep.progress.growing;
            if (whole && sweep.progress.number == yielded_.number && sweep.progress.received == yielded_.received) return std::nullopt;
            object = {std::move(sweep.scan), std::move(sweep.progress), whole};
        }
        shown_ = object.scan;
        if (object.finished) yielded_ = {object.progress.number, object.progress.received};
        return object;
    }
    Done wait(Clock::time_point end) {
        std::unique_lock lock(mutex_);
        wake_.wait_until(lock, std::min(end, Clock::now() + std::chrono::milliseconds(100)), [&] { return changed_; });
        changed_ = false;
        return {};
    }

    std::string address_, logged_;
    double timeout_;
    std::mutex mutex_; // protects changed_
    std::condition_variable wake_;
    bool changed_ = false;
    bool recording_ = false, stopped_ = false;
    std::deque<SweepObject> finished_;
    ScanPtr shown_;
    struct {
        int number = -1, received = 0;
    } yielded_;                             // the last finished sweep that was yielded
    std::unique_ptr<files::LiveFeed> feed_; // last member: its thread uses the members above
};

void checkTimeout(double timeout) {
    if (!NumberLimits{0, 4e7}.hold(timeout))
        throw Refused{{shortestText(timeout) + " seconds are out of reason", "timeout", "give 0 to 40000000"}};
}

std::unique_ptr<ConnectionObject> connect(const std::string& address, const std::string& record, const py::int_& expected,
                                          const std::optional<std::string>& axis, std::optional<double> lineStart,
                                          std::optional<double> lineStep, std::optional<double> ticksPerDegree,
                                          const std::string& calibration, bool stopAndGo, double timeout) {
    if (axis && *axis != "spin" && *axis != "sweep") throw Refused{{"\"" + *axis + "\" is not an axis", "axis", "use spin or sweep"}};
    const std::int64_t expectedLines = wholeOf(expected);
    if (expectedLines < 0 || expectedLines > 20000)
        throw Refused{{std::to_string(expectedLines) + " lines are out of reason", "expected_lines", "give 0 to 20000"}};
    if (!physical::kBeamDeg.hold(lineStart.value_or(0)) || !NumberLimits{-90, 90}.hold(lineStep.value_or(0)))
        throw Refused{{"the line angles are out of reason", "line_start, line_step", "give degrees, -360 to 360 and -90 to 90"}};
    checkTimeout(timeout);
    cli::Mounting mounting{.axis = std::nullopt,
                           .lineStepDeg = lineStep,
                           .firstLineDeg = lineStart,
                           .ticksPerDeg = ticksPerDegree,
                           .calibration = calibration,
                           .expectedLines = static_cast<int>(expectedLines),
                           .stopAndGo = stopAndGo};
    if (axis) mounting.axis = *axis == "spin" ? Axis::Spin : Axis::Sweep;
    valueOf(cli::checkMounting(mounting));
    auto connection = std::make_unique<ConnectionObject>(address, valueOf(cli::sweepOf(mounting)), record, timeout);
    connection->waitForFirstLine();
    return connection;
}

void bindSweep(py::module_& module) {
    Class<SweepObject> type(module, "Sweep", "A sweep as it was at one moment while its lines arrived.");
    const auto property = [&](const char* name, const auto& get, const char* help) {
        type.def_property_readonly(
            name, [get](const SweepObject& self) { return get(self); }, help);
    };
    using S = SweepObject;
    property(
        "scan", [](const S& s) { return ScanObject{s.scan}; }, "The lines so far as a scan.");
    property(
        "finished", [](const S& s) { return s.finished; }, "All lines that were expected came, or the next sweep began.");
    property(
        "number", [](const S& s) { return s.progress.number; }, "Of this sweep since the start, from 0.");
    property(
        "lines", [](const S& s) { return s.progress.lines; }, "Lines so far, lost ones included.");
    property(
        "received", [](const S& s) { return s.progress.received; }, "Lines of which nothing is missing.");
    property(
        "expected", [](const S& s) { return s.progress.expected; }, "Lines of the whole sweep; 0: not known.");
    property(
        "lost", [](const S& s) { return s.progress.lost; }, "Rows of which something is missing, ascending.");
    property(
        "complete", [](const S& s) { return s.progress.complete(); }, "Nothing is missing, and all lines expected are there.");
    property(
        "time_ns", [](const S& s) { return s.progress.newestNs; }, "Host time of the newest line, ns; only differences mean something.");
    type.def("__repr__",
             [](const S& s) { return "<edgescan.Sweep " + std::to_string(s.progress.number) + ": " + s.progress.text() + ">"; });
}

} // namespace

void bindSweeps(py::module_& module) {
    bindSweep(module);
    Class<ReplayObject>(module, "Replay", "Iterator over a recording.")
        .def("__iter__", [](py::object self) { return self; })
        .def("__next__", &ReplayObject::next)
        .def("__repr__", &ReplayObject::text);
    Class<ConnectionObject>(module, "Connection", "A scanner: iterator over its growing sweep, and context manager that ends the session.")
        .def("__iter__",
             [](py::object self) {
                 self.cast<const ConnectionObject&>().checkOpen();
                 return self;
             })
        .def("__next__", [](ConnectionObject& self) { return self.next(); })
        .def("__enter__", [](py::object self) { return self; })
        .def("__exit__", [](ConnectionObject& self, const py::args&) { self.stop(); })
        .def("__repr__", &ConnectionObject::text)
        .def_property_readonly("status", &ConnectionObject::status,
                               "A dict: phase, sentence, scanner, lines, undecodable, reconnects, sweep, recording.");
    module.def("connection_next", [](ConnectionObject& self, std::optional<double> timeout) {
        if (timeout) checkTimeout(*timeout);
        self.checkOpen();
        return self.next(timeout);
    });
    module.def("connection_stop", &ConnectionObject::stop);
    module.def("replay",
               [](const std::string& path, const py::int_& every, double speed, const std::string& pose, const std::string& calibration) {
                   return std::make_unique<ReplayObject>(path, wholeOf(every), speed, pose, calibration);
               });
    module.def("connect", &connect, py::arg("address"), py::arg("record"), py::arg("expected_lines"), py::arg("axis").none(true),
               py::arg("line_start").none(true), py::arg("line_step").none(true), py::arg("ticks_per_degree").none(true),
               py::arg("calibration"), py::arg("stop_and_go"), py::arg("timeout"));
}

} // namespace edgescan::python
