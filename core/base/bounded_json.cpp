// Builds a value from the events of nlohmann's parser. It stops at the first event that is out of bounds.
#include "core/base/bounded_json.h"
#include "core/base/translated_text.h"

#include "core/base/checked_size.h"
#include "core/base/foreign_text.h"
#include "core/base/memory.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <vector>

namespace edgescan {
namespace {

constexpr std::size_t kMostKeysOfOne = 4096; // for each new key, an ordered object compares all of its keys
// a value of two bytes of text takes sixteen bytes of memory, and twice that while its list grows
constexpr std::uint64_t kBytesPerByte = 32;
constexpr std::size_t kAskFrom = std::size_t{1} << 20U;
constexpr std::size_t kLongestShown = 60;

bool isDecimal(char c) { return c >= '0' && c <= '9'; }

/// "..., 217,4": whether the text ends with digits behind a comma without a blank, or with one more character.
bool isAfterDecimalComma(std::string_view text) {
    if (!text.empty() && !isDecimal(text.back())) text.remove_suffix(1);
    std::size_t at = text.size();
    while (at > 0 && isDecimal(text[at - 1])) --at;
    return at < text.size() && at > 1 && text[at - 1] == ',' && isDecimal(text[at - 2]);
}

template <class Json>
class BoundedBuilder final : public nlohmann::json_sax<Json> {
public:
    explicit BoundedBuilder(const JsonBounds& bounds) : bounds_(bounds) {}

    bool null() override { return add(Json()); }
    bool boolean(bool value) override { return add(Json(value)); }
    bool number_integer(typename Json::number_integer_t value) override { return add(Json(value)); }
    bool number_unsigned(typename Json::number_unsigned_t value) override { return add(Json(value)); }
    bool number_float(typename Json::number_float_t value, const std::string&) override { return add(Json(value)); }
    bool string(std::string& value) override { return add(Json(unescapedBytes(value))); }
    bool binary(typename Json::binary_t&) override { return false; } // JSON text cannot hold binary values
    bool start_object(std::size_t) override { return open(Json::object()); }
    bool start_array(std::size_t) override { return open(Json::array()); }
    bool end_object() override { return open_.pop_back(), true; }
    bool end_array() override { return open_.pop_back(), true; }

    bool key(std::string& name) override {
        auto& object = open_.back()->template get_ref<typename Json::object_t&>();
        if (++keys_ > bounds_.keys || object.size() >= kMostKeysOfOne) return stop("the JSON holds too many keys");
        const auto [place, fresh] = object.emplace(unescapedBytes(name), Json());
        if (!fresh) return stop(withValues("the key \"%1\" appears twice in the same object of the JSON", {name.substr(0, kLongestShown)}));
        slot_ = &place->second;
        return true;
    }
    bool parse_error(std::size_t byte, const std::string&, const nlohmann::detail::exception& problem) override {
        constexpr int kNumberTooLarge = 406; // nlohmann's out_of_range
        if (problem.id == kNumberTooLarge) return stop("the JSON holds a number that no computer can store");
        problem_ = "the JSON is damaged or cut off here";
        byte_ = byte;
        return false;
    }

    Json popRoot() { return std::move(root_); }
    [[nodiscard]] Error error(std::string_view text, const std::string& where) const {
        if (byte_ == 0) return {problem_, where, "correct the file or choose another"};
        const std::string_view before = text.substr(0, byte_);
        const auto lines = static_cast<std::size_t>(1 + std::ranges::count(before, '\n'));
        const std::size_t column = before.size() - (before.rfind('\n') + 1); // from 1, as byte_
        return {problem_, withValues("%1: byte %2", {where, byte_}),
                withValues(isAfterDecimalComma(before) ? "check line %1, column %2; write 217.4 for 217,4" : "check line %1, column %2",
                           {lines, column})};
    }

private:
    bool stop(std::string problem) {
        problem_ = std::move(problem);
        return false;
    }
    bool add(Json value) { return place(std::move(value)), true; }
    bool open(Json empty) {
        if (open_.size() >= static_cast<std::size_t>(bounds_.depth)) return stop("this JSON is nested too deep");
        open_.push_back(place(std::move(empty)));
        return true;
    }
    /// Stores the value and returns its address. The address stays valid: a list does not grow while one of its elements is open.
    Json* place(Json value) {
        if (open_.empty()) return &(root_ = std::move(value));
        if (!open_.back()->is_array()) return &(*slot_ = std::move(value));
        open_.back()->push_back(std::move(value));
        return &open_.back()->back();
    }

    const JsonBounds& bounds_;
    Json root_;
    std::vector<Json*> open_;
    Json* slot_ = nullptr; // of the key that was read last
    std::size_t keys_ = 0;
    std::string problem_;
    std::size_t byte_ = 0;
};

template <class Json>
Result<Json> parsedWithin(std::string_view text, const std::string& where, const JsonBounds& bounds) {
    if (text.size() > bounds.bytes)
        return Error{withValues("this JSON is too large: %1, and %2 are read", {sizeText(text.size()), sizeText(bounds.bytes)}), where,
                     "choose another file"};
    if (text.find_first_not_of(" \t\r\n") == std::string_view::npos)
        return Error{"the file is empty", where, "copy it again or choose another"};
    if (text.size() >= kAskFrom) {
        if (auto enough = checkMemory(productOf({text.size(), kBytesPerByte}), where); !enough) return enough.error();
    }
    BoundedBuilder<Json> builder(bounds);
    if (!Json::sax_parse(text.begin(), text.end(), &builder)) return builder.error(text, where);
    return builder.popRoot();
}

} // namespace

Result<nlohmann::json> parseJson(std::string_view text, const std::string& where, const JsonBounds& bounds) {
    return parsedWithin<nlohmann::json>(text, where, bounds);
}

Result<nlohmann::ordered_json> parseOrderedJson(std::string_view text, const std::string& where, const JsonBounds& bounds) {
    return parsedWithin<nlohmann::ordered_json>(text, where, bounds);
}

} // namespace edgescan
