// Looks up the addresses of a host name.
#include "core/scanner/cola/name_lookup.h"

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>

#include <algorithm>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

namespace edgescan::scanner {

namespace {

/// Shared with the thread that looks up the name. That thread may outlive the caller.
struct Lookup {
    std::mutex mutex;
    std::optional<std::vector<std::string>> addresses;
    bool done = false;
};

void resolve(const std::shared_ptr<Lookup>& lookup, const std::string& host) {
    boost::asio::io_context context;
    boost::system::error_code problem;
    boost::asio::ip::tcp::resolver resolver(context);
    const auto found = resolver.resolve(host, "", problem);
    std::vector<std::string> addresses;
    if (!problem) {
        for (const auto& entry : found) {
            std::string address = entry.endpoint().address().to_string();
            if (std::find(addresses.begin(), addresses.end(), address) == addresses.end()) addresses.push_back(std::move(address));
        }
    }
    const std::lock_guard lock(lookup->mutex);
    if (!problem) lookup->addresses = std::move(addresses);
    lookup->done = true;
}

} // namespace

Result<std::vector<std::string>> lookUp(const std::string& host, std::chrono::steady_clock::time_point deadline,
                                        const std::function<bool(std::chrono::steady_clock::duration)>& wait) {
    if (host.empty()) return Error{"no scanner is given", {}, "give its IP address or host name"};
    const bool bracketed = host.starts_with('[') && host.ends_with(']');
    const std::string bare = bracketed ? host.substr(1, host.size() - 2) : host;
    boost::system::error_code problem;
    (void)boost::asio::ip::make_address(bare, problem);
    if (!problem) return std::vector{bare};
    const auto lookup = std::make_shared<Lookup>();
    std::thread([lookup, bare] { resolve(lookup, bare); }).detach();
    while (true) {
        {
            const std::lock_guard lock(lookup->mutex);
            if (lookup->done && lookup->addresses && !lookup->addresses->empty()) return *lookup->addresses;
            if (lookup->done) return Error{"the host name is not known", {}, "check its spelling or use the scanner's IP address"};
        }
        if (std::chrono::steady_clock::now() >= deadline)
            return Error{"the name server does not answer", {}, "use the scanner's IP address"};
        if (!wait(std::chrono::milliseconds(5))) return Error{"interrupted", {}, {}};
    }
}

} // namespace edgescan::scanner
