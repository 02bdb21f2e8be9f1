// edgescan-lab emulate as a process that ends with this object.
#pragma once

#include "tests/support/folders.h"
#include "tests/support/run_program.h"
#include "tests/support/wait_until.h"

#include <nlohmann/json.hpp>

#include <chrono>
#include <csignal>
#include <string>
#include <sys/prctl.h>

namespace edgescan::test {

class ServedProgram {
public:
    /// `arguments` as typed behind "emulate"; any free port.
    explicit ServedProgram(const std::string& arguments) {
        const std::string command =
            "exec " + programFolder() + "/edgescan-lab emulate " + arguments + " --port 0 >" + (folder_ / "out").string() + " 2>&1";
        process_ = fork();
        if (process_ == 0) {
            prctl(PR_SET_PDEATHSIG, SIGTERM); // also where the test crashes
            execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
            _exit(127);
        }
        static_cast<void>(waitUntil([&] { return fileText(folder_ / "out").find('\n') != std::string::npos; }));
        said_ = nlohmann::json::parse(fileText(folder_ / "out"), nullptr, false);
        if (said_.is_object()) port_ = said_.value("port", 0);
    }
    ~ServedProgram() {
        kill(process_, SIGTERM);
        waitpid(process_, nullptr, 0);
    }
    ServedProgram(const ServedProgram&) = delete;
    ServedProgram& operator=(const ServedProgram&) = delete;

    [[nodiscard]] const nlohmann::json& said() const { return said_; }
    /// 0: it did not start.
    [[nodiscard]] int port() const { return port_; }
    [[nodiscard]] std::string address() const { return "127.0.0.1:" + std::to_string(port_); }

private:
    TemporaryFolder folder_;
    nlohmann::json said_;
    pid_t process_ = 0;
    int port_ = 0;
};

} // namespace edgescan::test
