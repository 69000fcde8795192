// SPDX-License-Identifier: MIT
#pragma once

#include <QJsonObject>

#include "core/annotation/reconstruction.h"

namespace app {

/// A joint as the ground truth file holds it: xyz, covariance, rmsPx, views, unplaceable, status.
QJsonObject jointJson(const core::JointReconstruction& found);

} // namespace app
