// SPDX-License-Identifier: MIT
#include "widgets/views/scene/scene_actors.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkMatrix4x4.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkSphereSource.h>
#include <vtkTexture.h>
#include <vtkUnsignedCharArray.h>

namespace widgets {

namespace {

void setColour(vtkActor& actor, const QColor& colour) {
    actor.GetProperty()->SetColor(colour.redF(), colour.greenF(), colour.blueF());
}

ActorPtr actorOf(vtkPolyData* data) {
    auto mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
    mapper->SetInputData(data);
    auto actor = ActorPtr::New();
    actor->SetMapper(mapper);
    return actor;
}

/// Collects line segments and polylines.
struct Lines {
    vtkSmartPointer<vtkPoints> points = vtkSmartPointer<vtkPoints>::New();
    vtkSmartPointer<vtkCellArray> cells = vtkSmartPointer<vtkCellArray>::New();

    Lines() { points->SetDataTypeToFloat(); }
    void add(const std::vector<Eigen::Vector3d>& polyline) {
        cells->InsertNextCell(static_cast<int>(polyline.size()));
        for (const Eigen::Vector3d& p : polyline)
            cells->InsertCellPoint(points->InsertNextPoint(p.data()));
    }
    vtkSmartPointer<vtkPolyData> data() const {
        auto result = vtkSmartPointer<vtkPolyData>::New();
        result->SetPoints(points);
        result->SetLines(cells);
        return result;
    }
};

/// The world point at `depthMm` on the viewing ray of a pixel; the centre where the lens has no inverse.
Eigen::Vector3d pointOnRay(const core::Camera& camera, const Eigen::Vector2d& px, double depthMm) {
    const Eigen::Vector2d n = core::undistort(camera, px).value_or(Eigen::Vector2d::Zero());
    return core::inverse(camera.cameraFromWorld) * Eigen::Vector3d(depthMm * n.homogeneous());
}

/// A unit ball moved and stretched by `shape`.
ActorPtr makeBall(const Eigen::Matrix3d& shape, const Eigen::Vector3d& centre) {
    auto source = vtkSmartPointer<vtkSphereSource>::New();
    source->SetRadius(1);
    source->SetThetaResolution(20);
    source->SetPhiResolution(14);
    source->Update();
    ActorPtr actor = actorOf(source->GetOutput());
    auto matrix = vtkSmartPointer<vtkMatrix4x4>::New();
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column)
            matrix->SetElement(row, column, shape(row, column));
        matrix->SetElement(row, 3, centre[row]);
    }
    actor->SetUserMatrix(matrix);
    return actor;
}

vtkSmartPointer<vtkUnsignedCharArray> vertexColours(const ViewSurface& surface) {
    auto colours = vtkSmartPointer<vtkUnsignedCharArray>::New();
    colours->SetNumberOfComponents(3);
    constexpr float kFull = 255;
    for (const Eigen::Vector3f& rgb : surface.coloursRgb)
        colours->InsertNextTuple3(static_cast<double>(kFull * rgb.x()), static_cast<double>(kFull * rgb.y()),
                                  static_cast<double>(kFull * rgb.z()));
    return colours;
}

} // namespace

ActorPtr makeMeshActor(const ViewSurface& surface, const MeshLayer& layer) {
    auto points = vtkSmartPointer<vtkPoints>::New();
    points->SetNumberOfPoints(static_cast<vtkIdType>(surface.verticesInWorld.size()));
    auto normals = vtkSmartPointer<vtkFloatArray>::New();
    normals->SetNumberOfComponents(3);
    normals->SetNumberOfTuples(static_cast<vtkIdType>(surface.normalsInWorld.size()));
    for (std::size_t i = 0; i < surface.verticesInWorld.size(); ++i) {
        points->SetPoint(static_cast<vtkIdType>(i), surface.verticesInWorld[i].data());
        normals->SetTuple(static_cast<vtkIdType>(i), surface.normalsInWorld[i].data());
    }
    auto cells = vtkSmartPointer<vtkCellArray>::New();
    cells->AllocateExact(static_cast<vtkIdType>(surface.triangles.size()),
                         static_cast<vtkIdType>(3 * surface.triangles.size()));
    for (const auto& [a, b, c] : surface.triangles) {
        const vtkIdType corners[3] = {a, b, c};
        cells->InsertNextCell(3, corners);
    }
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(points);
    data->SetPolys(cells);
    data->GetPointData()->SetNormals(normals);
    if (surface.coloursRgb.size() == surface.verticesInWorld.size())
        data->GetPointData()->SetScalars(vertexColours(surface));
    ActorPtr actor = actorOf(data);
    setColour(*actor, layer.colour);
    vtkProperty& look = *actor->GetProperty();
    look.SetAmbient(0.5); // so that what is lit has the layer's colour on average: it is a legend
    look.SetDiffuse(0.62);
    look.SetSpecular(0.04);
    look.SetSpecularPower(25);
    look.SetOpacity(layer.opacity);
    if (layer.style == MeshStyle::Wireframe) {
        look.SetRepresentationToWireframe();
        look.SetLineWidth(1.5);
    }
    return actor;
}

ActorPtr makeFrustumActor(const core::Camera& camera, double depthMm, const QColor& colour, double lineWidth) {
    const double right = camera.size.width - 0.5, bottom = camera.size.height - 0.5;
    const Eigen::Vector2d corners[] = {{-0.5, -0.5}, {right, -0.5}, {right, bottom}, {-0.5, bottom}};
    constexpr int kSteps = 8; // a lens bends the border
    Lines lines;
    for (int side = 0; side < 4; ++side) {
        const Eigen::Vector2d& from = corners[side];
        const Eigen::Vector2d& to = corners[(side + 1) % 4];
        lines.add({camera.centreInWorld(), pointOnRay(camera, from, depthMm)});
        std::vector<Eigen::Vector3d> border;
        for (int i = 0; i <= kSteps; ++i)
            border.push_back(pointOnRay(camera, from + (to - from) * i / kSteps, depthMm));
        lines.add(border);
    }
    // A tick says which way is up in the image.
    const Eigen::Vector2d top(camera.size.width / 2.0, -0.5);
    lines.add({pointOnRay(camera, top, depthMm), pointOnRay(camera, top - Eigen::Vector2d(0, 0.08 * bottom), depthMm)});
    ActorPtr actor = actorOf(lines.data());
    setColour(*actor, colour);
    actor->GetProperty()->LightingOff();
    actor->GetProperty()->SetLineWidth(static_cast<float>(lineWidth));
    return actor;
}

ActorPtr makeImageActor(const core::Camera& camera, const QImage& image, double depthMm) {
    constexpr int kCells = 32;
    auto points = vtkSmartPointer<vtkPoints>::New();
    auto texturePlaces = vtkSmartPointer<vtkFloatArray>::New();
    texturePlaces->SetNumberOfComponents(2);
    auto cells = vtkSmartPointer<vtkCellArray>::New();
    for (int row = 0; row <= kCells; ++row) {
        for (int column = 0; column <= kCells; ++column) {
            const double u = static_cast<double>(column) / kCells, v = static_cast<double>(row) / kCells;
            const Eigen::Vector2d px(u * camera.size.width - 0.5, v * camera.size.height - 0.5);
            points->InsertNextPoint(pointOnRay(camera, px, depthMm).data());
            texturePlaces->InsertNextTuple2(u, 1 - v);
            if (row < kCells && column < kCells) {
                const vtkIdType at = row * (kCells + 1) + column;
                const vtkIdType corners[4] = {at, at + 1, at + kCells + 2, at + kCells + 1};
                cells->InsertNextCell(4, corners);
            }
        }
    }
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(points);
    data->SetPolys(cells);
    data->GetPointData()->SetTCoords(texturePlaces);

    const QImage rgb = image.convertToFormat(QImage::Format_RGB888).mirrored(); // VTK's images start at the bottom
    auto pixels = vtkSmartPointer<vtkImageData>::New();
    pixels->SetDimensions(rgb.width(), rgb.height(), 1);
    pixels->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
    auto* target = static_cast<unsigned char*>(pixels->GetScalarPointer());
    for (int y = 0; y < rgb.height(); ++y)
        std::copy_n(rgb.constScanLine(y), 3 * rgb.width(), target + 3 * static_cast<std::ptrdiff_t>(rgb.width()) * y);
    auto texture = vtkSmartPointer<vtkTexture>::New();
    texture->SetInputData(pixels);
    texture->InterpolateOn();
    texture->RepeatOff();
    texture->EdgeClampOn();
    ActorPtr actor = actorOf(data);
    actor->SetTexture(texture);
    actor->GetProperty()->LightingOff();
    return actor;
}

ActorPtr makeJointActor(const SceneJoint& joint, double radiusMm) {
    ActorPtr actor = makeBall(radiusMm * Eigen::Matrix3d::Identity(), joint.pointInWorld);
    setColour(*actor, joint.colour);
    actor->GetProperty()->SetAmbient(0.35);
    return actor;
}

ActorPtr makeEllipsoidActor(const SceneJoint& joint) {
    constexpr double kChi2At95 = 7.814727903251179; // three degrees of freedom
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(joint.covariance.value_or(Eigen::Matrix3d::Zero()));
    const Eigen::Vector3d semiAxes = (kChi2At95 * axes.eigenvalues().cwiseMax(0)).cwiseSqrt();
    const Eigen::Matrix3d shape = axes.eigenvectors() * semiAxes.asDiagonal();
    ActorPtr actor = makeBall(shape, joint.pointInWorld);
    setColour(*actor, joint.colour);
    actor->GetProperty()->SetOpacity(0.35);
    actor->GetProperty()->SetAmbient(0.5);
    return actor;
}

ActorPtr makeHaloActor(const Eigen::Vector3d& centre, double radiusMm) {
    ActorPtr actor = makeBall(radiusMm * Eigen::Matrix3d::Identity(), centre);
    actor->GetProperty()->SetColor(1, 1, 1);
    actor->GetProperty()->LightingOff();
    actor->GetProperty()->FrontfaceCullingOn(); // only the far side is drawn, so that it rims what is inside
    return actor;
}

ActorPtr makeBonesActor(const std::vector<SceneBone>& bones) {
    Lines lines;
    auto colours = vtkSmartPointer<vtkUnsignedCharArray>::New();
    colours->SetNumberOfComponents(3);
    for (const SceneBone& bone : bones) {
        lines.add({bone.from, bone.to});
        colours->InsertNextTuple3(bone.colour.red(), bone.colour.green(), bone.colour.blue());
    }
    const auto data = lines.data();
    data->GetCellData()->SetScalars(colours);
    ActorPtr actor = actorOf(data);
    actor->GetProperty()->LightingOff();
    actor->GetProperty()->SetLineWidth(2);
    return actor;
}

ActorPtr makeGridActor(const Eigen::Vector3d& centre, const Eigen::Vector3d& normal, double spacingMm, int cells,
                       const QColor& colour) {
    const Eigen::Vector3d across = normal.unitOrthogonal(), along = normal.cross(across);
    const double reach = spacingMm * cells / 2;
    Lines lines;
    for (int i = 0; i <= cells; ++i) {
        const double offset = i * spacingMm - reach;
        lines.add({centre + offset * across - reach * along, centre + offset * across + reach * along});
        lines.add({centre + offset * along - reach * across, centre + offset * along + reach * across});
    }
    ActorPtr actor = actorOf(lines.data());
    setColour(*actor, colour);
    actor->GetProperty()->LightingOff();
    return actor;
}

} // namespace widgets
