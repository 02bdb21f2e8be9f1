// The scan telegram LMDscandata: converts bytes to fields and fields to bytes.
#include "core/scanner/sick_lms/scan_telegram.h"
#include "core/base/translated_text.h"

#include "core/base/number_text.h"
#include "core/base/physical_limits.h"
#include "core/scanner/cola/fields.h"

#include <algorithm>
#include <cmath>

namespace edgescan::scanner {
namespace {

constexpr std::uint16_t kFirstRange = 16; ///< smaller raw values are codes of the device

ScanChannel readChannel(ColaReader& reader, unsigned bits) {
    ScanChannel channel;
    channel.content = reader.fixed(5, "the name of a channel");
    channel.scale = reader.real("the scale of a channel");
    channel.offset = reader.real("the offset of a channel");
    channel.startAngle = reader.i32("the start angle of a channel");
    channel.step = reader.u16("the angle step of a channel");
    const std::size_t count = reader.u16("the number of values of a channel");
    channel.values = reader.values(count, bits, "the values of a channel");
    return channel;
}

std::vector<ScanChannel> readChannels(ColaReader& reader, unsigned bits) {
    const std::size_t count = reader.u16("the number of channels");
    std::vector<ScanChannel> channels;
    for (std::size_t i = 0; i < count && !reader.failed(); ++i) channels.push_back(readChannel(reader, bits));
    return channels;
}

void readHead(ColaReader& reader, ScanTelegram& telegram) {
    telegram.version = reader.u16("the version");
    telegram.deviceNumber = reader.u16("the device number");
    telegram.serialNumber = reader.u32("the serial number");
    for (std::uint8_t& byte : telegram.status) byte = reader.u8("the device status");
    telegram.telegramCounter = reader.u16("the telegram counter");
    telegram.scanCounter = reader.u16("the scan counter");
    telegram.sinceStartUs = reader.u32("the time since start-up");
    telegram.transmittedUs = reader.u32("the time of transmission");
    for (std::uint8_t& byte : telegram.digitalIn) byte = reader.u8("the digital inputs");
    for (std::uint8_t& byte : telegram.digitalOut) byte = reader.u8("the digital outputs");
    telegram.layer = reader.i16("the layer angle");
    telegram.scanFrequency = reader.u32("the scan frequency");
    telegram.measurementFrequency = reader.u32("the measurement frequency");
    const std::size_t encoders = reader.u16("the number of encoders");
    for (std::size_t i = 0; i < encoders && !reader.failed(); ++i) {
        const std::uint32_t position = reader.u32("an encoder position");
        telegram.encoders.push_back({position, reader.i16("an encoder speed")});
    }
}

ScanPosition readPosition(ColaReader& reader) {
    ScanPosition position;
    for (float& value : position.xyz) value = reader.real("the position");
    for (float& value : position.rotation) value = reader.real("the rotation");
    position.rotationType = reader.u8("the rotation type");
    return position;
}

ScanClock readClock(ColaReader& reader) {
    ScanClock clock;
    clock.year = reader.u16("the year");
    for (std::uint8_t* part : {&clock.month, &clock.day, &clock.hour, &clock.minute, &clock.second}) *part = reader.u8("the date and time");
    clock.microsecond = reader.u32("the microsecond");
    return clock;
}

ScanEvent readEvent(ColaReader& reader) {
    ScanEvent event;
    event.type = reader.fixed(4, "the event type");
    event.encoder = reader.u32("the event's encoder");
    event.timeUs = reader.u32("the event's time");
    event.angle = reader.i32("the event's angle");
    return event;
}

void readBlocks(ColaReader& reader, ScanTelegram& telegram) {
    if (reader.u16("the position flag") != 0) telegram.position = readPosition(reader);
    if (reader.u16("the name flag") != 0) telegram.deviceName = reader.text("the device name");
    if (reader.u16("the comment flag") != 0) telegram.comment = reader.text("the comment");
    if (reader.u16("the time flag") != 0) telegram.clock = readClock(reader);
    // Telegrams of old firmware end here.
    if (reader.failed() || reader.left() == 0) return;
    if (reader.u16("the event flag") != 0) telegram.event = readEvent(reader);
    telegram.trailingBytes = reader.left();
}

void writeChannels(ColaWriter& writer, const std::vector<ScanChannel>& channels, unsigned bits) {
    writer.u16(static_cast<std::uint16_t>(channels.size()));
    for (const ScanChannel& channel : channels) {
        writer.fixed(channel.content);
        writer.real(channel.scale);
        writer.real(channel.offset);
        writer.i32(channel.startAngle);
        writer.u16(channel.step);
        writer.u16(static_cast<std::uint16_t>(channel.values.size()));
        writer.values(channel.values, bits);
    }
}

void writeHead(ColaWriter& writer, const ScanTelegram& telegram) {
    writer.u16(telegram.version);
    writer.u16(telegram.deviceNumber);
    writer.u32(telegram.serialNumber);
    for (const std::uint8_t byte : telegram.status) writer.u8(byte);
    writer.u16(telegram.telegramCounter);
    writer.u16(telegram.scanCounter);
    writer.u32(telegram.sinceStartUs);
    writer.u32(telegram.transmittedUs);
    for (const std::uint8_t byte : telegram.digitalIn) writer.u8(byte);
    for (const std::uint8_t byte : telegram.digitalOut) writer.u8(byte);
    writer.i16(telegram.layer);
    writer.u32(telegram.scanFrequency);
    writer.u32(telegram.measurementFrequency);
    writer.u16(static_cast<std::uint16_t>(telegram.encoders.size()));
    for (const ScanEncoder& encoder : telegram.encoders) {
        writer.u32(encoder.position);
        writer.i16(encoder.speed);
    }
}

void writeBlocks(ColaWriter& writer, const ScanTelegram& telegram) {
    writer.u16(telegram.position ? 1 : 0);
    if (telegram.position) {
        for (const float value : telegram.position->xyz) writer.real(value);
        for (const float value : telegram.position->rotation) writer.real(value);
        writer.u8(telegram.position->rotationType);
    }
    for (const auto* text : {&telegram.deviceName, &telegram.comment}) {
        writer.u16(*text ? 1 : 0);
        if (*text) writer.text(**text);
    }
    writer.u16(telegram.clock ? 1 : 0);
    if (const auto& clock = telegram.clock) {
        writer.u16(clock->year);
        for (const std::uint8_t part : {clock->month, clock->day, clock->hour, clock->minute, clock->second}) writer.u8(part);
        writer.u32(clock->microsecond);
    }
    writer.u16(telegram.event ? 1 : 0);
    if (telegram.event) {
        writer.fixed(telegram.event->type);
        writer.u32(telegram.event->encoder);
        writer.u32(telegram.event->timeUs);
        writer.i32(telegram.event->angle);
    }
}

constexpr std::string_view kSubscribed = "sSN LMDscandata ";
constexpr std::string_view kPolled = "sRA LMDscandata ";

bool startsWith(ByteView payload, std::string_view text) {
    return payload.size() >= text.size() && std::equal(text.begin(), text.end(), payload.begin());
}

/// A scale or an offset from a broken device would give impossible ranges.
Result<Done> checkRangeChannels(const ScanTelegram& telegram) {
    constexpr double kLargestCount = 65535;
    for (const ScanChannel& channel : telegram.channels16) {
        if (!std::string_view(channel.content).starts_with("DIST")) continue;
        const bool scaled = physical::kUnitMm.hold(channel.scale) && physical::kRangeMm.hold(kLargestCount * channel.scale);
        if (scaled && physical::kRangeMm.hold(std::abs(channel.offset))) continue;
        return Error{withValues(scaled ? "the offset of the channel %1 is %2, which no scanner uses"
                                       : "the scale of the channel %1 is %2, which no scanner uses",
                                {channel.content, significantText(scaled ? channel.offset : channel.scale, 6)}),
                     "the scan telegram",
                     {}};
    }
    return Done{};
}

} // namespace

// Converts the raw fields of a scan telegram to millimetres, degrees, hertz and warnings.

const ScanChannel* findChannel(const ScanTelegram& telegram, std::string_view content) {
    for (const auto* channels : {&telegram.channels16, &telegram.channels8}) {
        const auto found = std::find_if(channels->begin(), channels->end(), [&](const ScanChannel& c) { return c.content == content; });
        if (found != channels->end()) return &*found;
    }
    return nullptr;
}

LineRanges rangesMm(const ScanChannel& channel) {
    LineRanges ranges{std::vector<float>(channel.values.size(), 0.0F), std::vector<CellState>(channel.values.size(), CellState::NoReturn)};
    for (std::size_t beam = 0; beam < channel.values.size(); ++beam) {
        const std::uint16_t raw = channel.values[beam];
        if (raw == 0) continue;
        const bool isRange = raw >= kFirstRange;
        const float mm = static_cast<float>(raw) * channel.scale + (isRange ? channel.offset : 0.0F);
        // An offset from a broken device must not put a range behind the scanner or beyond the largest possible range.
        if (mm == 0.0F || !physical::kRangeMm.hold(mm)) continue;
        ranges.rangeMm[beam] = mm;
        ranges.state[beam] = isRange ? CellState::Valid : CellState::DeviceStatus;
    }
    return ranges;
}

BeamGrid beamGrid(const ScanChannel& channel) {
    return {snappedDeg(channel.startAngle / 1e4), snappedDeg(channel.step / 1e4), static_cast<int>(channel.values.size())};
}

DeviceFlags deviceFlags(const ScanTelegram& telegram) {
    const unsigned bits = telegram.status[0];
    return {(bits & 1U) != 0, (bits & 2U) != 0, (bits & 4U) != 0};
}

double scanFrequencyHz(const ScanTelegram& telegram) { return telegram.scanFrequency / 100.0; }

double linePeriodS(const ScanTelegram& telegram) {
    constexpr double kUsualHz = 25.0, kSlowestHz = 1.0, kFastestHz = 1000.0;
    const double hz = scanFrequencyHz(telegram);
    return 1.0 / (hz >= kSlowestHz && hz <= kFastestHz ? hz : kUsualHz);
}

bool isScanTelegram(ByteView payload) { return startsWith(payload, kSubscribed) || startsWith(payload, kPolled); }

Result<ScanTelegram> decodeScanTelegram(ByteView payload, Dialect dialect) {
    if (!isScanTelegram(payload)) return Error{"this is not a scan telegram (LMDscandata)", "byte 0 of the telegram", {}};
    ScanTelegram telegram;
    telegram.polled = startsWith(payload, kPolled);
    ColaReader reader(payload, dialect);
    reader.word();
    reader.word();
    readHead(reader, telegram);
    telegram.channels16 = readChannels(reader, 16);
    telegram.channels8 = readChannels(reader, 8);
    readBlocks(reader, telegram);
    if (reader.failed()) return reader.error();
    if (auto measured = checkRangeChannels(telegram); !measured) return measured.error();
    return telegram;
}

Bytes encodeScanTelegram(const ScanTelegram& telegram, Dialect dialect) {
    ColaWriter writer(dialect);
    writer.word(telegram.polled ? "sRA" : "sSN");
    writer.word("LMDscandata");
    writeHead(writer, telegram);
    writeChannels(writer, telegram.channels16, 16);
    writeChannels(writer, telegram.channels8, 8);
    writeBlocks(writer, telegram);
    return std::move(writer).done();
}

} // namespace edgescan::scanner
