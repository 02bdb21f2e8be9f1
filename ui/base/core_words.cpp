// The tables of words, of parts of sentences, and of flags.
#include "ui/base/core_words.h"

#include "core/scan/georef/place_form.h"
#include "core/scan/grid/assumed_mounting.h"
#include "core/scan/grid/reading_options.h"
#include "ui/base/core_notes.h"
#include "ui/base/core_refusals.h"
#include "ui/base/shown_text.h"

#include <QObject>
#include <QRegularExpression>

#include <algorithm>
#include <array>
#include <cstring>
#include <functional>
#include <utility>
#include <vector>

namespace edgescan::ui {
namespace {

// Whole texts of the live strip. %1 and %2 are numbers, or texts of this table again.
constexpr std::array kWholeTexts{
    QT_TRANSLATE_NOOP("QObject", "CONNECTING"),
    QT_TRANSLATE_NOOP("QObject", "LIVE"),
    QT_TRANSLATE_NOOP("QObject", "STALE"),
    QT_TRANSLATE_NOOP("QObject", "STALE %1"),
    QT_TRANSLATE_NOOP("QObject", "LOST"),
    QT_TRANSLATE_NOOP("QObject", "LOST %1"),
    QT_TRANSLATE_NOOP("QObject", "STOPPED"),
    QT_TRANSLATE_NOOP("QObject", "STOPPED %1"),
    QT_TRANSLATE_NOOP("QObject", "%1, COUNTERS IN DOUBT"),
    QT_TRANSLATE_NOOP("QObject", "INCOMPLETE %1 lines"),
    QT_TRANSLATE_NOOP("QObject", "%1 lost: %2"),
    QT_TRANSLATE_NOOP("QObject", "%1 lines"),
    QT_TRANSLATE_NOOP("QObject", "line %1"),
    QT_TRANSLATE_NOOP("QObject", "lines %1 and others"),
    QT_TRANSLATE_NOOP("QObject", "lines %1"),
    QT_TRANSLATE_NOOP("QObject", "no return %1 %"),
    QT_TRANSLATE_NOOP("QObject", "COUNTERS IN DOUBT"),
    QT_TRANSLATE_NOOP("QObject", "MOUNTING ASSUMED"),
    QT_TRANSLATE_NOOP("QObject", "MOUNTING FROM RANGES"),
    QT_TRANSLATE_NOOP("QObject", "FIRST ANGLE ASSUMED"),
    QT_TRANSLATE_NOOP("QObject", "STEP ASSUMED %1°"),
    QT_TRANSLATE_NOOP("QObject", "START ASSUMED"),
    QT_TRANSLATE_NOOP("QObject", "1 remark"),
    QT_TRANSLATE_NOOP("QObject", "%1 remarks"),
    QT_TRANSLATE_NOOP("QObject", "%1 earlier in this sweep"),
    QT_TRANSLATE_NOOP("QObject", "WINDOW TOO DIRTY"),
    QT_TRANSLATE_NOOP("QObject", "WINDOW DIRTY"),
    QT_TRANSLATE_NOOP("QObject", "window clean"),
    QT_TRANSLATE_NOOP("QObject", "device ok"),
    QT_TRANSLATE_NOOP("QObject", "DEVICE ERROR"),
    QT_TRANSLATE_NOOP("QObject", "pose of unknown age"),
    QT_TRANSLATE_NOOP("QObject", "pose %1 old"),
    QT_TRANSLATE_NOOP("QObject", "sweep complete"),
    QT_TRANSLATE_NOOP("QObject", "sweep ended"),
    QT_TRANSLATE_NOOP("QObject", "%1 left"),
    QT_TRANSLATE_NOOP("QObject", "%1, %2 ago"),
    QT_TRANSLATE_NOOP("QObject", "recording %1 MB, %2"),
    QT_TRANSLATE_NOOP("QObject", "recording %1 MB"),
    QT_TRANSLATE_NOOP("QObject", "the disk is %1 s behind (%2 MB)"),
    QT_TRANSLATE_NOOP("QObject", "RECORDING ENDED: %1"),
    QT_TRANSLATE_NOOP("QObject", "RECORDING HAS GAPS: %1"),
    // How two scans were lined up.
    QT_TRANSLATE_NOOP("QObject", "%1; other cells: points moved to the grid of the later scan"),
    QT_TRANSLATE_NOOP("QObject", "one scan with two settings"),
    QT_TRANSLATE_NOOP("QObject", "lined up by their poses"),
    QT_TRANSLATE_NOOP("QObject", "lined up by given positions of the scanner, not in the mine grid"),
    QT_TRANSLATE_NOOP("QObject", "no pose: lined up by their surfaces"),
    // An angle.
    QT_TRANSLATE_NOOP("QObject", "not resolved"),
};

// Names of scans that have no file of their own.
constexpr std::array kScanNames{
    QT_TRANSLATE_NOOP("QObject", "sweep %1"),
    QT_TRANSLATE_NOOP("QObject", "demo draw-bell after the blast"),
    QT_TRANSLATE_NOOP("QObject", "demo draw-bell"),
};

// Parts of sentences of a live scanner, of connecting, of opening and of poses; core_notes.h has those about a file.
constexpr std::array kParts{
    QT_TRANSLATE_NOOP("QObject", "INCOMPLETE: %1 lines are there, how many there were is not known."),
    QT_TRANSLATE_NOOP("QObject", "INCOMPLETE %1 lines"),
    QT_TRANSLATE_NOOP("QObject", "Telegrams were lost: lines "),
    QT_TRANSLATE_NOOP("QObject", "Telegrams were lost: line "),
    QT_TRANSLATE_NOOP("QObject", "Telegrams had fewer beams than the sweep, the others are lost: "),
    QT_TRANSLATE_NOOP("QObject", "The line angles are computed from time alone: a change of speed bends the cloud."),
    QT_TRANSLATE_NOOP("QObject",
                      "The telegrams carry encoder counts, but the number of counts per degree was not given: angles do not follow them."),
    QT_TRANSLATE_NOOP("QObject", "The scanner lost its encoder count when it restarted: the line angles after that are computed."),
    QT_TRANSLATE_NOOP("QObject", " (from line %1 on)."),
    QT_TRANSLATE_NOOP("QObject", "How a motor turned the scanner was not said in full. ASSUMED: "),
    QT_TRANSLATE_NOOP("QObject", "the axis (spin)"),
    QT_TRANSLATE_NOOP("QObject", "the axis (sweep)"),
    QT_TRANSLATE_NOOP("QObject", "the axis (spin, seen in the ranges)"),
    QT_TRANSLATE_NOOP("QObject", "the axis (sweep, seen in the ranges)"),
    QT_TRANSLATE_NOOP("QObject", "the step from line to line (%1 degrees"),
    QT_TRANSLATE_NOOP("QObject", "the motor turning on while a line is measured)"),
    QT_TRANSLATE_NOOP("QObject", "the angle of the first line (%1 degrees)"),
    QT_TRANSLATE_NOOP("QObject", "Give %1 where that is wrong."),
    QT_TRANSLATE_NOOP("QObject", "The first line received is taken as line 0 of the sweep."),
    QT_TRANSLATE_NOOP("QObject", "The encoder count of the first line received is taken as the first angle of the sweep."),
    QT_TRANSLATE_NOOP("QObject", "The scanner reported an error or was not ready"),
    QT_TRANSLATE_NOOP("QObject", "The scanner reported a window too dirty to measure through"),
    QT_TRANSLATE_NOOP("QObject", "The scanner reported a dirty window"),
    QT_TRANSLATE_NOOP("QObject", " in all)"),
    QT_TRANSLATE_NOOP("QObject", "Trying again in %1 s."),
    QT_TRANSLATE_NOOP("QObject", "Connecting to %1."),
    QT_TRANSLATE_NOOP("QObject", " accepts the connection; asking what it is."),
    QT_TRANSLATE_NOOP("QObject", " is sending again."),
    QT_TRANSLATE_NOOP("QObject", " is sending."),
    QT_TRANSLATE_NOOP("QObject", ": no scan for %1 s."),
    QT_TRANSLATE_NOOP("QObject", ": disconnected."),
    QT_TRANSLATE_NOOP("QObject", "The sweep has ended; no line has come since."),
    QT_TRANSLATE_NOOP("QObject", "there is no such file"),
    QT_TRANSLATE_NOOP("QObject", "check the spelling and the folder"),
    QT_TRANSLATE_NOOP("QObject", "reading this file is not allowed"),
    QT_TRANSLATE_NOOP("QObject", "ask its owner for the right to read it"),
    QT_TRANSLATE_NOOP("QObject", "this is a folder, not a file"),
    QT_TRANSLATE_NOOP("QObject", "choose a file inside it"),
    QT_TRANSLATE_NOOP("QObject", "there is not enough memory for this scan"),
    QT_TRANSLATE_NOOP("QObject", "close other programs or open a smaller scan"),
    QT_TRANSLATE_NOOP("QObject", "there is not enough memory to show the scan in its place"),
    QT_TRANSLATE_NOOP("QObject", "there is not enough memory for this layer"),
    QT_TRANSLATE_NOOP("QObject", "there is not enough memory for a second picture"),
    QT_TRANSLATE_NOOP("QObject", "there is not enough memory for a second scan"),
    QT_TRANSLATE_NOOP("QObject", "there is not enough memory for these scans"),
    QT_TRANSLATE_NOOP("QObject", "there is not enough memory for this cloud"),
    QT_TRANSLATE_NOOP("QObject", "there is not enough memory to play this recording"),
    QT_TRANSLATE_NOOP("QObject", "hide or remove other layers, or choose a smaller scan"),
    QT_TRANSLATE_NOOP("QObject", "close other programs or choose a smaller scan"),
    QT_TRANSLATE_NOOP("QObject", "close other programs or choose a smaller one"),
    QT_TRANSLATE_NOOP("QObject", "close other programs or use fewer scans"),
    QT_TRANSLATE_NOOP("QObject", "close other programs or use a smaller scan"),
    QT_TRANSLATE_NOOP("QObject", "another program has changed this file, so it was not removed"),
    QT_TRANSLATE_NOOP("QObject", "open the scan again to see its edits"),
    QT_TRANSLATE_NOOP("QObject", "the file cannot be removed (%1)"),
    QT_TRANSLATE_NOOP("QObject", "check the rights of its folder"),
    QT_TRANSLATE_NOOP("QObject", "it could not be opened (%1)"),
    QT_TRANSLATE_NOOP("QObject", "auto is not a number"),
    QT_TRANSLATE_NOOP("QObject", "tick auto next to the box"),
    QT_TRANSLATE_NOOP("QObject", "the layer has another content than when it was placed"),
    QT_TRANSLATE_NOOP("QObject", "remove it and add it again"),
    QT_TRANSLATE_NOOP("QObject", "it was cancelled, so nothing was written"),
    QT_TRANSLATE_NOOP("QObject", "save it again"),
    QT_TRANSLATE_NOOP("QObject", "the file cannot be read: "),
    QT_TRANSLATE_NOOP("QObject", "check the disk and the path"),
    QT_TRANSLATE_NOOP("QObject", "there is not enough memory for this file"),
    QT_TRANSLATE_NOOP("QObject", "close other programs or open a smaller file"),
    QT_TRANSLATE_NOOP("QObject", "close other programs"),
    QT_TRANSLATE_NOOP("QObject", "this is a web page (HTML), not a scan"),
    QT_TRANSLATE_NOOP("QObject", "this is a JPEG picture, not a scan"),
    QT_TRANSLATE_NOOP("QObject", "this is a picture or film, not a scan"),
    QT_TRANSLATE_NOOP("QObject", "this is a PDF document, not a scan"),
    QT_TRANSLATE_NOOP("QObject", "this is a ZIP archive, not a scan"),
    QT_TRANSLATE_NOOP("QObject", "this is a program, not a scan"),
    QT_TRANSLATE_NOOP("QObject", "it may be what a site sent instead of the file: download the file again, or choose a scan file"),
    QT_TRANSLATE_NOOP("QObject", "choose a scan file"),
    QT_TRANSLATE_NOOP("QObject", "unpack it and open the scan in it"),
    QT_TRANSLATE_NOOP("QObject", "copy the file again, it may be cut off"),
    QT_TRANSLATE_NOOP("QObject", "copy the file again"),
    QT_TRANSLATE_NOOP("QObject", "export the file again"),
    QT_TRANSLATE_NOOP("QObject", "the folder to write into does not exist"),
    QT_TRANSLATE_NOOP("QObject", "make the folder or choose another"),
    QT_TRANSLATE_NOOP("QObject", "the folder to write into is not a folder"),
    QT_TRANSLATE_NOOP("QObject", "writing here is not allowed"),
    QT_TRANSLATE_NOOP("QObject", "choose another folder or ask for the right to write"),
    QT_TRANSLATE_NOOP("QObject", "the disk can only be read"),
    QT_TRANSLATE_NOOP("QObject", "the disk is full, so this file was not written"),
    QT_TRANSLATE_NOOP("QObject", "free some space or choose another disk"),
    QT_TRANSLATE_NOOP("QObject", "the file cannot be written: "),
    QT_TRANSLATE_NOOP("QObject", "choose another folder or disk"),
    QT_TRANSLATE_NOOP("QObject", "choose another folder"),
    QT_TRANSLATE_NOOP("QObject", "the file name is too long"),
    QT_TRANSLATE_NOOP("QObject", "choose a shorter name"),
    QT_TRANSLATE_NOOP("QObject", "give a file name"),
    QT_TRANSLATE_NOOP("QObject", "this file is read-only, so it was not replaced"),
    QT_TRANSLATE_NOOP("QObject", "allow writing with chmod u+w, or choose another name"),
    QT_TRANSLATE_NOOP("QObject", "this file belongs to another user, who does not allow writing, so it was not replaced"),
    QT_TRANSLATE_NOOP("QObject", "choose another name, or ask its owner"),
    QT_TRANSLATE_NOOP("QObject", "it is not a regular file, so settings are not read and nothing of this window is stored"),
    QT_TRANSLATE_NOOP("QObject", "remove it and start again"),
    QT_TRANSLATE_NOOP("QObject", "not all settings in this file can be read"),
    QT_TRANSLATE_NOOP("QObject", "what it held is in "),
    QT_TRANSLATE_NOOP("QObject", "this file was read as an input"),
    QT_TRANSLATE_NOOP("QObject", "this is the file that was read as an input under the name "),
    QT_TRANSLATE_NOOP("QObject", "choose another name"),
    QT_TRANSLATE_NOOP("QObject", "nothing answers there"),
    QT_TRANSLATE_NOOP("QObject", "check power, cable and the address, and that this computer is in the scanner's network"),
    QT_TRANSLATE_NOOP("QObject", "the connection is refused"),
    QT_TRANSLATE_NOOP("QObject", "check the port (2111 or 2112) and that no other program holds the scanner"),
    QT_TRANSLATE_NOOP("QObject", "there is no way to this address"),
    QT_TRANSLATE_NOOP("QObject", "check the cable and the network settings of this computer"),
    QT_TRANSLATE_NOOP("QObject", "check the address and the network settings of this computer"),
    QT_TRANSLATE_NOOP("QObject", "cannot connect (%1)"),
    QT_TRANSLATE_NOOP("QObject", "no scanner is given"),
    QT_TRANSLATE_NOOP("QObject", "give its IP address or host name"),
    QT_TRANSLATE_NOOP("QObject", "the host name is not known"),
    QT_TRANSLATE_NOOP("QObject", "check its spelling or use the scanner's IP address"),
    QT_TRANSLATE_NOOP("QObject", "the name server does not answer"),
    QT_TRANSLATE_NOOP("QObject", "use the scanner's IP address"),
    QT_TRANSLATE_NOOP("QObject", "the scanner closed the connection"),
    QT_TRANSLATE_NOOP("QObject", "the connection broke (%1)"),
    QT_TRANSLATE_NOOP("QObject", "no line was received"),
    QT_TRANSLATE_NOOP("QObject", "check cable, address and port"),
    QT_TRANSLATE_NOOP("QObject", "check the cable and whether the scanner's mirror turns"),
    QT_TRANSLATE_NOOP("QObject", "the scanner refuses to send scans: "),
    QT_TRANSLATE_NOOP("QObject", "check what else uses it"),
    QT_TRANSLATE_NOOP("QObject", "a recording is being written already"),
    QT_TRANSLATE_NOOP("QObject", "stop it first"),
    QT_TRANSLATE_NOOP("QObject", "the file ends within its E57 header"),
    QT_TRANSLATE_NOOP("QObject", "this is E57 version %1, and version 1 is known"),
    QT_TRANSLATE_NOOP("QObject", "export it as E57 version 1.0"),
    QT_TRANSLATE_NOOP("QObject", "the E57 header says that pages have %1 bytes"),
    QT_TRANSLATE_NOOP("QObject", "the E57 header promises %1 bytes and the file holds "),
    QT_TRANSLATE_NOOP("QObject", "the columns of points in this E57 file are nested too deep"),
    QT_TRANSLATE_NOOP("QObject", "the limits of the column %1 in this E57 file are not possible"),
    QT_TRANSLATE_NOOP("QObject", "scan %1 of this E57 file does not say where its points are and how many"),
    QT_TRANSLATE_NOOP("QObject", "the E57 header says that the XML part is at byte %1 and has "),
    QT_TRANSLATE_NOOP("QObject", "the XML part of this E57 file cannot be read: "),
    QT_TRANSLATE_NOOP("QObject", "the XML part of this E57 file has no e57Root"),
    QT_TRANSLATE_NOOP("QObject", "page %1 of %2 of this E57 file is damaged: its checksum does not fit"),
    QT_TRANSLATE_NOOP("QObject", "this E57 file ends before something that it names"),
    QT_TRANSLATE_NOOP("QObject", "this E57 file holds no scan"),
    QT_TRANSLATE_NOOP("QObject", "the file holds one scan"),
    QT_TRANSLATE_NOOP("QObject", "the file holds %1 scans"),
    QT_TRANSLATE_NOOP("QObject", "scan %1 of this E57 file holds no points"),
    QT_TRANSLATE_NOOP("QObject", "choose another scan or file"),
    QT_TRANSLATE_NOOP("QObject", "choose another scan"),
    QT_TRANSLATE_NOOP("QObject", "choose another file"),
    QT_TRANSLATE_NOOP("QObject", "the points are said to begin at byte %1, which is not in the file"),
    QT_TRANSLATE_NOOP("QObject", "no list of points begins where the E57 file says"),
    QT_TRANSLATE_NOOP("QObject", "the header of the points does not fit the file"),
    QT_TRANSLATE_NOOP("QObject", "a packet of points "),
    QT_TRANSLATE_NOOP("QObject", "the file promises %1 points and "),
    QT_TRANSLATE_NOOP("QObject", "this ZIP archive has no directory at its end"),
    QT_TRANSLATE_NOOP("QObject", "the directory of this ZIP archive is damaged"),
    QT_TRANSLATE_NOOP("QObject", "this ZIP archive does not begin where its directory says: other bytes are before it or in it"),
    QT_TRANSLATE_NOOP("QObject", "this part of the archive is encrypted"),
    QT_TRANSLATE_NOOP("QObject", "save it without a password"),
    QT_TRANSLATE_NOOP("QObject", "this part of the archive is packed by method %1"),
    QT_TRANSLATE_NOOP("QObject", "pack it with DEFLATE, as usual"),
    QT_TRANSLATE_NOOP("QObject", "this part of the archive is not where its directory says"),
    QT_TRANSLATE_NOOP("QObject", "unpacked this is %1, far more than a scan of its size can be"),
    QT_TRANSLATE_NOOP("QObject", "unpack it by hand and look at it"),
    QT_TRANSLATE_NOOP("QObject", "this part of the archive is damaged: its length or its checksum does not fit"),
    QT_TRANSLATE_NOOP("QObject", "it is a ROS bag of another version than 2.0"),
    QT_TRANSLATE_NOOP("QObject", "convert it with \"rosbag migrate\""),
    QT_TRANSLATE_NOOP("QObject", "this SQLite database is cut off or damaged: its tables cannot be read"),
    QT_TRANSLATE_NOOP("QObject", "this SQLite database is not a ROS bag: it has no table of topics"),
    QT_TRANSLATE_NOOP("QObject", "this SQLite database cannot be opened"),
    QT_TRANSLATE_NOOP("QObject", "copy it again"),
    QT_TRANSLATE_NOOP("QObject", "this is not an MCAP recording of a known version"),
    QT_TRANSLATE_NOOP("QObject", "choose a recording"),
    QT_TRANSLATE_NOOP("QObject", "this folder holds %1 files of a bag"),
    QT_TRANSLATE_NOOP("QObject", "open one of them, as "),
    QT_TRANSLATE_NOOP("QObject", "no topic of this %1 is a laser's"),
    QT_TRANSLATE_NOOP("QObject", "choose another bag"),
    QT_TRANSLATE_NOOP("QObject", "the bag has no topic "),
    QT_TRANSLATE_NOOP("QObject", "the topic %1 holds no scan"),
    QT_TRANSLATE_NOOP("QObject", "choose one of them with "),
    QT_TRANSLATE_NOOP("QObject", "choose one of "),
    QT_TRANSLATE_NOOP("QObject", "the laser did not turn while it measured"),
    QT_TRANSLATE_NOOP("QObject", "choose another topic, or give the joint that turns it"),
    QT_TRANSLATE_NOOP("QObject", "no line of the topic %1 could be placed"),
    QT_TRANSLATE_NOOP("QObject", "no message of the topic %1 is a line of ranges"),
    QT_TRANSLATE_NOOP("QObject", "The recording holds %1 sweeps; sweep %2 was opened; no other has more lines."),
    QT_TRANSLATE_NOOP("QObject", "no transform turns the laser's frame %1 while it measures"),
    QT_TRANSLATE_NOOP("QObject", "no joint turned while the laser measured"),
    QT_TRANSLATE_NOOP("QObject", "there is no joint called "),
    QT_TRANSLATE_NOOP("QObject", "choose another topic"),
    QT_TRANSLATE_NOOP("QObject", "the scan has no pose, so its place in the mine grid is not known"),
    QT_TRANSLATE_NOOP("QObject", "give a pose and the robot's calibration, or save in the scanner's frame"),
    // Of a pose, of several stations, and of a scan before and after.
    QT_TRANSLATE_NOOP("QObject", "The pose carries no time, so its age is not known."),
    QT_TRANSLATE_NOOP("QObject", "The start of the scan is not known, so the age of the pose is not either."),
    QT_TRANSLATE_NOOP("QObject", "OUT OF SPEC: the angles of the stepper are assumed, so E, N and RL may be wrong: give mounting, step and "
                                 "angle of the first line."),
    QT_TRANSLATE_NOOP("QObject",
                      "The calibration does not give %1, so 0 is used: add what is missing (Scan > Pose and Mounting, page Mounting)."),
    QT_TRANSLATE_NOOP("QObject", "OUT OF SPEC: the pose is %1 s older than the start of the scan."),
    QT_TRANSLATE_NOOP("QObject", "OUT OF SPEC: the tilt of the head changed by %1 degrees while it scanned, more than "),
    QT_TRANSLATE_NOOP("QObject", "OUT OF SPEC: %1 of %2 lines were measured before the first or after the last pose and were given the "
                                 "nearest one."),
    QT_TRANSLATE_NOOP("QObject", "OUT OF SPEC: whether the surfaces of \"%1\" fit cannot be seen."),
    QT_TRANSLATE_NOOP("QObject", "OUT OF SPEC: the surfaces of \"%1\" are %2 mm from those of the first scan at best."),
    QT_TRANSLATE_NOOP("QObject", "OUT OF SPEC: the base moved while \"%1\" was taken: one place fits it badly."),
    QT_TRANSLATE_NOOP("QObject", "OUT OF SPEC: without a pose of both, the two scans are lined up by their surfaces alone."),
    QT_TRANSLATE_NOOP("QObject",
                      "OUT OF SPEC: the surfaces of the two scans do not lie where their poses put them: %1 apart, and %2 if one "
                      "is moved by "),
    QT_TRANSLATE_NOOP("QObject",
                      "OUT OF SPEC: the surfaces of the two scans lie %1 apart at best, so most of the place changed or they are "
                      "not scans of one place. No areas of change are given."),
    QT_TRANSLATE_NOOP("QObject", "OUT OF SPEC: whether the poses fit cannot be seen, "),
    QT_TRANSLATE_NOOP("QObject", "OUT OF SPEC: the poses do not fit the surfaces, so the earlier scan was moved by its surfaces, by "),
    // Of a list of points.
    QT_TRANSLATE_NOOP("QObject", "The file lists only points: %1 lines, %2 beams and mounting "),
    QT_TRANSLATE_NOOP("QObject", "were found from them."),
    QT_TRANSLATE_NOOP("QObject",
                      "This file is an export of edge points, not a scan: all other cells count as no return. Open the scan to find "
                      "edges."),
};

/// Where the window sets what a flag sets. The flags of reading are fields of one dialog.
constexpr std::array<std::pair<const char*, const char*>, 8> kPlaces{{
    {"straighten", QT_TRANSLATE_NOOP("QObject", "Scan > Straighten Beams")},
    {"keep-repeated", QT_TRANSLATE_NOOP("QObject", "Scan > Keep Repeated Values")},
    {"frame", QT_TRANSLATE_NOOP("QObject", "the coordinates in the export dialog")},
    {"include-attached", QT_TRANSLATE_NOOP("QObject", "the points behind others in the export dialog")},
    {"with-filled", QT_TRANSLATE_NOOP("QObject", "the filled cells in the export dialog")},
    {"comments", QT_TRANSLATE_NOOP("QObject", "the comments in the export dialog")},
    {"fill", QT_TRANSLATE_NOOP("QObject", "the filling of gaps in the Edges panel")},
    {"picture-outlines", QT_TRANSLATE_NOOP("QObject", "the outlines in the picture")},
}};
constexpr std::array kFieldsOfReading{"beam-start", "beam-step", "line-start", "line-step", "unit", "grid-step",  "axis",
                                      "sensor",     "project",   "scan",       "columns",   "pose", "calibration"};

/// All parts of sentences, the longer ones first: one may hold another.
std::vector<const char*> sentenceParts() {
    std::vector<const char*> parts(kParts.begin(), kParts.end());
    parts.insert(parts.end(), kNotes.begin(), kNotes.end());
    parts.insert(parts.end(), kRefusals.begin(), kRefusals.end());
    std::ranges::stable_sort(parts, std::ranges::greater(), [](const char* part) { return std::strlen(part); });
    return parts;
}

QString wordsOf(const QString& text) {
    static const CoreTexts texts(kWholeTexts, true);
    return texts.translated(text, wordsOf);
}

/// Null: the flag is not one of reading.
const ReadingOption* optionOf(const QString& flag) {
    const auto table = readingOptionTable();
    const auto option = std::ranges::find_if(table, [&](const ReadingOption& each) { return flag == QLatin1String(each.key); });
    return option == table.end() ? nullptr : &*option;
}

/// "unit" and "cm" -> "“unit: cm” in Scan > How the Scan Is Read".
QString placeOf(const QString& flag, const QString& value) {
    const auto known = std::ranges::find_if(kPlaces, [&](const auto& each) { return flag == QLatin1String(each.first); });
    const QString valued = value.isEmpty() ? QString() : ": " + value;
    if (known != kPlaces.end()) return QObject::tr(known->second) + valued;
    if (std::ranges::any_of(kFieldsOfReading, [&](const char* field) { return flag == QLatin1String(field); })) {
        static const QRegularExpression unit("\\s*\\[.*$");
        const ReadingOption* option = optionOf(flag);
        const bool isNamed = option != nullptr && option->kind == ReadingOption::Kind::Number; // by its label
        return QObject::tr("“%1” in Scan > How the Scan Is Read").arg((isNamed ? QObject::tr(option->help).remove(unit) : flag) + valued);
    }
    return QObject::tr("“%1”").arg(QString(flag).replace('-', ' ') + valued);
}

/// A number, or one of the words that the flag takes; other words go on with the sentence.
bool isValueOf(const QString& flag, const QString& word) {
    const ReadingOption* option = optionOf(flag);
    const bool isNumber = !word.isEmpty() && (word.front().isDigit() || word.front() == '-');
    return isNumber || (option != nullptr && std::ranges::find(option->words, exactBytes(word)) != option->words.end());
}

QString withoutFlags(QString text) {
    // A flag, what its value is called, or a word that may be one, and the place in the window that some texts name themselves.
    static const QRegularExpression flag("(?<![\\w-])--([a-z][a-z-]*)(?: [A-Z][A-Z,.a-z]*(?:\\.json)?)?( \\([^)]* > [^)]*\\))?"
                                         "(?: (-?[0-9](?:[0-9.,-]*[0-9])?|[a-z]+))?");
    for (auto found = flag.match(text); found.hasMatch(); found = flag.match(text)) {
        const QString named = found.captured(2).mid(2).chopped(1);
        const QString value = isValueOf(found.captured(1), found.captured(3)) ? found.captured(3) : QString();
        const QString place = named.isEmpty() ? placeOf(found.captured(1), value) : QObject::tr(exactBytes(named).c_str());
        const int end = !value.isEmpty() || found.captured(3).isEmpty() ? found.capturedEnd() : found.capturedStart(3) - 1;
        text.replace(found.capturedStart(), end - found.capturedStart(), place);
    }
    return text;
}

/// The label in the form, without its unit and its list of axes.
QString fieldOf(const PlaceField& field) {
    static const QRegularExpression rest("(\\[|\\s*: ).*$");
    return QObject::tr("“%1”").arg(QObject::tr(field.label).remove(rest).trimmed());
}

/// "talin.in_robot_m" of a pose or calibration file -> "“Lever arm of TALIN in the robot”", as in Scan > Pose and Mounting.
QString withoutKeys(QString text) {
    for (const std::span<const PlaceField> form : {poseFields(), mountingFields()}) {
        for (const PlaceField& field : form) {
            const QString key = QString("%1.%2").arg(field.group, field.key);
            if (*field.group == '\0' || !text.contains(key)) continue;
            text.replace(QRegularExpression("\"?\\b" + QRegularExpression::escape(key) + "\\b\"?"), fieldOf(field));
        }
    }
    return text;
}

} // namespace

CoreTexts::CoreTexts(std::span<const char* const> sources, bool whole) : whole_(whole) {
    static const QRegularExpression place("%[1-9]");
    for (const char* source : sources) {
        const QStringList parts = QString::fromUtf8(source).split(place);
        QStringList escaped;
        for (const QString& part : parts) escaped << QRegularExpression::escape(part);
        const QString match = escaped.join("(.+?)");
        texts_.push_back(
            {source, *std::ranges::max_element(parts, {}, &QString::size), QRegularExpression(whole ? "^" + match + "$" : match)});
    }
}

QString CoreTexts::translated(QString text, QString (*inner)(const QString&)) const {
    for (const auto& [source, words, match] : texts_) {
        if (!text.contains(words)) continue;
        int at = 0; // behind what is translated already
        for (auto found = match.match(text); found.hasMatch(); found = match.match(text, at)) {
            QString part = QObject::tr(source);
            for (int n = found.lastCapturedIndex(); n >= 1; --n)
                part.replace("%" + QString::number(n), inner == nullptr ? found.captured(n) : inner(found.captured(n)));
            if (whole_) return part;
            text.replace(found.capturedStart(), found.capturedLength(), part);
            at = found.capturedStart() + part.size();
        }
    }
    return text;
}

std::string inLanguage(const char* text) { return exactBytes(QObject::tr(text)); }

QString coreWords(const std::string& text) { return wordsOf(shownText(text)); }

QString cellStateText(CellState state) {
    static constexpr std::array<const char*, kCellStates> kStates{
        QT_TRANSLATE_NOOP("QObject", "valid"),         QT_TRANSLATE_NOOP("QObject", "no return"),
        QT_TRANSLATE_NOOP("QObject", "device status"), QT_TRANSLATE_NOOP("QObject", "out of window"),
        QT_TRANSLATE_NOOP("QObject", "masked"),        QT_TRANSLATE_NOOP("QObject", "lost")};
    return QObject::tr(kStates[static_cast<std::size_t>(state)]);
}

QString scanName(const std::string& name, int mostCharacters) {
    static const CoreTexts texts(kScanNames, true);
    return shownName(texts.translated(exactText(name)), mostCharacters);
}

QString coreSentence(const QString& text) {
    static const CoreTexts parts(sentenceParts(), false);
    return parts.translated(withoutKeys(withoutFlags(text)));
}

QString coreSentence(const std::string& text) { return coreSentence(shownText(text)); }

QString scannersWarning(QString warning) {
    static const QRegularExpression advice("Give --[^.]* where that is wrong\\.");
    return warning.replace(advice, QObject::tr("Scan > Sweep… takes what is right."));
}

QString assumedText(const Scan& scan) {
    switch (assumedIn(scan)) {
    case Assumed::Nothing:
    case Assumed::Direction: // coordinates have a warning of their own
        break;
    case Assumed::SeenAxis:
        return QObject::tr("▲ mounting from the ranges");
    case Assumed::Step:
        return QObject::tr("▲ step assumed");
    case Assumed::Mounting:
        return QObject::tr("▲ mounting assumed");
    }
    return {};
}

} // namespace edgescan::ui
