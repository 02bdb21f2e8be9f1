// Lets stones fall until they rest, with the physics of Bullet.
#include "app/lab/stones/heap.h"
#include "core/base/portable_math.h"
#include "core/base/simd.h"

#ifdef EDGESCAN_BULLET
#include <btBulletDynamicsCommon.h>
#endif

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>

namespace edgescan::lab {
namespace {

using sim::Purpose;
using sim::RandomSequence;

constexpr double kBetweenStonesS = 0.06; // one stone after another is let go
constexpr double kLargeM = 0.55;         // larger stones need a fine mesh, or their triangles are visible

/// Where the stones are when they are let go, in the order in which they are.
Heap heapAtStart(const Site& site, const Stones& stones, const std::string& set, std::uint64_t seed) {
    std::vector<const Stone*> all, fine;
    for (const Stone& stone : stones.stones) {
        if (!isInSet(stone.name, set)) continue;
        all.push_back(&stone);
        if (stone.edgeLength < 0.05 && !stone.name.starts_with("apollo")) fine.push_back(&stone);
    }
    if (fine.empty()) fine = all;
    RandomSequence sizes(seed, Purpose::Sizes), shapes(seed, Purpose::Shapes), places(seed, Purpose::Places);
    const StoneSizes& usual = site.sizes;
    Heap heap;
    for (int n = 0; n < usual.count && !all.empty(); ++n) {
        RestingStone stone;
        stone.sizeM = std::clamp(usual.medianM * portable::exp(usual.sigma * sizes.normal()), usual.leastM, usual.mostM);
        const std::vector<const Stone*>& from = stone.sizeM < kLargeM ? all : fine;
        stone.stone = from[static_cast<std::size_t>(shapes.whole(0, static_cast<int>(from.size()) - 1))]->name;
        Eigen::Vector4d turn;
        for (int axis = 0; axis < 4; ++axis) turn[axis] = shapes.normal();
        stone.turn = Eigen::Quaterniond(turn.normalized());
        stone.placeM = site.start(stone.sizeM, places);
        heap.push_back(std::move(stone));
    }
    return heap;
}

#ifdef EDGESCAN_BULLET

btVector3 toBullet(const Eigen::Vector3d& v) {
    return {static_cast<btScalar>(v.x()), static_cast<btScalar>(v.y()), static_cast<btScalar>(v.z())};
}

/// Bullet's convex hull with a faster search for the corner that is farthest in a direction, where most of the time goes. Its type is not
/// that of a hull, because Bullet calls its own search for a hull.
class StoneShape : public btConvexHullShape {
public:
    StoneShape(const std::vector<Eigen::Vector3f>& hull, btScalar size) {
        for (const Eigen::Vector3f& corner : hull) addPoint(btVector3(corner.x(), corner.y(), corner.z()) * size, false);
        setMargin(0.002F * size + 0.001F);
        recalcLocalAabb();
        m_shapeType = CUSTOM_CONVEX_SHAPE_TYPE;
        const auto inRow = [this](int n) { return getUnscaledPoints()[std::min(n, getNumPoints() - 1)]; };
        for (int n = 0; n < getNumPoints(); n += kTogether) {
            Group& group = groups_.emplace_back();
            for (int k = 0; k < kTogether; ++k) {
                group.x[k / 4][k % 4] = inRow(n + k).x();
                group.y[k / 4][k % 4] = inRow(n + k).y();
                group.z[k / 4][k % 4] = inRow(n + k).z();
            }
        }
    }

    btVector3 localGetSupportingVertexWithoutMargin(const btVector3& along) const override {
        const FourLanes x = along.x() - FourLanes{}, y = along.y() - FourLanes{}, z = along.z() - FourLanes{};
        std::array<FourLanes, kChains> farthest;
        std::array<Numbers, kChains> number{};
        for (std::size_t c = 0; c < kChains; ++c) farthest[c] = groups_[0].x[c] * x + groups_[0].y[c] * y + groups_[0].z[c] * z;
        for (std::size_t n = 1; n < groups_.size(); ++n) {
            const Group& group = groups_[n];
            for (std::size_t c = 0; c < kChains; ++c) { // independent of each other, so that none waits for the one before
                const FourLanes reach = group.x[c] * x + group.y[c] * y + group.z[c] * z;
                const Numbers farther = reach > farthest[c];
                farthest[c] = farther ? reach : farthest[c];
                number[c] = farther ? static_cast<int>(n) - Numbers{} : number[c];
            }
        }
        std::size_t best = 0;
        for (std::size_t k = 1; k < kTogether; ++k) best = farthest[k / 4][k % 4] > farthest[best / 4][best % 4] ? k : best;
        return getUnscaledPoints()[std::min(kTogether * number[best / 4][best % 4] + static_cast<int>(best), getNumPoints() - 1)];
    }

private:
    static constexpr int kChains = 4, kTogether = 4 * kChains;
    using Numbers = std::int32_t __attribute__((vector_size(16)));
    struct Group {
        std::array<FourLanes, kChains> x, y, z;
    };
    std::vector<Group> groups_;
};

/// Finds the contacts of two stones that hardly move only in every fourth step; in between, their known contacts move with them. That
/// halves the time, because most stones are at rest.
class PatientDispatcher : public btCollisionDispatcher {
public:
    explicit PatientDispatcher(btCollisionConfiguration* configuration) : btCollisionDispatcher(configuration) {
        setNearCallback(&PatientDispatcher::meet);
    }
    void nextStep() { ++step_; }

private:
    static bool isSlow(const btCollisionObject& object) {
        constexpr btScalar kSlowMps = 0.1F, kSlowRadPerS = 0.3F;
        const btRigidBody* body = btRigidBody::upcast(&object);
        return object.isStaticObject() || (body->getLinearVelocity().length2() < kSlowMps * kSlowMps &&
                                           body->getAngularVelocity().length2() < kSlowRadPerS * kSlowRadPerS);
    }

    static void meet(btBroadphasePair& pair, btCollisionDispatcher& dispatcher, const btDispatcherInfo& info) {
        constexpr int kPatience = 4;
        const auto turn = pair.m_pProxy0->m_uniqueId + pair.m_pProxy1->m_uniqueId + static_cast<PatientDispatcher&>(dispatcher).step_;
        const auto& one = *static_cast<const btCollisionObject*>(pair.m_pProxy0->m_clientObject);
        const auto& other = *static_cast<const btCollisionObject*>(pair.m_pProxy1->m_clientObject);
        if (pair.m_algorithm == nullptr || turn % kPatience == 0 || !isSlow(one) || !isSlow(other))
            return defaultNearCallback(pair, dispatcher, info);
        btManifoldArray contacts;
        pair.m_algorithm->getAllContactManifolds(contacts);
        for (int n = 0; n < contacts.size(); ++n)
            contacts[n]->refreshContactPoints(contacts[n]->getBody0()->getWorldTransform(), contacts[n]->getBody1()->getWorldTransform());
    }

    int step_ = 0;
};

/// The walls and the stones that fall among them.
class FallingStones {
public:
    static constexpr double kStepS = 1.0 / 150.0;

    explicit FallingStones(const Site& site) {
        world_.setGravity({0, 0, -9.81F});
        world_.getSolverInfo().m_numIterations = 10;
        world_.getSolverInfo().m_splitImpulse = 1;
        for (const SiteWall& wall : site.walls) addWall(wall.coarse);
    }
    ~FallingStones() {
        for (const auto& body : bodies_) world_.removeRigidBody(body.get());
    }
    FallingStones(const FallingStones&) = delete;
    FallingStones& operator=(const FallingStones&) = delete;

    void letGo(const RestingStone& stone, const std::vector<Eigen::Vector3f>& hull) {
        const auto size = static_cast<btScalar>(stone.sizeM);
        auto shape = std::make_unique<StoneShape>(hull, size);
        const btScalar mass = 2700.0F * 0.4F * size * size * size; // kg; about 0.4 of the cube around a stone is rock
        btVector3 inertia;
        shape->calculateLocalInertia(mass, inertia);
        const btTransform start(btQuaternion(static_cast<btScalar>(stone.turn.x()), static_cast<btScalar>(stone.turn.y()),
                                             static_cast<btScalar>(stone.turn.z()), static_cast<btScalar>(stone.turn.w())),
                                toBullet(stone.placeM));
        btRigidBody& body = add(mass, start, std::move(shape), inertia);
        body.setRollingFriction(kRolling * size);
        body.setSpinningFriction(kRolling * size);
        body.setDamping(0.05F, 0.1F);
        body.setSleepingThresholds(0.06F, 0.15F);
        body.setCcdMotionThreshold(0.3F * size);
        body.setCcdSweptSphereRadius(0.2F * size);
        stones_.push_back(&body);
    }

    void step() {
        dispatcher_.nextStep();
        world_.stepSimulation(static_cast<btScalar>(kStepS), 1, static_cast<btScalar>(kStepS));
    }

    /// Mean speed of the stones that did not fall out.
    [[nodiscard]] double meanSpeed() const {
        double sum = 0;
        for (const btRigidBody* body : stones_) {
            if (body->getWorldTransform().getOrigin().z() > -20) sum += static_cast<double>(body->getLinearVelocity().length());
        }
        return stones_.empty() ? 0 : sum / static_cast<double>(stones_.size());
    }

    /// Takes the place of the n-th stone that was let go.
    void place(std::size_t n, RestingStone& stone) const {
        const btTransform& at = stones_[n]->getWorldTransform();
        const btVector3& origin = at.getOrigin();
        const btQuaternion turn = at.getRotation();
        stone.placeM = Eigen::Vector3f(origin.x(), origin.y(), origin.z()).cast<double>();
        stone.turn = Eigen::Quaternionf(turn.w(), turn.x(), turn.y(), turn.z()).cast<double>();
        stone.speedMps = static_cast<double>(stones_[n]->getLinearVelocity().length());
    }

private:
    static constexpr btScalar kFriction = 0.8F, kRolling = 0.03F, kRestitution = 0.03F;

    btRigidBody& add(btScalar mass, const btTransform& at, std::unique_ptr<btCollisionShape> shape, const btVector3& inertia) {
        btRigidBody::btRigidBodyConstructionInfo info(mass, nullptr, shape.get(), inertia);
        info.m_startWorldTransform = at;
        shapes_.push_back(std::move(shape));
        bodies_.push_back(std::make_unique<btRigidBody>(info));
        bodies_.back()->setFriction(kFriction);
        bodies_.back()->setRestitution(kRestitution);
        world_.addRigidBody(bodies_.back().get());
        return *bodies_.back();
    }

    void addWall(const Sheet& sheet) {
        auto mesh = std::make_unique<btTriangleMesh>();
        const auto corner = [&](std::int32_t n) { return toBullet(sheet.points[static_cast<std::size_t>(n)].cast<double>()); };
        for (const auto& [a, b, c] : sheet.triangles) mesh->addTriangle(corner(a), corner(b), corner(c));
        auto shape = std::make_unique<btBvhTriangleMeshShape>(mesh.get(), true);
        shape->setMargin(0.005F);
        meshes_.push_back(std::move(mesh));
        add(0, btTransform::getIdentity(), std::move(shape), {0, 0, 0});
    }

    btDefaultCollisionConfiguration configuration_;
    PatientDispatcher dispatcher_{&configuration_};
    btDbvtBroadphase broadphase_;
    btSequentialImpulseConstraintSolver solver_;
    btDiscreteDynamicsWorld world_{&dispatcher_, &broadphase_, &solver_, &configuration_};
    std::vector<std::unique_ptr<btTriangleMesh>> meshes_;
    std::vector<std::unique_ptr<btCollisionShape>> shapes_;
    std::vector<std::unique_ptr<btRigidBody>> bodies_;
    std::vector<btRigidBody*> stones_;
};

#endif

} // namespace

#ifdef EDGESCAN_BULLET

bool canSettle() { return true; }

Result<Heap> settledHeap(const Site& site, const Stones& stones, const std::string& set, std::uint64_t seed,
                         const StoneProgress& progress) {
    constexpr double kLongestS = 60.0, kRestAfterS = 3.0, kRestMps = 0.02;
    constexpr int kLookEvery = 75; // steps
    Heap heap = heapAtStart(site, stones, set, seed);
    const double lastS = kBetweenStonesS * static_cast<double>(heap.size());
    FallingStones falling(site);
    std::size_t next = 0;
    for (int n = 0; n * FallingStones::kStepS < kLongestS || next < heap.size(); ++n) {
        const double timeS = n * FallingStones::kStepS;
        for (; next < heap.size() && kBetweenStonesS * static_cast<double>(next) <= timeS; ++next)
            falling.letGo(heap[next], stones.named(heap[next].stone)->hull);
        falling.step();
        if (n % kLookEvery != 0) continue;
        if (timeS > lastS + kRestAfterS && falling.meanSpeed() < kRestMps) break;
        if (progress && !progress(std::min(0.99, timeS / (lastS + 2 * kRestAfterS)))) return Error{"cancelled", "", ""};
    }
    for (std::size_t n = 0; n < heap.size(); ++n) falling.place(n, heap[n]);
    return heap;
}

#else

bool canSettle() { return false; }

Result<Heap> settledHeap(const Site&, const Stones&, const std::string&, std::uint64_t, const StoneProgress&) {
    return Error{"this program was built without the physics by which stones settle", "stones",
                 "install libbullet-dev and build again, or give a folder of settled heaps"};
}

#endif

} // namespace edgescan::lab
