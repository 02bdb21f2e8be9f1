// The VTK side of the cloud view.
#include "ui/views/cloud/cloud_scene.h"

#include "core/base/order_statistic.h"
#include "ui/base/selected_colour.h"

#include <qopengl.h>
#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkCullerCollection.h>
#include <vtkFloatArray.h>
#include <vtkMatrix4x4.h>
#include <vtkOpenGLPolyDataMapper.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkOpenGLVertexBufferObject.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPropCollection.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkShaderProperty.h>
#include <vtkSphereSource.h>
#include <vtkTypeInt32Array.h>
#include <vtkUniforms.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <string>
#include <vector>

namespace edgescan::ui {
namespace {

// Edge points are drawn nearer by this share of their distance, at the same place on the screen. They appear in front of the rock under
// them, and behind rock that is really nearer.
constexpr double kEdgeNearer = 0.010;
constexpr double kHaloNearer = 0.007;
constexpr double kSelectedNearer = 0.004; // in front of the cloud, behind the edges
constexpr const char* kNormals = "normals";
constexpr double kAmbient = 0.5; // share of the cloud's colour on surfaces seen edge-on: still lighter than the background
constexpr double kLargestGrowth = 2.0;
const QColor kHalo(8, 8, 8);
const QColor kFocus(255, 255, 0);
const QColor kGround(0x85, 0x8b, 0x92);
const QColor kSelected(kSelectedColour);

// The halo darkens the cloud around an edge point. It must not hide another edge point, even one far behind it.
class HaloMapper : public vtkOpenGLPolyDataMapper {
public:
    static HaloMapper* New() {
        auto* mapper = new HaloMapper;
        mapper->InitializeObjectBase();
        return mapper;
    }
    void RenderPieceDraw(vtkRenderer* renderer, vtkActor* actor) override {
        vtkOpenGLState* state = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow())->GetState();
        state->vtkglDepthMask(GL_FALSE);
        vtkOpenGLPolyDataMapper::RenderPieceDraw(renderer, actor);
        state->vtkglDepthMask(GL_TRUE);
    }
};

void setColour(vtkActor* actor, const QColor& colour) { actor->GetProperty()->SetColor(colour.redF(), colour.greenF(), colour.blueF()); }

// Lights each point once, from the eye. VTK would light each fragment: in software a picture takes an eighth longer. Surfaces that are
// farther from the scanner than `fullM` fade, so that a wall seen through an opening differs from the rocks around it.
void lightPoints(vtkActor* actor) {
    vtkShaderProperty* shader = actor->GetShaderProperty();
    const char *declared = "//VTK::Normal::Dec", *computed = "//VTK::Normal::Impl", *lit = "//VTK::Light::Impl";
    shader->AddVertexShaderReplacement(declared, true, "in float normalAxes;\nuniform mat3 normalMatrix;\nflat out vec2 shares;\n", false);
    shader->AddVertexShaderReplacement(computed, true,
                                       "vec3 axes = mod(floor(normalAxes / vec3(65536.0, 256.0, 1.0)), 256.0) - 128.0;\n"
                                       "shares = vec2(isShaded != 0 ? max(0.0, normalize(normalMatrix * axes).z) : 1.0,"
                                       " clamp(fullM / max(distance(vertexMC.xyz, scannerMC), 1.0e-6), 0.35, 1.0));\n",
                                       false);
    shader->AddFragmentShaderReplacement(declared, true, "flat in vec2 shares;\n", false);
    shader->AddFragmentShaderReplacement(
        lit, true, "gl_FragData[0] = vec4(mix(farColour, ambientColor + shares.x * diffuseColor, shares.y), opacity);\n", false);
}

void setLight(vtkActor* actor, bool isShaded, const Eigen::Vector3f& scanner, double fullM, const std::array<float, 3>& farColour) {
    vtkShaderProperty* shader = actor->GetShaderProperty();
    shader->GetVertexCustomUniforms()->SetUniformi("isShaded", isShaded ? 1 : 0);
    shader->GetVertexCustomUniforms()->SetUniform3f("scannerMC", scanner.data());
    shader->GetVertexCustomUniforms()->SetUniformf("fullM", static_cast<float>(fullM));
    shader->GetFragmentCustomUniforms()->SetUniform3f("farColour", farColour.data());
}

/// The distance from the scanner up to which surfaces have their full colour, m: more than half of the points are nearer.
double fullDistanceM(const CloudGeometry& cloud) {
    constexpr std::size_t kMeasured = 2000;
    constexpr double kBeyondMedian = 1.3;
    const std::vector<std::uint32_t>& some = cloud.drawOrder.front();
    std::vector<double> distancesM;
    const std::size_t every = std::max<std::size_t>(1, some.size() / kMeasured);
    for (std::size_t n = 0; n < some.size(); n += every) distancesM.push_back((cloud.point(some[n]) - cloud.sensor).cast<double>().norm());
    return distancesM.empty() ? 0.0 : kBeyondMedian * quantile(distancesM, 0.5);
}

// Scales towards the eye (perspective) or shifts towards it (parallel): the same pixel, a smaller depth.
void pullNearer(vtkActor* actor, const CameraPose& pose, double share) {
    vtkNew<vtkMatrix4x4> matrix;
    const Eigen::Vector3d shift =
        pose.parallel ? Eigen::Vector3d(-pose.forward() * pose.distance() * share) : Eigen::Vector3d(pose.position * share);
    const double scale = pose.parallel ? 1.0 : 1.0 - share;
    for (int i = 0; i < 3; ++i) {
        matrix->SetElement(i, i, scale);
        matrix->SetElement(i, 3, shift[i]);
    }
    actor->SetUserMatrix(matrix);
}

} // namespace

// Drops cells that are not drawable. `cells` is replaced by the remaining ones; they must outlive their use in the layer.
void CloudScene::setLayer(Layer& layer, EdgeCells::Indices& cells) {
    const auto drawable = [this](std::uint32_t k) { return now_->cloud->drawable(k); };
    if (cells && now_->cloud && !std::all_of(cells->begin(), cells->end(), drawable)) {
        auto kept = std::make_shared<std::vector<std::uint32_t>>();
        std::copy_if(cells->begin(), cells->end(), std::back_inserter(*kept), drawable);
        cells = std::move(kept);
    }
    if (cells && (!now_->cloud || cells->empty())) cells = nullptr;
    if (cells) {
        layer.setCells(now_->points, *cells);
    } else {
        layer.setCells(nullptr, {}); // drops references to the floats of a cloud that is being freed
    }
}

void CloudScene::setFaces(std::shared_ptr<const std::vector<std::uint32_t>> colours) { facesWanted_ = std::move(colours); }

void CloudScene::setGround(const GroundGrid& grid) {
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> lines;
    for (const auto& line : grid.lines) {
        lines->InsertNextCell(2);
        for (const Eigen::Vector3f& end : line) lines->InsertCellPoint(points->InsertNextPoint(end.x(), end.y(), end.z()));
    }
    ground_.data->SetPoints(points);
    ground_.data->SetLines(lines);
    ground_.actor->SetVisibility(!grid.lines.empty());
}

// Called only when the faces are drawn: a cloud that is shown again still has its former colours, and usually needs them.
void CloudScene::useFaces() {
    std::shared_ptr<const std::vector<std::uint32_t>> colours = facesWanted_;
    vtkSmartPointer<vtkUnsignedCharArray> bytes;
    if (colours && now_->cloud && colours->size() == now_->cloud->cells()) {
        if (now_->faces == colours) return;
        bytes = vtkSmartPointer<vtkUnsignedCharArray>::New();
        bytes->SetNumberOfComponents(4); // with three components VTK would make a copy for each part
        auto* first = const_cast<std::uint32_t*>(colours->data());
        bytes->SetArray(reinterpret_cast<unsigned char*>(first), static_cast<vtkIdType>(4 * colours->size()), 1);
    } else {
        colours = nullptr;
        if (!now_->faces) return;
    }
    for (Layer& part : now_->parts) {
        part.data->GetPointData()->SetScalars(bytes);
        part.mapper->SetColorModeToDirectScalars();
        part.mapper->SetScalarVisibility(bytes != nullptr);
    }
    now_->faces = std::move(colours); // only now may the former colours be freed
    fadeParts();
}

void CloudScene::setOutline(EdgeCells::Indices cells) {
    setLayer(outline_, cells);
    EdgeCells::Indices halo = cells;
    setLayer(outlineHalo_, halo);
    outline_.actor->SetVisibility(cells != nullptr);
    outlineHalo_.actor->SetVisibility(cells != nullptr);
    outlined_ = std::move(cells);
}

void CloudScene::setSelection(EdgeCells::Indices cells) {
    EdgeCells::Indices rim;
    if (cells && now_->cloud)
        rim = std::make_shared<const std::vector<std::uint32_t>>(rimOf(*cells, static_cast<std::uint32_t>(now_->cloud->beams)));
    setLayer(selection_, cells);
    setLayer(selectionRim_, rim);
    selection_.actor->SetVisibility(cells != nullptr);
    selectionRim_.actor->SetVisibility(rim != nullptr);
    selected_ = std::move(cells);
    selectedRim_ = std::move(rim);
}

void CloudScene::setEdges(EdgeCells cells) {
    setLayer(edge_, cells.all);
    EdgeCells::Indices halo = cells.all;
    for (std::size_t n = 0; n < classes_.size() && halo; ++n) {
        constexpr float kLeast = 0.5F; // smaller points would be less than their halo
        if (!cells.byClass[n] || cells.sizes[n] >= kLeast) continue;
        std::vector<std::uint32_t> larger;
        std::ranges::set_difference(*halo, *cells.byClass[n], std::back_inserter(larger));
        halo = std::make_shared<const std::vector<std::uint32_t>>(std::move(larger));
    }
    setLayer(halo_, halo);
    haloed_ = std::move(halo);
    for (std::size_t n = 0; n < classes_.size(); ++n) setLayer(classes_[n], cells.byClass[n]);
    edges_ = std::move(cells);
    showEdgeLayers();
}

void CloudScene::showEdgeLayers() {
    const bool separate = std::any_of(edges_.byClass.begin(), edges_.byClass.end(), [](const auto& c) { return c != nullptr; });
    halo_.actor->SetVisibility(edgesShown_ && edges_.all != nullptr);
    edge_.actor->SetVisibility(edgesShown_ && edges_.all != nullptr && !separate);
    for (std::size_t n = 0; n < classes_.size(); ++n) {
        classes_[n].actor->SetVisibility(edgesShown_ && separate && edges_.byClass[n] != nullptr);
        classes_[n].actor->GetProperty()->SetPointSize(edgeSize_ * edges_.sizes[n]);
    }
}

std::size_t CloudScene::edgesDrawn() const { return edges_.all && edgesShown_ ? edges_.all->size() : 0; }

CloudScene::Layer::Layer(vtkSmartPointer<vtkPolyDataMapper> with) : mapper(std::move(with)) {
    if (!mapper) mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
    mapper->SetInputData(data);
    mapper->ScalarVisibilityOff();
    mapper->StaticOn(); // the data does not come from a VTK pipeline
    // Several layers share one vertex buffer, so VTK must not shift the coordinates; CloudGeometry sets the origin.
    if (auto* gl = vtkOpenGLPolyDataMapper::SafeDownCast(mapper)) {
        gl->SetVBOShiftScaleMethod(vtkOpenGLVertexBufferObject::DISABLE_SHIFT_SCALE);
    }
    actor->SetMapper(mapper);
    // A program that may discard fragments computes the hidden ones too. Where another VTK writes it otherwise, nothing is replaced.
    actor->GetShaderProperty()->AddFragmentShaderReplacement("if (gl_FragData[0].a <= 0.0)", true, "if (false)", false);
    actor->GetProperty()->LightingOff();
    actor->PickableOff();
    actor->VisibilityOff();
}

void CloudScene::Layer::setCells(vtkPoints* points, std::span<const std::uint32_t> cells) {
    vtkNew<vtkCellArray> verts;
    if (!cells.empty()) {
        // One poly-vertex cell over the caller's array: no copy is made here.
        vtkNew<vtkTypeInt32Array> ends;
        ends->InsertNextValue(0);
        ends->InsertNextValue(static_cast<vtkTypeInt32>(cells.size()));
        vtkNew<vtkTypeInt32Array> indices;
        auto* first = const_cast<std::uint32_t*>(cells.data());
        indices->SetArray(reinterpret_cast<vtkTypeInt32*>(first), static_cast<vtkIdType>(cells.size()), 1);
        verts->SetData(ends.Get(), indices.Get());
    }
    data->SetPoints(points);
    data->SetVerts(verts);
}

CloudScene::CloudScene(vtkRenderWindow* window)
    : window_(window), halo_(vtkSmartPointer<HaloMapper>::New()), outlineHalo_(vtkSmartPointer<HaloMapper>::New()) {
    window->SetMultiSamples(0);
    window->AddRenderer(renderer_);
    // The culler would visit all points for their bounds; clipRange() sets the planes instead.
    renderer_->GetCullers()->RemoveAllItems();
    renderer_->SetAutomaticLightCreation(0);
    now_ = newCloud();
    spare_ = newCloud();
    for (Layer* layer : {&selection_, &selectionRim_}) {
        renderer_->AddActor(layer->actor);
        setColour(layer->actor, kSelected);
    }
    selection_.actor->GetProperty()->SetOpacity(kSelectedTint);
    renderer_->AddActor(halo_.actor);
    renderer_->AddActor(edge_.actor);
    for (Layer& layer : classes_) renderer_->AddActor(layer.actor);
    renderer_->AddActor(ground_.actor);
    setColour(ground_.actor, kGround);
    renderer_->AddActor(outlineHalo_.actor);
    renderer_->AddActor(outline_.actor);
    setColour(halo_.actor, kHalo);
    setColour(outlineHalo_.actor, kHalo);
    setColour(outline_.actor, Qt::white);

    focusSphere_->SetThetaResolution(32);
    focusSphere_->SetPhiResolution(24);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(focusSphere_->GetOutputPort());
    focus_->SetMapper(mapper);
    setColour(focus_, kFocus);
    focus_->GetProperty()->SetOpacity(0.3);
    focus_->GetProperty()->LightingOff();
    focus_->GetProperty()->BackfaceCullingOn();
    // Blending also works in the opaque pass. This avoids the translucent pass over the whole picture.
    focus_->ForceOpaqueOn();
    focus_->PickableOff();
    focus_->VisibilityOff();
    renderer_->AddActor(focus_);
}

CloudScene::~CloudScene() = default;

std::unique_ptr<CloudScene::DrawnCloud> CloudScene::newCloud() {
    auto made = std::make_unique<DrawnCloud>();
    for (Layer& part : made->parts) {
        part.actor->GetProperty()->SetAmbient(kAmbient);
        part.actor->GetProperty()->SetDiffuse(1.0 - kAmbient);
        part.mapper->MapDataArrayToVertexAttribute("normalAxes", kNormals, vtkDataObject::FIELD_ASSOCIATION_POINTS);
        lightPoints(part.actor);
        part.actor->ForceOpaqueOn(); // otherwise VTK searches all point colours for a transparent one
        part.actor->VisibilityOff();
        renderer_->AddActor(part.actor);
    }
    return made;
}

void CloudScene::setCloud(std::shared_ptr<const CloudGeometry> cloud) {
    setEdges({});
    setFaces(nullptr);
    setOutline(nullptr);
    setSelection(nullptr);
    const bool isSpare = cloud && spare_->cloud == cloud;
    if (isSpare || (ready_ && (cloud == ready_ || now_->cloud == ready_))) {
        for (Layer& part : now_->parts) part.actor->VisibilityOff();
        std::swap(now_, spare_);
    }
    if (!isSpare) {
        useFaces(); // the faces of the previous cloud are dropped with it
        load(*now_, std::move(cloud));
    }
    colourParts();
}

void CloudScene::load(DrawnCloud& into, std::shared_ptr<const CloudGeometry> cloud) {
    into.uploaded.fill(false);
    into.points = nullptr;
    if (cloud) {
        vtkNew<vtkFloatArray> xyz;
        xyz->SetNumberOfComponents(3);
        xyz->SetArray(const_cast<float*>(cloud->xyz.data()), static_cast<vtkIdType>(cloud->xyz.size()), 1);
        into.points = vtkSmartPointer<vtkPoints>::New();
        into.points->SetData(xyz);
        into.normals = vtkSmartPointer<vtkFloatArray>::New();
        into.normals->SetName(kNormals);
        into.normals->SetArray(const_cast<float*>(cloud->normals.data()), static_cast<vtkIdType>(cloud->normals.size()), 1);
    }
    for (std::size_t i = 0; i < into.parts.size(); ++i) {
        Layer& part = into.parts[i];
        part.actor->VisibilityOff();
        part.data->GetPointData()->RemoveArray(kNormals);
        if (cloud) {
            part.setCells(into.points, cloud->drawOrder[i]);
            part.data->GetPointData()->AddArray(into.normals);
        } else {
            part.setCells(nullptr, {});
        }
    }
    into.fullM = cloud ? fullDistanceM(*cloud) : 0.0;
    into.cloud = std::move(cloud); // only now may the floats of the previous cloud be freed
}

void CloudScene::setLayers(const std::vector<CloudLayer>& layers, const Eigen::Vector3d& shownOriginM) {
    std::vector<std::unique_ptr<DrawnCloud>> before = std::exchange(layers_, {});
    layerColours_.clear();
    for (const CloudLayer& layer : layers) {
        const auto same = std::ranges::find_if(before, [&](const auto& drawn) { return drawn && drawn->cloud == layer.cloud; });
        layers_.push_back(same != before.end() ? std::move(*same) : newCloud());
        DrawnCloud& drawn = *layers_.back();
        if (drawn.cloud != layer.cloud) load(drawn, layer.cloud);
        const RigidTransform local = layer.local(shownOriginM);
        vtkNew<vtkMatrix4x4> place;
        for (int i = 0; i < 3; ++i) {
            for (int j = 0; j < 3; ++j) place->SetElement(i, j, local.rotation(i, j));
            place->SetElement(i, 3, local.translationM[i]);
        }
        for (Layer& part : drawn.parts) part.actor->SetUserMatrix(place);
        layerColours_.push_back(layer.colour);
    }
    for (auto& drawn : before) {
        if (!drawn) continue;
        for (Layer& part : drawn->parts) part.actor->VisibilityOff();
        gone_.push_back(std::move(drawn));
    }
    drawOverLast();
    colourParts();
}

/// Halos, edges and marks have to be drawn after all clouds. The order of the list is changed without RemoveActor(), which frees what is in
/// the graphics memory.
void CloudScene::drawOverLast() {
    std::vector<vtkActor*> over{selection_.actor, selectionRim_.actor, halo_.actor, edge_.actor};
    for (Layer& layer : classes_) over.push_back(layer.actor);
    for (vtkActor* actor : {ground_.actor.Get(), outlineHalo_.actor.Get(), outline_.actor.Get(), focus_.Get()}) over.push_back(actor);
    for (vtkActor* actor : over) {
        renderer_->GetViewProps()->RemoveItem(actor);
        renderer_->GetViewProps()->AddItem(actor);
    }
}

void CloudScene::keepReady(const std::shared_ptr<const CloudGeometry>& cloud) {
    if (ready_ != cloud) dropSpare_ = spare_->cloud && spare_->cloud != cloud;
    ready_ = cloud;
}

void CloudScene::colourParts() {
    const auto colour = [](DrawnCloud& cloud, const QColor& with) {
        for (Layer& part : cloud.parts) setColour(part.actor, with);
    };
    colour(*now_, look_.cloud);
    for (std::size_t n = 0; n < layers_.size(); ++n) colour(*layers_[n], layerColours_[n]);
    fadeParts();
}

/// Only the gray cloud: colours have a meaning of their own.
void CloudScene::fadeParts() {
    constexpr double kOfCloud = 0.12; // the rest is the background: what fades stays lighter than it
    const auto mixed = [](double background, double cloud) { return static_cast<float>(background * (1.0 - kOfCloud) + cloud * kOfCloud); };
    const std::array<float, 3> farColour{mixed(look_.background.redF(), look_.cloud.redF()),
                                         mixed(look_.background.greenF(), look_.cloud.greenF()),
                                         mixed(look_.background.blueF(), look_.cloud.blueF())};
    const auto fade = [&farColour, this](DrawnCloud& cloud, bool on) {
        const Eigen::Vector3f scanner = cloud.cloud ? cloud.cloud->sensor : Eigen::Vector3f::Zero();
        for (Layer& part : cloud.parts)
            setLight(part.actor, look_.shaded, scanner, on ? cloud.fullM : std::numeric_limits<float>::max(), farColour);
    };
    fade(*now_, look_.shaded && !now_->faces);
    for (const auto& layer : layers_) fade(*layer, false);
}

void CloudScene::setLook(const CloudLook& look) {
    renderer_->SetBackground(look.background.redF(), look.background.greenF(), look.background.blueF());
    look_ = look;
    colourParts();
    pointSize_ = look.pointSize;
    setColour(edge_.actor, look.edge.front());
    edgeSize_ = static_cast<float>(look.edgeSize);
    edge_.actor->GetProperty()->SetPointSize(edgeSize_);
    for (std::size_t n = 0; n < classes_.size(); ++n) setColour(classes_[n].actor, look.edge[n]);
    halo_.actor->GetProperty()->SetPointSize(static_cast<float>(look.edgeSize + 2.0 * look.halo));
    outline_.actor->GetProperty()->SetPointSize(static_cast<float>(look.edgeSize));
    outlineHalo_.actor->GetProperty()->SetPointSize(static_cast<float>(look.edgeSize + 2.0 * look.halo));
    selection_.actor->GetProperty()->SetPointSize(static_cast<float>(look.pointSize));
    selectionRim_.actor->GetProperty()->SetPointSize(static_cast<float>(look.pointSize + 1.0));
    edgesShown_ = look.edges;
    showEdgeLayers();
}

void CloudScene::setCamera(const CameraPose& pose, const ClipRange& clip) {
    vtkCamera* camera = renderer_->GetActiveCamera();
    camera->SetPosition(pose.position.data());
    camera->SetFocalPoint(pose.focus.data());
    camera->SetViewUp(pose.up.data());
    camera->SetViewAngle(pose.viewAngleDeg);
    camera->SetParallelProjection(pose.parallel);
    camera->SetParallelScale(pose.halfHeight());
    camera->SetClippingRange(clip.nearM, clip.farM);
    pullNearer(edge_.actor, pose, kEdgeNearer);
    for (Layer* layer : {&selection_, &selectionRim_}) pullNearer(layer->actor, pose, kSelectedNearer);
    for (Layer& layer : classes_) pullNearer(layer.actor, pose, kEdgeNearer);
    pullNearer(halo_.actor, pose, kHaloNearer);
    pullNearer(outline_.actor, pose, kEdgeNearer);
    pullNearer(outlineHalo_.actor, pose, kHaloNearer);
}

// Must be called while the graphics context is current.
void CloudScene::unload(DrawnCloud& cloud) {
    for (Layer& part : cloud.parts) {
        part.setCells(nullptr, {});
        part.data->GetPointData()->RemoveArray(kNormals);
        part.data->GetPointData()->SetScalars(nullptr);
        part.mapper->SetScalarVisibility(false);
        part.actor->ReleaseGraphicsResources(window_);
    }
    cloud.faces = nullptr;
    cloud.points = nullptr;
    cloud.normals = nullptr;
    cloud.cloud = nullptr;
}

// Must be called while the graphics context is current.
void CloudScene::freeUnused() {
    if (std::exchange(dropSpare_, false)) unload(*spare_);
    for (const auto& drawn : gone_) {
        unload(*drawn);
        for (Layer& part : drawn->parts) renderer_->RemoveActor(part.actor);
    }
    gone_.clear();
}

/// True if a part is uploaded to the graphics memory for the first time.
bool CloudScene::show(DrawnCloud& cloud, const Parts& parts, float size) {
    bool first = false;
    for (std::size_t i = 0; i < cloud.parts.size(); ++i) {
        const int part = static_cast<int>(i);
        const bool shown = part >= parts.first && part <= parts.last && cloud.cloud && !cloud.cloud->drawOrder[i].empty();
        cloud.parts[i].actor->SetVisibility(shown);
        cloud.parts[i].actor->GetProperty()->SetPointSize(size);
        first = first || (shown && !cloud.uploaded[i]);
        cloud.uploaded[i] = cloud.uploaded[i] || shown;
    }
    return first;
}

bool CloudScene::setParts(const Parts& parts) {
    const double share = kPartEnds[static_cast<std::size_t>(parts.last)];
    const double larger = parts.enlarge ? std::clamp(std::sqrt(0.5 / share), 1.0, kLargestGrowth) : 1.0;
    const auto size = static_cast<float>(std::round(pointSize_ * larger));
    useFaces();
    freeUnused();
    bool first = show(*now_, parts, size);
    for (const auto& layer : layers_) first = show(*layer, parts, size) || first;
    renderer_->SetPreserveColorBuffer(parts.onTop);
    renderer_->SetPreserveDepthBuffer(parts.onTop);
    return first;
}

void CloudScene::showFocus(const Eigen::Vector3d& centre, double radius) {
    focusSphere_->SetCenter(centre.x(), centre.y(), centre.z());
    focusSphere_->SetRadius(radius);
    focus_->VisibilityOn();
}

void CloudScene::hideFocus() { focus_->VisibilityOff(); }

} // namespace edgescan::ui
