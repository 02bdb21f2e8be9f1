// The parts of the cloud view that need no display: geometry, camera motion, picking, budget, mouse bindings.
#include "cloud_demo_scan.h"
#include "tests/support/placements.h"
#include "tests/ui/run_test.h"

#include "core/scan/georef/placed_points.h"
#include "ui/views/cloud/camera_motion.h"
#include "ui/views/cloud/cloud_geometry.h"
#include "ui/views/cloud/cloud_view.h"
#include "ui/views/cloud/drawing_budget.h"
#include "ui/views/cloud/point_pick.h"

#include <algorithm>
#include <numbers>
#include <random>
#include <set>

using namespace edgescan;
using namespace edgescan::ui;
using Eigen::Vector3d;

namespace {

constexpr double kAspect = 1.4;

ScreenView viewOf(const CloudGeometry& cloud, const CameraPose& pose, double height = 500.0, double pointSize = 2.0) {
    return {worldToClip(pose, clipRange(pose, cloud, 0.0, 0.0), kAspect), height * kAspect, height, pointSize};
}

CameraPose lens(bool parallel = false) {
    CameraPose pose;
    pose.viewAngleDeg = 60.0;
    pose.parallel = parallel;
    return pose;
}

std::shared_ptr<Scan> minePoints(const Vector3d& at) {
    auto scan = std::make_shared<Scan>();
    PointGeometry geometry;
    geometry.pointsM = Grid<Vector3d>(20, 30, Vector3d::Zero());
    geometry.sensorM = at;
    scan->rangeMm = Grid<float>(20, 30, 1.0F);
    scan->state = Grid<CellState>(20, 30, CellState::Valid);
    for (int i = 0; i < 20; ++i) {
        for (int j = 0; j < 30; ++j) geometry.pointsM.at(i, j) = at + Vector3d(0.001 * j, 5.0, -0.001 * i);
    }
    geometry.pointsM.at(3, 4) = Vector3d::Constant(std::nan(""));
    scan->geometry = geometry;
    return scan;
}

/// Of the points along one direction of the grid, as far as they are on one surface with the cell.
Eigen::Vector3f slope(const CloudGeometry& cloud, int line, int beam, int down, int right) {
    const auto cell = [&](int i, int j) {
        return static_cast<std::size_t>(i) * static_cast<std::size_t>(cloud.beams) + static_cast<std::size_t>(j);
    };
    const auto range = [&](std::size_t k) { return (cloud.point(k) - cloud.sensor).norm(); };
    const std::size_t own = cell(line, beam);
    Eigen::Vector3f sum = Eigen::Vector3f::Zero();
    for (const int sign : {-1, 1}) {
        for (int n = 1; n <= 3; ++n) {
            const int i = line + sign * n * down, j = beam + sign * n * right;
            if (i < 0 || i >= cloud.lines || j < 0 || j >= cloud.beams || cloud.valid[cell(i, j)] == 0) break;
            if (std::abs(range(cell(i, j)) - range(own)) > static_cast<float>(n) * 0.04F * range(own) + 0.05F) break;
            sum += static_cast<float>(sign * n) * (cloud.point(cell(i, j)) - cloud.point(own));
        }
    }
    return sum;
}

} // namespace

class CloudRoomsTest : public QObject {
    Q_OBJECT
private slots:
    void drawingOrderHoldsEveryValidCellOnce() {
        const auto scan = demo::room(101, 157, 3);
        const auto cloud = makeCloudGeometry(*scan);
        std::vector<std::uint32_t> all;
        for (std::size_t part = 0; part < cloud->drawOrder.size(); ++part) {
            const auto& order = cloud->drawOrder[part];
            QVERIFY(std::is_sorted(order.begin(), order.end()));
            all.insert(all.end(), order.begin(), order.end());
            const double share = static_cast<double>(all.size()) / static_cast<double>(cloud->validCount);
            QVERIFY2(std::abs(share - kPartEnds[part]) < 0.01, qPrintable(QString::number(share)));
        }
        QCOMPARE(all.size(), cloud->validCount);
        QCOMPARE(cloud->validCount, countCells(*scan)[0]);
        const std::set<std::uint32_t> once(all.begin(), all.end());
        QCOMPARE(once.size(), all.size());
        for (const std::uint32_t k : all) QVERIFY(scan->state[k] == CellState::Valid);
    }

    void normalsAreThoseOfTheSurfaceAround() {
        for (const auto& [lines, beams] : {std::pair(101, 157), std::pair(2, 40), std::pair(9, 3)}) {
            const auto cloud = makeCloudGeometry(*demo::room(lines, beams, 3));
            for (std::size_t k = 0; k < cloud->cells(); ++k) {
                const int line = static_cast<int>(k) / beams, beam = static_cast<int>(k) % beams;
                const Eigen::Vector3f toSensor = (cloud->sensor - cloud->point(k)).normalized();
                Eigen::Vector3f expected = slope(*cloud, line, beam, 0, 1).cross(slope(*cloud, line, beam, 1, 0));
                expected = expected.norm() > 0 ? Eigen::Vector3f(expected.normalized()) : toSensor;
                if (expected.dot(toSensor) < 0) expected = -expected;
                if (cloud->valid[k] == 0) expected.setZero();
                QVERIFY2((cloud->normal(k) - expected).norm() < 0.008F,
                         qPrintable(QString("%1 x %2, cell %3").arg(lines).arg(beams).arg(k)));
            }
        }
    }

    void coarsePartsLeaveNoHoles() {
        const auto cloud = makeCloudGeometry(*demo::room(128, 128));
        std::array<int, 64> perBlock{}; // 16 x 16 cells each
        for (const std::uint32_t k : cloud->drawOrder[0]) ++perBlock[(k / 128 / 16) * 8 + (k % 128) / 16];
        QVERIFY(*std::min_element(perBlock.begin(), perBlock.end()) >= 2);
        QVERIFY(*std::max_element(perBlock.begin(), perBlock.end()) <= 6);
    }

    void pointsAreThoseOfTheTables() {
        const auto scan = demo::room(40, 50, 7);
        const auto cloud = makeCloudGeometry(*scan);
        const CartesianTables tables(*scan);
        for (std::size_t k = 0; k < scan->cells(); ++k) {
            QCOMPARE(cloud->drawable(k), scan->state[k] == CellState::Valid);
            if (cloud->drawable(k)) QVERIFY((cloud->point(k).cast<double>() - tables.point(k)).norm() < 1e-5);
        }
        QVERIFY(!cloud->drawable(scan->cells()));
    }

    void mineCoordinatesKeepTheirMillimetres() {
        const Vector3d at(723456.7, 5150321.4, 1872.3);
        const auto scan = minePoints(at);
        const auto cloud = makeCloudGeometry(*scan);
        const auto& points = std::get<PointGeometry>(scan->geometry).pointsM;
        QCOMPARE(std::fmod(cloud->originM.y(), 1000.0), 0.0);
        QVERIFY(!cloud->drawable(3 * 30 + 4));
        for (std::size_t k = 0; k < cloud->cells(); ++k) {
            if (cloud->drawable(k)) QVERIFY((cloud->point(k).cast<double>() + cloud->originM - points[k]).norm() < 1e-4);
        }
        QVERIFY(cloud->axes.up.isApprox(Vector3d::UnitZ()));
        QVERIFY(cloud->axes.forward.isApprox(Vector3d::UnitY()));
    }

    // The plan has north on top, the elevations have RL up; the view from the scanner is the same as without a pose.
    void aPoseGivesTheViewsTheMinesAxes() {
        for (const unsigned seed : {1U, 2U, 3U, 4U}) {
            Scan scan = *demo::room(60, 80);
            const ViewFrame bare = makeCloudGeometry(scan)->scannerView;
            scan.placement = test::randomPlacement(seed, 1, true);
            const auto cloud = makeCloudGeometry(scan);
            const PlacedPoints placed(scan);
            const auto moved = [&](const Vector3d& way) {
                return Vector3d(placed.mine(30, 40, Vector3d(1, 2, 3) + way) - placed.mine(30, 40, Vector3d(1, 2, 3)));
            };
            QVERIFY((moved(cloud->axes.up) - Vector3d::UnitZ()).norm() < 1e-3);
            QVERIFY((moved(cloud->axes.forward) - Vector3d::UnitY()).norm() < 1e-3);
            QVERIFY((moved(cloud->axes.right) - Vector3d::UnitX()).norm() < 1e-3);
            QCOMPARE(cloud->scannerView.up, bare.up);
        }
    }

    void scannerSeesRowZeroOnTopAndColumnZeroAtTheLeft() {
        const auto scan = demo::room(60, 80);
        const auto cloud = makeCloudGeometry(*scan);
        for (const bool parallel : {false, true}) {
            const ScreenView view = viewOf(*cloud, fromScanner(*cloud, lens(parallel), kAspect));
            const auto at = [&](int line, int beam) { return toScreen(view, cloud->point(scan->rangeMm.index(line, beam))); };
            QVERIFY(at(10, 40).y < at(50, 40).y);
            QVERIFY(at(30, 10).x < at(30, 70).x);
        }
    }

    void strayReturnDoesNotHideTheCloud() {
        const auto scan = demo::room(60, 80);
        scan->rangeMm.at(30, 40) = 8e6F;
        const auto cloud = makeCloudGeometry(*scan);
        QVERIFY(cloud->mainBounds.diagonal().norm() < 40.0F);
        const ScreenView view = viewOf(*cloud, lookingAt(cloud->mainBounds, cloud->axes.forward, cloud->axes.up, lens(), kAspect));
        int inside = 0;
        for (std::size_t k = 0; k < cloud->cells(); ++k) {
            const ScreenPoint p = toScreen(view, cloud->point(k));
            inside += p.inside && p.x >= 0 && p.x < view.width && p.y >= 0 && p.y < view.height;
        }
        QVERIFY(inside > 0.95 * static_cast<double>(cloud->cells()));
    }

    void turntableKeepsTheHorizonAndTheDistance() {
        const auto cloud = makeCloudGeometry(*demo::room(60, 80));
        CameraPose pose = fromScanner(*cloud, lens(), kAspect);
        const Vector3d centre(0.3, -0.2, 6.0);
        const Vector3d up = turntableAxis(pose, cloud->axes.up, cloud->scannerView.up);
        const double distance = (pose.position - centre).norm();
        std::mt19937 random(7);
        std::uniform_real_distribution<double> step(-0.5, 0.5);
        for (int i = 0; i < 500; ++i) {
            pose = turned(pose, centre, up, step(random), step(random));
            QVERIFY(std::abs((pose.position - centre).norm() - distance) < 1e-6 * distance);
            QVERIFY(std::abs(pose.right().dot(up)) < 1e-6); // the horizon stays horizontal
            QVERIFY(pose.up.dot(up) > 0.0);                 // and never flips
        }
    }

    // In a draw-bell the scanner looks along its z: a turn about z would only roll its picture. Seen from a side, up is z.
    void theTurntableHasTheAxisOfThePicture() {
        for (const bool posed : {false, true}) {
            Scan scan = *demo::room(60, 80);
            if (posed) scan.placement = test::randomPlacement(3, 1, false);
            const auto cloud = makeCloudGeometry(scan);
            const Vector3d top = cloud->scannerView.up, up = cloud->axes.up;
            if (!posed) QVERIFY(up.isApprox(Vector3d::UnitZ()) && std::abs(cloud->axes.forward.z()) < 1e-9);
            const auto axisFrom = [&](const Vector3d& forward, const Vector3d& above) {
                return turntableAxis(lookingAt(cloud->mainBounds, forward, above, lens(), kAspect), up, top);
            };
            QVERIFY(axisFrom(cloud->axes.forward, up) == up);
            QVERIFY(axisFrom(cloud->axes.right, up) == up);
            const CameraPose first = fromScanner(*cloud, lens(), kAspect);
            const Vector3d axis = turntableAxis(first, up, top);
            QVERIFY(axis == top || std::abs(top.dot(up)) > 0.7);
            QVERIFY(std::abs(first.forward().dot(axis)) < 0.75); // a turn moves the view to the side
        }
        const auto level = makeCloudGeometry(*minePoints({0, 0, 0}));
        QVERIFY(turntableAxis(fromScanner(*level, lens(), kAspect), level->axes.up, level->scannerView.up) == level->axes.up);
    }

    void dragRightTurnsTheFrontToTheRight() {
        const auto cloud = makeCloudGeometry(*demo::room(60, 80));
        const CameraPose pose = fromScanner(*cloud, lens(), kAspect);
        const Vector3d centre = pose.focus;
        const Eigen::Vector3f front = (centre - 1.0 * pose.forward()).cast<float>();
        const auto at = [&](const CameraPose& p) { return toScreen(viewOf(*cloud, p), front); };
        const Vector3d axis = turntableAxis(pose, cloud->axes.up, cloud->scannerView.up);
        QVERIFY(at(turned(pose, centre, axis, 0.2, 0.0)).x > at(pose).x + 1.0);
        QVERIFY(at(turned(pose, centre, axis, 0.0, 0.2)).y < at(pose).y - 1.0);
        QVERIFY(at(tumbled(pose, centre, 0.2, 0.0)).x > at(pose).x + 1.0);
    }

    void zoomKeepsTheAnchorInPlace() {
        const auto cloud = makeCloudGeometry(*demo::room(60, 80));
        for (const bool parallel : {false, true}) {
            CameraPose pose = fromScanner(*cloud, lens(parallel), kAspect);
            const Eigen::Vector3f anchor = cloud->point(12 * 80 + 20);
            const ScreenPoint before = toScreen(viewOf(*cloud, pose), anchor);
            for (int i = 0; i < 6; ++i) pose = zoomed(pose, anchor.cast<double>(), 1.2);
            const ScreenPoint after = toScreen(viewOf(*cloud, pose), anchor);
            QVERIFY(std::abs(before.x - after.x) < 1e-6 && std::abs(before.y - after.y) < 1e-6);
        }
    }

    void panFollowsTheHand() {
        const auto cloud = makeCloudGeometry(*demo::room(60, 80));
        for (const bool parallel : {false, true}) {
            const CameraPose pose = fromScanner(*cloud, lens(parallel), kAspect);
            const Eigen::Vector3f anchor = cloud->point(30 * 80 + 40);
            const ScreenPoint a = toScreen(viewOf(*cloud, pose), anchor);
            const ScreenPoint b = toScreen(viewOf(*cloud, panned(pose, anchor.cast<double>(), 30, -12, 500)), anchor);
            QVERIFY(std::abs(b.x - a.x - 30) < 1e-3 && std::abs(b.y - a.y + 12) < 1e-3);
        }
    }

    void cursorRayHitsWhatItWasProjectedFrom() {
        const auto cloud = makeCloudGeometry(*demo::room(60, 80));
        for (const bool parallel : {false, true}) {
            const CameraPose pose = rolled(fromScanner(*cloud, lens(parallel), kAspect), 0.3);
            const ScreenView view = viewOf(*cloud, pose);
            const Eigen::Vector3f p = cloud->point(5 * 80 + 61);
            const ScreenPoint s = toScreen(view, p);
            const double depth = pose.forward().dot(p.cast<double>() - pose.position);
            const Vector3d back = underCursor(pose, 2 * s.x / view.width - 1, 1 - 2 * s.y / view.height, depth, kAspect);
            QVERIFY((back - p.cast<double>()).norm() < 1e-5);
        }
    }

    void pickEqualsBruteForce() {
        std::mt19937 random(11);
        for (const int holes : {0, 3}) {
            const auto cloud = makeCloudGeometry(*demo::room(120, 160, holes));
            int hits = 0;
            for (int i = 0; i < 300; ++i) {
                CameraPose pose = fromScanner(*cloud, lens(i % 4 == 3), kAspect);
                std::uniform_real_distribution<double> angle(-2.0, 2.0), x(0.0, 700.0), y(0.0, 500.0), size(1.0, 6.0), zoom(0.5, 20.0);
                pose = tumbled(pose, pose.focus, angle(random), angle(random));
                pose = zoomed(pose, pose.focus, zoom(random));
                const ScreenView view = viewOf(*cloud, pose, 500.0, std::round(size(random)));
                const double px = x(random), py = y(random);
                const auto fast = pickPoint(*cloud, view, px, py, 8.0);
                QCOMPARE(fast, pickPointSlowly(*cloud, view, px, py, 8.0));
                hits += fast.has_value();
            }
            QVERIFY(hits > 50);
        }
    }

    // Of some cells that are drawn over the others: each visible one whose square covers the pixel, the nearest of them.
    void pickOfWhatIsDrawnOverEqualsBruteForce() {
        std::mt19937 random(12);
        const auto cloud = makeCloudGeometry(*demo::room(120, 160));
        std::vector<std::uint32_t> some;
        for (std::uint32_t k = 0; k < cloud->cells(); ++k) {
            if (random() % 7 == 0) some.push_back(k);
        }
        int hits = 0;
        for (int i = 0; i < 300; ++i) {
            std::uniform_real_distribution<double> angle(-0.5, 0.5), x(0.0, 700.0), y(0.0, 500.0);
            const CameraPose start = fromScanner(*cloud, lens(), kAspect);
            const ScreenView view = viewOf(*cloud, tumbled(start, start.focus, angle(random), angle(random)), 500.0, 3.0);
            const double px = x(random), py = y(random), half = 2.0;
            std::optional<std::uint32_t> best;
            double least = half;
            for (const std::uint32_t k : some) {
                if (!cloud->drawable(k)) continue;
                const ScreenPoint p = toScreen(view, cloud->point(k));
                const double away = std::max(std::abs(p.x - px), std::abs(p.y - py));
                if (!p.inside || away > least || (best && away == least) || isPointHidden(*cloud, view, k)) continue;
                best = k;
                least = away;
            }
            QCOMPARE(pickDrawnOver(*cloud, view, px, py, half, some), best);
            hits += best.has_value();
        }
        QVERIFY2(hits > 20 && hits < 280, qPrintable(QString::number(hits)));
    }

    // A hole is where the surface around it would have been seen: from the scanner exactly there, from elsewhere close to it.
    void aCellOfAHoleIsFoundWhereItWouldBeDrawn() {
        const auto whole = demo::room(120, 160);
        auto holed = std::make_shared<Scan>(*whole);
        for (int i = 50; i < 66; ++i) {
            for (int j = 70; j < 90; ++j) holed->state.at(i, j) = CellState::NoReturn;
        }
        const auto before = makeCloudGeometry(*whole), cloud = makeCloudGeometry(*holed);
        const Eigen::Vector3f moved = (before->originM - cloud->originM).cast<float>();
        const CartesianTables tables(*holed);
        const auto apart = [](std::uint32_t a, std::uint32_t b) {
            const int lines = static_cast<int>(a / 160) - static_cast<int>(b / 160),
                      beams = static_cast<int>(a % 160) - static_cast<int>(b % 160);
            return std::max(std::abs(lines), std::abs(beams));
        };
        for (const double turned : {0.0, 0.15}) {
            const CameraPose start = fromScanner(*cloud, lens(), kAspect);
            const ScreenView view = viewOf(*cloud, tumbled(start, start.focus, turned, turned), 500.0, 3.0);
            for (std::uint32_t k = 0; k < cloud->cells(); ++k) {
                if (holed->state[k] == CellState::Valid) continue;
                const ScreenPoint at = toScreen(view, before->point(k) + moved);
                const auto found = pickVoid(*cloud, tables, view, at.x, at.y, 32.0);
                QVERIFY(found.has_value());
                QVERIFY(holed->state[*found] != CellState::Valid);
                QVERIFY2(apart(*found, k) <= (turned == 0.0 ? 0 : 2), qPrintable(QString("%1 %2").arg(k).arg(*found)));
            }
            const auto far = toScreen(view, cloud->point(5 * 160 + 5));
            QVERIFY(!pickVoid(*cloud, tables, view, far.x, far.y, 32.0));
        }
    }

    void pickedPointIsNeverHidden() {
        const auto cloud = makeCloudGeometry(*demo::room(120, 160));
        CameraPose pose = fromScanner(*cloud, lens(), kAspect);
        pose = turned(pose, pose.focus, cloud->axes.up, 0.9, 0.3);
        const ScreenView view = viewOf(*cloud, pose, 500.0, 4.0);
        std::size_t picked = 0, hidden = 0;
        for (double x = 20; x < view.width; x += 37) {
            for (double y = 20; y < view.height; y += 29) {
                const auto cell = pickPoint(*cloud, view, x, y, 8.0);
                if (!cell) continue;
                ++picked;
                QVERIFY(!isPointHidden(*cloud, view, *cell));
            }
        }
        QVERIFY(picked > 50);
        for (std::uint32_t k = 0; k < cloud->cells(); k += 17) hidden += isPointHidden(*cloud, view, k);
        QVERIFY(hidden > 0); // in the side view rock hides rock
    }

    void laserRayIsCutAtTheCamera() {
        CameraPose pose = lens();
        pose.position = {0, 0, 5};
        pose.focus = {0, 0, 10};
        CloudGeometry cloud;
        cloud.bounds.extend(Eigen::Vector3f(-1, -1, 0));
        cloud.bounds.extend(Eigen::Vector3f(1, 1, 10));
        cloud.mainBounds = cloud.bounds;
        const ScreenView view = viewOf(cloud, pose);
        QVERIFY(screenSegment(view, {0, 0, 0}, {0.5F, 0, 10}).has_value());
        QVERIFY(!screenSegment(view, {0, 0, 0}, {0.5F, 0, 4}).has_value());
        const auto whole = screenSegment(view, {0, 0, 7}, {0.5F, 0, 10});
        QVERIFY(whole && std::abs(whole->x0 - 350) < 1e-6);
    }

    void budgetKeepsTheFrameTime() {
        // A simulated machine: 12 ms + 140 ms x fraction, with 20 % jitter.
        std::mt19937 random(3);
        std::uniform_real_distribution<double> jitter(0.9, 1.1);
        DrawingBudget budget(1000.0); // a wrong first estimate
        double worstMoving = 0.0, worstRest = 0.0;
        for (int i = 0; i < 60; ++i) {
            const bool moving = i % 6 != 0;
            const double fraction = kPartEnds[static_cast<std::size_t>(budget.lastPart(moving))];
            const double ms = (12.0 + 140.0 * fraction) * jitter(random);
            budget.measured(fraction, ms);
            if (i > 20) (moving ? worstMoving : worstRest) = std::max(moving ? worstMoving : worstRest, ms);
        }
        QVERIFY2(worstMoving < 1.2 * DrawingBudget::kMovingMs && worstMoving > 0.6 * DrawingBudget::kMovingMs,
                 qPrintable(QString::number(worstMoving)));
        QVERIFY2(worstRest < 100.0 && worstRest > 50.0, qPrintable(QString::number(worstRest)));
    }

    // 2 ms + 1 ms per 10 000 points while the number of points grows tenfold: the measured frames stay useful.
    void budgetFollowsACloudThatGrows() {
        DrawingBudget budget(1000.0);
        double points = 100'000.0;
        double worst = 0.0;
        for (int i = 0; i < 40; ++i) {
            const double fraction = kPartEnds[static_cast<std::size_t>(budget.lastPart(true))];
            const double ms = 2.0 + fraction * points / 10'000.0;
            budget.measured(fraction, ms);
            if (i > 8) worst = std::max(worst, ms);
            const double more = std::min(1'000'000.0, points * 1.08);
            budget.grown(points / more);
            points = more;
        }
        QVERIFY2(worst < 1.25 * DrawingBudget::kMovingMs, qPrintable(QString::number(worst)));
        QCOMPARE(points, 1'000'000.0);
    }

    void budgetDrawsAllOnAFastMachine() {
        DrawingBudget budget;
        for (int i = 0; i < 12; ++i) budget.measured(kPartEnds[static_cast<std::size_t>(budget.lastPart(i % 2 == 0))], 2.0);
        QCOMPARE(budget.lastPart(true), kCloudParts - 1);
        QCOMPARE(budget.lastPart(false), kCloudParts - 1);
    }

    void budgetNeverDrawsNothing() {
        DrawingBudget budget;
        for (int i = 0; i < 12; ++i) budget.measured(1.0, 5000.0);
        QCOMPARE(budget.lastPart(true), 0);
    }

    void mouseMeansWhatViewerMdSays() {
        QVERIFY(dragAction(Qt::LeftButton, Qt::NoModifier) == DragAction::Rotate);
        QVERIFY(dragAction(Qt::LeftButton, Qt::ShiftModifier) == DragAction::Pan);
        QVERIFY(dragAction(Qt::LeftButton, Qt::ControlModifier) == DragAction::Roll);
        QVERIFY(dragAction(Qt::MiddleButton, Qt::NoModifier) == DragAction::Pan);
        QVERIFY(dragAction(Qt::RightButton, Qt::NoModifier) == DragAction::Zoom);
        QVERIFY(dragAction(Qt::RightButton, Qt::NoModifier, MousePreset::CloudCompare) == DragAction::Pan);
        QVERIFY(dragAction(Qt::MiddleButton, Qt::NoModifier, MousePreset::CloudCompare) == DragAction::Zoom);
        QVERIFY(wheelAction(Qt::NoModifier) == WheelAction::Zoom);
        QVERIFY(wheelAction(Qt::AltModifier) == WheelAction::PointSize);
        QVERIFY(wheelAction(Qt::ControlModifier) == WheelAction::NearClip);
        QVERIFY(wheelAction(Qt::ControlModifier | Qt::ShiftModifier) == WheelAction::FarClip);
    }

    void emptyAndInvalidScans() {
        const Scan nothing;
        QCOMPARE(makeCloudGeometry(nothing)->validCount, std::size_t(0));
        const auto scan = demo::room(20, 30, 1);
        const auto cloud = makeCloudGeometry(*scan);
        QCOMPARE(cloud->validCount, std::size_t(0));
        QVERIFY(cloud->scannerView.forward.allFinite() && cloud->axes.right.allFinite());
        const CameraPose pose = fromScanner(*cloud, lens(), kAspect);
        QVERIFY(pose.position.allFinite() && pose.up.allFinite());
        QVERIFY(!pickPoint(*cloud, viewOf(*cloud, pose), 100, 100, 8));
    }
};

int cloud_rooms_test(int argc, char** argv) { return runTest<CloudRoomsTest, QCoreApplication>(argc, argv); }
#include "cloud_rooms_test.moc"
