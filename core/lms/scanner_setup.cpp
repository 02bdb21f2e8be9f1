// Setting a scanner up: log in, set, read back, start, wait until it measures.
#include "core/lms/scanner_setup.h"

namespace edgescan {

namespace {

TelegramContent wantedContent(const ScannerSetup& setup) {
    TelegramContent content = setup.content;
    if (setup.encoder && setup.encoder->mode != 0) content.encoder = 1;
    return content;
}

/// Whether the scanner says that it did it: 1 is success for some methods, 0 for others.
std::string denial(const ColaRequest& request, const ColaAnswer& answer) {
    if (answer.kind == AnswerKind::Refused) return refusalText(answer.refusal);
    if (answer.kind != AnswerKind::Method) return {};
    const auto status = parseNumber8(answer);
    if (!status) return status.error().what;
    if (request.name == "mLMPsetscancfg") return *status == 0 ? "" : scanConfigurationProblem(*status);
    const int success = request.name == "LMCstartmeas" ? 0 : 1;
    return *status == success ? "" : "the scanner answers " + std::to_string(*status);
}

class SettingUp {
public:
    SettingUp(ScannerDialogue& dialogue, const ScannerSetup& setup, const std::function<void(const SetupStep&)>& log)
        : dialogue_(dialogue), setup_(setup), log_(log) {}

    Result<SetupOutcome> run() {
        bool goOn = say(subscribeRequest("LMDscandata", false));
        for (const ColaRequest& request : setupRequests(setup_)) {
            if (goOn) goOn = say(request);
        }
        if (goOn) readBack();
        if (setup_.storePermanently && goOn && outcome_.problems.empty()) say({"sMN", "mEEwriteall", {}});
        say({"sMN", "LMCstartmeas", {}});
        say({"sMN", "Run", {}});
        waitUntilReady();
        if (gone_) return *gone_;
        return outcome_;
    }

private:
    std::optional<ColaAnswer> ask(const ColaRequest& request) {
        if (gone_) return std::nullopt;
        auto answer = dialogue_.ask(request);
        const std::string problem = answer ? denial(request, *answer) : answer.error().what;
        if (log_) log_({requestText(request), answer ? answerText(*answer) : problem, !problem.empty()});
        if (!answer) {
            gone_ = answer.error();
            return std::nullopt;
        }
        if (!problem.empty()) outcome_.problems.push_back(requestText(request).append(" was refused: ").append(problem).append("."));
        return std::move(*answer);
    }
    bool say(const ColaRequest& request) {
        const std::size_t before = outcome_.problems.size();
        return ask(request) && outcome_.problems.size() == before;
    }

    template <class Value, class Parse>
    void compare(const char* name, Parse parse, const Value& wanted) {
        const auto answer = ask(readRequest(name));
        if (!answer || answer->kind == AnswerKind::Refused) return;
        const auto found = parse(*answer);
        if (!found || !(*found == wanted))
            outcome_.problems.push_back(std::string(name).append(" reads back differently: ").append(answerText(*answer)).append("."));
    }
    void readBack() {
        // The scan area is not set by LMPscancfg on this family (docs/protocol.md, "Interlaced lines"): only frequency and step count.
        compare("LMPscancfg", parseScanConfiguration, Same{setup_.scan});
        compare("LMPoutputRange", parseOutputRange, setup_.range);
        compare("LMDscandatacfg", parseTelegramContent, wantedContent(setup_));
        compare("FREchoFilter", parseNumber8, static_cast<int>(setup_.echoes));
    }

    struct Same {
        ScanConfiguration wanted;
        friend bool operator==(const ScanConfiguration& found, const Same& same) {
            return found.frequency == same.wanted.frequency && found.step == same.wanted.step;
        }
    };

    void waitUntilReady() {
        const auto deadline = ColaLink::Clock::now() + dialogue_.patience().ready;
        while (!gone_ && !dialogue_.link().interrupted() && ColaLink::Clock::now() < deadline) {
            const auto answer = dialogue_.ask(readRequest("SCdevicestate"));
            if (!answer) {
                gone_ = answer.error();
                return;
            }
            const auto state = parseNumber8(*answer);
            if (!state || *state != 0) return;
            dialogue_.link().pause(std::chrono::milliseconds(200));
        }
    }

    ScannerDialogue& dialogue_;
    const ScannerSetup& setup_;
    const std::function<void(const SetupStep&)>& log_;
    SetupOutcome outcome_;
    std::optional<Error> gone_;
};

} // namespace

std::vector<ColaRequest> setupRequests(const ScannerSetup& setup) {
    std::vector<ColaRequest> requests{logInRequest(setup.level)};
    if (setup.encoder) {
        requests.push_back({"sWN", "DO3And4Fnc", {std::uint8_t{1}}});
        requests.push_back({"sWN", "LICsrc", {std::uint8_t{1}}});
        requests.push_back({"sWN", "LICencset", {setup.encoder->mode}});
        requests.push_back({"sWN", "LICencres", {setup.encoder->resolution}});
    }
    requests.push_back(scanConfigurationRequest(setup.scan));
    requests.push_back(outputRangeRequest(setup.range));
    requests.push_back(telegramContentRequest(wantedContent(setup)));
    requests.push_back(echoFilterRequest(setup.echoes));
    return requests;
}

Result<SetupOutcome> setUpScanner(ScannerDialogue& dialogue, const ScannerSetup& setup, const std::function<void(const SetupStep&)>& log) {
    dialogue.allowWriting();
    return SettingUp(dialogue, setup, log).run();
}

} // namespace edgescan
