// Parses HOST[:PORT].
#include "core/scanner/cola/host_port.h"
#include "core/base/translated_text.h"

#include <algorithm>
#include <charconv>
#include <string_view>

namespace edgescan::scanner {

namespace {

constexpr std::string_view kBridge = "ws://";
constexpr std::uint16_t kBridgePort = 8765; // of foxglove_bridge

} // namespace

Result<HostPort> hostPort(const std::string& typed) {
    if (typed.starts_with("wss://")) return Error{"bridges with encryption are not supported", typed, "write ws://HOST or ws://HOST:PORT"};
    if (typed.starts_with(kBridge)) {
        std::string rest = typed.substr(kBridge.size());
        if (rest.ends_with('/')) rest.pop_back();
        auto bridge = hostPort(rest);
        if (!bridge) return Error{bridge.error().what, typed, "write ws://HOST or ws://HOST:PORT"};
        bridge->bridge = true;
        if (!bridge->portTyped) bridge->port = kBridgePort;
        return bridge;
    }
    if (const std::size_t scheme = typed.find("://"); scheme != std::string::npos)
        return Error{withValues("\"%1://\" is not known here", {typed.substr(0, scheme)}), typed,
                     "write HOST or HOST:PORT for a scanner, ws://HOST or ws://HOST:PORT for a robot's Foxglove bridge"};
    HostPort result;
    std::string port;
    const std::size_t bracket = typed.find(']');
    const auto colons = std::count(typed.begin(), typed.end(), ':');
    if (typed.starts_with('[') && bracket != std::string::npos) {
        result.host = typed.substr(1, bracket - 1);
        if (bracket + 1 < typed.size() && typed[bracket + 1] == ':')
            port = typed.substr(bracket + 2);
        else if (bracket + 1 < typed.size())
            return Error{"what follows the bracket is not a port", typed, "write [ADDRESS]:PORT"};
    } else if (colons == 1) {
        result.host = typed.substr(0, typed.find(':'));
        port = typed.substr(typed.find(':') + 1);
        if (port.empty()) return Error{"there is no port behind the colon", typed, "write HOST:PORT, or HOST alone"};
    } else {
        result.host = typed;
    }
    if (result.host.empty()) return Error{"there is no host", typed, "write HOST or HOST:PORT"};
    if (port.empty()) return result;
    unsigned number = 0;
    const auto [end, code] = std::from_chars(port.data(), port.data() + port.size(), number);
    if (code != std::errc{} || end != port.data() + port.size() || number == 0 || number > 65535) {
        return Error{withValues("\"%1\" is not a port", {port}), typed, "give a number from 1 to 65535"};
    }
    result.port = static_cast<std::uint16_t>(number);
    result.portTyped = true;
    return result;
}

} // namespace edgescan::scanner
