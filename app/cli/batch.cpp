// edgescan-cli batch: runs the method over a whole archive. An interrupted run can be continued (docs/reference/batch.md).
#include "app/cli/batch_scan.h"
#include "app/cli/commands.h"
#include "app/cli/export_flags.h"
#include "app/shared/exits.h"
#include "app/shared/outputs.h"
#include "core/base/bounded_json.h"
#include "core/base/foreign_text.h"
#include "core/base/inputs.h"
#include "core/base/json_text.h"
#include "core/base/number_text.h"
#include "core/base/sha256.h"
#include "core/base/version.h"
#include "core/base/whole_file.h"
#include "core/batch/archive/output_names.h"
#include "core/batch/archive/results_table.h"
#include "core/batch/archive/worker_processes.h"
#include "core/edges/pipeline/pipeline.h"
#include "core/edges/settings/parameters.h"
#include "core/exports/html/survey_page.h"
#include "core/rocks/attributes/attributes.h"

#include <nlohmann/json.hpp>

#include <sched.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <memory>
#include <set>
#include <span>

namespace edgescan::cli {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using Clock = std::chrono::steady_clock;

struct Batch {
    std::vector<std::string> asked;
    std::string json = "-";
    std::string results, wanted = "mask,json", names = "{path}", shard;
    int jobs = 0;
    double memoryGb = 0, timeLimit = 3600;
    bool noSidecars = false, noSurvey = false, withRocks = false, merge = false, retry = false, trustTimes = false;
    ReadFlags read;
    WriteFlags write;
    MethodFlags method;
    RockFlags rocks;
};

int processors() {
    cpu_set_t set;
    return ::sched_getaffinity(0, sizeof set, &set) == 0 ? std::max(1, CPU_COUNT(&set)) : 1;
}

std::uint64_t memoryOfJob(const Batch& batch, int jobs) {
    if (batch.memoryGb > 0) return static_cast<std::uint64_t>(batch.memoryGb * 1e9);
    const auto pages = static_cast<std::uint64_t>(std::max(0L, ::sysconf(_SC_PHYS_PAGES)));
    return pages * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE)) / 5 * 4 / static_cast<std::uint64_t>(jobs);
}

// Everything except the scan that can change a result.
Result<Json> settingsOfRun(const Batch& batch) {
    const Result<edges::Preset> preset = presetOf(batch.method);
    if (!preset) return preset.error();
    Json choices = Json::array();
    for (const files::WritingChoice& choice : files::kWritingChoices) {
        if (batch.write.choices.*choice.member) choices.push_back(choice.key);
    }
    Json settings{{"program", std::string(version()) + " " + commit()},
                  {"preset", edges::settingsToJson(preset->settings)},
                  {"typed", typedFlags(batch.method)},
                  {"reading", readingFlags(batch.read.options)},
                  {"results", batch.wanted},
                  {"sidecars", !batch.noSidecars},
                  {"names", batch.names},
                  {"writing", {batch.write.frame, batch.write.ascii, batch.write.includeAttached, choices}},
                  {"operator", {batch.write.operatorName, batch.write.role}}};
    if (batch.withRocks) settings["rocks"] = typedFlags(batch.rocks);
    return settings;
}

std::string leftOutText(const std::vector<std::string>& files) {
    const std::string first = printable(files.front());
    if (files.size() == 1)
        return first + ": this file is not a scan but a record or an export, and is left out; name it singly to have it read.";
    return first + ": this and " + std::to_string(files.size() - 1) +
           " more files are not scans but records or exports, and are left out; name them singly to have them read.";
}

constexpr std::array kTables{"results.csv", "results.ndjson", "settings.json", "survey.html"};

/// Of a first run in a folder that another command wrote to.
void warnOfOtherFiles(const fs::path& results) {
    std::error_code problem;
    if (fs::exists(results / ".batch", problem)) return;
    std::vector<std::string> others;
    for (fs::directory_iterator entry(results, problem), end; !problem && entry != end; entry.increment(problem)) {
        const std::string name = entry->path().filename().string();
        if (!entry->is_directory(problem) && !name.starts_with('.') && std::ranges::find(kTables, name) == kTables.end())
            others.push_back(name);
    }
    if (others.empty()) return;
    printError(Error{"this folder holds files that batch did not write, such as " + *std::ranges::min_element(others), results.string(),
                     "the run goes on; next time give -o a folder that is used for nothing else"});
}

/// Of results of another run in the folder, which the tables will not name, or which are made again.
void warnOfOtherRuns(const Batch& batch, const BatchWork& work) {
    const std::set<std::string_view> inputs(work.inputs.begin(), work.inputs.end());
    std::size_t others = 0, otherwise = 0;
    for (const auto& [input, text] : work.before) {
        const bool isOurs = inputs.contains(input);
        others += isOurs ? 0 : 1;
        const auto row = parseOrderedJson(text, "");
        otherwise += isOurs && row && row->value("settings_sha256", "") != work.settingsSha256 ? 1 : 0;
    }
    const auto say = [&](std::size_t scans, const char* what, const char* hint) {
        if (scans > 0) printError(Error{"it holds the results of " + counted(scans, "scan") + " " + what, batch.results, hint});
    };
    if (batch.shard.empty() && !batch.merge)
        say(others, "of other inputs", "the tables leave these out; give -o another folder to keep them apart");
    if (!batch.merge) say(otherwise, "with other settings", "these are made again; give -o another folder to keep both");
}

Result<BatchWork> planned(const Batch& batch, const Json& settings) {
    const auto listing = batch::listArchive(batch.asked, batch.results);
    if (!listing) return listing.error();
    const auto names = batch::outputNames(listing->inputs, batch.names);
    if (!names) return names.error();
    const auto wanted = wantedFiles(batch.wanted);
    const Result<batch::Shard> shard = batch.shard.empty() ? Result<batch::Shard>(batch::Shard{}) : batch::shardOf(batch.shard);
    if (!wanted) return wanted.error();
    if (!shard) return shard.error();
    BatchWork work;
    for (std::size_t i = 0; i < listing->inputs.size(); ++i) {
        if (!shard->holds(listing->inputs[i])) continue;
        work.inputs.push_back(listing->inputs[i]);
        work.names.push_back((*names)[i]);
    }
    if (!listing->leftOut.empty()) printError(leftOutText(listing->leftOut));
    for (const batch::ArchiveListing::NotRead& one : listing->notRead) printError(printable(one.path) + ": " + one.why + ".");
    for (const std::string& input : listing->inputs) claimInput(input); // no table and no result replaces a scan
    for (const std::string& asked : batch.asked) claimInput(asked);     // or a list
    for (const char* table : kTables) {
        if (auto free = checkIsNoInput(fs::path(batch.results) / table); !free) return free.error();
    }
    if (auto one = checkOnePose(listing->inputs, batch.read); !one) return one.error();
    work.results = batch.results;
    work.read = batch.read;
    work.method = batch.method;
    work.write = batch.write;
    work.wanted = *wanted;
    work.withRocks = batch.withRocks;
    work.rocks = batch.rocks;
    const std::string text = jsonText(settings);
    work.settingsSha256 = sha256Hex(std::as_bytes(std::span(text)));
    work.sidecars = !batch.noSidecars;
    work.retry = batch.retry;
    work.trustTimes = batch.trustTimes || batch.merge;
    return work;
}

struct Counts {
    std::size_t done = 0, refused = 0, failed = 0, unchanged = 0;
    [[nodiscard]] std::size_t ended() const { return done + refused + failed + unchanged; }
};

std::string clockText(double seconds) {
    const auto whole = static_cast<long long>(seconds + 0.5);
    const auto two = [](long long n) { return (n < 10 ? "0" : "") + std::to_string(n); };
    return (whole >= 3600 ? std::to_string(whole / 3600) + ":" + two(whole / 60 % 60) : std::to_string(whole / 60)) + ":" + two(whole % 60);
}

class ProgressLine {
public:
    ProgressLine(bool shown, std::size_t scans) : shown_(shown), scans_(scans) {}
    void show(const Counts& counts) {
        const auto now = Clock::now();
        const bool last = counts.ended() == scans_;
        if (!shown_ || (!last && now - shownAt_ < std::chrono::milliseconds(200))) return;
        shownAt_ = now;
        const double seconds = std::chrono::duration<double>(now - start_).count();
        const auto worked = static_cast<double>(counts.ended() - counts.unchanged);
        std::string text = std::to_string(counts.ended()) + "/" + std::to_string(scans_) + " scans";
        if (counts.unchanged > 0) text += ", " + std::to_string(counts.unchanged) + " unchanged";
        if (counts.refused + counts.failed > 0) text += ", " + std::to_string(counts.refused + counts.failed) + " not done";
        if (worked > 0) text += ", " + fixedText(worked / seconds, 1) + "/s";
        const double each = seconds / static_cast<double>(std::max<std::size_t>(1, counts.ended()));
        if (!last) text += ", " + clockText(each * static_cast<double>(scans_ - counts.ended())) + " left";
        showProgress(text, last);
    }

private:
    bool shown_;
    std::size_t scans_;
    Clock::time_point start_ = Clock::now(), shownAt_;
};

/// The state of a run.
struct Running {
    const BatchWork& work;
    batch::Journal& journal;
    Counts counts;
    std::optional<Error> stop; ///< the journal can no longer be written
};

void noteEnd(Running& running, const batch::JobEnd& end) {
    if (end.answer && end.answer->empty()) {
        ++running.counts.unchanged;
        return;
    }
    Json row;
    std::string picture;
    if (end.answer) {
        const std::size_t line = end.answer->find('\n');
        auto parsed = parseOrderedJson(std::string_view(*end.answer).substr(0, line), "");
        if (parsed) row = std::move(*parsed);
        picture = end.answer->substr(std::min(line + 1, end.answer->size()));
    } else {
        row = failedRow(running.work, end.job, end.death);
    }
    if (!row.is_object()) row = failedRow(running.work, end.job, "its answer is not a row");
    const std::string outcome = row.value("outcome", "");
    ++(outcome == "done" ? running.counts.done : outcome == "refused" ? running.counts.refused : running.counts.failed);
    if (row.contains("error") && row["error"].is_string()) printError(row["error"].get<std::string>());
    if (const auto noted = running.journal.append(row, picture); !noted && !running.stop) running.stop = noted.error();
}

Result<Done> workThrough(const Batch& batch, const BatchWork& work, int jobs, Running& running) {
    ProgressLine progress(batch.read.progress || isatty(STDERR_FILENO) != 0, work.inputs.size());
    std::size_t next = 0;
    batch::Jobs run;
    run.next = [&]() -> std::optional<std::size_t> { return next < work.inputs.size() ? std::optional(next++) : std::nullopt; };
    run.work = [&](std::size_t job, int worker) { return scanForArchive(work, job, worker); };
    run.ended = [&](const batch::JobEnd& end) {
        noteEnd(running, end);
        progress.show(running.counts);
    };
    run.goOn = [&] { return !interrupted() && !running.stop; };
    const auto ended = batch::runInProcesses({jobs, work.memoryBytes, batch.timeLimit}, run);
    if (running.stop) return *running.stop;
    return ended;
}

// The newest row of each input, in order. An input without a row, or with a row of other settings, is missing.
struct AllRows {
    std::vector<std::string> rows;
    std::vector<std::string> missing;
};
Result<AllRows> allRows(const BatchWork& work) {
    auto rows = batch::readJournals(work.results);
    if (!rows) return rows.error();
    AllRows all;
    for (const std::string& input : work.inputs) {
        const auto found = rows->find(input);
        const auto row = found == rows->end() ? Result<Json>(Json()) : parseOrderedJson(found->second, "");
        if (row && row->is_object() && row->value("settings_sha256", "") == work.settingsSha256)
            all.rows.push_back(std::move(found->second));
        else
            all.missing.push_back(input);
    }
    return all;
}

Result<Done> writeTables(const Batch& batch, const Json& settings, const std::vector<std::string>& rows) {
    const fs::path folder = batch.results;
    std::vector<std::pair<fs::path, std::string>> files{{folder / "results.csv", batch::csvTable(rows)},
                                                        {folder / "results.ndjson", batch::ndjsonTable(rows)},
                                                        {folder / "settings.json", jsonText(settings, 2) + "\n"}};
    if (!batch.noSurvey) {
        const auto picture = [&](const std::string& text) {
            const auto row = parseOrderedJson(text, "");
            return row ? batch::pictureOf(*row, folder) : std::string();
        };
        files.emplace_back(folder / "survey.html",
                           exports::surveyPage("Survey of " + std::to_string(rows.size()) + " scans", rows, picture));
    }
    std::vector<FileContent> contents;
    for (const auto& [path, text] : files) contents.push_back({path, std::as_bytes(std::span(text))});
    return writeWholeFiles(contents);
}

/// What to run before the merge.
std::string hintOfMerge(const Json& elements, int of, bool isFirst) {
    if (isFirst) return "no part has run yet: run each part with --shard N/PARTS, or all at once without --merge";
    if (elements.empty()) return "run the same command without --merge";
    std::string parts;
    for (const Json& element : elements)
        parts += (parts.empty() ? "" : ", ") + std::to_string(element.get<int>()) + "/" + std::to_string(of);
    return "run again with --shard " + parts + ", then the merge";
}

// The elements of an array job that must run again.
Json elementsOf(const std::vector<std::string>& missing, int of) {
    Json elements = Json::array();
    for (int i = 1; of > 1 && i <= of; ++i) {
        if (std::ranges::any_of(missing, [&](const std::string& input) { return batch::Shard{i, of}.holds(input); })) elements.push_back(i);
    }
    return elements;
}

int report(const Batch& batch, const Running& running, const AllRows& all, double seconds) {
    std::size_t refused = 0, failed = 0;
    Json frames = Json::object(); // files with coordinates, by frame
    for (const std::string& text : all.rows) {
        const auto row = parseOrderedJson(text, "");
        const std::string outcome = row ? row->value("outcome", "") : "";
        refused += outcome == "refused" ? 1 : 0;
        failed += outcome == "failed" ? 1 : 0;
        for (const Json& output : row ? row->value("outputs", Json::array()) : Json::array()) {
            if (!output.contains("frame")) continue;
            Json& files = frames[output.value("frame", "")];
            files = files.is_null() ? 1 : files.get<int>() + 1;
        }
    }
    Json report{{"results", batch.results},
                {"scans", running.work.inputs.size()},
                {"done", all.rows.size() - refused - failed},
                {"refused", refused},
                {"failed", failed},
                {"missing", all.missing.size()},
                {"frames", frames},
                {"unchanged", running.counts.unchanged},
                {"worked", running.counts.ended() - running.counts.unchanged},
                {"seconds", static_cast<double>(static_cast<long long>(seconds * 1000)) / 1000}};
    const int parts = batch.merge ? batch::shardsIn(batch.results) : 1;
    const Json elements = elementsOf(all.missing, parts);
    if (batch.merge) report["missing_elements"] = elements;
    if (const auto written = writeDocument(batch.json, document("batch", report), false); !written) return failWith(written.error());
    if (!all.missing.empty()) {
        printError(Error{counted(all.missing.size(), "scan has", "scans have") + " no row yet, so no table was written", batch.results,
                         batch.merge ? hintOfMerge(elements, parts, running.work.before.empty())
                                     : "run the same command again: it goes on from here"});
        return kRefused;
    }
    return refused + failed > 0 ? kPartly : kDone;
}

Result<int> runPlan(const Batch& batch, BatchWork& work, const Json& settings) {
    const auto start = Clock::now();
    const batch::Shard shard = batch.shard.empty() ? batch::Shard{} : *batch::shardOf(batch.shard);
    auto journal = batch::Journal::open(batch.results, shard, batch.shard.empty(), batch.merge ? "" : work.settingsSha256);
    if (!journal) return journal.error();
    if (const std::string& parts = journal->otherSettings(); !parts.empty())
        printError(printable(batch.results) + ": other settings were used in " + parts + "; run these again before the merge.");
    work.workFolder = journal->workFolder();
    auto before = batch::readJournals(batch.results);
    if (!before) return before.error();
    work.before = std::move(*before);
    warnOfOtherRuns(batch, work);
    const int jobs = batch.jobs > 0 ? batch.jobs : processors();
    work.memoryBytes = memoryOfJob(batch, jobs);
    Running running{work, *journal, {}, {}};
    if (!batch.merge) {
        catchInterrupt();
        if (auto worked = workThrough(batch, work, jobs, running); !worked) return worked.error();
    }
    const auto all = allRows(work);
    if (!all) return all.error();
    if (all->missing.empty() && batch.shard.empty()) {
        if (auto written = writeTables(batch, settings, all->rows); !written) return written.error();
    }
    return report(batch, running, *all, std::chrono::duration<double>(Clock::now() - start).count());
}

int run(Batch& batch) {
    const edges::Pipeline
        withoutThreads; // checking the settings smooths a step; if that started a thread pool, every forked worker would hang
    if (const auto folder = checkFolder(batch.results); !folder) return failWith(folder.error(), kWrongUsage);
    if (const auto method = checkMethodAndWarn(batch.method); !method) return failWith(method.error(), kWrongUsage);
    const auto wanted = wantedFiles(batch.wanted);
    if (!wanted) return failWith(wanted.error(), kWrongUsage);
    if (const auto names = batch::outputNames({}, batch.names); !names) return failWith(names.error(), kWrongUsage);
    std::vector<WantedExport> written;
    for (const WantedFile& file : *wanted) {
        if (file.kind != nullptr)
            written.push_back({file.kind, exports::exportFileName(*file.kind, file.extension, CoordinateFrame::Mine)});
    }
    WriteFlags ofFiles = batch.write;
    if (std::ranges::any_of(*wanted, [](const WantedFile& file) { return file.extension == ".html"; }))
        ofFiles.operatorName = ofFiles.role = ""; // the report names them
    if (batch.noSidecars && written.empty())
        return failWith({"no file that is written has a record", "--no-sidecars", "leave it out, or add a picture or a cloud to --results"},
                        kWrongUsage);
    if (const auto one = checkOnePose(batch.asked, batch.read); !one) return failWith(one.error(), kWrongUsage);
    if (const auto used = checkWriting(ofFiles, written, batch.method); !used) return failWith(used.error(), kWrongUsage);
    batch.withRocks = batch.withRocks || std::ranges::any_of(*wanted, &WantedFile::isOfRocks);
    if (const auto rocks = checkRocks(batch.rocks); !rocks) return failWith(rocks.error(), kWrongUsage);
    if (!batch.withRocks && anyTyped(batch.rocks))
        return failWith({"these flags are of rocks, and none are asked for", typedFlags(batch.rocks), "add --rocks, or a result of rocks"},
                        kWrongUsage);
    if (!batch.shard.empty()) {
        if (const auto shard = batch::shardOf(batch.shard); !shard) return failWith(shard.error(), kWrongUsage);
        if (batch.merge) return failWith({"a merge is of all parts", "--shard", "leave one of the two out"}, kWrongUsage);
    }
    const auto settings = settingsOfRun(batch);
    if (!settings) return failWith(settings.error(), kWrongUsage);
    auto work = planned(batch, *settings);
    if (!work) return failWith(work.error());
    warnOfOtherFiles(batch.results);
    if (const auto can = checkOutputs(std::array{batch.json}); !can) return failWith(can.error());
    const auto code = runPlan(batch, *work, *settings);
    return code ? *code : failWith(code.error());
}

void addFlags(CLI::App& command, Batch& batch) {
    command.add_option("INPUT", batch.asked, "Folders, lists of paths, patterns in quotes, or scans; - is a list on standard input")
        ->required();
    const char* group = "Results";
    std::string fields;
    for (const batch::NameField& field : batch::nameFields())
        fields += (fields.empty() ? "{" : ", {") + std::string(field.key) + "} " + field.help;
    command.add_option("-o,--output", batch.results, "Folder for tables and results, used for nothing else")
        ->type_name("DIR")
        ->required()
        ->group(group);
    addJsonFlag(command, batch.json, "Counts of the run").capture_default_str()->group(group);
    command.add_option("--results", batch.wanted, "What is written of each scan: " + wantedWords() + "; none for the table alone")
        ->type_name("NAME,...")
        ->capture_default_str()
        ->group(group);
    command.add_option("--names", batch.names, "The folder of each scan's results: " + fields)
        ->type_name("PATTERN")
        ->capture_default_str()
        ->group(group);
    command.add_flag("--no-sidecars", batch.noSidecars, "Write no records next to pictures and clouds")->group(group);
    command.add_flag("--no-survey", batch.noSurvey, "Write no survey.html")->group(group);
    group = "Run";
    addNumber(command, "--jobs", batch.jobs, {0, 1024}, "Scans at the same time; 0 = one per processor").group(group);
    addNumber(command, "--memory", batch.memoryGb, {0, 100'000}, "Most memory of one job [GB]; 0 = its share of four fifths of all")
        .group(group);
    addNumber(command, "--time-limit", batch.timeLimit, kSeconds, "Time after which a scan is given up [s]; 0 = never").group(group);
    command.add_flag("--retry", batch.retry, "Try refused scans again, although they did not change")->group(group);
    command.add_flag("--trust-times", batch.trustTimes, "Skip hashing where size and modification time are the same")->group(group);
    command.add_option("--shard", batch.shard, "Only this part of the run; --merge joins the parts")->type_name("N/PARTS")->group(group);
    command.add_flag("--merge", batch.merge, "Write only the tables, when all parts have run")->group(group);
}

} // namespace

void addBatch(CLI::App& app, int& code) {
    auto batch = std::make_shared<Batch>();
    CLI::App& command = *app.add_subcommand("batch", "Finds the edges of all scans of an archive; continues where it was interrupted");
    addFlags(command, *batch);
    command.add_flag("--rocks", batch->withRocks, std::string("Rocks of every scan, with their sizes in the table: ") + rocks::kRockCaveat)
        ->group("Rocks");
    addRockFlags(command, batch->rocks, false);
    addMethodFlags(command, batch->method);
    addReadFlags(command, batch->read);
    addWriteFlags(command, batch->write);
    command.callback([batch, &code] {
        if (batch->wanted == "none") batch->wanted.clear();
        code = run(*batch);
    });
}

} // namespace edgescan::cli
