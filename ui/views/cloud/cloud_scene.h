// The VTK side of the cloud view: one vertex buffer, an index list per part of the drawing order and one for the edges.
#pragma once

#include "ui/views/cloud/camera_motion.h"
#include "ui/views/cloud/cloud_geometry.h"
#include "ui/views/cloud/cloud_layer.h"
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
    bool shaded = true; ///< by their slope and their distance from the scanner; false: all points of the cloud have the full colour
};

/// GUI thread only; makes no OpenGL call itself.
class CloudScene {
public:
    explicit CloudScene(vtkRenderWindow* window);
    ~CloudScene();

    void setCloud(std::shared_ptr<const CloudGeometry> cloud);
    /// Keeps this cloud in the graphics memory together with the drawn one, so that switching between them uploads nothing. Null: only the
    /// drawn cloud stays in the graphics memory.
    void keepReady(const std::shared_ptr<const CloudGeometry>& cloud);
    /// Replaces the layers. A cloud that stays is not uploaded again.
    void setLayers(const std::vector<CloudLayer>& layers, const Eigen::Vector3d& shownOriginM);
    /// Cells that are not drawable are ignored.
    void setEdges(EdgeCells cells);
    /// Per cell, four bytes: red, green, blue, 255. Replaces the single colour of the cloud. Null, or a wrong number of cells: the single
    /// colour.
    void setFaces(std::shared_ptr<const std::vector<std::uint32_t>> colours);
    /// Drawn white over everything. Cells that are not drawable are ignored.
    void setOutline(EdgeCells::Indices cells);
    /// Drawn in the colour of the selection, in the size of edges. Cells that are not drawable are ignored.
    void setSelection(EdgeCells::Indices cells);
    /// A grid without lines is not drawn.
    void setGround(const GroundGrid& grid);
    void setLook(const CloudLook& look);
    void setCamera(const CameraPose& pose, const ClipRange& clip);
    /// The drawn parts of the drawing order: first .. last.
    struct Parts {
        int first = 0;
        int last = 0;
        bool onTop = false;   ///< draw over the frame before, which stays (same camera, same look)
        bool enlarge = false; ///< draw fewer points but larger ones, so that surfaces stay closed while the camera moves
    };
    /// True if a part is uploaded to the graphics memory for the first time.
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

    /// A cloud with its VTK objects.
    struct DrawnCloud {
        std::shared_ptr<const CloudGeometry> cloud; ///< owns the floats that VTK draws
        vtkSmartPointer<vtkPoints> points;
        vtkSmartPointer<vtkFloatArray> normals;
        std::array<Layer, kCloudParts> parts;
        std::array<bool, kCloudParts> uploaded{};
        std::shared_ptr<const std::vector<std::uint32_t>> faces;
        double fullM = 0.0; ///< from the scanner: surfaces farther away fade
    };
    [[nodiscard]] std::unique_ptr<DrawnCloud> newCloud();
    static void load(DrawnCloud& into, std::shared_ptr<const CloudGeometry> cloud);
    void unload(DrawnCloud& cloud);
    static bool show(DrawnCloud& cloud, const Parts& parts, float size);
    void useFaces();
    void colourParts();
    void fadeParts();
    void freeUnused();
    void showEdgeLayers();
    void drawOverLast();
    void setLayer(Layer& layer, EdgeCells::Indices& cells);

    vtkNew<vtkRenderer> renderer_;
    vtkRenderWindow* window_;
    std::unique_ptr<DrawnCloud> now_, spare_;                // the spare one is not drawn
    std::vector<std::unique_ptr<DrawnCloud>> layers_, gone_; // those that are gone have to be freed when the graphics context is current
    std::vector<QColor> layerColours_;
    std::shared_ptr<const CloudGeometry> ready_;
    bool dropSpare_ = false; // drop it when the graphics context is current
    CloudLook look_;
    EdgeCells edges_; // owns the indices that VTK draws
    std::shared_ptr<const std::vector<std::uint32_t>> facesWanted_;
    EdgeCells::Indices haloed_, outlined_, selected_, selectedRim_;
    Layer halo_, edge_, outlineHalo_, outline_, selection_, selectionRim_;
    std::array<Layer, kEdgeClasses> classes_; // used instead of edge_ if the method has classes
    vtkNew<vtkSphereSource> focusSphere_;
    vtkNew<vtkActor> focus_;
    Layer ground_;
    bool edgesShown_ = true;
    double pointSize_ = 2.0;
    float edgeSize_ = 4.0F;
};

} // namespace edgescan::ui
