// SPDX-License-Identifier: MIT
#include "widgets/views/scene/scene_view.h"

#include <QApplication>
#include <QSignalSpy>

#include <gtest/gtest.h>

#include "tests/support/camera_ring.h"
#include "tests/support/pointer.h"
#include "tests/support/shapes/surfaces.h"
#include "tests/widgets/views/lab_colour.h"
#include "widgets/views/joint_colours.h"

namespace {

using namespace widgets;

class SceneViewTest : public testing::Test {
protected:
    SceneViewTest() {
        scene.resize(400, 300);
        scene.show();
        for (int i = 0; i < 5; ++i)
            QApplication::processEvents();
        for (QWidget* child : scene.findChildren<QWidget*>())
            if (child->inherits("QVTKOpenGLNativeWidget"))
                gl = child;
    }
    /// Pixels that have the hue of `colour` and are lit.
    static int count(const QImage& image, const QColor& colour) {
        int found = 0;
        for (int y = 0; y < image.height(); ++y) {
            for (int x = 0; x < image.width(); ++x) {
                const QColor c = image.pixelColor(x, y);
                const int turn = std::abs(c.hsvHue() - colour.hsvHue());
                found += c.saturation() > 90 && c.value() > 50 && std::min(turn, 360 - turn) < 12;
            }
        }
        return found;
    }
    /// Of what has that colour; the axes in the lower left corner do not count.
    static QPointF middleOf(const QImage& image, const QColor& colour) {
        constexpr int kAxes = 60;
        QPointF sum;
        int found = 0;
        for (int y = 0; y < image.height(); ++y) {
            for (int x = 0; x < image.width(); ++x) {
                const QColor c = image.pixelColor(x, y);
                const int turn = std::abs(c.hsvHue() - colour.hsvHue());
                const bool isAxis = x < kAxes && y >= image.height() - kAxes;
                if (!isAxis && c.saturation() > 90 && c.value() > 50 && std::min(turn, 360 - turn) < 12) {
                    sum += QPointF(x, y);
                    ++found;
                }
            }
        }
        return found ? sum / found : QPointF(-1, -1);
    }
    SceneView scene;
    QWidget* gl = nullptr;
};

TEST_F(SceneViewTest, MeshesAreLitInTheirMethodsColours) {
    ASSERT_TRUE(gl);
    EXPECT_LT(count(scene.grabPicture(), QColor(0x56, 0xB4, 0xE9)), 20);
    MeshLayer blue = test::ballLayer(QColor(0x56, 0xB4, 0xE9)), orange = test::ballLayer(QColor(0xE6, 0x9F, 0x00));
    orange.surfaces = {test::ballSurface({260, 0, 0}, 80)};
    scene.setMeshLayers({blue, orange});
    const QImage both = scene.grabPicture();
    EXPECT_GT(count(both, blue.colour), 800);
    EXPECT_GT(count(both, orange.colour), 500);
    scene.setMeshLayers({blue});
    EXPECT_LT(count(scene.grabPicture(), orange.colour), 20) << "only the axes' letters";
}

TEST_F(SceneViewTest, OrbitPanAndZoomMoveThePicture) {
    scene.setMeshLayers({test::ballLayer(Qt::green)});
    const QImage before = scene.grabPicture();
    const QPointF middle = middleOf(before, Qt::green);
    test::drag(gl, {100, 100}, {150, 120}, Qt::MiddleButton);
    const QPointF moved = middleOf(scene.grabPicture(), Qt::green);
    EXPECT_NEAR(moved.x() - middle.x(), 50, 3);
    EXPECT_NEAR(moved.y() - middle.y(), 20, 3);
    scene.resetView();
    test::wheel(gl, {200, 150}, 2);
    EXPECT_GT(count(scene.grabPicture(), Qt::green), 1.5 * count(before, Qt::green));
    scene.resetView();
    scene.setGridShown(true);
    const QImage still = scene.grabPicture();
    test::drag(gl, {100, 100}, {180, 130});
    EXPECT_NE(scene.grabPicture(), still);
}

TEST_F(SceneViewTest, ALookedThroughCameraSeesWhatItsViewShows) {
    const auto cameras = test::cameraRing(4, false);
    scene.setCameras(cameras);
    MeshLayer layer = test::ballLayer(Qt::green);
    layer.surfaces = {test::ballSurface({60, -90, 30}, 70)};
    scene.setMeshLayers({layer});
    QSignalSpy changed(&scene, &SceneView::lookedThroughChanged);
    scene.lookThrough(2);
    EXPECT_EQ(changed.count(), 1);
    const QImage picture = scene.grabPicture();
    const QPointF seen = middleOf(picture, Qt::green);
    // The whole image stands in the middle of the window. A ball's outline is nearly centred on its centre.
    const double scale = picture.height() / 1920.0;
    const Eigen::Vector2d px = core::project(cameras[2], {60, -90, 30}).value();
    EXPECT_NEAR(seen.x(), (px.x() + 0.5) * scale + (picture.width() - 1080 * scale) / 2 - 0.5, 1.0);
    EXPECT_NEAR(seen.y(), (px.y() + 0.5) * scale - 0.5, 1.0);
    test::drag(gl, {100, 100}, {140, 120});
    EXPECT_EQ(scene.lookedThrough(), -1) << "a drag returns to orbiting";
}

TEST_F(SceneViewTest, ClicksFindJointsAndCameras) {
    const auto cameras = test::cameraRing(4, false);
    scene.setCameras(cameras);
    const core::JointId index{core::Side::Left, "index_mcp"}, thumb{core::Side::Right, "thumb_ip"};
    scene.setJoints({{index, {60, -90, 30}, {}, Qt::cyan, false}, {thumb, {-80, 40, -20}, {}, Qt::yellow, true}});
    scene.lookThrough(1);
    const QSize window = gl->size();
    const double scale = window.height() / 1920.0;
    const auto place = [&](const Eigen::Vector3d& point) {
        const Eigen::Vector2d px = core::project(cameras[1], point).value();
        return QPointF((px.x() + 0.5) * scale + (window.width() - 1080 * scale) / 2, (px.y() + 0.5) * scale);
    };
    std::vector<core::JointId> clicked;
    QObject::connect(&scene, &SceneView::jointClicked, [&](const core::JointId& joint) { clicked.push_back(joint); });
    test::click(gl, place({60, -90, 30}) + QPointF(2, 1));
    test::click(gl, place({-80, 40, -20}));
    test::click(gl, {5, 5});
    ASSERT_EQ(clicked.size(), 2u);
    EXPECT_EQ(clicked[0], index);
    EXPECT_EQ(clicked[1], thumb);
}

TEST_F(SceneViewTest, JointsShowThroughFlesh) {
    scene.setMeshLayers({test::ballLayer(QColor(90, 90, 90))});
    SceneJoint joint{{core::Side::Left, "thumb_ip"}, {0, 0, 0}, {}, QColor(255, 160, 0), false};
    scene.setJoints({joint});
    const int small = count(scene.grabPicture(), joint.colour);
    EXPECT_GT(small, 4);
    joint.covariance = Eigen::Matrix3d(Eigen::Vector3d(100, 100, 100).asDiagonal());
    scene.setJoints({joint});
    EXPECT_GT(count(scene.grabPicture(), joint.colour), 3 * small) << "its ellipsoid is drawn";
}

TEST_F(SceneViewTest, MeshesHaveTheColourOfTheirLegend) {
    scene.setGridShown(false);
    MeshLayer first = test::ballLayer(Qt::black);
    scene.setMeshLayers({first});
    const QImage black = scene.grabPicture();
    std::vector<QColor> shown;
    for (const char* method : {"ch", "dch-thres", "dch-quant", "dch-quant2", "dch-dt3", "best"}) {
        MeshLayer layer = test::ballLayer(methodColour(method));
        layer.opacity = 1;
        scene.setMeshLayers({layer});
        const QImage picture = scene.grabPicture();
        const auto isMesh = [&](int x, int y) {
            return test::labDistance(picture.pixelColor(x, y), black.pixelColor(x, y)) > 15;
        };
        shown.push_back(test::meanColour(picture, isMesh));
        EXPECT_LT(test::labDistance(shown.back(), layer.colour), 10)
            << method << " " << shown.back().name().toStdString();
    }
    for (std::size_t a = 0; a < shown.size(); ++a)
        for (std::size_t b = a + 1; b < shown.size(); ++b)
            EXPECT_GT(test::labDistance(shown[a], shown[b]), 20) << a << " " << b;
}

TEST_F(SceneViewTest, MeshesAreAsOpaqueAsTheirLayer) {
    scene.setGridShown(false);
    MeshLayer layer = test::ballLayer(QColor(255, 160, 0));
    const auto mean = [&](double opacity) {
        layer.opacity = opacity;
        scene.setMeshLayers({layer});
        return test::meanColour(scene.grabPicture(), [](int, int) { return true; });
    };
    const QColor opaque = mean(1), half = mean(0.5), none = mean(0);
    EXPECT_GT(test::labDistance(opaque, none), 1.2 * test::labDistance(half, none));
    EXPECT_GT(test::labDistance(half, none), 0.5);
}

} // namespace
