// Any bytes as messages of a bridge: as text, as a message of a topic, and as lines and transforms of a laser. The first byte chooses.
#include "core/robots/bridge/protocol.h"
#include "core/robots/sweeps/live_laser.h"
#include "tests/fuzz/open_bytes.h"

#include <algorithm>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    using namespace edgescan;
    if (size < 1) return 0;
    const ByteView input(bytes + 1, size - 1);
    if (bytes[0] % 3 == 0) {
        const auto text = robots::bridgeText({reinterpret_cast<const char*>(input.data()), input.size()}, "robot:8765");
        fuzz::hold(text ? text->offered.size() <= input.size() : text.error().sentence().find('\n') == std::string::npos);
        return 0;
    }
    if (bytes[0] % 3 == 1) {
        const auto data = robots::bridgeData(input);
        fuzz::hold(!data || robots::bridgeDataBytes(*data).size() == input.size());
        return 0;
    }
    // Messages, each behind two bytes of its length and one that chooses its topic.
    constexpr std::size_t kHead = 3;
    const char* const types[] = {"sensor_msgs/LaserScan", "tf2_msgs/TFMessage", "sensor_msgs/JointState"};
    robots::LiveLaser laser(scanner::assumedSweep(), {});
    scanner::SweepAssembler assembler(scanner::assumedSweep());
    std::int64_t lines = 0, messages = 0;
    for (ByteView rest = input; rest.size() > kHead;) {
        const std::size_t length = std::min<std::size_t>(rest.size() - kHead, rest[0] + 256U * rest[1]);
        const char* const type = types[rest[2] % 3];
        const robots::RosTopic topic{type, type, std::string(robots::commonRosDefinition(type)), robots::RosEncoding::Cdr, false};
        lines += laser.receive(topic, rest.subspan(kHead, length), assembler);
        ++messages;
        rest = rest.subspan(kHead + length);
    }
    fuzz::hold(lines + laser.leftOut() <= 2 * messages);
    static_cast<void>(assembler.snapshot());
    return 0;
}
