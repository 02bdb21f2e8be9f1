// The VTK side of the cloud view: one vertex buffer, an index list per part of the drawing order and one for the edges.
#pragma once

#include "ui/views/cloud/camera_motion.h"
#include "ui/views/cloud/cloud_geometry.h"
#include "ui/views/cloud/edge_cells.h"
#include "ui/views/cloud/ground_grid.h"

#include <QColor>

#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

class vtkActor;
class vtkOpenGLPolyDataMapper;
class vtkFloatArray;
class vtkPoints;
class vtkPolyData;
class vtkPolyDataMapper;
class vtkRenderer;
class vtkRenderWindow;
class vtkSphereSource;

namespace edgescan::ui {

struct CloudLook {
    QColor background, cloud;
    EdgeColours edge = kUsualColours;
    double pointSize = 2.0; ///< device pixels
    double edgeSize = 4.0;  ///< device pixels
    double halo = 1.0;      ///< device pixels on each side of an edge point
    bool edges = true;
    bool byClass = false; ///< each class in its own colour
    bool shaded = true;   ///< false: every point of the cloud has its full colour
};

/// GUI thread only; makes no OpenGL call itself.
class CloudScene {
public:
    explicit CloudScene(vtkRenderWindow* window);
    ~CloudScene();

    void setCloud(std::shared_ptr<const CloudGeometry> cloud);
    /// This cloud and the one before or after it stay in the graphics memory both, so that going from one to the other sends nothing; null:
    /// only the one that is drawn stays.
    void keepReady(const std::shared_ptr<const CloudGeometry>& cloud);
    /// Cells that are not drawable are left out.
    void setEdges(EdgeCells cells);
    /// By cell, four bytes: red, green, blue, 255. Instead of the one colour of the cloud; null, or of another number of cells: none.
    void setFaces(std::shared_ptr<const std::vector<std::uint32_t>> colours);
    /// Drawn white over everything. Cells that are not drawable are left out.
    void setOutline(EdgeCells::Indices cells);
    /// Drawn in the colour of what is selected, as large as edges. Cells that are not drawable are left out.
    void setSelection(EdgeCells::Indices cells);
    /// Without a line: none is drawn.
    void setGround(const GroundGrid& grid);
    void setLook(const CloudLook& look);
    void setCamera(const CameraPose& pose, const ClipRange& clip);
    /// What is drawn of the drawing order: parts first .. last.
    struct Parts {
        int first = 0;
        int last = 0;
        bool onTop = false;   ///< of the frame before, which stays (same camera, same look)
        bool enlarge = false; ///< fewer points are drawn larger, so that a surface stays a surface while the camera moves
    };
    /// True when one of them goes to the graphics memory for the first time.
    bool setParts(const Parts& parts);
    void showFocus(const Eigen::Vector3d& centre, double radius);
    void hideFocus();

    [[nodiscard]] std::size_t edgesDrawn() const;

private:
    struct Layer {
        explicit Layer(vtkSmartPointer<vtkPolyDataMapper> with = nullptr);
        /// The cells are not copied and must outlive their use.
        void setCells(vtkPoints* points, std::span<const std::uint32_t> cells);
        vtkNew<vtkPolyData> data;
        vtkSmartPointer<vtkPolyDataMapper> mapper;
        vtkNew<vtkActor> actor;
    };

    /// A cloud with what VTK made of it.
    struct DrawnCloud {
        std::shared_ptr<const CloudGeometry> cloud; ///< owns the floats that VTK draws
        vtkSmartPointer<vtkPoints> points;
        vtkSmartPointer<vtkFloatArray> normals;
        std::array<Layer, kCloudParts> parts;
        std::array<bool, kCloudParts> uploaded{};
        std::shared_ptr<const std::vector<std::uint32_t>> faces;
    };
    [[nodiscard]] std::unique_ptr<DrawnCloud> newCloud();
    void load(std::shared_ptr<const CloudGeometry> cloud);
    void useFaces();
    void colourParts();
    void letSpareGo();
    void showEdgeLayers();
    void setLayer(Layer& layer, EdgeCells::Indices& cells);

    vtkNew<vtkRenderer> renderer_;
    vtkRenderWindow* window_;
    std::unique_ptr<DrawnCloud> now_, spare_; // the spare one is not drawn
    std::shared_ptr<const CloudGeometry> ready_;
    bool spareGoes_ = false; // once the graphics context is current
    CloudLook look_;
    EdgeCells edges_; // owns the indices that VTK draws
    std::shared_ptr<const std::vector<std::uint32_t>> facesWanted_;
    EdgeCells::Indices outlined_, selected_;
    Layer halo_, edge_, outlineHalo_, outline_, selection_;
    std::array<Layer, kEdgeClasses> classes_; // instead of edge_ where edges have the colours of their classes
    vtkNew<vtkSphereSource> focusSphere_;
    vtkNew<vtkActor> focus_;
    Layer ground_;
    bool edgesShown_ = true;
    bool byClass_ = false;
    double pointSize_ = 2.0;
    float edgeSize_ = 4.0F;
};

} // namespace edgescan::ui
