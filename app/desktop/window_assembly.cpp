// SPDX-License-Identifier: MIT
#include "app/desktop/window_assembly.h"

#include "app/desktop/actions/annotation_actions.h"
#include "app/desktop/actions/compare_actions.h"
#include "app/desktop/actions/dataset_actions.h"
#include "app/desktop/actions/figure_actions.h"
#include "app/desktop/actions/file_actions.h"
#include "app/desktop/actions/menus.h"
#include "app/desktop/actions/number_keys.h"
#include "app/desktop/actions/panel_actions.h"
#include "app/desktop/actions/people_actions.h"
#include "app/desktop/actions/review_actions.h"
#include "app/desktop/actions/rig_actions.h"
#include "app/desktop/actions/silhouette_actions.h"
#include "app/desktop/actions/window_actions.h"
#include "app/desktop/windows/preferences_window.h"

namespace app {

std::unique_ptr<MainWindow> makeMainWindow(QSettings& settings, const WindowOptions& options) {
    auto window = std::make_unique<MainWindow>(settings, options);
    bindWindowActions(*window);
    bindAnnotationActions(*window);
    bindPanelActions(*window);
    bindCompareActions(*window);
    bindFileActions(*window);
    bindFigureActions(*window);
    bindDatasetActions(*window);
    bindRigActions(*window);
    bindReviewActions(*window);
    bindSilhouetteActions(*window);
    bindPeopleActions(*window, options.hints && options.rater.empty());
    new NumberKeys(*window);
    buildMenus(*window);
    buildToolbar(*window);
    applyPreferences(*window);
    return window;
}

} // namespace app
