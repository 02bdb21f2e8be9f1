// Reads and writes targets and measurements.
#include "core/inspect/measure/notebook.h"

#include "core/base/bounded_json.h"
#include "core/base/json_fields.h"
#include "core/base/json_text.h"
#include "core/base/sha256.h"
#include "core/base/utc_time.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <set>
#include <span>

namespace edgescan::inspect {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kNotebookFormat = "edgescan-targets/1";
constexpr const char* kNotebookHint = "move the file away to begin a new one";
constexpr std::size_t kMostRows = 40;
constexpr std::size_t kLongestRow = 200; // bytes

Json cellJson(std::uint32_t k, int beams) {
    const auto width = static_cast<std::uint32_t>(beams);
    return Json::array({k / width, k % width});
}

Json cellsJson(const std::vector<std::uint32_t>& cells, int beams) {
    Json list = Json::array();
    for (const std::uint32_t k : cells) list.push_back(cellJson(k, beams));
    return list;
}

/// "[line, beam]" of the grid.
std::uint32_t cellFrom(JsonFields& fields, const nlohmann::json& pair, const NotebookScan& scan) {
    const bool isPair = pair.is_array() && pair.size() == 2 && pair[0].is_number_unsigned() && pair[1].is_number_unsigned();
    if (!isPair || pair[0] >= scan.lines || pair[1] >= scan.beams) {
        fields.refuse("cell", "must be [line, beam] of a cell of the scan");
        return 0;
    }
    return pair[0].get<std::uint32_t>() * static_cast<std::uint32_t>(scan.beams) + pair[1].get<std::uint32_t>();
}

std::string shortText(JsonFields& fields, const char* key, std::size_t most) {
    std::string text = fields.text(key);
    if (text.size() > most) fields.refuse(key, "must be no longer than " + std::to_string(most) + " bytes");
    return text;
}

PinnedTarget targetFrom(JsonFields& fields, const NotebookScan& scan) {
    PinnedTarget target;
    target.number = static_cast<int>(fields.wholeNumber("number", 1, 1'000'000));
    target.name = shortText(fields, "name", kLongestTargetName);
    target.note = shortText(fields, "note", kLongestTargetNote);
    target.cell = cellFrom(fields, fields.value("cell"), scan);
    if (fields.has("clicked")) target.clicked = cellFrom(fields, fields.value("clicked"), scan);
    target.locked = fields.boolean("locked", false);
    target.pinnedUtc = fields.text("pinned_utc");
    if (!target.pinnedUtc.empty() && !parseUtc(target.pinnedUtc))
        fields.refuse("pinned_utc", "must be a time such as 2026-11-20T10:15:30Z");
    const nlohmann::json& rows = fields.value("as_pinned");
    const auto isRow = [](const nlohmann::json& row) {
        return row.is_array() && row.size() == 2 && row[0].is_string() && row[1].is_string() &&
               row[0].get_ref<const std::string&>().size() <= kLongestRow && row[1].get_ref<const std::string&>().size() <= kLongestRow;
    };
    if (!rows.is_null() && (!rows.is_array() || rows.size() > kMostRows || !std::ranges::all_of(rows, isRow)))
        fields.refuse("as_pinned", "must be a list of pairs of short texts");
    else
        for (const nlohmann::json& row : rows) target.asPinned.emplace_back(row[0].get<std::string>(), row[1].get<std::string>());
    return target;
}

/// The list has one cell for each click.
std::vector<std::uint32_t> cellsFrom(JsonFields& fields, const char* key, MeasureKind kind, const NotebookScan& scan) {
    std::vector<std::uint32_t> list;
    const nlohmann::json& cells = fields.value(key);
    if (!cells.is_array() || cells.size() != traitsOf(kind).cells)
        fields.refuse(key, "must have as many cells as its kind takes");
    else
        for (const nlohmann::json& cell : cells) list.push_back(cellFrom(fields, cell, scan));
    return list;
}

std::vector<double> sharesFrom(JsonFields& fields) {
    std::vector<double> shares;
    const nlohmann::json& list = fields.value("shares");
    const auto isShare = [](const nlohmann::json& share) { return share.is_number() && share >= 0.0 && share <= 1.0; };
    if (!list.is_array() || list.size() != 2 || !std::ranges::all_of(list, isShare))
        fields.refuse("shares", "must be two numbers from 0 to 1");
    else
        for (const nlohmann::json& share : list) shares.push_back(share.get<double>());
    return shares;
}

StoredMeasure measureFrom(JsonFields& fields, const NotebookScan& scan) {
    StoredMeasure measure;
    const std::string key = fields.text("kind");
    const auto kind = measureKindNamed(key);
    if (!kind) fields.refuse("kind", "must be distance, vertical, angle, spans, path, throat or section");
    measure.kind = kind.value_or(MeasureKind::Distance);
    measure.cells = cellsFrom(fields, "cells", measure.kind, scan);
    if (fields.has("clicked")) measure.clicked = cellsFrom(fields, "clicked", measure.kind, scan);
    if (measure.kind == MeasureKind::Section) measure.shares = sharesFrom(fields);
    if (fields.has("number")) measure.number = static_cast<int>(fields.wholeNumber("number", 1, 1'000'000));
    return measure;
}

bool samePlace(const PinnedTarget& one, const PinnedTarget& other) { return one.cell == other.cell && one.pinnedUtc == other.pinnedUtc; }
bool samePlace(const StoredMeasure& one, const StoredMeasure& other) { return one.kind == other.kind && one.cells == other.cells; }

template <class Entry>
bool isOneEntry(const Entry& one, const Entry& other) {
    return samePlace(one, other) && one.number == other.number;
}

/// What `entry`, one of `own`, is in `others`: it may have another number there. Of several alike each has one partner.
template <class Entry>
const Entry* partnerOf(const Entry& entry, const std::vector<Entry>& own, const std::vector<Entry>& others) {
    const auto same = std::ranges::find_if(others, [&](const Entry& other) { return isOneEntry(entry, other); });
    if (same != others.end()) return &*same;
    const auto renumbered = std::ranges::find_if(others, [&](const Entry& other) {
        return samePlace(entry, other) && std::ranges::none_of(own, [&](const Entry& one) { return isOneEntry(one, other); });
    });
    return renumbered == others.end() ? nullptr : &*renumbered;
}

template <class Entry>
std::vector<Entry> mergedEntries(const std::vector<Entry>& base, const std::vector<Entry>& mine, const std::vector<Entry>& theirs) {
    std::vector<Entry> merged;
    int most = 0;
    for (const std::vector<Entry>* side : {&base, &mine, &theirs}) {
        for (const Entry& entry : *side) most = std::max(most, entry.number);
    }
    for (const Entry& entry : mine) {
        const Entry* before = partnerOf(entry, mine, base);
        const Entry* there = partnerOf(entry, mine, theirs);
        const bool same = before != nullptr && entry == *before;
        if (same && there == nullptr) continue; // removed there
        merged.push_back(same ? *there : entry);
        if (there != nullptr)
            merged.back().number = there->number;
        else if (std::ranges::find(theirs, entry.number, &Entry::number) != theirs.end())
            merged.back().number = ++most;
    }
    for (const Entry& entry : theirs) {
        const Entry* before = partnerOf(entry, theirs, base);
        if (partnerOf(entry, theirs, mine) == nullptr && (before == nullptr || entry != *before)) merged.push_back(entry);
    }
    return merged;
}

template <class Entry>
void keepPlaces(std::vector<Entry>& entries, const std::vector<Entry>& some, const std::vector<Entry>& more) {
    std::erase_if(entries, [&](const Entry& entry) {
        const auto isThere = [&](const Entry& one) { return samePlace(entry, one); };
        return std::ranges::none_of(some, isThere) && std::ranges::none_of(more, isThere);
    });
}

/// Checks that the notebook was made on this scan.
Result<Done> checkScan(JsonFields fields, const NotebookScan& scan, const std::string& where) {
    const NotebookScan of{fields.text("sha256"), fields.text("name"), static_cast<int>(fields.wholeNumber("lines", 1, INT32_MAX)),
                          static_cast<int>(fields.wholeNumber("beams", 1, INT32_MAX))};
    fields.done();
    if (fields.problem()) return *fields.problem();
    if (of.sha256 == scan.sha256 && of.name == scan.name && of.lines == scan.lines && of.beams == scan.beams) return Done{};
    return Error{"these targets were picked on another scan", where, kNotebookHint};
}

} // namespace

std::optional<MeasuredCells> measureStored(const Scan& scan, const RangeNoise& noise, const StoredMeasure& measure) {
    auto measured = measureCells(scan, noise, measure.kind, measure.cells, measure.shares);
    if (measured) measureClicks(scan, measure.cells, measure.clicked, *measured);
    return measured;
}

Notebook mergedNotebook(const Notebook& base, const Notebook& mine, const Notebook& theirs) {
    Notebook merged{mergedEntries(base.targets, mine.targets, theirs.targets),
                    mergedEntries(base.measures, mine.measures, theirs.measures)};
    std::ranges::sort(merged.measures, {}, &StoredMeasure::number);
    return merged;
}

Notebook withOthers(const Notebook& value, const Notebook& opposite, const Notebook& now) {
    Notebook own = now;
    keepPlaces(own.targets, value.targets, opposite.targets);
    keepPlaces(own.measures, value.measures, opposite.measures);
    return mergedNotebook(own, value, now);
}

int nextNumber(const Notebook& notebook) {
    int most = 0;
    for (const PinnedTarget& target : notebook.targets) most = std::max(most, target.number);
    return most + 1;
}

int nextMeasureNumber(const Notebook& notebook) { return notebook.measures.empty() ? 1 : notebook.measures.back().number + 1; }

std::string measureName(const StoredMeasure& measure) { return "M" + std::to_string(measure.number); }

NotebookScan notebookScan(const Scan& scan) { return {scan.sha256, scan.name, scan.lines(), scan.beams()}; }

std::string notebookFileName(const NotebookScan& scan) {
    if (scan.sha256.empty()) return {};
    const std::string key = scan.sha256 + "\n" + scan.name;
    return sha256Hex(std::as_bytes(std::span(key))) + ".json";
}

std::string notebookText(const Notebook& notebook, const NotebookScan& scan) {
    Json targets = Json::array();
    for (const PinnedTarget& target : notebook.targets) {
        Json rows = Json::array();
        for (const auto& [row, value] : target.asPinned) rows.push_back(Json::array({row, value}));
        targets.push_back({{"number", target.number},
                           {"name", target.name},
                           {"cell", cellJson(target.cell, scan.beams)},
                           {"locked", target.locked},
                           {"pinned_utc", target.pinnedUtc},
                           {"as_pinned", std::move(rows)}});
        if (target.clicked) targets.back()["clicked"] = cellJson(*target.clicked, scan.beams);
        if (!target.note.empty()) targets.back()["note"] = target.note; // an earlier version refuses the key
    }
    Json measures = Json::array();
    for (const StoredMeasure& measure : notebook.measures) {
        measures.push_back({{"kind", traitsOf(measure.kind).key}, {"cells", cellsJson(measure.cells, scan.beams)}});
        if (!measure.clicked.empty()) measures.back()["clicked"] = cellsJson(measure.clicked, scan.beams);
        if (!measure.shares.empty()) measures.back()["shares"] = measure.shares;
        if (measure.number > 0 && measure.number != static_cast<int>(measures.size()))
            measures.back()["number"] = measure.number; // an earlier version refuses it
    }
    const Json whole{{"format", kNotebookFormat},
                     {"scan", {{"sha256", scan.sha256}, {"name", scan.name}, {"lines", scan.lines}, {"beams", scan.beams}}},
                     {"targets", std::move(targets)},
                     {"measures", std::move(measures)}};
    return asciiJsonText(whole, 1) + "\n";
}

Result<Notebook> notebookFromText(std::string_view text, const NotebookScan& scan, const std::string& where) {
    const auto object = parseJson(text, where, kSettingsJson);
    if (!object) return object.error();
    if (!object->is_object() || !object->contains("format") || (*object)["format"] != kNotebookFormat)
        return Error{std::string("these are not targets (") + kNotebookFormat + ")", where,
                     "give the file of targets that the viewer wrote"};
    JsonFields fields(*object, where, kNotebookHint);
    (void)fields.text("format");
    if (auto same = checkScan(fields.object("scan"), scan, where); !same) return same.error();
    Notebook notebook;
    std::set<int> numbers;
    for (JsonFields& each : fields.objects("targets")) {
        notebook.targets.push_back(targetFrom(each, scan));
        if (!numbers.insert(notebook.targets.back().number).second) each.refuse("number", "must appear once only");
        each.done();
    }
    for (JsonFields& each : fields.objects("measures")) {
        StoredMeasure measure = measureFrom(each, scan);
        if (measure.number == 0) measure.number = static_cast<int>(notebook.measures.size()) + 1;
        if (measure.number < nextMeasureNumber(notebook)) each.refuse("number", "must be larger than the one before");
        notebook.measures.push_back(std::move(measure));
        each.done();
    }
    if (notebook.targets.size() > kMostTargets || notebook.measures.size() > kMostMeasures)
        fields.refuse("targets", "must be no more than " + std::to_string(kMostTargets));
    fields.done();
    if (fields.problem()) return *fields.problem();
    return notebook;
}

} // namespace edgescan::inspect
