// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <opencv2/core/mat.hpp>

namespace core {

/// A silhouette from a picture and one of the same camera without hands: what differs by more than the noise, closed,
/// without small holes and specks. Skin before something of its colour is missed, as it is in reality.
cv::Mat differenceMask(const cv::Mat& picture, const cv::Mat& background);

struct BackgroundOptions {
    double leastDifference = 12; ///< grey levels, of the channel that differs most
    double darkestShadow = 0.4;  ///< light that a shadow leaves, share
    double shadowColour =
        0.035; ///< how far a shadow's colour may be from the background's (of red, green, blue shares)
};

/// The same for a room in which hands throw shadows: what is only darker than the background, in its colour, is taken
/// for one. The picture may be brighter or darker as a whole (the exposure is matched by the median).
cv::Mat backgroundMask(const cv::Mat& picture, const cv::Mat& background, const BackgroundOptions& options = {});

/// The median of pictures of one camera, channel by channel: the room without what moves. CV_8UC3 of their size.
/// Pictures of another size than the first one are left out; empty if there is none.
cv::Mat medianPicture(const std::vector<cv::Mat>& pictures);

} // namespace core
