// SPDX-License-Identifier: Apache-2.0
//! What bindings/rust/README.md leaves to the reader: points in the unit square, and values there.

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let uniforms: Vec<f64> = (0..2048).map(|i| f64::from(i) * 0.618_033_988 % 1.0).collect();
    let values = vec![1.0; uniforms.len() / 2];
    // @body
    assert!(density.pdf(&samples.points)?.iter().all(|&pdf| pdf > 0.0));
    Ok(())
}
