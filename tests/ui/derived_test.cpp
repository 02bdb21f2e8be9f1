// Derived: questions and answers between the GUI thread and the pool, without a window.
#include "ui/engine/worker_bridge/derived.h"

#include "tests/ui/run_test.h"

#include <memory>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

using namespace edgescan;
using namespace edgescan::ui;
using namespace std::chrono_literals;

namespace {

/// Answers with ten times the question; a negative one fails. A question below 10 waits until it may end, or no caller waits for it.
struct Asked {
    explicit Asked(Older older = Older::Dropped)
        : derived(
              Urgency::Now, [this](int question, const Asker& asker) { return answer(question, asker); },
              [this](int question, const std::shared_ptr<const int>& made) {
                  questions.push_back(question);
                  answers.push_back(*made);
              },
              [this](const QString& what) { failures << what; }, older) {}

    int answer(int question, const Asker& asker) {
        ++begun;
        while (question >= 0 && question < 10 && !mayEnd) {
            if (asker.waits()) {
                std::this_thread::yield();
                continue;
            }
            ++leftOff;
            break;
        }
        if (question < 0) throw std::runtime_error("no memory");
        return 10 * question;
    }

    std::atomic<int> begun{0}, leftOff{0};
    std::atomic<bool> mayEnd{false};
    std::vector<int> questions, answers;
    QStringList failures;
    Derived<int, int> derived; // last
};

} // namespace

class DerivedTest : public QObject {
    Q_OBJECT
private slots:
    void anAnswerComesWithItsQuestion() {
        Asked on;
        QVERIFY(!on.derived.behind());
        on.derived.ask(12);
        QVERIFY(on.derived.behind());
        QTRY_VERIFY(!on.derived.behind());
        QCOMPARE(on.questions, std::vector<int>{12});
        QCOMPARE(on.answers, std::vector<int>{120});
    }

    void theNewestQuestionWins() {
        Asked on;
        on.derived.ask(1);
        QTRY_COMPARE(on.begun.load(), 1);
        for (int question = 20; question < 30; ++question) on.derived.ask(question);
        QTRY_VERIFY(!on.derived.behind());
        QCOMPARE(on.answers, std::vector<int>{290});
        QCOMPARE(on.leftOff.load(), 1);
        QVERIFY(on.begun <= 11); // a question that waits is replaced; one that had begun before the next was asked is not
    }

    void anOlderAnswerIsDeliveredWhereItIsWanted() {
        Asked on(Older::Delivered);
        on.derived.ask(1);
        QTRY_COMPARE(on.begun.load(), 1);
        for (int question = 2; question < 5; ++question) on.derived.ask(question);
        QVERIFY(on.answers.empty());
        on.mayEnd = true;
        QTRY_VERIFY(!on.derived.behind());
        // Both may be ready before the event loop runs: the newest is then the only one.
        QCOMPARE(on.answers.back(), 40);
        QVERIFY(on.answers.size() == 1 || on.answers == (std::vector<int>{10, 40}));
        QCOMPARE(on.begun.load(), 2);
    }

    void behindUntilTheNewestIsThere() {
        Asked on(Older::Delivered);
        on.derived.ask(12);
        QTRY_COMPARE(on.begun.load(), 1);
        on.derived.ask(1); // waits: the answer to 12 is older
        QTRY_COMPARE(on.answers, std::vector<int>{120});
        QVERIFY(on.derived.behind());
        on.mayEnd = true;
        QTRY_VERIFY(!on.derived.behind());
    }

    void aFailureIsReportedAndTheNextQuestionWorks() {
        Asked on;
        on.derived.ask(-1);
        QTRY_COMPARE(on.failures, QStringList{"no memory"});
        QVERIFY(!on.derived.behind() && on.answers.empty());
        on.derived.ask(12);
        QTRY_COMPARE(on.answers, std::vector<int>{120});
        QCOMPARE(on.failures.size(), 1);
    }

    // More questions than the pool has threads, most of which fail; every one is answered or reported, whatever fails next to it.
    void failuresOfManyAtATimeAreReportedEach() {
        std::vector<std::unique_ptr<Asked>> all;
        for (int n = 0; n < 40; ++n) all.push_back(std::make_unique<Asked>(n % 2 == 0 ? Older::Dropped : Older::Delivered));
        for (int round = 0; round < 25; ++round) {
            for (std::size_t n = 0; n < all.size(); ++n) all[n]->derived.ask((round + static_cast<int>(n)) % 4 == 0 ? 100 + round : -1);
            if (round % 5 == 0) QCoreApplication::processEvents();
        }
        for (std::size_t n = 0; n < all.size(); ++n) {
            Asked& each = *all[n];
            QTRY_VERIFY(!each.derived.behind());
            if ((24 + n) % 4 == 0)
                QCOMPARE(each.answers.back(), 1240);
            else
                QCOMPARE(each.failures.value(each.failures.size() - 1), QString("no memory"));
        }
    }

    void whatWasGivenUpIsNotDelivered() {
        for (const Older older : {Older::Dropped, Older::Delivered}) {
            Asked on(older);
            on.derived.ask(1);
            QTRY_COMPARE(on.begun.load(), 1);
            on.derived.ask(2);
            on.derived.giveUp();
            QVERIFY(!on.derived.behind());
            QTRY_VERIFY(on.leftOff > 0);
            on.derived.ask(12);
            QTRY_VERIFY(!on.derived.behind());
            QCOMPARE(on.answers, std::vector<int>{120});
            QVERIFY(on.begun <= 3); // 2 may have begun before it was given up
        }
    }

    void aQuestionIsFreedWithItsAnswer() {
        int delivered = 0;
        Derived<std::shared_ptr<const int>, int> derived(
            Urgency::Now, [](const auto& question) { return *question; }, [&](const auto&, const auto&) { ++delivered; },
            [](const QString&) {});
        auto large = std::make_shared<const int>(12);
        const std::weak_ptr<const int> held = large;
        derived.ask(std::exchange(large, nullptr), 1ms);
        QVERIFY(!held.expired());
        QTRY_COMPARE(delivered, 1);
        QTRY_VERIFY(held.expired()); // the pool's thread may hold it a moment longer
        large = std::make_shared<const int>(13);
        const std::weak_ptr<const int> given = large;
        derived.ask(std::exchange(large, nullptr), 1h);
        derived.giveUp();
        QVERIFY(given.expired());
    }

    void nothingStartsBeforeTheQuietTimeIsOver() {
        Asked on;
        for (int question = 20; question < 30; ++question) on.derived.ask(question, 30ms);
        QVERIFY(on.derived.waiting() && on.derived.behind());
        QCOMPARE(on.begun.load(), 0); // the timer needs the event loop
        QTRY_VERIFY(!on.derived.behind());
        QVERIFY(!on.derived.waiting());
        QCOMPARE(on.begun.load(), 1);
        QCOMPARE(on.answers, std::vector<int>{290});
    }

    void aQuestionWithoutQuietTimeStartsAtOnce() {
        Asked on;
        on.derived.ask(20, 1h);
        on.derived.ask(21);
        QVERIFY(!on.derived.waiting());
        QTRY_COMPARE(on.answers, std::vector<int>{210});
        on.derived.ask(22, 1h);
        on.derived.giveUp();
        QVERIFY(!on.derived.waiting() && !on.derived.behind());
    }

    void whatIsShownMeanwhileComesInOrderAndBeforeTheAnswer() {
        QStringList seen;
        Derived<int, int> derived(
            Urgency::Soon,
            [&seen](int question, const Asker& asker) {
                for (int n = 0; n < 5; ++n) asker.show([&seen, n] { seen << QString::number(n); });
                return question;
            },
            [&seen](int, const std::shared_ptr<const int>&) { seen << "answer"; }, [](const QString&) {});
        derived.ask(1);
        QTRY_VERIFY(!derived.behind());
        QCOMPARE(seen, (QStringList{"0", "1", "2", "3", "4", "answer"}));
    }

    void nothingIsShownOfAQuestionThatWasGivenUp() {
        int seen = 0;
        std::atomic<bool> sent{false};
        Derived<int, int> derived(
            Urgency::Later,
            [&](int question, const Asker& asker) {
                asker.show([&seen] { ++seen; });
                sent = true;
                return question;
            },
            [&seen](int, const std::shared_ptr<const int>&) { ++seen; }, [](const QString&) {});
        derived.ask(1);
        while (!sent) std::this_thread::yield(); // no event loop: what is sent waits
        derived.giveUp();
        derived.ask(2);
        QTRY_VERIFY(!derived.behind());
        QCOMPARE(seen, 2);
    }

    void aNullAnswerIsNotDelivered() {
        int delivered = 0;
        Derived<int, int> derived(
            Urgency::Now, [](int) { return std::shared_ptr<const int>(); }, [&](int, const auto&) { ++delivered; }, [](const QString&) {});
        derived.ask(1);
        QTRY_VERIFY(!derived.behind());
        QCOMPARE(delivered, 0);
    }

    void anAnswerMayAskTheNextQuestion() {
        std::vector<int> answers;
        std::unique_ptr<Derived<int, int>> derived;
        derived = std::make_unique<Derived<int, int>>(
            Urgency::Now, [](int question) { return question; },
            [&](int question, const std::shared_ptr<const int>& made) {
                answers.push_back(*made);
                if (question < 4) derived->ask(question + 1);
            },
            [](const QString&) {});
        derived->ask(1);
        QTRY_VERIFY(!derived->behind());
        QCOMPARE(answers, (std::vector<int>{1, 2, 3, 4}));
    }

    void itMayGoWhileItsWorkIsUnderWay() {
        for (int round = 0; round < 50; ++round) {
            auto on = std::make_unique<Asked>(round % 2 == 0 ? Older::Dropped : Older::Delivered);
            on->derived.ask(round % 3 == 0 ? 12 : 1);
            if (round % 5 != 0) QTRY_COMPARE(on->begun.load(), 1);
            on->derived.ask(2);
            on.reset();
            QCoreApplication::processEvents();
        }
    }
};

int derived_test(int argc, char** argv) { return runTest<DerivedTest, QCoreApplication>(argc, argv); }
#include "derived_test.moc"
