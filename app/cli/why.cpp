// edgescan-cli why: explains why a cell is an edge or is not an edge.
#include "app/cli/commands.h"
#include "app/shared/json_output.h"
#include "app/shared/options.h"
#include "core/edges/pipeline/pipeline.h"
#include "core/edges/pipeline/work_memory.h"
#include "core/exports/report.h"
#include "core/exports/why_report.h"

#include <nlohmann/json.hpp>

#include <memory>

namespace edgescan::cli {
namespace {

struct WhyFlags {
    std::string file;
    int line = 0;
    int beam = 0;
    ReadFlags read;
    MethodFlags method;
};

Result<Done> explain(const WhyFlags& flags) {
    Result<Scan> opened = openAndWarn(flags.file, flags.read);
    if (!opened) return opened.error();
    if (!opened->rangeMm.contains(flags.line, flags.beam)) {
        return Error{"there is no cell at line " + std::to_string(flags.line) + ", beam " + std::to_string(flags.beam), flags.file,
                     "lines run from 0 to " + std::to_string(opened->lines() - 1) + ", beams from 0 to " +
                         std::to_string(opened->beams() - 1)};
    }
    if (auto enough = edges::checkMemoryFor(edges::Work::Explain, *opened); !enough) return enough.error();
    const Result<edges::Settings> settings = settingsFor(flags.method, *opened);
    if (!settings) return settings.error();
    const auto detection = edges::detectEdges(std::make_shared<const Scan>(std::move(*opened)), *settings);
    const edges::Why why = edges::whyCell(*detection, detection->scan->rangeMm.index(flags.line, flags.beam));
    printResult(document("why", exports::whyReport(*detection, why)), true);
    return Done{};
}

int run(const WhyFlags& flags) {
    const Result<Done> method = checkMethod(flags.method);
    if (!method) {
        printError(method.error());
        return kWrongUsage;
    }
    const Result<Done> result = explain(flags);
    if (result) return kDone;
    printError(result.error());
    return kRefused;
}

} // namespace

void addWhy(CLI::App& app, int& code) {
    auto flags = std::make_shared<WhyFlags>();
    CLI::App& command = *app.add_subcommand("why", "Why a cell is an edge, or why it is none; JSON");
    command.add_option("FILE", flags->file, "Scan")->required();
    constexpr NumberLimits kIndex{0, 1e9};
    addNumber(command, "--line", flags->line, kIndex, "Line of the cell, from 0").required();
    addNumber(command, "--beam", flags->beam, kIndex, "Beam of the cell, from 0").required();
    addMethodFlags(command, flags->method);
    addReadFlags(command, flags->read);
    command.callback([flags, &code] { code = run(*flags); });
}

} // namespace edgescan::cli
