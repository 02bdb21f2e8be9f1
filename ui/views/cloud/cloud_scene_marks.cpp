// What is drawn over the points: colours of their faces, the ground, edges, outline and selection.
#include "ui/views/cloud/cloud_scene.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <iterator>

namespace edgescan::ui {

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

} // namespace edgescan::ui
