// SPDX-License-Identifier: MIT
#include "widgets/views/camera/mesh_layer_painter.h"

#include <QApplication>
#include <QSignalSpy>

#include <gtest/gtest.h>

#include "tests/support/camera_ring.h"
#include "tests/support/shapes/surfaces.h"

namespace {

using namespace widgets;

MeshLayerPainter::Request requestAt(double scale) {
    return {test::cameraRing(1)[0], {test::ballLayer(Qt::cyan)}, {10.5, 20.25}, {200, 300}, scale};
}

QImage expected(double scale) {
    const MeshLayerPainter::Request r = requestAt(scale);
    return drawMeshLayers(r.camera, r.layers, r.topLeftPx, r.size, r.scale).picture;
}

TEST(MeshLayerPainter, DrawsWhatWasAskedFor) {
    MeshLayerPainter painter;
    QSignalSpy changed(&painter, &MeshLayerPainter::pictureChanged);
    painter.request(requestAt(0.2));
    ASSERT_TRUE(changed.wait(60000));
    EXPECT_EQ(painter.picture().picture, expected(0.2));
    EXPECT_EQ(painter.picture().scale, 0.2);
    EXPECT_EQ(painter.picture().topLeftPx, QPointF(10.5, 20.25));
}

TEST(MeshLayerPainter, OfManyRequestsTheLastOneCounts) {
    MeshLayerPainter painter;
    QSignalSpy changed(&painter, &MeshLayerPainter::pictureChanged);
    for (int i = 1; i <= 40; ++i)
        painter.request(requestAt(0.01 * i));
    while (painter.picture().scale != 0.4 && changed.wait(60000)) {
    }
    EXPECT_EQ(painter.picture().picture, expected(0.4));
    EXPECT_LE(changed.count(), 3) << "those in between were skipped";
}

TEST(MeshLayerPainter, LayersThatStayAreDrawnAsBefore) {
    MeshLayerPainter painter;
    MeshLayerPainter::Request request = requestAt(0.2);
    request.layers.push_back(test::ballLayer(Qt::red));
    request.layers[1].opacity = 0;
    const auto drawn = [&] {
        painter.request(request);
        painter.finish();
        return painter.picture().picture;
    };
    const auto wanted = [&] {
        return drawMeshLayers(request.camera, request.layers, request.topLeftPx, request.size, request.scale).picture;
    };
    const QImage first = drawn();
    EXPECT_EQ(first, wanted());
    EXPECT_EQ(drawn(), first) << "the same again";
    request.layers[0].colour = Qt::yellow;
    EXPECT_EQ(drawn(), wanted()) << "another layer below";
    std::swap(request.layers[0], request.layers[1]);
    EXPECT_EQ(drawn(), wanted()) << "another order";
    request.topLeftPx += QPointF(3, 5);
    EXPECT_EQ(drawn(), wanted()) << "another crop";
    request.camera = test::cameraRing(5)[2];
    EXPECT_EQ(drawn(), wanted()) << "another camera";
    request.layers.pop_back();
    EXPECT_EQ(drawn(), wanted()) << "a layer less";
    request.layers.clear();
    EXPECT_TRUE(drawn().isNull());
}

TEST(MeshLayerPainter, FinishLeavesNothingToWaitFor) {
    MeshLayerPainter painter;
    painter.request(requestAt(0.2));
    painter.request(requestAt(0.3));
    painter.finish();
    EXPECT_EQ(painter.picture().picture, expected(0.3));
    QSignalSpy changed(&painter, &MeshLayerPainter::pictureChanged);
    EXPECT_FALSE(changed.wait(200)) << "the drawing that was overtaken is dropped";
    EXPECT_EQ(painter.picture().scale, 0.3);
}

TEST(MeshLayerPainter, MayGoAwayWhileItDraws) {
    for (int i = 0; i < 20; ++i) {
        MeshLayerPainter painter;
        painter.request(requestAt(0.3));
    }
    QApplication::processEvents();
}

} // namespace
