// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/views/page_picture.h"
#include "widgets/views/picture_export.h"
#include "widgets/workspaces/inspect_page.h"

namespace widgets {

/// The pair with its sequence, for what leaves the window; empty without a fit.
QString pairText(const InspectPage& page);

/// The compared pair as a figure on white paper: a heading, every view as it is shown with its title above it, the
/// curves below. It draws the page's widgets: to be used while they live.
PagePicture comparisonPicture(const InspectPage& page);

/// Saved by the path's suffix: PNG, SVG or PDF.
PictureSource comparisonSource(const InspectPage& page);

} // namespace widgets
