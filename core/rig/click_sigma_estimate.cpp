// SPDX-License-Identifier: MIT
#include "core/rig/click_sigma_estimate.h"

#include "core/rig/rig_error_model.h"

namespace core {

ClickSigmas estimateClickSigmas(const std::vector<Camera>& cameras, const std::vector<RigJoint>& joints,
                                const RigResiduals& residuals) {
    RigErrorModel model(cameras, joints, residuals);
    model.estimate();
    ClickSigmas sigmas;
    bool isAnyKnown = false;
    for (std::size_t r = 0; r < model.raters().size(); ++r) {
        const int rater = static_cast<int>(r);
        RaterSigma& sigma = sigmas.raters[model.raters()[r]];
        for (const ErrorModelClick& click : model.clicks())
            if (click.rater == rater)
                ++(click.isUsed ? sigma.clicks : sigma.wrongClicks);
        if (model.freedom(rater) < kLeastSigmaFreedom)
            continue;
        isAnyKnown = true;
        sigma.isAssumed = false;
        sigma.clickPx = model.sigmaPx(rater);
        for (int c = 0; c < static_cast<int>(cameras.size()); ++c)
            sigma.clickPxByCamera.push_back(model.sigmaPx(rater, c));
    }
    if (isAnyKnown)
        sigmas.systematicPx = model.systematicPx();
    return sigmas;
}

ClickSigmas estimateClickSigmas(const std::vector<Camera>& cameras, const std::vector<RigJoint>& joints) {
    return estimateClickSigmas(cameras, joints, computeRigResiduals(cameras, joints));
}

} // namespace core
