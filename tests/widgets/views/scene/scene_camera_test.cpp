// SPDX-License-Identifier: MIT
#include "widgets/views/scene/scene_camera.h"

#include <random>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include "core/contour/rasteriser.h"
#include "tests/support/camera_ring.h"
#include "tests/support/shapes/surfaces.h"
#include "widgets/views/scene/scene_actors.h"

namespace {

using namespace widgets;

Eigen::Vector2d projectedByVtk(vtkCamera& vtk, const core::ImageSize& window, const Eigen::Vector3d& point) {
    const double aspect = static_cast<double>(window.width) / window.height;
    const Eigen::Matrix<double, 4, 4, Eigen::RowMajor> matrix(
        vtk.GetCompositeProjectionTransformMatrix(aspect, -1, 1)->GetData());
    const Eigen::Vector4d clip = matrix * point.homogeneous();
    return {(clip.x() / clip.w() + 1) / 2 * window.width - 0.5, (1 - clip.y() / clip.w()) / 2 * window.height - 0.5};
}

TEST(SceneCamera, AgreesWithTheProjectionAtEverySize) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> place(-200, 200);
    for (core::Camera camera : test::cameraRing(5, false)) {
        camera.intrinsics(0, 1) = 3.5; // skew, too
        for (const QSize window : {QSize(270, 480), QSize(1080, 1920), QSize(801, 333)}) {
            const core::Camera fitted = fittedToWindow(camera, window);
            vtkNew<vtkCamera> vtk;
            setCalibrated(*vtk, fitted, {100, 3000});
            for (int i = 0; i < 50; ++i) {
                const Eigen::Vector3d point(place(random), place(random), place(random));
                const Eigen::Vector2d expected = core::project(fitted, point).value();
                EXPECT_LT((projectedByVtk(*vtk, fitted.size, point) - expected).norm(), 5e-4);
            }
        }
    }
}

TEST(SceneCamera, FittedCameraShowsTheWholeImageInTheMiddle) {
    const core::Camera camera = test::cameraRing(1)[0];
    const core::Camera fitted = fittedToWindow(camera, {800, 480});
    EXPECT_EQ(fitted.size.width, 800);
    EXPECT_NEAR(fitted.intrinsics(0, 0), camera.intrinsics(0, 0) / 4, 1e-9);
    // The image's edges, x = -0.5 and 1079.5, lie 135 px left and right of the window's middle edge.
    const double left =
        (-0.5 - camera.intrinsics(0, 2)) / camera.intrinsics(0, 0) * fitted.intrinsics(0, 0) + fitted.intrinsics(0, 2);
    EXPECT_NEAR(left, 400 - 135 - 0.5, 1e-9);
}

/// VTK as the oracle of the mesh layer: both draw the same silhouette.
TEST(SceneCamera, VtkDrawsTheSilhouetteOfTheRasteriser) {
    MeshLayer layer = test::ballLayer(Qt::white);
    layer.surfaces.push_back(test::ballSurface({90, 60, -40}, 60));
    for (const core::Camera& full : test::cameraRing(3, false)) {
        const core::Camera camera = core::cropped(full, {-0.5, -0.5}, {270, 480}, 0.25);
        vtkNew<vtkRenderer> renderer;
        vtkNew<vtkRenderWindow> window;
        window->SetOffScreenRendering(1);
        window->SetMultiSamples(0);
        window->SetSize(270, 480);
        window->AddRenderer(renderer);
        std::vector<core::PosedSurface> surfaces;
        for (const ViewSurfacePtr& surface : layer.surfaces) {
            const ActorPtr actor = makeMeshActor(*surface, layer);
            actor->GetProperty()->LightingOff();
            renderer->AddActor(actor);
            surfaces.push_back({&surface->verticesInWorld, &surface->triangles});
        }
        setCalibrated(*renderer->GetActiveCamera(), camera, {100, 3000});
        window->Render();
        vtkNew<vtkUnsignedCharArray> pixels;
        window->GetPixelData(0, 0, 269, 479, 1, pixels);
        const cv::Mat mask = core::renderMask(camera, surfaces);
        int different = 0;
        for (int y = 0; y < 480; ++y) {
            for (int x = 0; x < 270; ++x) {
                const bool lit = pixels->GetValue(3 * ((479 - y) * 270 + x)) > 128;
                different += lit != (mask.at<unsigned char>(y, x) != 0);
            }
        }
        const int covered = cv::countNonZero(mask);
        EXPECT_GT(covered, 3000);
        EXPECT_LE(different, 2) << "of " << covered << " pixels";
    }
}

} // namespace
