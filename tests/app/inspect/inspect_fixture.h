// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "tests/app/window_fixture.h"

namespace test {

/// The Inspect workspace with a fitted pair: frame 7 from frame 4 of the tiny dataset.
class InspectTest : public WindowTest {
protected:
    /// `methods`: names in quotes, with commas between.
    void fit(const std::string& methods) {
        run(R"({"do":"fit","start":4,"test":7,"methods":[)" + methods +
            "]}\n{\"do\":\"action\",\"id\":\"workspace.inspect\"}\n");
    }
    void setLayer(const char* layer, bool on) {
        run(std::string("{\"do\":\"layer\",\"id\":\"") + layer + "\",\"on\":" + (on ? "true" : "false") + "}\n");
        page().grid()->finishDrawing();
    }
    void trigger(const char* action) {
        window->actions().action(QString::fromLatin1(action))->trigger();
        app::waitUntilIdle(*window);
        page().grid()->finishDrawing();
    }
    widgets::InspectPage& page() { return *window->workspaces().inspectPage(); }
    widgets::InspectColumns& columns() { return *page().columns(); }
    widgets::CameraView& view(int index) { return *page().grid()->view(index); }
};

} // namespace test
