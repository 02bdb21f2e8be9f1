// The independent Python tools in ../shared/protocol/tools, run as separate programs.
#pragma once

#include "tests/support/cola_vectors.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <string>
#include <vector>

namespace edgescan::test {

inline bool pythonIsThere() {
    static const bool there = std::system("python3 -c 1 >/dev/null 2>&1") == 0;
    return there;
}

/// A process that ends with the test.
class Process {
public:
    explicit Process(std::vector<std::string> words) {
        std::vector<char*> arguments;
        for (std::string& word : words) arguments.push_back(word.data());
        arguments.push_back(nullptr);
        pid_ = ::fork();
        if (pid_ != 0) return;
        const int null = ::open("/dev/null", O_RDWR);
        ::dup2(null, 0);
        ::dup2(null, 1);
        ::dup2(null, 2);
        ::execvp(arguments[0], arguments.data());
        ::_exit(127);
    }
    ~Process() {
        ::kill(pid_, SIGKILL);
        ::waitpid(pid_, nullptr, 0);
    }
    Process(const Process&) = delete;
    Process& operator=(const Process&) = delete;

private:
    pid_t pid_ = 0;
};

} // namespace edgescan::test

#define EDGESCAN_NEEDS_PYTHON()                                                                                                            \
    EDGESCAN_NEEDS_SHARED("protocol/tools");                                                                                               \
    if (!edgescan::test::pythonIsThere()) GTEST_SKIP() << "needs python3"
