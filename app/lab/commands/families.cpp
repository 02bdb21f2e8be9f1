// edgescan-lab families: scores methods on families of scenes, and judges a change of a method.
#include "app/lab/commands/commands.h"
#include "app/lab/commands/contestants.h"
#include "app/lab/families/family_report.h"
#include "app/lab/reports/comparison_pictures.h"
#include "app/lab/stones/stones.h"
#include "app/shared/exits.h"
#include "app/shared/numbers.h"
#include "app/shared/outputs.h"
#include "core/base/bounded_json.h"
#include "core/base/json_text.h"
#include "core/base/number_text.h"
#include "core/base/sha256.h"
#include "core/base/version.h"
#include "core/base/whole_file.h"
#include "core/containers/png/png.h"
#include "core/edges/pipeline/pipeline.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <memory>

#include <unistd.h>

namespace edgescan::cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kSmallDraw = "small"; // the scenes of the small run are fixed

struct FamiliesAsked {
    std::vector<std::string> only, with, named;
    lab::FamilyRunSettings run;
    std::string shared = "../shared", surface, kinect, store, stones, settled, stoneSet = "lab";
    std::string json, against, record, recorded, pictures;
    bool progress = false;
};

/// A JSON document of an earlier run.
Result<nlohmann::json> earlierDocument(const std::string& path) {
    const auto bytes = readWholeFile(path);
    if (!bytes) return bytes.error();
    return parseJson(textOf(*bytes), path);
}

bool isDocument(const std::string& against) { return against.ends_with(".json"); }

Result<std::vector<const lab::Family*>> askedFamilies(const FamiliesAsked& asked) {
    std::vector<const lab::Family*> chosen;
    for (const std::vector<std::string>* names : {&asked.only, &asked.named}) {
        for (const std::string& name : *names) {
            if (lab::findFamily(name) != nullptr) continue;
            std::string known;
            for (const lab::Family& family : lab::families()) known += (known.empty() ? "" : ", ") + std::string(family.name);
            return Error{"no family is called \"" + name + "\"", names == &asked.only ? "--family" : "--named", "use one of " + known};
        }
    }
    for (const lab::Family& family : lab::families()) {
        const bool wanted = asked.only.empty() || std::ranges::find(asked.only, family.name) != asked.only.end();
        if (wanted && (!asked.run.draw.small || family.small > 0)) chosen.push_back(&family);
    }
    return chosen;
}

lab::FamilyProgress familyProgress(const FamiliesAsked& asked) {
    return [shown = asked.progress || isatty(STDERR_FILENO) != 0](const std::string& scene, std::size_t done, std::size_t total) {
        if (shown) showProgress(std::to_string(done) + " of " + std::to_string(total) + ": " + scene, done == total);
        return !interrupted();
    };
}

/// The scores that this run is compared with, and the name of their contestant.
Result<lab::NamedScores> scoresBefore(const FamiliesAsked& asked, const std::vector<lab::ScoredFamily>& scored,
                                      const nlohmann::json& earlier) {
    const std::vector<lab::Contestant>& contestants = asked.run.contestants;
    if (isDocument(asked.against)) return lab::namedScoresFrom(earlier, contestants.front().name, asked.against);
    const auto one = std::ranges::find(contestants, asked.against, &lab::Contestant::name);
    return lab::namedScores(scored, static_cast<std::size_t>(one - contestants.begin()));
}

Result<int> checkRecord(const FamiliesAsked& asked, const std::vector<lab::ScoredFamily>& scored) {
    if (!asked.record.empty()) {
        Json record{{"schema", "edgescan-families-recorded/1"}, {"made_by", "edgescan-lab families --small --record FILE"}};
        record.update(lab::recordedFigures(scored));
        if (const auto written = writeWholeFile(asked.record, jsonText(record, 1) + "\n"); !written) return written.error();
    }
    if (asked.recorded.empty()) return kDone;
    const auto record = earlierDocument(asked.recorded);
    if (!record) return record.error();
    const auto fallen = lab::fallenFigures(scored, *record, asked.recorded);
    if (!fallen) return fallen.error();
    for (const std::string& sentence : *fallen) printResult(sentence);
    return fallen->empty() ? kDone : kDiffers;
}

/// The first contestant's edges on the scene, as a PNG in the folder.
Result<Done> drawScene(const FamiliesAsked& asked, const lab::MadeScene& scene, const std::string& name) {
    const auto& settings = asked.run.contestants.front().settings;
    if (!scene.truth || !settings) return Done{};
    std::string file = name;
    std::ranges::replace(file, '/', '-');
    const auto detection = edges::detectEdges(scene.scan, *settings);
    return containers::savePngRgb(lab::sceneSheet(*detection, scene.truth->edges, lab::kFamilyTolerance),
                                  std::filesystem::path(asked.pictures) / (file + ".png"));
}

Result<int> runAsked(FamiliesAsked& asked) {
    nlohmann::json earlier;
    if (isDocument(asked.against)) {
        auto document = earlierDocument(asked.against);
        if (!document) return document.error();
        earlier = std::move(*document);
        const auto draw = earlier.find("draw"); // scenes are compared in pairs, so they must be the same
        if (asked.run.draw.text.empty() && draw != earlier.end() && draw->is_string()) asked.run.draw.text = draw->get<std::string>();
    }
    if (asked.run.draw.text.empty()) asked.run.draw.text = asked.run.draw.small ? kSmallDraw : commit();
    const auto program = sha256OfFile("/proc/self/exe");
    if (!program) return program.error();
    asked.run.program = *program;
    const auto scored = lab::runFamilies(
        asked.run, [] { return !interrupted(); }, familyProgress(asked));
    if (!scored) return scored.error();

    Json json = document("families", {{"commit", commit()}, {"draw", asked.run.draw.text}});
    json.update(lab::familiesJson(*scored, asked.run.contestants));
    std::string text = lab::familiesText(*scored, asked.run.contestants);
    int code = kDone;
    if (!asked.against.empty()) {
        const auto before = scoresBefore(asked, *scored, earlier);
        if (!before) return before.error();
        const lab::Verdict verdict = lab::verdictAgainst(*scored, 0, *before, asked.named);
        json["against"] = asked.against;
        json["verdict"] = lab::verdictJson(verdict);
        text += "\n";
        for (const std::string& sentence : verdict.sentences) text += sentence + "\n";
        text += verdict.passes ? "The change passes." : "The change does not pass.";
        if (!verdict.passes) code = kDiffers;
    }
    if (asked.json != "-") printResult(text);
    if (!asked.json.empty()) {
        if (const auto written = writeDocument(asked.json, json); !written) return written.error();
    }
    const Result<int> recorded = checkRecord(asked, *scored);
    return recorded && *recorded == kDone ? Result<int>(code) : recorded;
}

std::optional<Error> wrongUsage(FamiliesAsked& asked) {
    auto contestants = contestantsOf(asked.run.draw.small && asked.with.empty() ? std::vector<std::string>{"default"} : asked.with);
    if (!contestants) return contestants.error();
    asked.run.contestants = std::move(*contestants);
    auto families = askedFamilies(asked);
    if (!families) return families.error();
    asked.run.families = std::move(*families);
    const auto& names = asked.run.contestants;
    if (!asked.against.empty() && !isDocument(asked.against) &&
        std::ranges::find(names, asked.against, &lab::Contestant::name) == names.end())
        return Error{"neither a contestant nor a .json is called \"" + asked.against + "\"", "--against",
                     "give the --json of an earlier run, or the name of a --with"};
    if (!asked.named.empty() && asked.against.empty()) return Error{"nothing is compared", "--named", "give --against too"};
    asked.run.places = {.shared = asked.shared,
                        .surface = asked.surface,
                        .kinect = asked.kinect,
                        .stones = asked.stones,
                        .stoneSet = asked.stoneSet,
                        .settled = asked.settled};
    asked.run.store = asked.store;
    if (asked.pictures.empty()) return std::nullopt;
    if (const auto made = makeFolder(asked.pictures); !made) return made.error();
    asked.run.showFirst = [&asked](const lab::MadeScene& scene, const std::string& name) { return drawScene(asked, scene, name); };
    return std::nullopt;
}

int run(FamiliesAsked& asked) {
    if (const auto wrong = wrongUsage(asked)) return failWith(*wrong, kWrongUsage);
    catchInterrupt();
    const Result<int> code = runAsked(asked);
    if (code) return *code;
    return failWith(code.error());
}

} // namespace

void addFamilies(CLI::App& app, int& code) {
    auto asked = std::make_shared<FamiliesAsked>();
    CLI::App& command = *app.add_subcommand(
        "families", "Scores methods on families of fresh scenes with truth, each made once, and judges a change against an earlier run");
    command
        .add_option("--with", asked->with,
                    "A method by name and flags; the first one is judged. Also a usual name alone; usual are " + usualContestants())
        ->type_name("NAME=FLAGS");
    command.add_option("--family", asked->only, "Only this family; repeat for several")->type_name("NAME");
    lab::SceneDraw& draw = asked->run.draw;
    addNumber(command, "--scenes", draw.fresh, {1, 10000}, "Fresh scenes per family; as many of each of its variants");
    command.add_option("--draw", draw.text, "Text that the seeds are drawn from; usually the commit of the program, or that of --against")
        ->type_name("TEXT");
    command.add_flag("--small", draw.small, "A dozen fixed scenes, by the default method alone, for each change");
    addNumber(command, "--threads", asked->run.threads, {1, 1024}, "Scenes made at a time; as many are in memory");
    command.add_option("--store", asked->store, "Folder for the scores of each scene; an interrupted run goes on from there")
        ->type_name("DIR");
    command.add_option("--shared", asked->shared, "Folder with the data of others; without it their families are skipped")
        ->type_name("DIR")
        ->capture_default_str();
    command.add_option("--surface", asked->surface, "Cloud of a real surface for the re-scans, in place of the one in --shared");
    command.add_option("--stones", asked->stones, "Folder of the meshes of real stones, in place of the one in --shared")->type_name("DIR");
    command.add_option("--settled", asked->settled, "Folder of settled heaps, read and written")->type_name("DIR");
    command.add_option("--stone-set", asked->stoneSet, "Which stones: those that judge (lab), those that may teach (free), or all")
        ->check(CLI::IsMember(lab::stoneSets()))
        ->capture_default_str();
    command.add_option("--kinect", asked->kinect, "Folder with the truth of Kinect clouds, each made by docs/measurements/kinect-truth")
        ->type_name("DIR");
    command
        .add_option("--against", asked->against,
                    "JSON of an earlier run on the same draw, or another method of this run: says whether the change passes (exit code 3 "
                    "if not)")
        ->type_name("FILE|NAME");
    command.add_option("--named", asked->named, "With --against: a family whose counts may change; repeat for several")->type_name("NAME");
    command.add_option("--record", asked->record, "File for the F of each scene, to be compared with later")->type_name("FILE");
    command.add_option("--recorded", asked->recorded, "File of --record: exit code 3 if an F fell by .03 or more")->type_name("FILE");
    addJsonFlag(command, asked->json, "All figures, with those of each scene");
    command
        .add_option("--pictures", asked->pictures,
                    "Folder for a picture of the first scene of each family: found, missed and false edges, and borders and folds")
        ->type_name("DIR");
    command.add_flag("--progress", asked->progress, "Show the progress on stderr, also where that is not a terminal");
    command.callback([asked, &code] { code = run(*asked); });
}

} // namespace edgescan::cli
