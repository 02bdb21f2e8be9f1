// edgescan-cli info: one JSON object per file.
#include "app/cli/commands.h"
#include "app/shared/options.h"
#include "app/shared/outputs.h"
#include "core/exports/report.h"
#include "core/files/open_save/topics_of_file.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <memory>

namespace edgescan::cli {
namespace {

/// The topics of a ROS bag; null: the file is none.
nlohmann::ordered_json bagReport(const std::string& file) {
    const auto listing = files::topicsOfFile(file);
    if (!listing || !*listing) return nullptr;
    nlohmann::ordered_json topics = nlohmann::ordered_json::array();
    for (const files::ListedTopic& topic : (*listing)->topics)
        topics.push_back({{"topic", topic.name},
                          {"type", topic.type},
                          {"messages", topic.messages},
                          {"hertz", std::round(topic.hertz * 1000) / 1000},
                          {"frame", topic.frame},
                          {"gives", topic.gives},
                          {"scan", topic.isScan}});
    return {{"kind", (*listing)->kind}, {"topics", topics}, {"warnings", (*listing)->warnings}};
}

struct Info {
    std::vector<std::string> files;
    std::string json = "-";
    ReadFlags read;
};

int run(const Info& info) {
    if (const auto one = checkOnePose(info.files, info.read); !one) return failWith(one.error(), kWrongUsage);
    JsonLines json(info.json);
    std::size_t done = 0, refused = 0;
    for (const std::string& file : info.files) {
        const auto one = [&] {
            const Result<Scan> scan = files::openAsAsked(file, readingOptions(info.read));
            nlohmann::ordered_json report = scan ? document("info", exports::infoReport(*scan)) : refusal("info", file, scan.error());
            if (auto bag = bagReport(file); !bag.is_null()) report["bag"] = std::move(bag);
            json.add(report);
            if (!scan) printError(scan.error());
            return scan ? kDone : kRefused;
        };
        ++(guarded(one, kRefused) == kDone ? done : refused);
    }
    return json.ended(codeOf(done, refused));
}

} // namespace

void addInfo(CLI::App& app, int& code) {
    auto info = std::make_shared<Info>();
    CLI::App& command = *app.add_subcommand("info", "Prints what a file holds, as JSON");
    command.add_option("FILE", info->files, "Scans")->required();
    addJsonFlag(command, info->json, "One JSON object per file and line").capture_default_str();
    addReadFlags(command, info->read);
    command.callback([info, &code] { code = run(*info); });
}

} // namespace edgescan::cli
