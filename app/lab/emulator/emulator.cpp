// An emulated LMS511 on a TCP port: one thread, any number of connections, and bounded memory.
#include "app/lab/emulator/emulator.h"

#include "app/lab/emulator/device.h"
#include "app/lab/emulator/sent_sweep.h"
#include "core/scanner/cola/link.h"

#include <boost/asio.hpp>

#include <algorithm>
#include <array>
#include <deque>
#include <list>
#include <mutex>
#include <thread>

namespace edgescan::scanner {

namespace {

namespace asio = boost::asio;
using boost::system::error_code;
using tcp = asio::ip::tcp;
using Clock = std::chrono::steady_clock;

constexpr std::size_t kMostWaiting = 4U << 20U; ///< bytes queued for a client that does not read; beyond this, telegrams are lost
constexpr std::size_t kEager = 64U << 10U;      ///< as fast as possible: the next line is made when fewer bytes than this are queued
/// bytes of answers queued for a client that does not read; beyond this, its requests are not read
constexpr std::size_t kMostAnswers = 256U << 10U;
constexpr std::size_t kMostClients = 8;
constexpr auto kAcceptAgain = std::chrono::milliseconds(200); ///< wait after the system had no free descriptor

} // namespace

struct EmulatedScanner::Server {
    struct Client : std::enable_shared_from_this<Client> {
        explicit Client(tcp::socket accepted, std::optional<Dialect> only) : socket(std::move(accepted)), stream(only) {}
        tcp::socket socket;
        ColaStream stream;
        bool subscribed = false;
        Dialect dialect = Dialect::B;
        std::array<std::uint8_t, 4096> piece{};
        std::deque<Bytes> queue;
        std::size_t waiting = 0;     ///< bytes in queue
        Bytes merged;                ///< telegrams to be sent together with later ones
        std::deque<ColaFrame> asked; ///< requests that are not answered yet
        bool reading = false;
        Clock::time_point active = Clock::now(); ///< when the client last sent or read something
        bool open = true;
    };
    using ClientPointer = std::shared_ptr<Client>;

    Server(std::shared_ptr<const std::vector<ScanTelegram>> telegrams, const EmulatedScannerSettings& given)
        : settings(given), device(telegrams->front(), given.refusals), sweep(std::move(telegrams), given) {}

    Result<Done> listen();
    void accept();
    void welcome(tcp::socket socket);
    void read(const ClientPointer& client);
    void answerAll(const ClientPointer& client);
    void answer(const ClientPointer& client, const ColaFrame& frame);
    void write(const ClientPointer& client, Bytes bytes);
    void writeNext(const ClientPointer& client);
    void close(const ClientPointer& client);
    void closeAll();
    void wake();
    void tick();
    void advance();
    void send(const ClientPointer& client, const SweepStep& step);
    void sendPieces(const ClientPointer& client, const Bytes& bytes);
    [[nodiscard]] bool wanted() const;
    [[nodiscard]] bool eager() const;
    template <class Change>
    void count(Change change) {
        const std::lock_guard lock(mutex);
        change(statistics);
    }

    EmulatedScannerSettings settings;
    EmulatedDevice device;
    EmulatedSweep sweep;
    asio::io_context context{1};
    tcp::acceptor acceptor{context};
    asio::steady_timer timer{context};
    asio::steady_timer acceptAgain{context};
    bool timing = false;
    Clock::time_point due;
    std::list<ClientPointer> clients;
    std::mt19937 merging{7};
    std::uint16_t port = 0;
    std::mutex mutex;
    EmulatedScannerStatistics statistics;
    std::thread thread;
};

Result<Done> EmulatedScanner::Server::listen() {
    const std::string where = addressText(settings.address, settings.port);
    error_code problem;
    const auto address = asio::ip::make_address(settings.address, problem);
    if (problem) return Error{"this is not an IP address to listen on", where, "use 127.0.0.1, or 0.0.0.0 for all"};
    const tcp::endpoint endpoint(address, settings.port);
    acceptor.open(endpoint.protocol(), problem);
    error_code ignored;
    if (!problem) acceptor.set_option(asio::socket_base::reuse_address(true), ignored);
    if (!problem) acceptor.bind(endpoint, problem);
    if (!problem) acceptor.listen(4, problem);
    if (problem) return Error{"the emulated scanner cannot listen there (" + problem.message() + ")", where, "choose another port"};
    port = acceptor.local_endpoint(ignored).port();
    accept();
    if (settings.keepTurning) wake();
    return Done{};
}

void EmulatedScanner::Server::accept() {
    acceptor.async_accept([this](const error_code& problem, tcp::socket socket) {
        if (problem == asio::error::operation_aborted) return;
        if (!problem) {
            welcome(std::move(socket));
            return accept();
        }
        // The system has no free descriptor or no memory: new clients wait until it has.
        count([](auto& s) { ++s.failedAccepts; });
        acceptAgain.expires_after(kAcceptAgain);
        acceptAgain.async_wait([this](const error_code& ended) {
            if (!ended) accept();
        });
    });
}

/// If all places are taken, the connection that was silent for the longest time is closed.
void EmulatedScanner::Server::welcome(tcp::socket socket) {
    if (clients.size() >= kMostClients) {
        const auto oldest =
            std::min_element(clients.begin(), clients.end(), [](const auto& a, const auto& b) { return a->active < b->active; });
        if (std::chrono::duration<double>(Clock::now() - (*oldest)->active).count() < settings.silentS) return;
        close(ClientPointer(*oldest));
    }
    error_code ignored;
    socket.set_option(tcp::no_delay(true), ignored);
    const auto client = std::make_shared<Client>(std::move(socket), settings.only);
    clients.push_back(client);
    count([](auto& s) { ++s.clients; });
    read(client);
}

void EmulatedScanner::Server::read(const ClientPointer& client) {
    if (client->reading) return;
    client->reading = true;
    client->socket.async_read_some(asio::buffer(client->piece), [this, client](const error_code& problem, std::size_t length) {
        client->reading = false;
        if (problem || !client->open) return close(client);
        client->active = Clock::now();
        for (ColaFrame& frame : client->stream.push(ByteView(client->piece).first(length))) client->asked.push_back(std::move(frame));
        answerAll(client);
    });
}

/// If a client sends requests and does not read the answers, its requests are neither answered nor read until it has read.
void EmulatedScanner::Server::answerAll(const ClientPointer& client) {
    while (client->open && !client->asked.empty() && client->waiting < kMostAnswers) {
        const ColaFrame frame = std::move(client->asked.front());
        client->asked.pop_front();
        answer(client, frame);
    }
    if (client->open && client->asked.empty()) read(client);
}

void EmulatedScanner::Server::answer(const ClientPointer& client, const ColaFrame& frame) {
    if (settings.faults.mute) return;
    client->dialect = frame.dialect;
    const std::string_view text(reinterpret_cast<const char*>(frame.payload().data()), std::min<std::size_t>(frame.payload().size(), 3));
    if (text != "sRN" && text != "sEN") count([](auto& s) { ++s.writes; });
    Bytes payload = device.answer(frame.payload(), frame.dialect, client->subscribed);
    if (payload.empty()) {
        auto step = sweep.next();
        if (!step) return;
        step->telegram.polled = true;
        payload = encodeScanTelegram(step->telegram, frame.dialect);
        count([](auto& s) { ++s.lines; });
    }
    sendPieces(client, framed(payload, frame.dialect));
    wake();
}

void EmulatedScanner::Server::write(const ClientPointer& client, Bytes bytes) {
    if (!client->open || bytes.empty()) return;
    client->waiting += bytes.size();
    client->queue.push_back(std::move(bytes));
    if (client->queue.size() == 1) writeNext(client);
}

void EmulatedScanner::Server::writeNext(const ClientPointer& client) {
    asio::async_write(client->socket, asio::buffer(client->queue.front()), [this, client](const error_code& problem, std::size_t) {
        if (problem || !client->open) return close(client);
        client->active = Clock::now();
        client->waiting -= client->queue.front().size();
        client->queue.pop_front();
        if (!client->queue.empty()) writeNext(client);
        answerAll(client);
        if (eager()) wake();
    });
}

void EmulatedScanner::Server::close(const ClientPointer& client) {
    if (!client->open) return;
    client->open = false;
    error_code ignored;
    client->socket.shutdown(tcp::socket::shutdown_both, ignored);
    client->socket.close(ignored);
    clients.remove(client);
}

void EmulatedScanner::Server::closeAll() {
    const std::list<ClientPointer> all = clients;
    for (const ClientPointer& client : all) close(client);
}

bool EmulatedScanner::Server::eager() const { return settings.linesPerSecond <= 0.0; }

/// Whether a line must be measured now or at the next tick.
bool EmulatedScanner::Server::wanted() const {
    if (sweep.finished()) return false;
    bool subscribed = false;
    for (const ClientPointer& client : clients) {
        if (!client->subscribed) continue;
        if (eager() && client->waiting >= kEager) return false;
        subscribed = true;
    }
    return subscribed || (settings.keepTurning && !eager());
}

/// Starts the timer for the next tick if a tick is needed.
void EmulatedScanner::Server::wake() {
    if (timing || !wanted()) return;
    timing = true;
    due = std::max(due, Clock::now());
    timer.expires_at(due);
    timer.async_wait([this](const error_code& problem) {
        if (!problem) tick();
    });
}

void EmulatedScanner::Server::tick() {
    timing = false;
    if (wanted()) {
        if (!eager()) due += std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(1.0 / settings.linesPerSecond));
        // After the computer was asleep, the missed telegrams are not sent all at once.
        due = std::max(due, Clock::now() - std::chrono::seconds(1));
        advance();
    }
    wake();
}

void EmulatedScanner::Server::advance() {
    const auto step = sweep.next();
    if (!step) return;
    bool anyone = false;
    for (const ClientPointer& client : clients) {
        if (!client->subscribed) continue;
        anyone = true;
        if (!step->lost) send(client, *step);
    }
    count([&](auto& s) {
        ++s.lines;
        if (step->lost) ++s.lost;
        if (anyone && step->duplicate && !step->lost) ++s.duplicated;
        if (anyone && step->garbage && !step->lost) ++s.garbage;
        if (anyone && step->corrupt && !step->lost) ++s.corrupted;
        if (step->stall) ++s.stalls;
        if (step->drop) ++s.drops;
        s.finished = sweep.finished();
    });
    if (step->stall)
        due = Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(settings.faults.stallS));
    if (step->drop) closeAll();
}

void EmulatedScanner::Server::send(const ClientPointer& client, const SweepStep& step) {
    if (client->waiting > kMostWaiting) return count([](auto& s) { ++s.lost; });
    const Bytes frame = framed(encodeScanTelegram(step.telegram, client->dialect), client->dialect);
    Bytes bytes = step.garbage ? sweep.garbage() : Bytes{};
    const Bytes sound = step.corrupt ? sweep.corrupted(frame) : frame;
    bytes.insert(bytes.end(), sound.begin(), sound.end());
    if (step.duplicate) bytes.insert(bytes.end(), frame.begin(), frame.end());
    count([](auto& s) { ++s.sent; });
    if (!settings.faults.mergeSends) return sendPieces(client, bytes);
    client->merged.insert(client->merged.end(), bytes.begin(), bytes.end());
    if (merging() % 3 != 0 && !sweep.finished()) return;
    sendPieces(client, std::exchange(client->merged, {}));
}

void EmulatedScanner::Server::sendPieces(const ClientPointer& client, const Bytes& bytes) {
    if (!settings.faults.splitSends) return write(client, bytes);
    for (std::size_t at = 0; at < bytes.size();) {
        const std::size_t length = std::min(sweep.pieceLength(1500), bytes.size() - at);
        const auto from = bytes.begin() + static_cast<std::ptrdiff_t>(at);
        write(client, Bytes(from, from + static_cast<std::ptrdiff_t>(length)));
        at += length;
    }
}

EmulatedScanner::EmulatedScanner(std::unique_ptr<Server> server) : server_(std::move(server)) {
    server_->thread = std::thread([s = server_.get()] {
        const auto work = asio::make_work_guard(s->context);
        s->context.run();
    });
}

EmulatedScanner::~EmulatedScanner() {
    server_->context.stop();
    server_->thread.join();
}

std::uint16_t EmulatedScanner::port() const { return server_->port; }

EmulatedScannerStatistics EmulatedScanner::statistics() const {
    const std::lock_guard lock(server_->mutex);
    return server_->statistics;
}

void EmulatedScanner::setContamination(bool warning, bool error) {
    asio::post(server_->context, [s = server_.get(), warning, error] {
        s->sweep.contaminationWarning = warning;
        s->sweep.contaminationError = error;
    });
}

void EmulatedScanner::dropConnections() {
    asio::post(server_->context, [s = server_.get()] { s->closeAll(); });
}

Result<std::unique_ptr<EmulatedScanner>> serveTelegrams(std::shared_ptr<const std::vector<ScanTelegram>> telegrams,
                                                        const EmulatedScannerSettings& settings) {
    if (!telegrams || telegrams->empty()) return Error{"there are no lines to serve", {}, "take a scan with at least one line"};
    auto server = std::make_unique<EmulatedScanner::Server>(std::move(telegrams), settings);
    if (const auto listening = server->listen(); !listening) return listening.error();
    return std::unique_ptr<EmulatedScanner>(new EmulatedScanner(std::move(server)));
}

} // namespace edgescan::scanner
