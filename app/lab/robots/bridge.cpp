// An emulated bridge: one thread, any number of clients, bounded memory.
#include "app/lab/robots/bridge.h"

#include "core/base/bounded_json.h"
#include "core/base/json_text.h"
#include "core/scanner/cola/host_time.h"
#include "core/scanner/cola/link.h"

#include <boost/asio.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/websocket.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <deque>
#include <list>
#include <mutex>
#include <thread>

namespace edgescan::robots {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace websocket = beast::websocket;
using boost::system::error_code;
using tcp = asio::ip::tcp;

/// Messages queued for a client that does not read; beyond this, messages are lost.
constexpr std::size_t kMostQueued = 4096, kMostCloudsQueued = 16;
constexpr std::size_t kMostConnected = 8, kLongestRequest = std::size_t{1} << 20U;
constexpr double kUsualPeriodS = 0.04;

} // namespace

struct EmulatedBridge::Server : std::enable_shared_from_this<EmulatedBridge::Server> {
    struct Client {
        explicit Client(tcp::socket socket) : stream(std::move(socket)) {}
        websocket::stream<tcp::socket> stream;
        beast::flat_buffer buffer{kLongestRequest};
        std::map<std::uint32_t, std::uint32_t> subscriptions; // of channels
        std::deque<std::pair<bool, Bytes>> queue;             // whether text
        bool open = true;
    };
    using ClientPointer = std::shared_ptr<Client>;

    Server(BridgeSweep given, const scanner::EmulatedScannerSettings& asked) : sweep(std::move(given)), settings(asked) {}

    Result<Done> listen();
    void accept();
    void welcome(tcp::socket socket);
    void read(const ClientPointer& client);
    void answer(const ClientPointer& client);
    void greet(const ClientPointer& client);
    void post(const ClientPointer& client, bool text, Bytes bytes);
    void write(const ClientPointer& client);
    void close(const ClientPointer& client);
    void send(BridgeTopic topic, std::int64_t ns, const Bytes& message);
    void tick();
    void wait();
    [[nodiscard]] Bytes nextMessage(std::int64_t ns, double periodS);
    bool sendMessage();
    [[nodiscard]] std::size_t row() const;
    [[nodiscard]] bool happens(int every) const { return every > 0 && (number + 1) % static_cast<std::uint64_t>(every) == 0; }
    [[nodiscard]] bool eagerAndFull() const;
    [[nodiscard]] std::size_t mostQueued() const { return sweep.cloud ? kMostCloudsQueued : kMostQueued; }
    template <class Change>
    void count(Change change) {
        const std::lock_guard lock(mutex);
        change(statistics);
    }

    const BridgeSweep sweep;
    const scanner::EmulatedScannerSettings settings;
    const std::vector<BridgeChannel> topics = bridgeTopics(sweep);
    asio::io_context context{1};
    tcp::acceptor acceptor{context};
    asio::steady_timer timer{context};
    std::list<ClientPointer> clients;
    std::uint64_t number = 0; // of the next line
    std::int64_t startNs = scanner::hostNow().utcNs;
    double pausedS = 0;
    std::uint16_t port = 0;
    mutable std::mutex mutex;
    EmulatedBridgeStatistics statistics;
    std::thread thread;
};

Result<Done> EmulatedBridge::Server::listen() {
    const std::string where = scanner::addressText(settings.address, settings.port);
    error_code problem;
    const auto address = asio::ip::make_address(settings.address, problem);
    if (problem) return Error{"this is not an IP address to listen on", where, "use 127.0.0.1, or 0.0.0.0 for all"};
    const tcp::endpoint endpoint(address, settings.port);
    acceptor.open(endpoint.protocol(), problem);
    error_code ignored;
    if (!problem) acceptor.set_option(asio::socket_base::reuse_address(true), ignored);
    if (!problem) acceptor.bind(endpoint, problem);
    if (!problem) acceptor.listen(4, problem);
    if (problem) return Error{"the emulated bridge cannot listen there (" + problem.message() + ")", where, "choose another port"};
    port = acceptor.local_endpoint(ignored).port();
    accept();
    wait();
    return Done{};
}

void EmulatedBridge::Server::accept() {
    acceptor.async_accept([this](const error_code& problem, tcp::socket socket) {
        if (problem == asio::error::operation_aborted) return;
        if (!problem && clients.size() < kMostConnected) welcome(std::move(socket));
        accept();
    });
}

void EmulatedBridge::Server::welcome(tcp::socket socket) {
    auto client = std::make_shared<Client>(std::move(socket));
    clients.push_back(client);
    count([](auto& s) { ++s.clients; });
    client->stream.read_message_max(kLongestRequest);
    client->stream.set_option(websocket::stream_base::decorator(
        [](websocket::response_type& response) { response.set(beast::http::field::sec_websocket_protocol, "foxglove.websocket.v1"); }));
    client->stream.async_accept([this, client](const error_code& problem) {
        if (problem) return close(client);
        if (!settings.faults.mute) greet(client);
        read(client);
    });
}

/// Who it is, and all its topics.
void EmulatedBridge::Server::greet(const ClientPointer& client) {
    using Json = nlohmann::json;
    const auto text = [&](const Json& json) {
        const std::string all = jsonText(json);
        post(client, true, Bytes(all.begin(), all.end()));
    };
    text({{"op", "serverInfo"}, {"name", "EdgeScan"}, {"capabilities", Json::array()}, {"supportedEncodings", {"cdr"}}});
    Json channels = Json::array();
    for (const BridgeChannel& topic : topics) {
        channels.push_back({{"id", topic.id},
                            {"topic", topic.topic},
                            {"encoding", topic.encoding},
                            {"schemaName", topic.type},
                            {"schema", topic.definition},
                            {"schemaEncoding", topic.definitionEncoding}});
    }
    text({{"op", "advertise"}, {"channels", channels}});
}

void EmulatedBridge::Server::read(const ClientPointer& client) {
    client->stream.async_read(client->buffer, [this, client](const error_code& problem, std::size_t) {
        if (problem || !client->open) return close(client);
        answer(client);
        client->buffer.consume(client->buffer.size());
        read(client);
    });
}

/// Subscriptions are carried out; everything is noted.
void EmulatedBridge::Server::answer(const ClientPointer& client) {
    const std::string_view said(static_cast<const char*>(client->buffer.data().data()), client->buffer.size());
    const auto json = client->stream.got_text() ? parseJson(said, "") : Result<nlohmann::json>(Error{"binary", "", ""});
    const bool known = json && json->is_object() && json->contains("op") && (*json)["op"].is_string();
    const std::string op = known ? (*json)["op"].get<std::string>() : client->stream.got_text() ? "garbage" : "binary";
    count([&](auto& s) { ++s.asked[op]; });
    if (op != "subscribe" || !json->contains("subscriptions")) return;
    for (const auto& subscription : (*json)["subscriptions"]) {
        const std::uint64_t channel = subscription.value("channelId", std::uint64_t{0});
        if (channel >= topics.size()) continue;
        client->subscriptions[static_cast<std::uint32_t>(channel)] = subscription.value("id", std::uint32_t{0});
        count([&](auto& s) { s.subscribed.insert(topics[channel].topic); });
        if (channel == static_cast<std::uint64_t>(BridgeTopic::Fixed)) send(BridgeTopic::Fixed, startNs, fixedMessage(startNs));
    }
}

void EmulatedBridge::Server::post(const ClientPointer& client, bool text, Bytes bytes) {
    if (!client->open || client->queue.size() >= mostQueued()) return;
    client->queue.emplace_back(text, std::move(bytes));
    if (client->queue.size() == 1) write(client);
}

void EmulatedBridge::Server::write(const ClientPointer& client) {
    client->stream.text(client->queue.front().first);
    client->stream.async_write(asio::buffer(client->queue.front().second), [this, client](const error_code& problem, std::size_t) {
        if (problem || !client->open) return close(client);
        client->queue.pop_front();
        if (!client->queue.empty()) write(client);
    });
}

void EmulatedBridge::Server::close(const ClientPointer& client) {
    if (!std::exchange(client->open, false)) return;
    error_code ignored;
    client->stream.next_layer().shutdown(tcp::socket::shutdown_both, ignored);
    client->stream.next_layer().close(ignored);
    std::erase(clients, client);
}

void EmulatedBridge::Server::send(BridgeTopic topic, std::int64_t ns, const Bytes& message) {
    for (const ClientPointer& client : std::list<ClientPointer>(clients)) {
        const auto subscription = client->subscriptions.find(static_cast<std::uint32_t>(topic));
        if (subscription != client->subscriptions.end()) post(client, false, bridgeDataBytes({subscription->second, ns, message}));
    }
}

std::size_t EmulatedBridge::Server::row() const {
    const std::uint64_t lines = sweep.messages();
    const std::uint64_t at = number % lines;
    const bool back = settings.atEnd == scanner::AtEnd::Reverse && number / lines % 2 == 1;
    return static_cast<std::size_t>(back ? lines - 1 - at : at);
}

/// The message that is due at `ns`; before a line goes its angle.
Bytes EmulatedBridge::Server::nextMessage(std::int64_t ns, double periodS) {
    if (sweep.cloud) return cloudMessage(*sweep.cloud, ns);
    const BridgeLine& line = sweep.lines[row()];
    send(BridgeTopic::Transforms, ns, transformMessage(sweep, line.lineDeg, ns));
    return lineMessage(sweep, line, ns, periodS);
}

/// A line or a cloud, with faults. False: the last one was sent.
bool EmulatedBridge::Server::sendMessage() {
    if (settings.atEnd == scanner::AtEnd::Stop && number >= sweep.messages()) return false;
    const scanner::ScannerFaults& faults = settings.faults;
    const double periodS = settings.linesPerSecond > 0 ? 1 / settings.linesPerSecond : kUsualPeriodS;
    const auto ns = startNs + static_cast<std::int64_t>(std::llround((static_cast<double>(number) * periodS + pausedS) * 1e9));
    const Bytes message = nextMessage(ns, periodS);
    if (happens(faults.garbageEvery)) {
        const std::string_view garbage = "}{ this is not JSON";
        for (const ClientPointer& client : std::list<ClientPointer>(clients)) post(client, true, Bytes(garbage.begin(), garbage.end()));
    }
    const Bytes cut(message.begin(), message.begin() + static_cast<std::ptrdiff_t>(message.size() / 2));
    if (!happens(faults.loseEvery)) send(BridgeTopic::Measured, ns, happens(faults.corruptEvery) ? cut : message);
    if (happens(faults.duplicateEvery)) send(BridgeTopic::Measured, ns, message);
    if (happens(faults.dropEvery)) {
        for (const ClientPointer& client : std::list<ClientPointer>(clients)) close(client);
    }
    if (happens(faults.stallEvery)) pausedS += faults.stallS;
    ++number;
    const bool last = settings.atEnd == scanner::AtEnd::Stop && number == sweep.messages();
    count([&](auto& s) {
        ++s.lines;
        s.finished = last;
    });
    return !last;
}

bool EmulatedBridge::Server::eagerAndFull() const {
    return settings.linesPerSecond <= 0 &&
           std::ranges::any_of(clients, [&](const ClientPointer& client) { return client->queue.size() > mostQueued() / 2; });
}

void EmulatedBridge::Server::tick() {
    const auto measured = static_cast<std::uint32_t>(BridgeTopic::Measured);
    const bool wanted = std::ranges::any_of(clients, [&](const ClientPointer& client) { return client->subscriptions.contains(measured); });
    if (wanted && !eagerAndFull() && !settings.faults.mute && !sendMessage()) return;
    wait();
}

void EmulatedBridge::Server::wait() {
    const double pause = happens(settings.faults.stallEvery) ? settings.faults.stallS : 0.0;
    const double periodS = settings.linesPerSecond > 0 ? 1 / settings.linesPerSecond : 0.0005;
    timer.expires_after(std::chrono::duration_cast<asio::steady_timer::duration>(std::chrono::duration<double>(periodS + pause)));
    timer.async_wait([this](const error_code& problem) {
        if (!problem) tick();
    });
}

EmulatedBridge::EmulatedBridge(std::shared_ptr<Server> server) : server_(std::move(server)) {}

EmulatedBridge::~EmulatedBridge() {
    server_->context.stop();
    if (server_->thread.joinable()) server_->thread.join();
}

std::uint16_t EmulatedBridge::port() const { return server_->port; }

EmulatedBridgeStatistics EmulatedBridge::statistics() const {
    const std::lock_guard lock(server_->mutex);
    return server_->statistics;
}

void EmulatedBridge::dropConnections() {
    asio::post(server_->context, [server = server_] {
        for (const auto& client : std::list<Server::ClientPointer>(server->clients)) server->close(client);
    });
}

Result<std::unique_ptr<EmulatedBridge>> serveBridge(BridgeSweep sweep, const scanner::EmulatedScannerSettings& settings) {
    if (sweep.messages() == 0) return Error{"there are no lines to send", {}, "choose another scan"};
    auto server = std::make_shared<EmulatedBridge::Server>(std::move(sweep), settings);
    if (const auto listening = server->listen(); !listening) return listening.error();
    server->thread = std::thread([raw = server.get()] { raw->context.run(); });
    return std::unique_ptr<EmulatedBridge>(new EmulatedBridge(std::move(server)));
}

} // namespace edgescan::robots
