// SPDX-License-Identifier: MIT
// A saved comparison is looked at as it was when it was saved.
#include <fstream>

#include "app/desktop/script/workspace_file.h"
#include "app/desktop/script/workspace_player.h"
#include "tests/app/inspect/inspect_fixture.h"

namespace {

class WorkspaceLookTest : public test::InspectTest {
protected:
    std::vector<QImage> pictures() {
        app::waitUntilIdle(*window);
        page().grid()->finishDrawing();
        std::vector<QImage> taken;
        for (const widgets::CameraView* one : page().grid()->views())
            taken.push_back(one->grabPicture());
        return taken;
    }
    std::string save() { return run(R"({"do":"workspace","path":"w.json"})")[0]["path"]; }
    widgets::LayerPresenter& layers() { return *window->workspaces().layers(); }
};

TEST_F(WorkspaceLookTest, ZoomMeshesProbeAndWipeComeBack) {
    fit("\"ch\",\"dch-thres\"");
    const std::string plain = save();
    const std::vector<QImage> before = pictures();
    const app::Workspace untouched = app::readWorkspace(plain);
    EXPECT_TRUE(untouched.regions.empty());
    EXPECT_FALSE(untouched.probe.has_value() || untouched.wipe.has_value());
    columns().setCurrent(1);
    trigger("view.meshWireframe");
    trigger("view.meshLess");
    trigger("view.startMesh");
    view(0).lookAt(view(0).home().center(), 3 * view(0).scale());
    const QPointF pinned = session().fits.outcome()->handsPx[0].center();
    page().probePin()->pin(1, pinned);
    page().views()->wipe()->setPlace(0.3);
    page().views()->wipe()->setKind(widgets::ColumnWipe::Kind::Wipe);
    const double opacity = layers().look().opacity, scale = view(1).scale();
    const std::vector<QImage> looked = pictures();
    for (std::size_t one = 0; one < looked.size(); ++one)
        ASSERT_NE(looked[one], before[one]) << one;
    EXPECT_EQ(view(1).scale(), view(0).scale()) << "a row is one";
    const std::string file = save();

    std::ofstream(folder / "old.json")
        << R"({"format":"handlens-workspace","version":1,"sequence":"a","start":4,"test":7,"methods":["ch","dch-thres"],)"
        << "\"iteration\":" << page().lastIteration() << "}";
    trigger("view.meshShaded");
    trigger("view.meshMore");
    trigger("view.startMesh");
    app::restoreWorkspace(*window, app::readWorkspace(folder / "old.json"));
    EXPECT_FALSE(page().probePin()->isPinned()) << "files of before show the hands, and nothing else";
    EXPECT_TRUE(view(0).isFitted());
    EXPECT_EQ(page().views()->wipe()->kind(), widgets::ColumnWipe::Kind::None);
    EXPECT_EQ(pictures(), before);

    app::restoreWorkspace(*window, app::readWorkspace(file));
    EXPECT_EQ(columns().current(), 1u);
    EXPECT_EQ(layers().look().style, widgets::MeshStyle::Wireframe);
    EXPECT_EQ(layers().look().opacity, opacity);
    EXPECT_TRUE(window->actions().action(QStringLiteral("view.startMesh"))->isChecked());
    ASSERT_TRUE(page().probePin()->isPinned());
    EXPECT_EQ(page().probePin()->pinned()->px, pinned);
    EXPECT_NEAR(view(1).scale(), scale, 1e-9 * scale);
    EXPECT_EQ(page().views()->wipe()->kind(), widgets::ColumnWipe::Kind::Wipe);
    EXPECT_EQ(page().views()->wipe()->place(), 0.3);
    EXPECT_EQ(pictures(), looked);
}

TEST_F(WorkspaceLookTest, AWindowOfAnotherSizeShowsTheSameWidth) {
    fit("\"ch\"");
    run(R"({"do":"columns","cameras":["cam1","cam0"]})");
    view(0).lookAt({40, 30}, 2 * view(0).scale());
    const double widthPx = view(0).viewport()->width() / view(0).scale();
    const std::string file = save();
    run(R"({"do":"resize","size":[1100,700]})");
    app::restoreWorkspace(*window, app::readWorkspace(file));
    EXPECT_NEAR(view(0).viewport()->width() / view(0).scale(), widthPx, 1e-6);
    EXPECT_TRUE(view(1).isFitted());
}

TEST_F(WorkspaceLookTest, AProbeOfAViewThatIsNotThereIsRefused) {
    fit("\"ch\"");
    app::Workspace workspace = app::readWorkspace(save());
    workspace.probe = {"best", "cam0", 10, 10};
    EXPECT_ANY_THROW(app::restoreWorkspace(*window, workspace));
    std::ofstream(folder / "bad.json")
        << R"({"format":"handlens-workspace","version":1,"sequence":"a","start":4,"test":7,"methods":["ch"],"meshes":{"style":"glass"}})";
    EXPECT_ANY_THROW(app::readWorkspace(folder / "bad.json"));
}

} // namespace
