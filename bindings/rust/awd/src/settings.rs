// SPDX-License-Identifier: Apache-2.0
//! Settings that densities, fields and renders share.

use awd_sys::*;

enumeration! {
    /// A group of settings.
    #[derive(Default)]
    Preset {
        /// What we found best.
        #[default]
        Default = AWD_PRESET_DEFAULT,
        /// Pietrek and Peter 1999 to the letter.
        Paper = AWD_PRESET_PAPER,
    }
}

enumeration! {
    /// What a density becomes proportional to.
    #[derive(Default)]
    Target {
        /// The mean.
        #[default]
        Default = AWD_TARGET_DEFAULT,
        /// The local mean of |f|.
        Mean = AWD_TARGET_MEAN,
        /// The local sqrt(E[f^2]): better where f is noisy at each point, learned more slowly.
        Rms = AWD_TARGET_RMS,
    }
}

enumeration! {
    /// How coefficients come from samples; `awd/types.h` has the formulas.
    #[derive(Default)]
    Estimator {
        /// Of a density quasi, or ratio where its level can't grow any more; of a field lumped.
        #[default]
        Default = AWD_ESTIMATOR_DEFAULT,
        /// The paper's; wants [`Sampler::Component`](crate::Sampler::Component).
        Paper = AWD_ESTIMATOR_PAPER,
        /// Weighted means, solved with the Gram matrix.
        Mixture = AWD_ESTIMATOR_MIXTURE,
        /// Ratios of sums, solved with the Gram matrix.
        Ratio = AWD_ESTIMATOR_RATIO,
        /// Ratios of sums, shrunk towards the coarser levels: never negative.
        Quasi = AWD_ESTIMATOR_QUASI,
        /// Least squares above the floor; wants the refit module.
        Refit = AWD_ESTIMATOR_REFIT,
        /// Weighted sums: never negative. Of fields alone.
        Lumped = AWD_ESTIMATOR_LUMPED,
    }
}

enumeration! {
    /// How passes make one result.
    #[derive(Default)]
    Combination {
        /// Count; of an adaptive render, but for the preset paper, experience.
        #[default]
        Default = AWD_COMBINE_DEFAULT,
        /// Every sample counts the same: unbiased.
        Count = AWD_COMBINE_COUNT,
        /// Of a density: by the variance of each pass as the last one's samples see it.
        CrossVariance = AWD_COMBINE_CROSS_VARIANCE,
        /// Of a render: samples count for less while little has been learned; unbiased.
        Experience = AWD_COMBINE_EXPERIENCE,
    }
}

enumeration! {
    /// How a refit ended.
    RefitStatus {
        /// There was none.
        None = AWD_REFIT_NONE,
        /// At the optimum.
        Converged = AWD_REFIT_CONVERGED,
        /// At the solver's limit of iterations: good, not quite the optimum.
        Limit = AWD_REFIT_LIMIT,
        /// The quasi coefficients were taken instead.
        Failed = AWD_REFIT_FAILED,
    }
}

/// A level as a setting; None: the default.
pub(crate) fn level(level: Option<u32>) -> u32 {
    level.map_or(0, |level| AWD_LEVEL(level.min(u32::MAX - 1)))
}
