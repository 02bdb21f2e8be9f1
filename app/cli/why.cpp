// edgescan-cli why: explains why a cell is an edge or is not an edge.
#include "app/cli/commands.h"
#include "app/shared/numbers.h"
#include "app/shared/options.h"
#include "app/shared/outputs.h"
#include "core/edges/pipeline/pipeline.h"
#include "core/edges/pipeline/work_memory.h"
#include "core/exports/report.h"

#include <nlohmann/json.hpp>

#include <memory>

namespace edgescan::cli {
namespace {

struct WhyFlags {
    std::string file, cell;
    std::string json = "-";
    ReadFlags read;
    MethodFlags method;
};

Result<Done> explain(const WhyFlags& flags) {
    Result<Scan> opened = openAndWarn(flags.file, flags.read);
    if (!opened) return opened.error();
    const Result<std::uint32_t> cell = cellIn(*opened, flags.cell, "--cell");
    if (!cell) return cell.error();
    if (auto enough = edges::checkMemoryFor(edges::Work::Explain, *opened); !enough) return enough.error();
    const Result<edges::Settings> settings = settingsFor(flags.method, *opened);
    if (!settings) return settings.error();
    const auto detection = edges::detectEdges(std::make_shared<const Scan>(std::move(*opened)), *settings);
    const edges::Why why = edges::whyCell(*detection, *cell);
    return writeDocument(flags.json, document("why", exports::whyReport(*detection, why)));
}

int run(const WhyFlags& flags) {
    const Result<Done> method = checkMethodAndWarn(flags.method);
    if (!method) return failWith(method.error(), kWrongUsage);
    const Result<Done> result = explain(flags);
    return result ? kDone : failWith(result.error());
}

} // namespace

void addWhy(CLI::App& app, int& code) {
    auto flags = std::make_shared<WhyFlags>();
    CLI::App& command = *app.add_subcommand("why", "Explains why a cell is an edge, or why it is not, as JSON");
    command.add_option("FILE", flags->file, "Scan")->required();
    command.add_option("--cell", flags->cell, "The cell; lines and beams are counted from 0")
        ->type_name("LINE,BEAM")
        ->check(cellText())
        ->required();
    addJsonFlag(command, flags->json, "What was measured at the cell, and the sentence").capture_default_str();
    addMethodFlags(command, flags->method);
    addReadFlags(command, flags->read);
    command.callback([flags, &code] { code = run(*flags); });
}

} // namespace edgescan::cli
