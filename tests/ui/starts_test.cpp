// Every start of the viewer with a request ends with an answer: the exit code and, where it is not 0, one sentence on stderr. The real
// program, for each kind of request, each way in which it can be faulty, and each flag that ends the viewer.
#include "core/base/whole_file.h"
#include "core/files/open_save/open_scan.h"
#include "core/files/open_save/save_scan.h"
#include "core/inspect/session_file/session_file.h"
#include "tests/support/folders.h"
#include "tests/support/robot_files.h"
#include "tests/support/run_program.h"
#include "tests/support/scans.h"
#include "tests/ui/run_test.h"

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QFile>
#include <QImage>
#include <QProcess>

#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/stat.h>

#include <deque>
#include <list>
#include <memory>

using namespace edgescan;
namespace fs = std::filesystem;

namespace starts { // has a name: members of the class below have these types

constexpr int kProcessPatienceMs = 240'000;
constexpr std::size_t kAtOnce = 4; // processes that compute

/// A listening socket to which this test never answers; `open` false: the port is free again, so that a connection is refused.
class Port {
public:
    explicit Port(bool open) : socket_(::socket(AF_INET, SOCK_STREAM, 0)) {
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        socklen_t size = sizeof address;
        const auto plain = reinterpret_cast<sockaddr*>(&address);
        if (::bind(socket_, plain, size) != 0 || ::getsockname(socket_, plain, &size) != 0) return;
        if (open) ::listen(socket_, 64);
        address_ = "127.0.0.1:" + QString::number(ntohs(address.sin_port));
    }
    ~Port() { ::close(socket_); }
    Port(const Port&) = delete;
    Port& operator=(const Port&) = delete;
    [[nodiscard]] const QString& address() const { return address_; }

private:
    int socket_;
    QString address_;
};

/// The ways in which a file can be faulty.
enum class Fault { Missing, Broken, Empty, Folder, Unreadable, Slow };
constexpr std::array kFaults{Fault::Missing, Fault::Broken, Fault::Empty, Fault::Folder, Fault::Unreadable, Fault::Slow};

struct Start {
    QString name;
    QStringList arguments;
    QString says;      ///< is in the sentence
    bool good = false; ///< exit code 0 and no sentence
};

struct Running {
    Start start;
    QString picture; ///< empty: not wanted
    std::unique_ptr<QProcess> process;
};

} // namespace starts
using namespace starts;

class StartsTest : public QObject {
    Q_OBJECT
    test::TemporaryFolder folder_;
    Port silent_{true}, refusing_{false};
    std::vector<int> writers_; // of the pipes: a writer that never writes
    QString scan_;
    std::vector<Start> starts_;

    [[nodiscard]] QString at(const std::string& name) const { return QString::fromStdString((folder_ / name).string()); }

    /// A faulty file with this ending.
    QString faulty(Fault fault, const std::string& kind, const std::string& ending) {
        static constexpr std::array kNames{"missing", "broken", "empty", "folder", "unreadable", "slow"};
        const fs::path path = folder_ / (kind + "-" + kNames[static_cast<std::size_t>(fault)] + ending);
        switch (fault) {
        case Fault::Missing:
            break;
        case Fault::Broken:
            writeText(path, "{\"format\": \"edgescan\", [[[");
            break;
        case Fault::Empty:
            writeText(path, "");
            break;
        case Fault::Folder:
            fs::create_directory(path);
            break;
        case Fault::Unreadable: // root may read every file but this one
            if (::geteuid() == 0) {
                fs::create_symlink("/proc/self/mem", path);
            } else {
                writeText(path, "{}");
                fs::permissions(path, fs::perms::none);
            }
            break;
        case Fault::Slow:
            if (::mkfifo(path.c_str(), 0600) == 0) writers_.push_back(::open(path.c_str(), O_RDWR | O_CLOEXEC));
            break;
        }
        return QString::fromStdString(path.string());
    }
    static void writeText(const fs::path& path, const std::string& text) { QVERIFY(writeWholeFile(path, text)); }

    QString session(const char* name, const fs::path& scan, const inspect::NotebookScan& identity) {
        inspect::ViewerState state;
        state.scan = inspect::fileScan(scan, {}, identity);
        const std::string file = std::string(name) + inspect::kSessionEnding;
        writeText(folder_ / file, inspect::sessionText(state, folder_.path(), {}));
        return at(file);
    }

    void listStarts() {
        const auto add = [&](const QString& name, const QStringList& arguments, const QString& says) {
            starts_.push_back({name, arguments, says});
        };
        struct Kind {
            const char* name;
            const char* ending;
            QStringList before; ///< the faulty file
            QStringList others;
        };
        writeText(folder_ / "robot.json", test::calibrationText(test::exampleCalibration()));
        const std::vector<Kind> kinds{{"scan", ".json", {}, {}},
                                      {"session", inspect::kSessionEnding, {"--session"}, {}},
                                      {"compare", ".json", {"--compare"}, {scan_}},
                                      {"calibration", ".json", {"--calibration"}, {scan_, "--pose", at("any-pose.json")}},
                                      {"live-calibration", ".json", {"--calibration"}, {"--live", silent_.address()}},
                                      {"pose", ".json", {"--pose"}, {scan_, "--calibration", at("robot.json")}},
                                      {"preset", ".json", {"--preset"}, {scan_}}};
        for (const Kind& kind : kinds) {
            for (const Fault fault : kFaults) {
                const QString file = faulty(fault, kind.name, kind.ending);
                const QString name = QFileInfo(file).completeBaseName();
                add(name, kind.others + kind.before + QStringList{file}, QFileInfo(file).baseName());
            }
        }
        const auto opened = files::openScan(scan_.toStdString(), {});
        QVERIFY(opened);
        const inspect::NotebookScan identity = inspect::notebookScan(*opened);
        inspect::NotebookScan other = identity;
        other.sha256 = std::string(64, 'a');
        add("session of a missing scan", {"--session", session("of-missing", folder_ / "gone.json", identity)}, "gone");
        add("session of another scan", {"--session", session("of-another", scan_.toStdString(), other)}, "good");
        add("session of a broken scan", {"--session", session("of-broken", folder_ / "scan-broken.json", identity)}, "scan-broken");
        add("session of a slow scan", {"--session", session("of-slow", folder_ / "scan-slow.json", identity)}, "slow");
        writeText(folder_ / "no-session.json", "{\"format\": \"another\"}");
        add("a session that is none", {"--session", at("no-session.json")}, "no-session.json: this is not a session; choose a session");
        add("a scan as a session", {"--session", scan_}, "good.json: this is not a session");
        add("no session to continue", {"--continue"}, "session");
        add("a pin outside", {scan_, "--pin", "99,5"}, "line 99");
        add("a scanner that refuses", {"--live", refusing_.address()}, refusing_.address());
        add("a silent scanner", {"--live", silent_.address()}, silent_.address());
        const QString of = session("good", scan_.toStdString(), identity);
        for (const QStringList& good : {QStringList{scan_}, {"--session", of}, {scan_, "--compare", scan_}, {scan_, "--pin", "5,5"}})
            starts_.push_back({"good: " + good.join(' '), good, {}, true});
    }

    static bool isSlow(const Start& start) { return start.name.contains("slow") || start.name.contains("scanner"); }

    Running run(const Start& start, bool screenshot, bool quitAfter, int number) {
        Running running{start, screenshot ? at("picture" + std::to_string(number) + ".png") : QString(), std::make_unique<QProcess>()};
        QStringList arguments{"--no-settings", "--language", "en"};
        if (screenshot) arguments << "--screenshot" << running.picture;
        // With a screenshot the viewer ends before this time, unless the request is slow.
        if (quitAfter) arguments << "--quit-after" << (screenshot && !isSlow(start) ? "60" : "3");
        if (quitAfter && (!screenshot || isSlow(start))) running.start.says.clear(); // on a busy machine the time may pass first
        running.start.name += (screenshot ? " --screenshot" : "") + QString(quitAfter ? " --quit-after" : "");
        running.process->start(QString::fromStdString(test::programFolder()) + "/edgescan", arguments + start.arguments);
        return running;
    }

    /// The fault of an ended process; empty: none.
    static QString faultOf(Running& running) {
        const QString said = QString::fromUtf8(running.process->readAllStandardError());
        QStringList sentences;
        for (const QString& line : said.split('\n')) {
            if (line.startsWith("edgescan: ")) sentences << line;
        }
        const Start& start = running.start;
        const bool picture = !running.picture.isEmpty() && QFile::exists(running.picture);
        if (running.process->exitStatus() != QProcess::NormalExit) return "it crashed: " + said;
        const int code = running.process->exitCode();
        if (start.good) {
            if (code != 0 || !sentences.isEmpty()) return QString("exit code %1: %2").arg(code).arg(said);
            return picture || running.picture.isEmpty() ? QString() : "no picture";
        }
        if (code != 1 && code != 2) return QString("exit code %1: %2").arg(code).arg(said);
        if (sentences.size() != 1) return QString("%1 sentences: %2").arg(sentences.size()).arg(said);
        if (!sentences.front().contains(start.says)) return "not about " + start.says + ": " + said;
        return picture ? "a picture was written" : QString();
    }

    /// Ends by itself; the lines on stderr.
    static QStringList linesOf(QProcess& viewer, const QProcessEnvironment& environment, const QStringList& arguments) {
        viewer.setProcessEnvironment(environment);
        viewer.start(QString::fromStdString(test::programFolder()) + "/edgescan", arguments);
        if (!viewer.waitForFinished(kProcessPatienceMs)) return {"it does not end"};
        return QString::fromUtf8(viewer.readAllStandardError()).split('\n', Qt::SkipEmptyParts);
    }

private slots:
    void initTestCase() {
        const fs::path scan = folder_ / "good.json";
        QVERIFY(files::saveScan(test::boxesScan(60, 80, 3, 0.05), scan));
        scan_ = QString::fromStdString(scan.string());
        listStarts();
    }
    void cleanupTestCase() {
        for (const int writer : writers_) ::close(writer);
    }

    // Not with Qt's words and abort().
    void aPlatformWithoutAWindowIsAnsweredInOneSentence() {
        const auto usual = QProcessEnvironment::systemEnvironment();
        for (const auto& [platform, display] : {std::pair{"wayland", ":0"}, {"no-such-platform", ":0"}, {"xcb", ":97"}, {"", ""}}) {
            QProcessEnvironment environment = usual;
            environment.insert("QT_QPA_PLATFORM", platform);
            environment.insert("DISPLAY", display);
            environment.remove("WAYLAND_DISPLAY");
            QProcess viewer;
            const QStringList lines = linesOf(viewer, environment, {"--no-settings", scan_});
            QCOMPARE(viewer.exitStatus(), QProcess::NormalExit);
            QCOMPARE(viewer.exitCode(), 1);
            QVERIFY2(lines.size() == 1 && lines.front().startsWith("edgescan: "), qPrintable(lines.join('\n')));
            QVERIFY2(lines.front().contains(*display == ':' && display[1] == '0' ? platform : "display"), qPrintable(lines.front()));
        }
    }

    // 144 dpi are a factor of 1.5: the window has the room of 853 x 533 pixels, not that of half the screen.
    void textAt144DpiFitsOnASmallScreen() {
        QProcess screen;
        screen.start("Xvfb", {"-displayfd", "1", "-screen", "0", "1280x800x24"});
        if (!screen.waitForStarted()) QSKIP("Xvfb is missing");
        QVERIFY(screen.waitForReadyRead(kProcessPatienceMs));
        auto environment = QProcessEnvironment::systemEnvironment();
        environment.insert("DISPLAY", ":" + QString::fromLatin1(screen.readLine()).trimmed());
        environment.insert("QT_FONT_DPI", "144");
        QProcess viewer;
        const QString picture = at("large-text.png");
        const QStringList lines = linesOf(viewer, environment, {"--no-settings", "--screenshot", picture, scan_});
        screen.terminate();
        screen.waitForFinished();
        QVERIFY2(viewer.exitCode() == 0, qPrintable(lines.join('\n')));
        QCOMPARE(QImage(picture).size(), QSize(1280, 800));
    }

    // It would be waited for without end.
    void settingsThatAreAPipeAreRefusedInOneSentence() {
        fs::create_directories(folder_ / "config/edgescan");
        QCOMPARE(::mkfifo((folder_ / "config/edgescan/viewer.ini").c_str(), 0600), 0);
        auto environment = QProcessEnvironment::systemEnvironment();
        environment.insert("XDG_CONFIG_HOME", at("config"));
        QProcess viewer;
        const QStringList lines = linesOf(viewer, environment, {"--language", "en", "--screenshot", at("piped.png"), scan_});
        QCOMPARE(viewer.exitCode(), 0);
        QVERIFY2(lines.size() == 1 && lines.front().contains("viewer.ini: it is not a regular file"), qPrintable(lines.join('\n')));
        QVERIFY(QFile::exists(at("piped.png")));
    }

    // With code 2, before a window opens; a file that is missing has code 1.
    void whatWouldHaveNoEffectIsRefused() {
        struct Typed {
            QStringList arguments;
            int code;
            QString says;
        };
        writeText(folder_ / "shot.png", "a picture with a session");
        const QString other = at("other.json"), session = at(std::string("good") + inspect::kSessionEnding);
        QVERIFY(QFile::exists(other) || QFile::copy(scan_, other));
        std::vector<Typed> all{
            {{"--session", scan_, other}, 2, "other.json: --session shows a scan of its own and no other; leave out one of the two."},
            {{"--session", session, other}, 2, "other.json: --session"},
            {{"--continue", other}, 2, "other.json: --continue"},
            {{"--demo", other}, 2, "other.json: --demo"},
            {{"--demo", "--session", session}, 2, "--session: --demo"},
            {{"--session", session, "--preset", "thesis"}, 2, "--preset: the session has settings of its own; leave it out."},
            {{"--session", session, "--jump", "40"}, 2, "--jump: the session has"},
            {{"--session", session, "--unit", "cm"}, 2, "--unit: the session says how its scan is read; leave it out."},
            {{"--demo", "--unit", "cm"}, 2, "--unit: this is of a file, and none is named; leave it out."},
            {{"--live", silent_.address(), "--unit", "cm"}, 2, "--unit: this is of a file"},
            {{"--live", silent_.address(), "--keep-repeated"}, 2, "--keep-repeated: this is of a file"},
            {{"--live", silent_.address(), "--topic", "/x"}, 2, "--topic: this is of a file or of a robot's bridge"},
            {{"--live", silent_.address(), scan_}, 2, "good.json: --live shows a scan of its own and no other"},
            {{"--session", session, "--screenshot", session}, 2, "the picture is a PNG"},
            {{"--session", at("shot.png"), "--screenshot", at("shot.png")}, 2, "shot.png: the session is read from this file"},
            {{"--pin", "5,5"}, 2, "--pin: there is no scan to show"},
            {{"--compare", scan_}, 2, "--compare: there is no scan to show"},
            {{scan_, "--screenshot-lines", "5"}, 2, "--screenshot-lines: no screenshot is asked for"},
            {{scan_, at("nope.pcd")}, 1, "nope.pcd: there is no such file; check the spelling and the folder."},
            {{scan_, other, at("nope.pcd")}, 1, "nope.pcd: there is no such file"}};
        for (const char* flag : {"--expected-lines=100", "--stop-and-go", "--ticks-per-degree=5"})
            all.push_back({{scan_, flag}, 2, QString(flag).section('=', 0, 0) + ": this is of a live scanner; give --live ADDRESS too"});
        for (const char* name : {"victim.las", "victim.pcd", "victim.jpg", "victim", "victim.PNG.json"}) {
            writeText(folder_ / name, "precious");
            all.push_back(
                {{scan_, "--screenshot", at(name)}, 2, QString(name) + ": the picture is a PNG; give a name that ends with .png."});
        }
        for (const Typed& typed : all) {
            QProcess viewer;
            const QStringList lines =
                linesOf(viewer, QProcessEnvironment::systemEnvironment(), QStringList{"--no-settings"} + typed.arguments);
            const QString said = typed.arguments.join(' ') + " -> " + lines.join('\n');
            QVERIFY2(viewer.exitCode() == typed.code && lines.size() == 1 && lines.front().contains(typed.says), qPrintable(said));
        }
        QCOMPARE(QFile(at("victim.las")).size(), 8);
    }

    void everyStartEndsWithAnAnswer() {
        std::deque<std::function<Running()>> waiting, slow;
        int number = 0;
        for (const Start& start : starts_) {
            for (const auto& [screenshot, quitAfter] : {std::pair{true, false}, {false, true}, {true, true}}) {
                // A window with a notice ends in the same way, whatever the fault, and a picture before its time is over.
                if (quitAfter && !isSlow(start) && !start.name.contains("missing") && !(screenshot && start.good)) continue;
                // What waits for a time uses no processor: all of these run at once.
                const bool rests = isSlow(start) && !quitAfter;
                (rests ? slow : waiting).push_back([this, &start, s = screenshot, q = quitAfter, n = ++number] {
                    return run(start, s, q, n);
                });
            }
        }
        std::list<Running> running;
        QStringList faults;
        QElapsedTimer sinceEnd;
        sinceEnd.start();
        std::size_t resting = slow.size();
        for (const auto& start : slow) running.push_back(start());
        while (!running.empty() || !waiting.empty()) {
            for (auto it = running.begin(); it != running.end();) {
                if (it->process->state() != QProcess::NotRunning && !it->process->waitForFinished(10)) {
                    ++it;
                    continue;
                }
                if (const QString fault = faultOf(*it); !fault.isEmpty()) faults << it->start.name + ": " + fault;
                it = running.erase(it);
                sinceEnd.restart();
            }
            resting = std::min(resting, running.size());
            while (!waiting.empty() && running.size() < resting + kAtOnce) {
                running.push_back(waiting.front()());
                waiting.pop_front();
            }
            if (sinceEnd.elapsed() < kProcessPatienceMs) continue;
            for (Running& one : running) {
                faults << one.start.name + ": it does not end";
                one.process->kill();
                one.process->waitForFinished();
            }
            break;
        }
        QVERIFY2(faults.isEmpty(), qPrintable(QString("%1 of %2:\n").arg(faults.size()).arg(number) + faults.join("\n")));
    }
};

int starts_test(int argc, char** argv) { return ui::runTest<StartsTest, QCoreApplication>(argc, argv); }

#include "starts_test.moc"
