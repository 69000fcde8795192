// SPDX-License-Identifier: MIT
#include "widgets/views/camera/mesh_layer.h"

#include <QApplication>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "core/contour/rasteriser.h"
#include "tests/support/camera_ring.h"
#include "tests/support/shapes/ball.h"
#include "tests/support/shapes/surfaces.h"
#include "tests/widgets/views/lab_colour.h"
#include "widgets/views/camera/camera_view.h"
#include "widgets/views/joint_colours.h"

namespace {

using namespace widgets;

cv::Mat maskOf(const core::Camera& camera, const MeshLayer& layer) {
    std::vector<core::PosedSurface> surfaces;
    for (const ViewSurfacePtr& s : layer.surfaces)
        surfaces.push_back({&s->verticesInWorld, &s->triangles});
    return core::renderMask(camera, surfaces);
}

TEST(MeshLayer, HasTheSilhouetteOfTheCrop) {
    const core::Camera camera = test::cameraRing(3)[1];
    const MeshLayer layer = test::ballLayer(Qt::cyan);
    const MeshPicture drawn = drawMeshLayers(camera, {layer}, {211.3, 403.7}, {300, 420}, 0.613);
    const cv::Mat mask = maskOf(core::cropped(camera, {211.3, 403.7}, {300, 420}, 0.613), layer);
    ASSERT_EQ(drawn.picture.size(), QSize(300, 420));
    int covered = 0;
    for (int y = 0; y < 420; ++y) {
        for (int x = 0; x < 300; ++x) {
            const bool inside = mask.at<unsigned char>(y, x) != 0;
            covered += inside;
            ASSERT_EQ(qAlpha(drawn.picture.pixel(x, y)) > 0, inside) << x << " " << y;
        }
    }
    EXPECT_GT(covered, 2000);
}

TEST(MeshLayer, LaterLayersLieOnTop) {
    const core::Camera camera = core::cropped(test::cameraRing(1)[0], {0, 0}, {270, 480}, 0.25);
    MeshLayer below = test::ballLayer(Qt::red), above = test::ballLayer(Qt::green);
    below.opacity = above.opacity = 1;
    const QPoint middle(135, 239);
    const auto colour = [&](const std::vector<MeshLayer>& layers) {
        return QColor(drawMeshLayers(camera, layers, {-0.5, -0.5}, {270, 480}, 1).picture.pixel(middle));
    };
    EXPECT_GT(colour({below, above}).green(), 2 * colour({below, above}).red());
    EXPECT_GT(colour({above, below}).red(), 2 * colour({above, below}).green());
}

TEST(MeshLayer, OffAndEmptyLayersDrawNothing) {
    const core::Camera camera = test::cameraRing(1)[0];
    MeshLayer off = test::ballLayer(Qt::red);
    off.style = MeshStyle::Off;
    EXPECT_TRUE(drawMeshLayers(camera, {off, MeshLayer{}}, {0, 0}, {100, 100}, 0.1).picture.isNull());
    EXPECT_TRUE(drawMeshLayers(camera, {}, {0, 0}, {100, 100}, 0.1).picture.isNull());
}

/// In a view, at a zoom where image pixels are large, the layer covers exactly the image pixels that the full mask
/// does.
TEST(MeshLayer, LiesOnTheImagePixelsThatItBelongsTo) {
    const core::Camera camera = test::cameraRing(2)[1];
    MeshLayer layer = test::ballLayer(Qt::white);
    layer.opacity = 1;
    const cv::Mat mask = maskOf(camera, layer);
    CameraView view;
    view.setCamera(camera);
    view.resize(420, 440);
    view.show();
    QImage black(1080, 1920, QImage::Format_RGB32);
    black.fill(Qt::black);
    view.setImage(black);
    view.setMeshLayers({layer});
    // The left end of the ball's outline.
    cv::Mat columns;
    cv::reduce(mask, columns, 0, cv::REDUCE_MAX);
    int left = 0;
    while (columns.at<unsigned char>(0, left) == 0)
        ++left;
    view.lookAt({left + 10.0, 955.0}, 8);
    QApplication::processEvents();
    view.finishDrawing();
    const QImage shown = view.viewport()->grab().toImage();
    int different = 0, edge = 0, inside = 0;
    for (int y = 935; y < 975; ++y) {
        for (int x = left - 8; x < left + 28; ++x) {
            const QPoint at = view.imageToViewport({static_cast<double>(x), static_cast<double>(y)}).toPoint();
            if (!shown.rect().adjusted(2, 2, -2, -2).contains(at))
                continue;
            const bool expected = mask.at<unsigned char>(y, x) != 0;
            inside += expected;
            edge += expected != (mask.at<unsigned char>(y, x + 1) != 0);
            different += (shown.pixelColor(at).value() > 40) != expected;
        }
    }
    EXPECT_GT(edge, 30);
    EXPECT_GT(inside, 300);
    EXPECT_LE(different, edge / 5) << "half a pixel of offset would change about half of the edge pixels";
}

TEST(MeshLayer, ANewZoomIsDrawnAnewAndTheOldPictureStandsInMeanwhile) {
    CameraView view;
    view.setCamera(test::cameraRing(1)[0]);
    view.resize(270, 500);
    view.show();
    view.setMeshLayers({test::ballLayer(Qt::green)});
    view.finishDrawing();
    const auto greenAt = [&](QPointF px) {
        return view.viewport()->grab().toImage().pixelColor(view.imageToViewport(px).toPoint()).green() > 60;
    };
    EXPECT_TRUE(greenAt({541, 956}));
    view.lookAt({541, 956}, 1.7);
    EXPECT_TRUE(greenAt({541, 956})) << "before the new picture is there";
    view.finishDrawing();
    EXPECT_TRUE(greenAt({541, 956}));
    view.setMeshLayers({});
    view.finishDrawing();
    EXPECT_FALSE(greenAt({541, 956}));
}

/// On the screen, at any zoom: what shows the mesh lies within the rasteriser's silhouette grown by a pixel, what does
/// not lies outside the silhouette shrunk by one.
TEST(MeshLayer, EdgeInTheViewIsTheRasterisersAtEveryZoom) {
    const core::Camera camera = test::cameraRing(1)[0];
    MeshLayer layer = test::ballLayer(Qt::green);
    layer.opacity = 1;
    CameraView view;
    view.setCamera(camera);
    view.resize(300, 420);
    view.show();
    view.setMeshLayers({layer});
    for (const double scale : {0.15, 0.37, 1.0, 2.3, 6.7}) {
        const double radiusPx = 200; // of the ball in the picture, about: its right edge is in view
        view.lookAt({541 + (scale > 0.5 ? radiusPx : 0), 956}, scale);
        view.finishDrawing();
        const QImage shown = view.viewport()->grab().toImage();
        // The image pixel whose upper left corner is the viewport's: centres of pixels are at integers.
        const QPointF corner = view.viewportToImage({0, 0}) + QPointF(0.5, 0.5);
        const cv::Mat mask = maskOf(
            core::cropped(camera, {corner.x(), corner.y()}, {shown.width(), shown.height()}, view.scale()), layer);
        cv::Mat grown, shrunk;
        const cv::Mat cross = cv::getStructuringElement(cv::MORPH_CROSS, {3, 3});
        cv::dilate(mask, grown, cross);
        cv::erode(mask, shrunk, cross);
        int wrong = 0;
        for (int y = 1; y + 1 < shown.height(); ++y) {
            for (int x = 1; x + 1 < shown.width(); ++x) {
                const QColor pixel = shown.pixelColor(x, y);
                const bool isMesh = pixel.green() > pixel.red() + 40;
                wrong += isMesh ? grown.at<unsigned char>(y, x) == 0 : shrunk.at<unsigned char>(y, x) != 0;
            }
        }
        EXPECT_EQ(wrong, 0) << scale;
        const int covered = cv::countNonZero(mask);
        EXPECT_GT(covered, 500) << scale;
        EXPECT_LT(covered, 0.95 * shown.width() * shown.height()) << scale << ": an edge is in view";
    }
}

/// What a person compares: the lit mesh with its method's chip, curve and table row.
TEST(MeshLayer, HasTheColourOfItsLegend) {
    const core::Camera camera = core::cropped(test::cameraRing(1)[0], {0, 0}, {270, 480}, 0.25);
    std::vector<QColor> shown;
    for (const char* method : {"start", "ch", "dch-thres", "dch-quant", "dch-quant2", "dch-dt3", "best"}) {
        MeshLayer layer = test::ballLayer(methodColour(method));
        layer.silhouetteEdge = false;
        layer.opacity = 1;
        const QImage opaque = drawMeshLayers(camera, {layer}, {-0.5, -0.5}, {270, 480}, 1).picture;
        shown.push_back(test::meanColour(opaque, [&](int x, int y) { return qAlpha(opaque.pixel(x, y)) > 0; }));
        EXPECT_LT(test::labDistance(shown.back(), layer.colour), 10)
            << method << " " << shown.back().name().toStdString();
        layer.opacity = 0.5; // the colour that is mixed in is the same
        const QImage half =
            drawMeshLayers(camera, {layer}, {-0.5, -0.5}, {270, 480}, 1).picture.convertToFormat(QImage::Format_ARGB32);
        const QColor mixedIn = test::meanColour(half, [&](int x, int y) { return qAlpha(half.pixel(x, y)) > 0; });
        EXPECT_LT(test::labDistance(mixedIn, layer.colour), 10) << method;
    }
    for (std::size_t a = 0; a < shown.size(); ++a)
        for (std::size_t b = a + 1; b < shown.size(); ++b)
            EXPECT_GT(test::labDistance(shown[a], shown[b]), 20) << a << " " << b;
}

} // namespace
