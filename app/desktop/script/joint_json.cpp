// SPDX-License-Identifier: MIT
#include "app/desktop/script/joint_json.h"

#include <QJsonArray>

#include "widgets/text/local_text.h"

namespace app {

namespace {

QJsonObject viewJson(const core::ViewReconstruction& view) {
    QJsonObject object;
    object[QStringLiteral("camera")] = QString::fromStdString(view.camera);
    object[QStringLiteral("px")] = QJsonArray{view.mark->px.x(), view.mark->px.y()};
    object[QStringLiteral("state")] =
        view.mark->state == core::MarkState::Occluded ? QStringLiteral("occluded") : QStringLiteral("visible");
    object[QStringLiteral("placement")] =
        view.mark->placement == core::Placement::Auto ? QStringLiteral("auto") : QStringLiteral("manual");
    object[QStringLiteral("errorPx")] = view.errorPx ? QJsonValue(*view.errorPx) : QJsonValue();
    return object;
}

QJsonArray rows(const Eigen::Matrix3d& matrix) {
    QJsonArray array;
    for (int row = 0; row < 3; ++row)
        array.append(QJsonArray{matrix(row, 0), matrix(row, 1), matrix(row, 2)});
    return array;
}

} // namespace

QJsonObject jointJson(const core::JointReconstruction& found) {
    QJsonObject object;
    QJsonArray views, unplaceable;
    for (const core::ViewReconstruction& view : found.views) {
        if (!view.mark)
            continue;
        if (view.mark->state == core::MarkState::Unplaceable)
            unplaceable.append(QString::fromStdString(view.camera));
        else if (view.mark->isPlaced())
            views.append(viewJson(view));
    }
    const auto& point = found.result.point;
    object[QStringLiteral("xyz")] =
        point ? QJsonValue(QJsonArray{point->pointInWorld.x(), point->pointInWorld.y(), point->pointInWorld.z()})
              : QJsonValue();
    object[QStringLiteral("covariance")] = point ? QJsonValue(rows(point->covariance)) : QJsonValue();
    object[QStringLiteral("rmsPx")] = point && !found.isAccepted ? QJsonValue(point->rmsPx) : QJsonValue();
    object[QStringLiteral("views")] = views;
    object[QStringLiteral("unplaceable")] = unplaceable;
    object[QStringLiteral("status")] = widgets::toQString(core::statusName(found.status));
    if (!point)
        object[QStringLiteral("reason")] = QString::fromStdString(std::string(core::failureText(found.result.failure)));
    return object;
}

} // namespace app
