// Tables of words; letters with marks are replaced first.
#include "core/files/point_tables/axis_words.h"

#include "core/base/physical_limits.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <set>

namespace edgescan::files {
namespace {

struct MarkedLetter {
    std::string_view bytes;
    std::string_view plain;
};

// Of headings, small and large; German, Nordic, Spanish, Portuguese, French, Polish, Czech, Turkish, Hungarian. UTF-8.
constexpr MarkedLetter kMarkedLetters[]{
    {"ä", "ae"}, {"Ä", "ae"}, {"ö", "oe"}, {"Ö", "oe"}, {"ü", "ue"}, {"Ü", "ue"}, {"ß", "ss"}, {"ø", "oe"}, {"Ø", "oe"},
    {"å", "aa"}, {"Å", "aa"}, {"æ", "ae"}, {"Æ", "ae"}, {"á", "a"},  {"Á", "a"},  {"à", "a"},  {"À", "a"},  {"ã", "a"},
    {"Ã", "a"},  {"â", "a"},  {"ç", "c"},  {"Ç", "c"},  {"é", "e"},  {"É", "e"},  {"è", "e"},  {"È", "e"},  {"ê", "e"},
    {"Ê", "e"},  {"í", "i"},  {"Í", "i"},  {"ñ", "n"},  {"Ñ", "n"},  {"ó", "o"},  {"Ó", "o"},  {"ô", "o"},  {"õ", "o"},
    {"ú", "u"},  {"Ú", "u"},  {"ý", "y"},  {"Ý", "y"},  {"ł", "l"},  {"Ł", "l"},  {"ś", "s"},  {"Ś", "s"},  {"ć", "c"},
    {"Ć", "c"},  {"š", "s"},  {"Š", "s"},  {"ğ", "g"},  {"Ğ", "g"},  {"ő", "oe"}, {"ı", "i"},  {"İ", "i"}};

// The same in Latin-1, where a letter has one byte.
constexpr MarkedLetter kLatinLetters[]{{"\xe4", "ae"}, {"\xc4", "ae"}, {"\xf6", "oe"}, {"\xd6", "oe"}, {"\xfc", "ue"}, {"\xdc", "ue"},
                                       {"\xf8", "oe"}, {"\xd8", "oe"}, {"\xe5", "aa"}, {"\xc5", "aa"}, {"\xe1", "a"},  {"\xe3", "a"},
                                       {"\xe7", "c"},  {"\xe9", "e"},  {"\xe8", "e"},  {"\xea", "e"},  {"\xed", "i"},  {"\xf3", "o"},
                                       {"\xf1", "n"},  {"\xfa", "u"},  {"\xb0", ""}};

/// Bytes of the letter of UTF-8 that a text begins with; 1 where it begins with none.
std::size_t letterBytes(std::string_view text) {
    const auto first = static_cast<unsigned char>(text[0]);
    const std::size_t bytes = first < 0xC2 ? 1 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : first < 0xF5 ? 4 : 1;
    if (bytes > text.size()) return 1;
    const auto follows = [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; };
    return std::ranges::all_of(text.substr(1, bytes - 1), follows) ? bytes : 1;
}

/// A large Cyrillic letter as the small one.
std::string smallCyrillic(std::string_view letter) {
    std::string small(letter);
    if (letter.size() != 2 || letter[0] != '\xD0') return small;
    const auto second = static_cast<unsigned char>(letter[1]);
    if (second >= 0x90 && second < 0xA0) small[1] = static_cast<char>(second + 0x20);
    if (second >= 0xA0 && second < 0xB0) small = {'\xD1', static_cast<char>(second - 0x20)};
    return small;
}

/// The letter at the front of a text in small letters without marks; empty for what is not a letter or a digit. Removes it.
std::string nextLetter(std::string_view& text) {
    constexpr MarkedLetter kSigns[]{{"(')", "ft"},  {"[']", "ft"},  {"(\u2032)", "ft"}, {"[\u2032]", "ft"},
                                    {"(\")", "in"}, {"[\"]", "in"}, {"(\u2033)", "in"}};
    for (const auto& [sign, letters] : kSigns) {
        if (!text.starts_with(sign)) continue;
        text.remove_prefix(sign.size());
        return std::string(letters);
    }
    const std::size_t bytes = letterBytes(text);
    const std::string_view letter = text.substr(0, bytes);
    text.remove_prefix(bytes);
    const auto plainIn = [&](const auto& letters) {
        const auto* const found = std::ranges::find(letters, letter, &MarkedLetter::bytes);
        return found == std::end(letters) ? std::string() : std::string(found->plain);
    };
    if (bytes == 1) {
        char c = letter[0];
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c + 32);
        if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9')) return {c};
        return static_cast<unsigned char>(c) < 0x80 ? std::string() : plainIn(kLatinLetters);
    }
    if (std::string plain = plainIn(kMarkedLetters); !plain.empty()) return plain;
    // Blanks, marks of punctuation and signs of UTF-8 are below and between the scripts.
    const bool sign = letter[0] == '\xC2' || letter.starts_with("\xE2\x80") || letter.starts_with("\xE3\x80") || letter == "\xEF\xBB\xBF" ||
                      letter.starts_with("\xEF\xBC");
    return sign ? std::string() : smallCyrillic(letter);
}

struct NamedAxis {
    AxisWord axis;
    bool compass; ///< goes before letters
    std::vector<std::string_view> words;
};

const std::vector<NamedAxis>& axisTable() {
    static const std::vector<NamedAxis> rows{
        {AxisWord::East, true, {"east",       "easting", "eastings", "e",       "me",     "ost",    "osten", "ostwert",
                                "rechtswert", "oest",    "oester",   "oestlig", "oost",   "oosten", "oos",   "este",
                                "leste",      "est",     "itae",     "wschod",  "vychod", "istok",  "dogu",  "timur",
                                "kelet",      "austur",  "восток",   "东",      "東",     "东坐标", "东向",  "東座標",
                                "eastg",      "estg",    "abscisse", "abscisa", "coorde"}},
        {AxisWord::North, true, {"north",  "northing", "northings", "n",       "mn",       "nord",      "norden", "nordwert", "hochwert",
                                 "norr",   "nordlig",  "noord",     "noorden", "norte",    "pohjoinen", "polnoc", "sever",    "sjever",
                                 "kuzey",  "utara",    "eszak",     "nordur",  "север",    "北",        "北坐标", "北向",     "北座標",
                                 "northg", "nthg",     "nth",       "norting", "ordonnee", "ordenada",  "coordn"}},
        {AxisWord::Up, true, {"elevation",    "elevations", "elev",     "height",   "altitude", "alt",    "rl",        "mrl",
                              "reducedlevel", "level",      "up",       "hoehe",    "hoejd",    "hoejde", "hoeyde",    "hoogte",
                              "korkeus",      "kote",       "kota",     "cota",     "quota",    "cote",   "altura",    "altitud",
                              "elevacion",    "elevacao",   "nivel",    "wysokosc", "vyska",    "visina", "yukseklik", "yuekseklik",
                              "tinggi",       "elevasi",    "magassag", "высота",   "отметка",  "高",     "高程",      "标高",
                              "標高",         "h",          "ht",       "hgt",      "elevn",    "kot",    "niveau",    "ahd",
                              "nap",          "nn",         "nhn",      "ngf",      "rh2000",   "msl",    "navd88"}},
        {AxisWord::East, false, {"x", "xp", "xc"}},
        {AxisWord::North, false, {"y", "yp", "yc"}},
        {AxisWord::Up, false, {"z", "zp", "zc"}},
    };
    return rows;
}

/// Words next to that of the axis: they say of what or in which frame the numbers are, and not which axis.
bool saysNoAxis(std::string_view word) {
    static constexpr std::string_view kWords[]{
        "mine",        "grid",        "local",       "global",      "world",      "utm",       "mga",          "amg",   "gda",
        "wgs",         "etrs",        "map",         "site",        "plant",      "survey",    "true",         "proj",  "projected",
        "coord",       "coords",      "coordinate",  "coordinates", "value",      "val",       "wert",         "werte", "koord",
        "koordinate",  "koordinaten", "coordonnee",  "coordenada",  "coordinata", "koordinat", "koordinaatti", "point", "points",
        "pt",          "punkt",       "center",      "centre",      "centroid",   "mid",       "middle",       "pos",   "position",
        "ellipsoidal", "ellipsoid",   "orthometric", "ortho",       "collar",     "m",         "axis",         "achse", "координата",
        "坐标",        "座標",        "lo",          "wg",          "surveyed",   "field",     "мм",           "м"};
    const bool number = std::ranges::all_of(word, [](char c) { return c >= '0' && c <= '9'; });
    if (number || std::ranges::find(kWords, word) != std::end(kWords)) return true;
    // "utm33", "mga94", "gda2020"
    const std::size_t digits = word.find_first_of("0123456789");
    return digits != std::string_view::npos && digits >= 2 && saysNoAxis(word.substr(0, digits));
}

using Shared = std::span<const std::string>;

bool saysNoAxis(std::string_view word, Shared shared) { return saysNoAxis(word) || std::ranges::find(shared, word) != shared.end(); }

/// The axis of a word, also where it is joined with one that says none: "xcollar", "midy", "nordkoordinate".
const NamedAxis* axisOf(std::string_view word, Shared shared = {}) {
    for (const NamedAxis& axis : axisTable()) {
        if (std::ranges::find(axis.words, word) != axis.words.end()) return &axis;
    }
    const auto joins = [&](const NamedAxis& axis, std::string_view name) {
        constexpr std::size_t kFewestLetters = 3;
        if (name.size() >= word.size() || (axis.compass && name.size() < kFewestLetters)) return false;
        return (word.starts_with(name) && saysNoAxis(word.substr(name.size()), shared)) ||
               (word.ends_with(name) && saysNoAxis(word.substr(0, word.size() - name.size()), shared));
    };
    for (const NamedAxis& axis : axisTable()) {
        if (std::ranges::any_of(axis.words, [&](std::string_view name) { return joins(axis, name); })) return &axis;
    }
    return nullptr;
}

/// What is measured along axes and is not a place.
bool isQuantity(std::string_view word) {
    static constexpr std::string_view kWords[]{
        "normal",   "normals",    "vel",   "velocity",    "speed", "acc",      "accel",    "acceleration", "gyro",   "rate",   "ori",
        "orig",     "origin",     "inc",   "size",        "min",   "max",      "std",      "stddev",       "stdev",  "sd",     "sigma",
        "error",    "err",        "rms",   "var",         "cov",   "accuracy", "delta",    "diff",         "offset", "shift",  "rot",
        "rotation", "angle",      "dir",   "quat",        "force", "mag",      "gradient", "vector",       "dim",    "length", "width",
        "scale",    "resolution", "trans", "translation", "omega", "euler",    "torque"};
    return std::ranges::find(kWords, word) != std::end(kWords);
}

} // namespace

std::vector<std::string> headingWords(std::string_view text) {
    std::vector<std::string> words(1);
    while (!text.empty()) {
        const std::string letter = nextLetter(text);
        if (!letter.empty())
            words.back() += letter;
        else if (!words.back().empty())
            words.emplace_back();
    }
    if (words.back().empty()) words.pop_back();
    return words;
}

ScaledHeading withoutFactor(std::string_view heading) {
    const std::size_t open = std::min(heading.find_first_of("(["), heading.size() - 1);
    ScaledHeading found{std::string(heading)};
    double factor = 0, below = 1;
    const char* const end = heading.data() + heading.size();
    const char* const from = heading.data() + open + 1;
    auto [rest, problem] = std::from_chars(from, end, factor);
    if (problem == std::errc{} && rest < end && *rest == '/') rest = std::from_chars(rest + 1, end, below).ptr; // "1/100 deg"
    const std::string_view unit(rest, static_cast<std::size_t>(end - rest));
    if (!(factor > 0 && factor < 1e9) || !(below > 0) || headingWords(unit).size() > 1 || unit.starts_with('-')) return found;
    found.factor = factor / below;
    found.name = std::string(heading.substr(0, open + 1)) + std::string(unit);
    return found;
}

std::string headingLetters(std::string_view text) {
    std::string letters;
    while (!text.empty()) letters += nextLetter(text);
    return letters;
}

std::optional<AxisWord> axisNamed(std::string_view heading, Shared shared) {
    std::optional<AxisWord> compass, letter;
    if (const NamedAxis* const whole = axisOf(headingLetters(heading))) return whole->axis; // "reduced level", "m N"
    for (const std::string& word : headingWords(heading)) {
        const NamedAxis* const axis = axisOf(word, shared);
        if (axis == nullptr && saysNoAxis(word, shared)) continue;
        if (axis == nullptr) return std::nullopt;
        std::optional<AxisWord>& found = axis->compass ? compass : letter;
        if (found && *found != axis->axis) return std::nullopt;
        found = axis->axis;
    }
    return compass ? compass : letter;
}

std::vector<std::string> wordsNextToAxes(std::span<const std::string> headings) {
    constexpr std::string_view kLetters = "xyz";
    std::vector<std::string> once, again;
    for (const std::string& heading : headings) {
        const std::vector<std::string> words = headingWords(heading);
        const bool hasAxis = std::ranges::any_of(words, [](const std::string& word) { return axisOf(word) != nullptr; });
        std::set<std::string> own;
        for (const std::string& word : words) {
            if (axisOf(word) != nullptr) continue;
            if (hasAxis) own.insert(word);
            if (word.size() > 1 && kLetters.find(word.front()) != kLetters.npos) own.insert(word.substr(1));
            if (word.size() > 2 && kLetters.find(word.back()) != kLetters.npos) own.insert(word.substr(0, word.size() - 1)); // not "nx"
        }
        for (const std::string& word : own) {
            if (isQuantity(word)) continue;
            (std::ranges::find(once, word) == once.end() ? once : again).push_back(word);
        }
    }
    return again;
}

bool speaksOfAxis(std::string_view heading) {
    static constexpr std::string_view kOpposite[]{"south", "southing", "west",  "westing", "sued",  "syd",  "soeder", "zuid", "sur",
                                                  "sul",   "sud",      "ouest", "oeste",   "ovest", "vest", "vaest",  "юг",   "запад"};
    return std::ranges::any_of(headingWords(heading), [](const std::string& word) {
        const NamedAxis* const axis = axisOf(word);
        const bool letters = word.size() == 1 && word != "x" && word != "y" && word != "z"; // a count, an error
        return (axis != nullptr && !letters) || std::ranges::find(kOpposite, word) != std::end(kOpposite);
    });
}

std::optional<double> unitNamed(std::string_view letters) {
    struct Unit {
        double mm;
        std::vector<std::string_view> names;
    };
    static const std::vector<Unit> rows{
        {1.0, {"mm", "millimetre", "millimetres", "millimeter", "millimeters", "milimetros", "millimetern", "мм"}},
        {10.0, {"cm", "centimetre", "centimetres", "centimeter", "centimeters", "centimetros", "zentimeter", "см"}},
        {1000.0, {"m", "metre", "metres", "meter", "meters", "metro", "metros", "metern", "metri", "mts", "м"}},
        {1e6, {"km", "kilometre", "kilometres", "kilometer", "kilometers"}},
        {kFootMm,
         {"ft", "feet", "foot", "ift", "internationalfeet", "internationalfoot", "intft", "ftint", "pie", "pies", "pied", "pieds", "pes",
          "piedi", "fuss", "voet", "fot"}},
        {kUsSurveyFootMm,
         {"usft", "ftus", "ussurveyfeet", "ussurveyfoot", "surveyfeet", "surveyfoot", "sft", "usfeet", "usfoot", "ussft", "usftsurvey",
          "footus"}},
        {25.4, {"in", "inch", "inches", "pulgada", "pulgadas", "polegada", "polegadas", "pouce", "pouces", "zoll"}},
    };
    for (const Unit& unit : rows) {
        if (std::ranges::find(unit.names, letters) != unit.names.end()) return unit.mm;
    }
    return std::nullopt;
}

std::optional<double> unitInComment(std::string_view comment) {
    static constexpr std::string_view kUnitWords[]{"unit",  "units",  "einheit", "einheiten", "unidad",  "unidades", "unidade",
                                                   "unite", "unites", "eenheid", "enhet",     "единица", "единицы"};
    static constexpr std::string_view kPlaceWords[]{"coordinates", "coordinate",  "coords",    "xyz",        "points",
                                                    "koordinaten", "coordenadas", "distances", "distance",   "values",
                                                    "lengths",     "ranges",      "data",      "coordonnees"};
    constexpr std::size_t kMostWords = 24, kLongest = 3; // "US survey feet"
    const std::vector<std::string> words = headingWords(comment.substr(0, 400));
    if (words.size() > kMostWords) return std::nullopt;
    const auto hasAny = [&](const auto& any) {
        return std::ranges::any_of(words, [&](const std::string& word) { return std::ranges::find(any, word) != std::end(any); });
    };
    const bool asUnit = hasAny(kUnitWords), asPlace = hasAny(kPlaceWords);
    if (!asUnit && !asPlace) return std::nullopt;
    std::optional<double> found;
    for (std::size_t n = 0; n < words.size(); ++n) {
        std::string name;
        std::optional<double> longest;
        std::size_t last = n;
        for (std::size_t end = n; end < std::min(words.size(), n + kLongest); ++end) {
            name += words[end];
            if (const auto unit = unitNamed(name)) {
                longest = unit;
                last = end;
            }
        }
        const bool counted = n > 0 && words[n - 1][0] >= '0' && words[n - 1][0] <= '9'; // "to 5 mm", "0.01 m": not the unit of the points
        const bool preposition = last == n && words[n] == "in";                         // and not an inch
        const bool inBrackets = last + 1 == words.size() && comment.find_first_of("[(") != comment.npos;
        const bool stated = asUnit || inBrackets || (n > 0 && words[n - 1] == "in");
        if (!longest || counted || preposition || !stated) continue;
        if (found && *found != *longest) return std::nullopt;
        found = longest;
        n = last;
    }
    return found;
}

} // namespace edgescan::files
