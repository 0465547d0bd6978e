// SPDX-License-Identifier: Apache-2.0
//! Integrates exp(-4 (x + y)) over the unit square, by passes each of whose points fall where the
//! ones before have found the function to be large.

use awd::{Density, DensitySettings, Device, Result};

const SAMPLES: usize = 4096;

/// A uniform in [0,1), by SplitMix64.
fn uniform(state: &mut u64) -> f64 {
    *state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
    let mut z = *state;
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
}

fn main() -> Result<()> {
    let device = Device::new(Default::default())?;
    let settings = DensitySettings { dimensions: 2, ..Default::default() };
    let mut density = Density::new(&device, &settings)?;
    let mut random = 7;
    for pass in 0..5 {
        let uniforms: Vec<f64> = (0..2 * SAMPLES).map(|_| uniform(&mut random)).collect();
        let samples = density.sample(&uniforms)?;
        let values: Vec<f64> =
            samples.points.chunks(2).map(|x| (-4.0 * (x[0] + x[1])).exp()).collect();
        density.record(&samples.points, Some(&samples.pdfs), None, &values)?;
        let estimate = density.estimate()?;
        println!(
            "pass {}: integral {:.6} +- {:.1e}",
            pass + 1,
            estimate.integral,
            estimate.standard_error
        );
        density.adapt()?;
    }
    let side = (1.0 - (-4.0f64).exp()) / 4.0;
    println!("in truth: {:.6}", side * side);
    Ok(())
}
