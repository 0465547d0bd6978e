// SPDX-License-Identifier: Apache-2.0
//! What scenes are made of.

use std::marker::PhantomData;
use std::mem::size_of;

use awd_sys::*;

use crate::{Error, Result, Vector};

/// A diffuse material: f_r = albedo / pi on both sides.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Material {
    /// Linear RGB, 0 to 1.
    pub albedo: Vector,
    /// Radiance leaving the front side, linear RGB, finite, >= 0.
    pub emission: Vector,
}

/// What a [`Buffer`] holds.
pub trait Item: private::Sealed {
    /// What it is made of.
    type Scalar;
}

mod private {
    pub trait Sealed {
        const FORMAT: i32;
    }
}

macro_rules! items {
    ($( $item:ty: $scalar:ty, $format:ident; )*) => { $(
        impl private::Sealed for $item {
            const FORMAT: i32 = awd_sys::$format;
        }

        impl Item for $item {
            type Scalar = $scalar;
        }
    )* };
}

items! {
    u32: u32, AWD_FORMAT_UINT;
    [u32; 3]: u32, AWD_FORMAT_UINT3;
    [f32; 3]: f32, AWD_FORMAT_FLOAT3;
}

/// Items of a mesh, borrowed: a slice of them, or every so many numbers of one.
///
/// ```
/// # fn main() -> awd::Result<()> {
/// // Position and normal of each vertex, in one array.
/// let data = [0.0f32, 0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0];
/// let positions = awd::Buffer::<[f32; 3]>::strided(&data, 0, 6, 2)?;
/// assert_eq!(positions.len(), 2);
/// assert!(awd::Buffer::<[f32; 3]>::strided(&data, 4, 6, 2).is_err()); // beyond the end
/// # Ok(())
/// # }
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Buffer<'a, T: Item> {
    raw: AWDBuffer,
    items: PhantomData<&'a [T]>,
}

impl<'a, T: Item> Buffer<'a, T> {
    /// `count` items, of which item i begins at `data[offset + i * stride]`.
    ///
    /// # Errors
    /// `InvalidArgument` if they don't lie within the data.
    pub fn strided(
        data: &'a [T::Scalar],
        offset: usize,
        stride: usize,
        count: usize,
    ) -> Result<Self> {
        let width = size_of::<T>() / size_of::<T::Scalar>();
        let end = match count {
            0 => Some(0),
            _ => (count - 1)
                .checked_mul(stride)
                .and_then(|last| last.checked_add(offset))
                .and_then(|last| last.checked_add(width)),
        };
        if stride == 0 || end.map_or(true, |end| end > data.len()) {
            return Err(Error::argument(format!(
                "a buffer of {} items from number {} on, {} apart, does not lie within {} numbers",
                count,
                offset,
                stride,
                data.len()
            )));
        }
        let scalar = size_of::<T::Scalar>();
        Ok(Self::of(data.as_ptr().cast(), offset * scalar, stride * scalar, count))
    }

    /// How many items there are.
    pub fn len(&self) -> usize {
        self.raw.count
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.raw.count == 0
    }

    fn of(data: *const u8, offset: usize, stride: usize, count: usize) -> Self {
        let data = if count == 0 { std::ptr::null() } else { data.cast() };
        let raw = AWDBuffer {
            data,
            byteOffset: offset,
            byteStride: stride,
            count,
            format: T::FORMAT,
            reserved: 0,
        };
        Buffer { raw, items: PhantomData }
    }
}

impl<'a, T: Item> From<&'a [T]> for Buffer<'a, T> {
    fn from(items: &'a [T]) -> Self {
        Self::of(items.as_ptr().cast(), 0, 0, items.len())
    }
}

impl<'a, T: Item, const N: usize> From<&'a [T; N]> for Buffer<'a, T> {
    fn from(items: &'a [T; N]) -> Self {
        Self::from(&items[..])
    }
}

impl<'a, T: Item> From<&'a Vec<T>> for Buffer<'a, T> {
    fn from(items: &'a Vec<T>) -> Self {
        Self::from(&items[..])
    }
}

impl<T: Item> Default for Buffer<'_, T> {
    fn default() -> Self {
        Self::of(std::ptr::null(), 0, 0, 0)
    }
}

/// Triangles, copied when they are added.
#[derive(Clone, Copy, Debug, Default)]
pub struct Mesh<'a> {
    /// Finite, below 1e18 in magnitude.
    pub vertices: Buffer<'a, [f32; 3]>,
    /// Three vertices a triangle, counter-clockwise seen from the front.
    pub indices: Buffer<'a, [u32; 3]>,
    /// One a triangle; empty: `material` for all.
    pub materials: Buffer<'a, u32>,
    /// One a triangle, below 2^31 - 1; empty: a patch per planar piece.
    pub patches: Buffer<'a, u32>,
    /// Used when there are no `materials`.
    pub material: u32,
}

impl Mesh<'_> {
    /// Points to what the mesh borrows.
    pub(crate) fn desc(&self) -> AWDMeshDesc {
        AWDMeshDesc {
            vertices: self.vertices.raw,
            indices: self.indices.raw,
            materials: self.materials.raw,
            patches: self.patches.raw,
            material: self.material,
            ..Default::default()
        }
    }
}
