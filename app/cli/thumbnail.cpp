// edgescan-cli thumbnail: a small picture of a scan, for file managers.
#include "app/cli/commands.h"
#include "app/shared/options.h"
#include "app/shared/outputs.h"
#include "core/base/foreign_text.h"
#include "core/containers/png/png.h"
#include "core/edges/gray/gray.h"
#include "core/files/formats/formats.h"

#include <algorithm>
#include <array>
#include <memory>
#include <string_view>

namespace edgescan::cli {
namespace {

struct Thumbnail {
    std::string in, out;
    int size = 256;
};

/// Each pixel is the mean of its cells with a range; cells without a range are black. Images are never enlarged.
Grid<std::uint8_t> shrunk(const Scan& scan, const Grid<std::uint8_t>& levels, int size) {
    const double step = std::max(1.0, static_cast<double>(std::max(levels.lines, levels.beams)) / size);
    const auto pixels = [&](int cells) { return std::max(1, static_cast<int>(cells / step)); };
    Grid<std::uint8_t> picture(pixels(levels.lines), pixels(levels.beams));
    Grid<std::uint32_t> sum(picture.lines, picture.beams), count(picture.lines, picture.beams);
    for (int line = 0; line < levels.lines; ++line) {
        for (int beam = 0; beam < levels.beams; ++beam) {
            if (scan.state.at(line, beam) != CellState::Valid) continue;
            const int row = std::min(picture.lines - 1, static_cast<int>(line / step));
            const int column = std::min(picture.beams - 1, static_cast<int>(beam / step));
            sum.at(row, column) += levels.at(line, beam);
            ++count.at(row, column);
        }
    }
    for (std::size_t k = 0; k < picture.size(); ++k) picture[k] = count[k] == 0 ? 0 : static_cast<std::uint8_t>(sum[k] / count[k]);
    return picture;
}

int run(const Thumbnail& thumbnail) {
    // File managers give names of temporary files, without .png.
    constexpr std::array<std::string_view, 8> kOthers{".jpg", ".jpeg", ".gif", ".bmp", ".tif", ".tiff", ".webp", ".pdf"};
    const std::string extension = asciiLower(std::filesystem::path(thumbnail.out).extension().string());
    const auto reads = [&](const files::Format& format) { return std::ranges::find(format.reads, extension) != format.reads.end(); };
    if (extension != ".png" && (std::ranges::find(kOthers, extension) != kOthers.end() || std::ranges::any_of(files::formats(), reads)))
        return failWith({"the picture is a PNG", thumbnail.out, "give a name that ends with .png"}, kWrongUsage);
    const Result<Scan> scan = files::openScan(thumbnail.in);
    if (!scan) return failWith(scan.error());
    const Grid<std::uint8_t> picture = shrunk(*scan, edges::grayImage(*scan, edges::Settings{}).levels, thumbnail.size);
    const Result<Done> saved = containers::savePng8(picture, thumbnail.out);
    printError(saved ? printable(thumbnail.in) + ": " + std::to_string(picture.beams) + " x " + std::to_string(picture.lines) +
                           " pixels; written to " + placesText({thumbnail.out}) + "."
                     : saved.error().sentence());
    return saved ? kDone : kRefused;
}

} // namespace

void addThumbnail(CLI::App& app, int& code) {
    auto thumbnail = std::make_shared<Thumbnail>();
    CLI::App& command = *app.add_subcommand("thumbnail", "Draws a small gray picture of a scan, for file managers");
    command.add_option("SCAN", thumbnail->in, "Scan")->required();
    command.add_option("OUT", thumbnail->out, "New picture (.png)")->required();
    addNumber(command, "-s,--size", thumbnail->size, {16, 4096}, "Longest side at most [pixels]");
    command.callback([thumbnail, &code] { code = run(*thumbnail); });
}

} // namespace edgescan::cli
