// What an LMS511 answers to a request (docs/protocol.md, "Requests and answers").
#include "core/emulator/emulated_device.h"

#include "core/lms/cola_fields.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace edgescan::sim {

namespace {

enum Refusal : int {
    MethodDenied = 1,
    UnknownMethod = 2,
    UnknownVariable = 3,
    NotPossible = 4,
    WrongArguments = 5,
    WriteDenied = 10,
    UnknownCommand = 12,
    UnknownEvent = 15
};

constexpr int kClientLevel = 3; ///< needed to change anything

int unknown(std::string_view type) {
    if (type == "sRN" || type == "sWN") return UnknownVariable;
    if (type == "sMN") return UnknownMethod;
    return type == "sEN" ? UnknownEvent : UnknownCommand;
}

Bytes refusal(int code, Dialect dialect) {
    ColaWriter writer(dialect);
    if (dialect == Dialect::A) {
        writer.word("sFA");
    } else {
        writer.fixed("sFA"); // no blank before the code
    }
    writer.u16(static_cast<std::uint16_t>(code));
    return std::move(writer).done();
}

} // namespace

/// One request being answered. Each handler reads its arguments, then either gives a refusal code or has written the answer.
class ColaDeviceAnswers {
public:
    ColaDeviceAnswers(EmulatedDevice& device, Visitor& visitor, ByteView request, Dialect dialect)
        : device_(device), visitor_(visitor), reader_(request, dialect), writer_(dialect), dialect_(dialect) {}

    Bytes run() {
        const std::string type(reader_.word());
        const std::string name(reader_.word());
        if (const auto refused = device_.refusals.find(name); refused != device_.refusals.end()) return refusal(refused->second, dialect_);
        if (type == "sRN" && name == "LMDscandata") return {};
        const auto entry = std::find_if(kAnswers.begin(), kAnswers.end(), [&](const Entry& e) { return e.type == type && e.name == name; });
        if (entry == kAnswers.end()) return refusal(unknown(type), dialect_);
        const bool allowed = visitor_.accessLevel >= kClientLevel || name == "SetAccessMode" || name == "Run";
        if (type == "sWN" && !allowed) return refusal(WriteDenied, dialect_);
        if (type == "sMN" && !allowed) return refusal(MethodDenied, dialect_);
        writer_.word(type == "sRN" ? "sRA" : type == "sWN" ? "sWA" : type == "sMN" ? "sAN" : "sEA");
        writer_.word(name);
        const int code = (this->*entry->handler)();
        if (code != 0) return refusal(code, dialect_);
        return std::move(writer_).done();
    }

private:
    using Handler = int (ColaDeviceAnswers::*)();
    struct Entry {
        std::string_view type, name;
        Handler handler;
    };

    int argumentsOk() const { return reader_.failed() ? WrongArguments : 0; }

    int logIn() {
        const int level = reader_.u8("level");
        const std::uint32_t hash = reader_.u32("hash");
        const bool known = level >= 2 && level <= 4 && accessHash(static_cast<AccessLevel>(level)) == hash;
        if (reader_.failed()) return WrongArguments;
        if (known) {
            visitor_.accessLevel = level;
            device_.measuring = false; // until the next start
        }
        writer_.u8(known ? 1 : 0);
        return 0;
    }
    void writeScan() {
        writer_.u32(device_.scan.frequency);
        writer_.u16(device_.scan.sectors);
        writer_.u32(device_.scan.step);
        writer_.i32(device_.scan.startAngle);
        writer_.i32(device_.scan.stopAngle);
    }
    int setScan() {
        const std::uint32_t frequency = reader_.u32("frequency");
        (void)reader_.u16("sectors");
        const std::uint32_t step = reader_.u32("step");
        (void)reader_.i32("start");
        (void)reader_.i32("stop");
        if (reader_.failed()) return WrongArguments;
        constexpr std::array<std::uint32_t, 5> kFrequencies{2500, 3500, 5000, 7500, 10000};
        const bool badFrequency = std::find(kFrequencies.begin(), kFrequencies.end(), frequency) == kFrequencies.end();
        const bool badStep = step != device_.scan.step; // the lines are what they are
        if (!badFrequency && !badStep) device_.scan.frequency = frequency;
        writer_.u8(static_cast<std::uint8_t>((badFrequency ? 1 : 0) + (badStep ? 2 : 0)));
        writeScan();
        return 0;
    }
    int getScan() {
        writeScan();
        return 0;
    }
    int setRange() {
        const OutputRange wanted{reader_.u16("sectors"), reader_.u32("step"), reader_.i32("start"), reader_.i32("stop")};
        if (reader_.failed()) return WrongArguments;
        if (wanted.step != device_.scan.step || wanted.startAngle >= wanted.stopAngle) return NotPossible;
        device_.range = wanted;
        device_.range.startAngle = std::max(wanted.startAngle, device_.widest_.startAngle);
        device_.range.stopAngle = std::min(wanted.stopAngle, device_.widest_.stopAngle);
        return 0;
    }
    int getRange() {
        writer_.u16(device_.range.sectors);
        writer_.u32(device_.range.step);
        writer_.i32(device_.range.startAngle);
        writer_.i32(device_.range.stopAngle);
        return 0;
    }
    int setContent() {
        const ColaAnswer same{AnswerKind::Read, "LMDscandatacfg", Bytes(reader_.rest().begin(), reader_.rest().end()), 0, dialect_};
        const auto wanted = parseTelegramContent(same);
        if (!wanted || wanted->everyNth == 0) return WrongArguments;
        device_.content = *wanted;
        return 0;
    }
    int getContent() {
        const TelegramContent& c = device_.content;
        for (const std::uint8_t byte :
             {c.channels, c.channelsHigh, std::uint8_t{c.remission}, std::uint8_t{c.remission16}, c.unit, c.encoder, c.encoderHigh,
              std::uint8_t{c.position}, std::uint8_t{c.deviceName}, std::uint8_t{c.comment}, std::uint8_t{c.time}})
            writer_.u8(byte);
        writer_.u16(c.everyNth);
        return 0;
    }
    int setEchoes() {
        const int wanted = reader_.u8("filter");
        if (reader_.failed()) return WrongArguments;
        if (wanted > 2) return NotPossible;
        device_.echoFilter = wanted;
        return 0;
    }
    int getEchoes() {
        writer_.u8(static_cast<std::uint8_t>(device_.echoFilter));
        return 0;
    }
    int setByte() {
        (void)reader_.u8("value");
        return argumentsOk();
    }
    int setReal() {
        (void)reader_.real("value");
        return argumentsOk();
    }
    int getIdentity() {
        writer_.text("LMS511 emulated");
        writer_.text("EdgeScan");
        return 0;
    }
    int getFirmware() {
        writer_.text(device_.firmware);
        return 0;
    }
    int getLocation() {
        writer_.text(device_.location);
        return 0;
    }
    int getState() {
        writer_.u8(device_.measuring ? 1 : 0);
        return 0;
    }
    int getMeasuring() {
        writer_.u16(device_.measuring ? 7 : 3);
        writer_.u8(0);
        writer_.text("00:00:00");
        writer_.text("01.01.1970");
        for (int led = 0; led < 3; ++led) writer_.u16(0);
        return 0;
    }
    int getHours() {
        writer_.u32(1085);
        return 0;
    }
    int startMeasuring() {
        device_.measuring = true;
        writer_.u8(0);
        return 0;
    }
    int stopMeasuring() {
        device_.measuring = false;
        writer_.u8(0);
        return 0;
    }
    int store() {
        device_.stored = true;
        writer_.u8(1);
        return 0;
    }
    int leave() {
        visitor_.accessLevel = 0;
        writer_.u8(1);
        return 0;
    }
    int subscribe() {
        const int on = reader_.u8("switch");
        if (reader_.failed() || on > 1) return WrongArguments;
        visitor_.subscribed = on == 1;
        writer_.u8(static_cast<std::uint8_t>(on));
        return 0;
    }
    int subscribeOther() {
        writer_.u8(reader_.u8("switch"));
        return argumentsOk();
    }

    static const std::array<Entry, 31> kAnswers;

    EmulatedDevice& device_;
    Visitor& visitor_;
    ColaReader reader_;
    ColaWriter writer_;
    Dialect dialect_;
};

const std::array<ColaDeviceAnswers::Entry, 31> ColaDeviceAnswers::kAnswers{{
    {"sMN", "SetAccessMode", &ColaDeviceAnswers::logIn},
    {"sMN", "mLMPsetscancfg", &ColaDeviceAnswers::setScan},
    {"sMN", "LMCstartmeas", &ColaDeviceAnswers::startMeasuring},
    {"sMN", "LMCstopmeas", &ColaDeviceAnswers::stopMeasuring},
    {"sMN", "mEEwriteall", &ColaDeviceAnswers::store},
    {"sMN", "Run", &ColaDeviceAnswers::leave},
    {"sRN", "LMPscancfg", &ColaDeviceAnswers::getScan},
    {"sRN", "LMPoutputRange", &ColaDeviceAnswers::getRange},
    {"sRN", "LMDscandatacfg", &ColaDeviceAnswers::getContent},
    {"sRN", "FREchoFilter", &ColaDeviceAnswers::getEchoes},
    {"sRN", "DeviceIdent", &ColaDeviceAnswers::getIdentity},
    {"sRN", "FirmwareVersion", &ColaDeviceAnswers::getFirmware},
    {"sRN", "LocationName", &ColaDeviceAnswers::getLocation},
    {"sRN", "SCdevicestate", &ColaDeviceAnswers::getState},
    {"sRN", "STlms", &ColaDeviceAnswers::getMeasuring},
    {"sRN", "ODoprh", &ColaDeviceAnswers::getHours},
    {"sRN", "ODpwrc", &ColaDeviceAnswers::getHours},
    {"sWN", "LMPoutputRange", &ColaDeviceAnswers::setRange},
    {"sWN", "LMDscandatacfg", &ColaDeviceAnswers::setContent},
    {"sWN", "FREchoFilter", &ColaDeviceAnswers::setEchoes},
    {"sWN", "DO3And4Fnc", &ColaDeviceAnswers::setByte},
    {"sWN", "LICsrc", &ColaDeviceAnswers::setByte},
    {"sWN", "LICencset", &ColaDeviceAnswers::setByte},
    {"sWN", "LICencres", &ColaDeviceAnswers::setReal},
    {"sWN", "TSCRole", &ColaDeviceAnswers::setByte},
    {"sWN", "TSCTCInterface", &ColaDeviceAnswers::setByte},
    {"sEN", "LMDscandata", &ColaDeviceAnswers::subscribe},
    {"sEN", "LFErec", &ColaDeviceAnswers::subscribeOther},
    {"sEN", "LIDoutputstate", &ColaDeviceAnswers::subscribeOther},
    {"sEN", "LIDinputstate", &ColaDeviceAnswers::subscribeOther},
    {"sWN", "EIHstCola", &ColaDeviceAnswers::setByte},
}};

EmulatedDevice::EmulatedDevice(const ScanTelegram& likeThis) : location("SN " + std::to_string(likeThis.serialNumber)) {
    scan.frequency = likeThis.scanFrequency > 0 ? likeThis.scanFrequency : 2500;
    if (!likeThis.channels16.empty()) {
        const ScanChannel& channel = likeThis.channels16.front();
        const BeamGrid grid = beamGrid(channel);
        scan.step = channel.step;
        scan.startAngle = channel.startAngle;
        scan.stopAngle = static_cast<std::int32_t>(std::lround((grid.startDeg + grid.stepDeg * std::max(grid.beams - 1, 0)) * 1e4));
    }
    range = {1, scan.step, scan.startAngle, scan.stopAngle};
    widest_ = range;
    content.remission = !likeThis.channels8.empty();
    content.encoder = likeThis.encoders.empty() ? 0 : 1;
    content.deviceName = likeThis.deviceName.has_value();
    content.comment = likeThis.comment.has_value();
    content.position = likeThis.position.has_value();
    content.time = likeThis.clock.has_value();
}

Bytes EmulatedDevice::answer(ByteView request, Dialect dialect, Visitor& visitor) {
    return ColaDeviceAnswers(*this, visitor, request, dialect).run();
}

} // namespace edgescan::sim
