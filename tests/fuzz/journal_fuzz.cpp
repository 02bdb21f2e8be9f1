// Any bytes as the journal of a batch: rows, to which a continued run adds its own, or an error sentence.
#include "core/base/bounded_json.h"
#include "core/batch/archive/journal.h"
#include "tests/fuzz/text_file.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>

using namespace edgescan;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    namespace fs = std::filesystem;
    static const fs::path results = fs::temp_directory_path() / ("edgescan-journal-fuzz-" + std::to_string(::getpid()));
    fs::create_directories(results / ".batch");
    std::ofstream(results / ".batch/rows.ndjson", std::ios::binary) << fuzz::textOf(bytes, size);
    const auto rows = batch::readJournals(results);
    if (!rows && !rows.error().sentence().ends_with(".")) std::abort();
    if (rows) {
        for (const auto& [input, row] : *rows) static_cast<void>(batch::pictureOf(nlohmann::ordered_json::parse(row), results));
        auto journal = batch::Journal::open(results, batch::Shard{}, true, "");
        if (!journal) std::abort();
        const nlohmann::ordered_json added{{"input", "added"}, {"times", {{"finished_utc", "9999-12-31T23:59:59.999Z"}}}};
        if (!journal->append(added, "picture")) std::abort();
        const auto more = batch::readJournals(results);
        if (!more || !more->contains("added") || more->size() < rows->size()) std::abort();
    }
    fs::remove_all(results);
    return 0;
}
