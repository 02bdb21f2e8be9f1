// Writes to stdout and stderr.
#include "app/shared/exits.h"

#include "core/base/foreign_text.h"
#include "core/base/version.h"
#include "core/exports/report.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <atomic>
#include <csignal>
#include <filesystem>
#include <iostream>
#include <new>
#include <stdexcept>
#include <system_error>

namespace edgescan::cli {
namespace {

volatile std::sig_atomic_t caught = 0;

void note(int /*signal*/) { caught = 1; }

std::string typedName = "edgescan-cli";
std::atomic<bool> progressLineOpen{false}; // an error message then starts on a new line

std::string repeated(const std::string& what) {
    return "this was not foreseen (" + what + "); run it again with less at once, and report it with what you typed if it stays.";
}

} // namespace

void surviveFileLimit() { std::signal(SIGXFSZ, SIG_IGN); }

void catchInterrupt() {
    std::signal(SIGINT, note);
    std::signal(SIGTERM, note);
    if (std::signal(SIGHUP, note) == SIG_IGN) std::signal(SIGHUP, SIG_IGN);
}

bool interrupted() { return caught != 0; }

void setProgramName(const std::string& name) { typedName = name; }

const std::string& programName() { return typedName; }

std::string versionText() {
    return typedName + " " + version() + " (commit " + commit() + ")\nLicence: BSD-3-Clause. Without any warranty.";
}

void printError(const std::string& sentence) {
    if (progressLineOpen.exchange(false)) std::cerr << '\n';
    std::cerr << typedName << ": " << printable(sentence, 4 * kMostShown) << '\n';
}

void printError(const Error& error) { printError(error.sentence()); }

int failWith(const Error& error, int code) {
    printError(error);
    return code;
}

void printResult(const std::string& text) { std::cout << printableLines(text) << '\n' << std::flush; }

void printResult(const nlohmann::ordered_json& report, bool indented) {
    std::cout << exports::reportText(report, indented) << '\n' << std::flush;
}

void showProgress(const std::string& text, bool last) {
    constexpr std::size_t kWidth = 78;
    std::string line = printable(text, kWidth);
    line.resize(std::max(line.size(), kWidth), ' ');
    std::cerr << '\r' << line << (last ? "\n" : "") << std::flush;
    progressLineOpen = !last;
}

int guarded(const std::function<int()>& work, int failed) {
    try {
        return work();
    } catch (const std::bad_alloc&) {
        printError("there is not enough memory for this; close other programs or use a smaller scan.");
    } catch (const std::length_error&) {
        printError("this needs more memory than any computer has; use a smaller scan.");
    } catch (const std::filesystem::filesystem_error& error) {
        printError(
            Error{"the folder or file cannot be used (" + error.code().message() + ")", error.path1().string(), "check it and its rights"});
    } catch (const std::system_error& error) {
        printError("the system refused what was needed (" + error.code().message() + "); close other programs and try again.");
    } catch (const std::exception& error) {
        printError(repeated(error.what()));
    }
    return failed;
}

int exitCodeOf(const std::function<int()>& work) {
    const int code = guarded(work, kRefused);
    std::cout.flush();
    if (std::cout.good()) return code;
    printError("stdout: the results cannot be written (no space, or closed); send them elsewhere.");
    return kRefused;
}

} // namespace edgescan::cli
