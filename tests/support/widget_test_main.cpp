// SPDX-License-Identifier: MIT
// main() of the tests that need windows: they run on an X server of their own, with OpenGL.
#include <QApplication>

#include <gtest/gtest.h>

#include "widgets/views/private_display.h"
#include "widgets/views/scene/scene_view.h"

int main(int argc, char** argv) {
    testing::InitGoogleTest(&argc, argv);
    if (testing::GTEST_FLAG(list_tests))
        return RUN_ALL_TESTS();
    const widgets::PrivateDisplay display;
    widgets::SceneView::prepareApplication();
    QApplication application(argc, argv);
    QApplication::setStyle(QStringLiteral("Fusion"));
    return RUN_ALL_TESTS();
}
