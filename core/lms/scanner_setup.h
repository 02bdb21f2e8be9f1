// Setting a scanner up: off unless asked for, every command and answer logged, everything read back.
#pragma once

#include "core/lms/scanner_dialogue.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace edgescan {

/// Encoder inputs that tag lines with the stepper's position.
struct EncoderInput {
    std::uint8_t mode = 3;   ///< 0 off, 1 single pulse, 2 quadrature, 3 pulse and direction
    float resolution = 1.0F; ///< LICencres
};

struct ScannerSetup {
    ScanConfiguration scan;
    OutputRange range;
    TelegramContent content;
    EchoFilter echoes = EchoFilter::Last;
    std::optional<EncoderInput> encoder; ///< switches content.encoder on too
    AccessLevel level = AccessLevel::AuthorisedClient;
    bool storePermanently = false; ///< mEEwriteall: survives switching off. Only when asked for in so many words
};

/// One command and its answer, in words.
struct SetupStep {
    std::string command;
    std::string answer;
    bool refused = false;
};

/// Everything that is sent, in order, without the questions that read it back. For tests and for showing before doing.
[[nodiscard]] std::vector<ColaRequest> setupRequests(const ScannerSetup& setup);

/// How a set-up ended while the connection held.
struct SetupOutcome {
    std::vector<std::string> problems; ///< refused commands and values that read back differently, a sentence each; empty: all taken
};

/// Sends it. After a refusal nothing more is set, but the scanner is started again, as logging in may have stopped it.
/// Error: the connection is gone.
[[nodiscard]] Result<SetupOutcome> setUpScanner(ScannerDialogue& dialogue, const ScannerSetup& setup,
                                                const std::function<void(const SetupStep&)>& log);

} // namespace edgescan
