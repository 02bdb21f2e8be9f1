// The scene of a picture in every combination of A/B, confidence, rocks and flip, without a window.
#include "ui/engine/linked_views/scene.h"

#include "core/edges/pipeline/methods.h"
#include "core/edges/pipeline/pipeline.h"
#include "tests/support/scans.h"
#include "tests/ui/run_test.h"

#include <set>

using namespace edgescan;
using namespace edgescan::ui;

namespace {

using Colours = std::shared_ptr<const std::vector<std::uint32_t>>;
constexpr std::uint32_t kOthers = 0xff112233U;
const EdgeColours kBandColours{Qt::cyan, Qt::magenta, Qt::yellow, Qt::gray, Qt::black};
const EdgeColours kChangeColours{Qt::red, Qt::green, Qt::blue, Qt::white, Qt::black};

std::shared_ptr<const Picture> pictureOf(const std::shared_ptr<const Scan>& scan) {
    return makePicture(edges::detectEdges(scan, edges::Settings{}), {}, edges::Settings{}, makeCloudGeometry(*scan), nullptr);
}

std::shared_ptr<const QImage> imageLike(const QImage& image) {
    return std::make_shared<const QImage>(image.size(), QImage::Format_ARGB32_Premultiplied);
}

std::shared_ptr<const OverlayEdges> edgesOn(const Picture& picture, const EdgeColours& colours, bool asAsked) {
    EdgeCells cells{std::make_shared<const std::vector<std::uint32_t>>(1, 7U), {}};
    return std::make_shared<const OverlayEdges>(
        OverlayEdges{cells, colours, imageLike(*picture.edges), imageLike(*picture.edges), asAsked, "words"});
}

enum class AB { Off, Shown, Flipped, FlippedWithoutChanges };
enum class Sure { Off, Working, Made };
enum class RocksAre { Off, Unknown, Known, OfFewerLines };

/// One combination: what goes in, and what has to come out, stated rule by rule.
struct Case {
    AB ab = AB::Off;
    Sure sure = Sure::Off;
    RocksAre rocks = RocksAre::Off;
    SceneState state;

    [[nodiscard]] bool flip() const { return ab == AB::Flipped || ab == AB::FlippedWithoutChanges; }
    [[nodiscard]] bool changes() const { return ab == AB::Shown || ab == AB::Flipped; }
};

} // namespace

class SceneTest : public QObject {
    Q_OBJECT
private:
    std::shared_ptr<const Picture> picture_, a_;
    std::shared_ptr<const OverlayEdges> changes_, bands_;
    Colours changed_, staying_, rocks_, fewer_;
    std::shared_ptr<const QImage> faces_;

    [[nodiscard]] Overlays overlaysOf(const Case& on) const {
        Overlays overlays;
        const int beams = picture_->detection->scan->beams();
        if (on.changes()) {
            Overlay overlay;
            overlay.name = OverlayName::Comparison;
            overlay.scan = picture_->detection->scan;
            overlay.edges = changes_;
            overlay.points = OverlayPoints{changed_, beams, 0, true, staying_};
            overlays[1] = overlay;
        }
        if (on.sure != Sure::Off) {
            Overlay overlay;
            overlay.name = OverlayName::Confidence;
            overlay.legend = true;
            if (on.sure == Sure::Made) {
                overlay.scan = picture_->detection->scan;
                overlay.edges = bands_;
            }
            overlays[0] = overlay;
        }
        if (on.rocks != RocksAre::Off) {
            Overlay overlay;
            overlay.name = OverlayName::Rocks;
            overlay.points = OverlayPoints{nullptr, beams, kOthers, false};
            if (on.rocks != RocksAre::Unknown) {
                overlay.faces = faces_;
                overlay.facesFaded = on.rocks == RocksAre::OfFewerLines;
                overlay.points->colours = on.rocks == RocksAre::Known ? rocks_ : fewer_;
            }
            overlays[2] = overlay;
        }
        return overlays;
    }

    void checkEdges(const Case& on, const Scene& scene) const {
        const Picture& shown = on.flip() ? *a_ : *picture_;
        const auto instead = on.changes() ? changes_ : on.sure == Sure::Made ? bands_ : nullptr;
        QVERIFY(scene.instead == instead);
        const OverlayEdges* now = on.flip() ? nullptr : instead.get();
        QVERIFY(scene.insteadNow() == now);
        const bool plain = !on.state.byClass && on.state.colours == kUsualColours;
        if (now != nullptr) {
            QVERIFY(scene.edgeMap == now->map);
            QVERIFY(scene.cells == now->cells && scene.colours == now->colours && scene.byClass);
            const bool over = now == changes_.get() || on.state.edgesOverImage;
            QVERIFY(scene.overGray == (over ? now->overImage : nullptr));
            return;
        }
        QVERIFY(scene.cells == shown.edgeCells && scene.colours == on.state.colours && scene.byClass == on.state.byClass);
        if (on.state.byClass)
            QVERIFY(*scene.edgeMap == classPicture(shown, on.state.colours));
        else
            QVERIFY(scene.edgeMap == shown.edges);
        if (!on.state.edgesOverImage)
            QVERIFY(scene.overGray == nullptr);
        else if (plain)
            QVERIFY(scene.overGray == shown.overlay);
        else
            QVERIFY(*scene.overGray == edgeOverlay(shown, on.state.colours, on.state.byClass));
    }

    void checkPoints(const Case& on, const Scene& scene) const {
        QVERIFY(scene.faces == (!on.flip() && on.rocks >= RocksAre::Known ? faces_ : nullptr));
        QCOMPARE(scene.facesFaded, !on.flip() && on.rocks == RocksAre::OfFewerLines);
        const bool changes = !on.flip() && on.changes() && on.rocks == RocksAre::Off;
        const bool both = !on.flip() && on.changes() && on.rocks >= RocksAre::Known;
        QCOMPARE(scene.edgesOverPoints, changes || both);
        QCOMPARE(scene.pointsOver != nullptr, both);
        if (both) {
            const auto& rocks = on.rocks == RocksAre::Known ? *rocks_ : *fewer_;
            for (std::size_t k = 0; k < scene.points->size(); ++k)
                QCOMPARE((*scene.points)[k], (*staying_)[k] != 0 ? (*staying_)[k] : k < rocks.size() ? rocks[k] : kOthers);
        } else if (on.rocks == RocksAre::OfFewerLines && !on.flip()) {
            QVERIFY(scene.points != nullptr && scene.points->size() == rocks_->size());
            QVERIFY(std::equal(fewer_->begin(), fewer_->end(), scene.points->begin()));
            QCOMPARE(scene.points->back(), kOthers);
        } else {
            QVERIFY(scene.points == (changes ? changed_ : !on.flip() && on.rocks == RocksAre::Known ? rocks_ : nullptr));
        }
    }

    void check(const Case& on) const {
        const Overlays overlays = overlaysOf(on);
        const Scene scene = sceneOf(on.state, picture_, overlays);
        QVERIFY(scene.picture == (on.flip() ? a_ : picture_));
        if (on.state.window)
            QVERIFY(*scene.gray == grayPicture(*scene.picture->detection, on.state.window, scene.picture->gray->height()));
        else
            QVERIFY(scene.gray == scene.picture->gray);
        checkEdges(on, scene);
        checkPoints(on, scene);
        QCOMPARE(scene.legend, on.sure != Sure::Off && !on.changes() ? std::optional(OverlayName::Confidence) : std::nullopt);
        const Scene again = sceneOf(on.state, picture_, overlays, scene);
        QVERIFY(again.gray == scene.gray && again.edgeMap == scene.edgeMap && again.overGray == scene.overGray);
        QVERIFY(again.points == scene.points && again.cells == scene.cells);
    }

private slots:
    void initTestCase() {
        picture_ = pictureOf(std::make_shared<const Scan>(test::boxesScan(40, 60, 2)));
        a_ = pictureOf(std::make_shared<const Scan>(test::boxesScan(40, 60, 3)));
        QVERIFY(picture_->detection->classes && a_->detection->classes && !picture_->detection->edges->empty());
        changes_ = edgesOn(*picture_, kChangeColours, false);
        bands_ = edgesOn(*picture_, kBandColours, true);
        const std::size_t cells = picture_->detection->scan->cells();
        changed_ = std::make_shared<const std::vector<std::uint32_t>>(cells, 0xff010203U);
        auto staying = std::make_shared<std::vector<std::uint32_t>>(cells, 0U);
        for (std::size_t k = 0; k < cells; k += 3) (*staying)[k] = 0xff010203U;
        staying_ = std::move(staying);
        rocks_ = std::make_shared<const std::vector<std::uint32_t>>(cells, 0xff040506U);
        fewer_ = std::make_shared<const std::vector<std::uint32_t>>(cells / 2, 0xff070809U);
        faces_ = imageLike(*picture_->edges);
    }

    void everyCombination() {
        int cases = 0;
        for (const AB ab : {AB::Off, AB::Shown, AB::Flipped, AB::FlippedWithoutChanges})
            for (const Sure sure : {Sure::Off, Sure::Working, Sure::Made})
                for (const RocksAre rocks : {RocksAre::Off, RocksAre::Unknown, RocksAre::Known, RocksAre::OfFewerLines})
                    for (int switches = 0; switches < 16; ++switches) {
                        Case on{ab, sure, rocks, {}};
                        on.state.edgesOverImage = (switches & 1) != 0;
                        on.state.byClass = (switches & 2) != 0;
                        if ((switches & 4) != 0) on.state.colours = kColourBlindColours;
                        if ((switches & 8) != 0) on.state.window = RangeSpan{1.0, 3.0};
                        if (on.flip()) on.state.flippedTo = a_;
                        check(on);
                        if (QTest::currentTestFailed())
                            QFAIL(qPrintable(QString("A/B %1, confidence %2, rocks %3, switches %4")
                                                 .arg(static_cast<int>(ab))
                                                 .arg(static_cast<int>(sure))
                                                 .arg(static_cast<int>(rocks))
                                                 .arg(switches)));
                        ++cases;
                    }
        QCOMPARE(cases, 768);
    }

    void anotherScanKeepsNothingOfTheOverlaysBefore() {
        Case on{AB::Shown, Sure::Made, RocksAre::Off, {}};
        const Scene scene = sceneOf(on.state, a_, overlaysOf(on), sceneOf(on.state, picture_, overlaysOf(on)));
        QVERIFY(scene.picture == a_ && scene.instead == nullptr && scene.edgeMap == a_->edges && scene.points == nullptr);
    }

    void aSwitchKeepsThePointersOfAllElse() {
        Case on{AB::Off, Sure::Off, RocksAre::OfFewerLines, {}};
        on.state.byClass = on.state.edgesOverImage = true;
        on.state.window = RangeSpan{1.0, 3.0};
        const Scene first = sceneOf(on.state, picture_, overlaysOf(on));
        SceneState window = on.state;
        window.window = RangeSpan{1.0, 2.0};
        const Scene other = sceneOf(window, picture_, overlaysOf(on), first);
        QVERIFY(other.gray != first.gray);
        QVERIFY(other.edgeMap == first.edgeMap && other.overGray == first.overGray && other.points == first.points);
        SceneState colours = on.state;
        colours.colours = kColourBlindColours;
        const Scene third = sceneOf(colours, picture_, overlaysOf(on), first);
        QVERIFY(third.gray == first.gray && third.points == first.points);
        QVERIFY(third.edgeMap != first.edgeMap && third.overGray != first.overGray);
    }

    void withoutAPictureThereIsOnlyALegend() {
        Case on{AB::Off, Sure::Working, RocksAre::Unknown, {}};
        const Scene scene = sceneOf(on.state, nullptr, overlaysOf(on));
        QVERIFY(scene.picture == nullptr && scene.gray == nullptr && scene.instead == nullptr && scene.points == nullptr);
        QVERIFY(scene.legend == OverlayName::Confidence);
    }

    // A wall with an opening that nothing comes back from, and a box in front of it.
    void rimsOfVoidsHaveTheirOwnLookWithoutColoursByClass() {
        const Picture picture = *pictureOf(std::make_shared<const Scan>(test::makeScan(60, 80, [](int i, int j) {
            if (i > 10 && i < 30 && j > 10 && j < 40) return 0.0;
            return i > 40 && i < 52 && j > 50 && j < 70 ? 3000.0 : 5000.0;
        })));
        const auto& classes = *picture.detection->classes;
        std::size_t rims = 0, others = 0;
        std::set<QRgb> rimInMap, rimOver, otherInMap, otherOver;
        for (const std::uint32_t k : *picture.detection->edges) {
            const int line = static_cast<int>(k) / 80, beam = static_cast<int>(k) % 80;
            const bool rim = classes[k] == edges::DepthEdge::VoidRim;
            ++(rim ? rims : others);
            (rim ? rimInMap : otherInMap).insert(picture.edges->pixel(beam, line));
            (rim ? rimOver : otherOver).insert(picture.overlay->pixel(beam, line));
        }
        QVERIFY(rims > 80 && others > 40);
        QCOMPARE(otherInMap, std::set<QRgb>{qRgb(255, 255, 255)});
        QCOMPARE(otherOver, std::set<QRgb>{kUsualColours.front().rgba()});
        // Dashed: two shades, both of another colour than edges.
        QCOMPARE(rimInMap.size(), std::size_t{2});
        QCOMPARE(rimOver.size(), std::size_t{2});
        QVERIFY(rimOver.contains(kUsualColours[kRimClass].rgba()) && !rimInMap.contains(qRgb(255, 255, 255)));
        QVERIFY(picture.edgeCells.sizes[kRimClass] < picture.edgeCells.sizes.front());
        const EdgeColours drawn = drawnColours(kColourBlindColours, false);
        QCOMPARE(drawn[1], kColourBlindColours[0]);
        QCOMPARE(drawn[kRimClass], kColourBlindColours[kRimClass]);
        QCOMPARE(drawnColours(kColourBlindColours, true), kColourBlindColours);
    }
};

int scene_test(int argc, char** argv) { return runTest<SceneTest, QCoreApplication>(argc, argv); }
#include "scene_test.moc"
