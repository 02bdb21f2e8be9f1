// edgescan-lab benchmark: every method of the thesis, every PCL peer and EdgeScan+ on one scan in one run.
#include "app/lab/commands/commands.h"
#include "app/lab/commands/compared_methods.h"
#include "app/lab/reports/comparison_pictures.h"
#include "app/lab/reports/comparison_report.h"
#include "app/lab/score/truth_fit.h"
#include "app/shared/outputs.h"
#include "core/base/number_text.h"
#include "core/base/whole_file.h"
#include "core/containers/png/png.h"
#include "core/edges/pipeline/pipeline.h"
#include "core/edges/pipeline/work_memory.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <memory>

namespace edgescan::cli {
namespace {

namespace fs = std::filesystem;

struct Benchmark {
    std::string file, truth, pictures;
    ComparedFlags compared;
};

// "BoundaryEstimation k=30" -> "boundaryestimation-k-30".
std::string fileName(const std::string& name) {
    std::string result;
    for (const char c : asciiLower(name)) {
        const bool plain = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '+';
        if (plain)
            result += c;
        else if (!result.empty() && result.back() != '-')
            result += '-';
    }
    while (!result.empty() && result.back() == '-') result.pop_back();
    return result;
}

Result<Done> savePictures(const Benchmark& asked, const Scan& scan, const std::vector<lab::ComparedMethod>& methods,
                          const std::optional<sim::TruthSet>& truth) {
    const fs::path folder = asked.pictures;
    if (auto made = makeFolder(folder); !made) return made;
    for (const lab::ComparedMethod& method : methods) {
        if (method.edges == 0 && !method.note.empty()) continue;
        if (const Result<Done> saved = containers::savePng8(method.mask, folder / (fileName(method.key) + ".png")); !saved)
            return saved.error();
    }
    if (truth) {
        const Grid<Rgb> sheet = lab::truthSheet(scan, methods, truth->edges, asked.compared.settings.tolerance);
        if (const Result<Done> saved = sheet.size() > 0 ? containers::savePngRgb(sheet, folder / "truth.png") : Done{}; !saved)
            return saved.error();
    }
    return containers::savePngRgb(lab::edgesSheet(scan, methods), folder / "comparison.png");
}

Result<Done> benchmark(const Benchmark& asked) {
    const lab::ComparisonSettings settings = comparisonSettings(asked.compared);
    Result<Scan> opened = openAndWarn(asked.file, asked.compared.read);
    if (!opened) return opened.error();
    if (auto enough = edges::checkMemoryFor(edges::Work::Compare, *opened); !enough) return enough.error();
    const auto scan = std::make_shared<const Scan>(std::move(*opened));
    std::optional<sim::TruthSet> truth;
    if (!asked.truth.empty()) {
        Result<sim::TruthSet> read = sim::readTruth(asked.truth);
        if (!read) return read.error();
        if (read->edges.edgeClass.lines != scan->lines() || read->edges.edgeClass.beams != scan->beams())
            return Error{"the truth is not of this scan's shape", asked.truth, "give the folder that was written with the scan"};
        if (auto fits = lab::checkTruthFits(*scan, *read, asked.truth); !fits) return fits.error();
        truth = std::move(*read);
    }
    const std::vector<lab::ComparedMethod> methods =
        lab::compareMethods(scan, truth ? &*truth : nullptr, settings, shownProgress(asked.compared));
    if (showsProgress(asked.compared)) showProgress("all compared", true);
    if (!asked.pictures.empty()) {
        const Result<Done> saved = savePictures(asked, *scan, methods, truth);
        if (!saved) return saved.error();
    }
    const std::string& json = asked.compared.json;
    if (json != "-") printResult(lab::comparisonText(*scan, methods));
    if (json.empty()) return Done{};
    return writeDocument(json, document("benchmark", lab::comparisonReport(*scan, methods, settings)));
}

int run(const Benchmark& asked) {
    std::optional<Error> wrong = unknownKey(asked.compared);
    if (!wrong && asked.compared.settings.bestThreshold && asked.truth.empty())
        wrong = Error{"without truth no threshold is the best", "--best", "give --truth DIR too"};
    if (wrong) return failWith(*wrong, kWrongUsage);
    const Result<Done> result = benchmark(asked);
    if (!result) printError(result.error());
    return result ? kDone : kRefused;
}

} // namespace

void addBenchmark(CLI::App& app, int& code) {
    auto asked = std::make_shared<Benchmark>();
    CLI::App& command = *app.add_subcommand("benchmark", "Runs every method of the thesis, the PCL peers and EdgeScan+ on one scan");
    command.add_option("SCAN", asked->file, "Scan")->required();
    CLI::Option* truth =
        command.add_option("--truth", asked->truth, "Folder with ground truth of simulate --truth: also scores")->type_name("DIR");
    command
        .add_option("--pictures", asked->pictures,
                    "Folder for a labelled sheet (comparison.png), with truth one of cells found, missed and false (truth.png), and one "
                    "mask per method")
        ->type_name("DIR");
    lab::ComparisonSettings& settings = asked->compared.settings;
    addNumber(command, "--tolerance", settings.tolerance, {0, 20}, "How far a detection may lie from a true edge [cells]").needs(truth);
    command.add_flag("--best", settings.bestThreshold, "With truth: also each method's score at its best threshold for this scan");
    addNumber(command, "--repeats", settings.repeats, {1, 1000},
              "Runs of each of our methods, interleaved; medians of thread CPU time are reported");
    addComparedFlags(command, asked->compared);
    command.callback([asked, &code] { code = run(*asked); });
}

} // namespace edgescan::cli
