// PNG through libpng. Its errors leave by longjmp: the functions that set it hold nothing that needs a destructor.
#include "core/containers/png/png.h"
#include "core/base/translated_text.h"

#include "core/base/inputs.h"
#include "core/base/memory.h"
#include "core/base/whole_file.h"

#include <png.h>

#include <algorithm>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace edgescan::containers {
namespace {

/// Where libpng writes to. Memory running out is remembered, never thrown through libpng's C code.
struct Sink {
    std::vector<std::byte> bytes;
    bool full = false;
};

struct Message {
    char text[200] = "unknown reason";
};

extern "C" {
void appendToSink(png_structp png, png_bytep bytes, png_size_t count) {
    auto* sink = static_cast<Sink*>(png_get_io_ptr(png));
    try {
        const auto* first = reinterpret_cast<const std::byte*>(bytes);
        sink->bytes.insert(sink->bytes.end(), first, first + count);
    } catch (...) {
        sink->full = true;
    }
    if (sink->full) png_error(png, "out of memory");
}
void flushNothing(png_structp) {}
void keepMessage(png_structp png, png_const_charp text) {
    auto* message = static_cast<Message*>(png_get_error_ptr(png));
    std::strncpy(message->text, text, sizeof message->text - 1);
    png_longjmp(png, 1);
}
void ignoreWarning(png_structp, png_const_charp) {}
void readFromText(png_structp png, png_bytep to, png_size_t count) {
    auto* left = static_cast<std::string_view*>(png_get_io_ptr(png));
    if (count > left->size()) png_error(png, "the file ends too early");
    std::memcpy(to, left->data(), count);
    left->remove_prefix(count);
}
}

/// As in encode(), a longjmp skips no destructor.
bool readUpToPixels(png_structp png, png_infop head, std::string_view* left) {
    if (setjmp(png_jmpbuf(png)) != 0) return false;
    png_set_read_fn(png, left, readFromText);
    png_set_user_limits(png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
    png_read_info(png, head);
    return true;
}

struct Shape {
    png_uint_32 width = 0, height = 0;
    int depth = 8;
    int colour = PNG_COLOR_TYPE_GRAY;
};

/// rows: big-endian samples, height pointers. Only trivial objects live here, so a longjmp skips no destructor.
bool encode(png_structp png, png_infop head, Sink* sink, Shape shape, png_bytepp rows, png_textp note) {
    if (setjmp(png_jmpbuf(png)) != 0) return false;
    png_set_write_fn(png, sink, appendToSink, flushNothing);
    png_set_user_limits(png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
    png_set_IHDR(png, head, shape.width, shape.height, shape.depth, shape.colour, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    png_set_compression_level(png, 4); // half the time of the default for a few per cent of size
    if (note != nullptr) png_set_text(png, head, note, 1);
    png_write_info(png, head);
    png_write_image(png, rows);
    png_write_end(png, head);
    return true;
}

Result<std::string> samplesBytes(std::vector<png_byte>& samples, Shape shape, const std::string& where, const std::string& record) {
    if (shape.width == 0 || shape.height == 0) return Error{"there are no cells to make a picture of", where, "open a scan first"};
    const std::size_t bytesPerRow = samples.size() / shape.height;
    std::vector<png_bytep> rows;
    rows.reserve(shape.height);
    for (std::size_t i = 0; i < shape.height; ++i) rows.push_back(samples.data() + i * bytesPerRow);
    Message message;
    Sink sink;
    std::string keyword = kPngRecordKeyword;
    std::string words = record;
    png_text note{};
    note.compression = PNG_TEXT_COMPRESSION_NONE;
    note.key = keyword.data();
    note.text = words.data();
    note.text_length = words.size();
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &message, keepMessage, ignoreWarning);
    png_infop head = png != nullptr ? png_create_info_struct(png) : nullptr;
    const bool encoded = head != nullptr && encode(png, head, &sink, shape, rows.data(), words.empty() ? nullptr : &note);
    png_destroy_write_struct(&png, &head);
    if (!encoded) return Error{std::string("the picture cannot be made: ") + message.text, where, "free some memory"};
    return std::string(reinterpret_cast<const char*>(sink.bytes.data()), sink.bytes.size());
}

template <class Cell>
Shape shapeOf(const Grid<Cell>& cells, int depth, int colour) {
    if (cells.lines <= 0 || cells.beams <= 0) return {};
    return {static_cast<png_uint_32>(cells.beams), static_cast<png_uint_32>(cells.lines), depth, colour};
}

constexpr std::string_view kMagic{"\x89PNG\r\n\x1a\n", 8};

struct Chunk {
    std::string_view name, content;
};

/// The chunk of `bytes` at `at`, which moves behind it; nothing where no picture starts or the file is shorter than its chunk.
std::optional<Chunk> chunkAt(std::string_view bytes, std::size_t& at) {
    if (!bytes.starts_with(kMagic) || at + 12 > bytes.size()) return std::nullopt;
    std::uint64_t length = 0;
    for (std::size_t i = 0; i < 4; ++i) length = length << 8U | static_cast<unsigned char>(bytes[at + i]);
    if (length > bytes.size() - at - 12) return std::nullopt;
    const Chunk chunk{bytes.substr(at + 4, 4), bytes.substr(at + 8, length)};
    at += 12 + length;
    return chunk;
}

/// Every chunk before the pixels is in the file. libpng clears the memory that a chunk promises (up to 8 MB) before it reads the chunk.
bool headIsWhole(std::string_view bytes) {
    std::size_t at = kMagic.size();
    while (at + 12 <= bytes.size() && bytes.substr(at + 4, 4) != "IDAT") {
        if (!chunkAt(bytes, at)) return false;
    }
    return true;
}

struct FreeImage {
    png_image* image;
    ~FreeImage() { png_image_free(image); }
};

/// Reads the head of a picture; a refusal is in image.message.
bool begin(png_image& image, std::string_view bytes) {
    if (headIsWhole(bytes)) return png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()) != 0;
    std::strncpy(image.message, "the file ends too early", sizeof image.message - 1);
    return false;
}

} // namespace

Result<std::string> png8Bytes(const Grid<std::uint8_t>& gray, const std::string& where, const std::string& record) {
    std::vector<png_byte> samples(gray.cells.begin(), gray.cells.end());
    return samplesBytes(samples, shapeOf(gray, 8, PNG_COLOR_TYPE_GRAY), where, record);
}

Result<std::string> png16Bytes(const Grid<std::uint16_t>& values, const std::string& where, const std::string& record) {
    std::vector<png_byte> samples;
    samples.reserve(values.size() * 2);
    for (const std::uint16_t value : values.cells) {
        samples.push_back(static_cast<png_byte>(value >> 8U));
        samples.push_back(static_cast<png_byte>(value & 255U));
    }
    return samplesBytes(samples, shapeOf(values, 16, PNG_COLOR_TYPE_GRAY), where, record);
}

Result<Done> savePng8(const Grid<std::uint8_t>& gray, const std::filesystem::path& path) {
    const auto bytes = png8Bytes(gray, path.string());
    if (!bytes) return bytes.error();
    return writeWholeFile(path, *bytes);
}

Result<Done> savePng16(const Grid<std::uint16_t>& values, const std::filesystem::path& path) {
    const auto bytes = png16Bytes(values, path.string());
    if (!bytes) return bytes.error();
    return writeWholeFile(path, *bytes);
}

Result<std::string> pngRgbBytes(const Grid<Rgb>& picture, const std::string& where) {
    std::vector<png_byte> samples;
    samples.reserve(picture.size() * 3);
    for (const Rgb& pixel : picture.cells) samples.insert(samples.end(), {pixel.red, pixel.green, pixel.blue});
    return samplesBytes(samples, shapeOf(picture, 8, PNG_COLOR_TYPE_RGB), where, {});
}

Result<Done> savePngRgb(const Grid<Rgb>& picture, const std::filesystem::path& path) {
    const auto bytes = pngRgbBytes(picture, path.string());
    if (!bytes) return bytes.error();
    return writeWholeFile(path, *bytes);
}

Result<std::string> barePng(std::string_view bytes, std::uint64_t mostPixels, const std::string& where) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    const FreeImage freeing{&image};
    const auto refused = [&] { return Error{std::string("the picture cannot be read: ") + image.message, where, "save it again as PNG"}; };
    if (!begin(image, bytes)) return refused();
    const std::uint64_t pixels = std::uint64_t{image.width} * image.height;
    if (pixels > mostPixels)
        return Error{withValues("the picture has %1 x %2 pixels; at most %3 are taken", {image.width, image.height, mostPixels}), where,
                     "make the picture smaller"};
    image.format = PNG_FORMAT_RGBA;
    std::vector<png_byte> samples(PNG_IMAGE_SIZE(image));
    if (png_image_finish_read(&image, nullptr, samples.data(), 0, nullptr) == 0 || image.warning_or_error != 0) return refused();
    png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
    std::string bare(size, '\0');
    if (png_image_write_to_memory(&image, bare.data(), &size, 0, samples.data(), 0, nullptr) == 0) return refused();
    bare.resize(size);
    return bare;
}

std::string pngRecord(std::string_view bytes) {
    const std::string wanted = std::string(kPngRecordKeyword) + '\0';
    std::size_t at = kMagic.size();
    while (const auto chunk = chunkAt(bytes, at)) {
        if (chunk->name == "tEXt" && chunk->content.starts_with(wanted)) return std::string(chunk->content.substr(wanted.size()));
    }
    return {};
}

std::string pngText(std::string_view bytes, std::string_view key) {
    if (!headIsWhole(bytes)) return {};
    Message message;
    std::string_view left = bytes;
    std::string found;
    png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &message, keepMessage, ignoreWarning);
    png_infop head = png != nullptr ? png_create_info_struct(png) : nullptr;
    if (head != nullptr && readUpToPixels(png, head, &left)) {
        png_textp texts = nullptr;
        int count = 0;
        png_get_text(png, head, &texts, &count);
        for (int i = 0; i < count; ++i) {
            if (texts[i].text != nullptr && key == texts[i].key) found.assign(texts[i].text);
        }
    }
    png_destroy_read_struct(&png, &head, nullptr);
    return found;
}

Result<Grid<std::uint8_t>> readPng8(const std::filesystem::path& path) {
    const auto bytes = readInput(path);
    if (!bytes) return bytes.error();
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    const FreeImage freeImage{&image};
    const auto damaged = [&] {
        return Error{std::string("this is not a readable PNG picture: ") + image.message, path.string(), "save the mask again as PNG"};
    };
    if (!begin(image, {reinterpret_cast<const char*>(bytes->data()), bytes->size()})) return damaged();
    if ((image.format & PNG_FORMAT_FLAG_LINEAR) != 0) {
        return Error{"this picture has 16 bits per pixel where 8 are needed", path.string(), "save the mask as 8-bit gray"};
    }
    const std::uint64_t pixels = std::uint64_t{image.width} * image.height;
    // Deflate shrinks at most 1032 times and a pixel takes at least one bit: a header that promises more is false.
    if (pixels / 8 > std::uint64_t{bytes->size()} * 1032) {
        return Error{"the picture promises more pixels than the file can hold", path.string(), "copy the file again"};
    }
    if (auto enough = checkMemory(pixels * 5, path.string()); !enough) return enough.error();
    image.format = PNG_FORMAT_GRAY;
    const png_color black{0, 0, 0};
    Grid<std::uint8_t> gray(static_cast<int>(image.height), static_cast<int>(image.width));
    if (png_image_finish_read(&image, &black, gray.cells.data(), 0, nullptr) == 0) return damaged();
    return gray;
}

Result<Grid<std::uint16_t>> pngValues(std::string_view bytes, const std::string& where) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    const FreeImage freeImage{&image};
    const auto damaged = [&] {
        return Error{std::string("this is not a readable PNG picture: ") + image.message, where, "export it again"};
    };
    if (!begin(image, bytes)) return damaged();
    const std::uint64_t pixels = std::uint64_t{image.width} * image.height;
    if (pixels / 8 > std::uint64_t{bytes.size()} * 1032) return damaged();
    if (auto enough = checkMemory(pixels * 4, where); !enough) return enough.error();
    Grid<std::uint16_t> values(static_cast<int>(image.height), static_cast<int>(image.width));
    if ((image.format & PNG_FORMAT_FLAG_LINEAR) != 0) {
        image.format = PNG_FORMAT_LINEAR_Y;
        if (png_image_finish_read(&image, nullptr, values.cells.data(), 0, nullptr) == 0) return damaged();
        return values;
    }
    image.format = PNG_FORMAT_GRAY;
    std::vector<std::uint8_t> samples(values.size());
    if (png_image_finish_read(&image, nullptr, samples.data(), 0, nullptr) == 0) return damaged();
    std::copy(samples.begin(), samples.end(), values.cells.begin());
    return values;
}

} // namespace edgescan::containers
