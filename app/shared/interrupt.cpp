// Handles Ctrl+C without ending the program at once.
#include "app/shared/interrupt.h"

#include <csignal>

namespace edgescan::cli {
namespace {

volatile std::sig_atomic_t caught = 0;

void note(int /*signal*/) { caught = 1; }

} // namespace

void surviveFileLimit() { std::signal(SIGXFSZ, SIG_IGN); }

void catchInterrupt() {
    std::signal(SIGINT, note);
    std::signal(SIGTERM, note);
    if (std::signal(SIGHUP, note) == SIG_IGN) std::signal(SIGHUP, SIG_IGN);
}

bool interrupted() { return caught != 0; }

} // namespace edgescan::cli
