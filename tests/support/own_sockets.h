// The TCP sockets of this process, as the kernel lists them.
#pragma once

#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace edgescan::test {

struct OwnSocket {
    bool listening = false;
    int localPort = 0, remotePort = 0;
    bool loopback = false; ///< the other end is 127.0.0.1
    bool underWay = false; ///< bytes that were sent are not received, or were received and are not read
};

inline std::set<std::string> ownInodes() {
    std::set<std::string> inodes;
    std::error_code ignored;
    for (const auto& entry : std::filesystem::directory_iterator("/proc/self/fd", ignored)) {
        const std::string target = std::filesystem::read_symlink(entry.path(), ignored).string();
        if (target.starts_with("socket:[")) inodes.insert(target.substr(8, target.size() - 9));
    }
    return inodes;
}

/// TCP over IPv4 and IPv6.
inline std::vector<OwnSocket> ownTcpSockets() {
    const std::set<std::string> inodes = ownInodes();
    std::vector<OwnSocket> sockets;
    for (const char* table : {"/proc/self/net/tcp", "/proc/self/net/tcp6"}) {
        std::ifstream file(table);
        std::string line;
        std::getline(file, line); // the heading
        while (std::getline(file, line)) {
            std::istringstream words(line);
            std::string slot, local, remote, state, queues, timer, retransmitted, user, timeout, inode;
            words >> slot >> local >> remote >> state >> queues >> timer >> retransmitted >> user >> timeout >> inode;
            if (!inodes.contains(inode)) continue;
            const auto port = [](const std::string& address) { return std::stoi(address.substr(address.find(':') + 1), nullptr, 16); };
            sockets.push_back({state == "0A", port(local), port(remote), remote.starts_with("0100007F:"),
                               state != "0A" && queues != "00000000:00000000"});
        }
    }
    return sockets;
}

} // namespace edgescan::test
