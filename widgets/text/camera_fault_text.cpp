// SPDX-License-Identifier: MIT
#include "widgets/text/camera_fault_text.h"

#include "widgets/text/local_text.h"

namespace widgets {

namespace {

constexpr LocalText faultWords{"widgets::CameraFaultText"};

QString pixelsText(const core::ImageSize& size) {
    return QStringLiteral("%1 × %2").arg(size.width).arg(size.height);
}

QString nameOf(int camera, const std::vector<core::Camera>& cameras) {
    return camera >= 0 && camera < static_cast<int>(cameras.size())
               ? toQString(cameras[static_cast<std::size_t>(camera)].name)
               : QString();
}

QString whatIsWrong(const core::CameraFault& fault, const std::vector<core::Camera>& cameras) {
    switch (fault.kind) {
    case core::CameraFaultKind::NotARotation:
        return fault.value == -1
                   ? faultWords(QT_TRANSLATE_NOOP("widgets::CameraFaultText",
                                                  "its rotation is a mirror: an axis points the wrong way"))
                   : faultWords(QT_TRANSLATE_NOOP("widgets::CameraFaultText", "its rotation matrix is not a rotation"));
    case core::CameraFaultKind::NoFocalLength:
        return faultWords(QT_TRANSLATE_NOOP("widgets::CameraFaultText", "its focal length is not positive"));
    case core::CameraFaultKind::CentreOutside:
        return faultWords(QT_TRANSLATE_NOOP(
            "widgets::CameraFaultText", "its principal point lies outside the image: is the matrix transposed, or the "
                                        "image size wrong?"));
    case core::CameraFaultKind::OtherSize:
        return faultWords(
                   QT_TRANSLATE_NOOP("widgets::CameraFaultText",
                                     "its footage has %1 pixels, the calibration is for %2: another camera's footage?"))
            .arg(pixelsText(fault.pictures), pixelsText(cameras[static_cast<std::size_t>(fault.camera)].size));
    case core::CameraFaultKind::OtherScale:
        return faultWords(QT_TRANSLATE_NOOP("widgets::CameraFaultText",
                                            "its footage is scaled by %1 (%2 pixels, the calibration is for %3)"))
            .arg(localNumber(fault.value, 3), pixelsText(fault.pictures),
                 pixelsText(cameras[static_cast<std::size_t>(fault.camera)].size));
    case core::CameraFaultKind::SamePlace:
        return faultWords(QT_TRANSLATE_NOOP("widgets::CameraFaultText", "it stands where %1 stands"))
            .arg(nameOf(fault.other, cameras));
    case core::CameraFaultKind::LooksAway:
        return faultWords(QT_TRANSLATE_NOOP("widgets::CameraFaultText",
                                            "where the cameras look lies behind it: is its rotation inverted?"));
    case core::CameraFaultKind::TargetUnseen:
        return faultWords(
            QT_TRANSLATE_NOOP("widgets::CameraFaultText", "it does not see where the other cameras look"));
    case core::CameraFaultKind::LensFolds:
        return faultWords(
                   QT_TRANSLATE_NOOP("widgets::CameraFaultText", "its lens model holds in %1 % of the image only"))
            .arg(localNumber(100 * fault.value, 0));
    case core::CameraFaultKind::OddUnit:
        return faultWords(QT_TRANSLATE_NOOP("widgets::CameraFaultText",
                                            "The cameras are %1 mm from where they look: choose another unit."))
            .arg(localNumber(fault.value, fault.value < 10 ? 2 : 0));
    }
    return {};
}

} // namespace

QString cameraFaultText(const core::CameraFault& fault, const std::vector<core::Camera>& cameras) {
    const QString name = nameOf(fault.camera, cameras), what = whatIsWrong(fault, cameras);
    return name.isEmpty() ? what : QStringLiteral("%1: %2").arg(name, what);
}

} // namespace widgets
