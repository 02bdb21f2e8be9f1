// The window's settings file (viewer.ini) with damaged bytes: what is read can be used, and what is written then is read back.
#include "core/edges/settings/parameters.h"
#include "tests/support/damage.h"
#include "tests/support/run_program.h"
#include "tests/ui/run_test.h"
#include "ui/base/shown_text.h"
#include "ui/engine/worker_bridge/preferences.h"

#include <QTest>

#include <fstream>
#include <sys/stat.h>

using namespace edgescan;
using namespace edgescan::ui;

namespace {

constexpr int kRounds = 120;

class DamagedSettingsTest : public QObject {
    Q_OBJECT

private slots:
    void whateverTheBytesAreTheSettingsCanBeUsedAndWrittenAgain() {
        const std::string path = (folder_ / "viewer.ini").string();
        const std::string whole = wholeFile(path);
        QVERIFY(whole.size() > 500);
        std::mt19937 random(28);
        int kept = 0;
        for (int round = 0; round < kRounds; ++round) {
            const std::string bytes = round % 10 == 9 ? whole.substr(0, random() % whole.size()) : test::damaged(whole, random, round);
            std::ofstream(path, std::ios::binary) << bytes;
            edges::Settings next;
            next.jumpMm = 10 + round % 200;
            {
                Preferences preferences(exactText(path));
                const edges::Settings read = preferences.settings(edges::Settings{});
                QVERIFY2(bool(edges::checkSettings(read)), bytes.c_str());
                kept += read.jumpMm == 55 ? 1 : 0;
                QVERIFY2(preferences.recentFiles().size() < 1000, bytes.c_str());
                for (const char* key : {"language", "view/mouse", "live/sweep", "window/panel-dragged"}) (void)preferences.text(key);
                for (const char* key : {"window/geometry", "window/state", "window/views"}) (void)preferences.bytes(key);
                (void)preferences.flag("view/cab", false);
                QVERIFY2(!preferences.folder("exports").isEmpty(), bytes.c_str());
                preferences.keepRecentFile("/scans/next.pcd");
                QVERIFY2(preferences.recentFiles().size() <= 10 && preferences.recentFiles().first() == "/scans/next.pcd", bytes.c_str());
                preferences.keepSettings(next);
            }
            const Preferences again(exactText(path));
            QVERIFY2(again.settings(edges::Settings{}) == next, bytes.c_str());
            QCOMPARE(again.recentFiles().first(), QString("/scans/next.pcd"));
        }
        QVERIFY2(kept > kRounds / 10, qPrintable(QString::number(kept))); // most damage is elsewhere in the file
    }

    void onlyARegularFileIsTakenForSettings() {
        const std::string pipe = (folder_ / "pipe.ini").string();
        QCOMPARE(::mkfifo(pipe.c_str(), 0600), 0);
        for (const std::string& path : {pipe, folder_.path().string()}) {
            Preferences preferences(exactText(path));
            QVERIFY(preferences.refusal() && preferences.refusal()->where == path);
            preferences.keep("language", QString("fr"));
            QCOMPARE(preferences.text("language"), QString());
            QVERIFY(preferences.dataFolder().isEmpty());
        }
        QVERIFY(!Preferences(exactText((folder_ / "new.ini").string())).refusal());
    }

    void whatCannotBeReadIsKeptAndSaid() {
        const std::string path = (folder_ / "random.ini").string();
        std::mt19937 random(7);
        std::string bytes(4000, '\0');
        for (char& byte : bytes) byte = static_cast<char>(random());
        for (const std::string& held : {bytes, std::string("[General]\nversion=99\n"), std::string("a letter")}) {
            std::ofstream(path, std::ios::binary | std::ios::trunc) << held;
            {
                Preferences preferences(exactText(path));
                QVERIFY(preferences.refusal() && preferences.refusal()->hint.ends_with("random.ini.damaged"));
                preferences.keep("language", QString("fr"));
            }
            QCOMPARE(test::fileText(path + ".damaged"), held);
            const Preferences again(exactText(path));
            QVERIFY(!again.refusal());
            QCOMPARE(again.text("language"), QString("fr"));
        }
        std::ofstream(path, std::ios::binary | std::ios::trunc) << "[General]\nlanguage=fr\n"; // written by hand, without a version
        QVERIFY(!Preferences(exactText(path)).refusal());
        QCOMPARE(Preferences(exactText(path)).text("language"), QString("fr"));
        std::ofstream(path, std::ios::binary | std::ios::trunc).flush();
        QVERIFY(!Preferences(exactText(path)).refusal());
    }

private:
    // A file with a value of every kind.
    static std::string wholeFile(const std::string& path) {
        {
            Preferences preferences(exactText(path));
            preferences.keep("language", QString("fr"));
            preferences.keep("view/cab", true);
            preferences.keep("view/mouse", QString("fly"));
            preferences.keep("live/sweep", QString("sweep 0.18"));
            preferences.keep("window/panel-dragged", QString("321"));
            for (const char* key : {"window/geometry", "window/state", "window/views"}) preferences.keep(key, QByteArray(120, '\x9d'));
            for (int n = 0; n < 10; ++n) preferences.keepRecentFile(QString("/scans/%1, \"bell\" é.pcd").arg(n));
            preferences.keepFolder("exports", exactText(path));
            edges::Settings settings;
            settings.jumpMm = 55;
            preferences.keepSettings(settings);
        }
        return test::fileText(path);
    }

    test::TemporaryFolder folder_;
};

} // namespace

int damaged_settings_test(int argc, char** argv) { return runTest<DamagedSettingsTest, QCoreApplication>(argc, argv); }
#include "damaged_settings_test.moc"
