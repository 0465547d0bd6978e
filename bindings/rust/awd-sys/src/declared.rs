// SPDX-License-Identifier: Apache-2.0
//! What this crate declares, for the test that compares it with the C headers.

use std::fmt::Write;
use std::mem::size_of;

use crate::{basis, density, device, field, image, light, render, scene, types};

/// How a value is handed over; "other": a pointer, or a struct within another one.
pub(crate) trait Kind {
    const KIND: &'static str;
}

macro_rules! kinds {
    ($( $type:ty: $kind:expr; )*) => { $(
        impl Kind for $type {
            const KIND: &'static str = $kind;
        }
    )* };
}

kinds! {
    u8: "u8";
    i32: "i32";
    u32: "u32";
    u64: "u64";
    usize: if size_of::<usize>() == 8 { "u64" } else { "u32" };
    f32: "f32";
    f64: "f64";
    [f32; 2]: "f32[2]";
    [f32; 3]: "f32[3]";
}

impl<T> Kind for *const T {
    const KIND: &'static str = "other";
}

impl<T> Kind for *mut T {
    const KIND: &'static str = "other";
}

/// Functions, of which NULL is None.
impl<T> Kind for Option<T> {
    const KIND: &'static str = "other";
}

pub(crate) struct Field {
    pub name: &'static str,
    pub offset: usize,
    pub size: usize,
    pub kind: &'static str,
}

pub(crate) struct Struct {
    pub name: &'static str,
    pub size: usize,
    pub fields: Vec<Field>,
}

pub(crate) trait Layout {
    fn layout() -> Struct;
}

pub(crate) struct Function {
    pub name: &'static str,
    pub result: &'static str,
    pub arguments: Vec<&'static str>,
}

pub(crate) fn first(kinds: &[&'static str]) -> &'static str {
    kinds[0]
}

/// A struct's default, as the bytes of its fields in hexadecimal digits.
pub(crate) struct Init {
    name: &'static str,
    fields: Vec<(&'static str, String)>,
}

impl Init {
    pub(crate) fn of<T: Layout + Default>() -> Self {
        let value = T::default();
        let layout = T::layout();
        let hex = |field: &Field| {
            (0..field.size).fold(String::new(), |digits, i| {
                // Safety: a byte of a field, which has no padding and is initialised.
                let byte = unsafe { *(&value as *const T).cast::<u8>().add(field.offset + i) };
                format!("{}{:02x}", digits, byte)
            })
        };
        let fields = layout.fields.iter().map(|field| (field.name, hex(field))).collect();
        Init { name: layout.name, fields }
    }
}

fn object<'a, V: std::fmt::Display>(items: impl IntoIterator<Item = (&'a str, V)>) -> String {
    let mut text = String::from("{");
    for (i, (name, value)) in items.into_iter().enumerate() {
        let comma = if i == 0 { "" } else { ", " };
        // Writing to a String can't fail.
        let _ = write!(text, "{}\"{}\": {}", comma, name, value);
    }
    text + "}"
}

fn quoted(text: &str) -> String {
    format!("\"{}\"", text)
}

/// Functions, constants, structs, and what defaults they have, as JSON.
pub fn json() -> String {
    let mut functions = Vec::new();
    for module in [device::functions, density::functions, field::functions, light::functions] {
        functions.extend(module());
    }
    for module in [scene::functions, render::functions, image::functions] {
        functions.extend(module());
    }
    let mut constants = Vec::new();
    for module in [types::constants, device::constants, density::constants, field::constants] {
        constants.extend(module());
    }
    for module in [scene::constants, render::constants, basis::constants] {
        constants.extend(module());
    }
    let mut structs = Vec::new();
    for module in [types::structs, device::structs, density::structs, field::structs] {
        structs.extend(module());
    }
    for module in [scene::structs, render::structs, image::structs, basis::structs] {
        structs.extend(module());
    }
    let mut inits = Vec::new();
    for module in [device::inits, density::inits, field::inits, scene::inits, render::inits] {
        inits.extend(module());
    }
    inits.extend(image::inits());

    let signature = |function: &Function| {
        let kinds = std::iter::once(&function.result).chain(&function.arguments);
        format!("[{}]", kinds.map(|kind| quoted(kind)).collect::<Vec<_>>().join(", "))
    };
    let layout = |item: &Struct| {
        let offsets = object(item.fields.iter().map(|field| (field.name, field.offset)));
        format!("{{\"size\": {}, \"fields\": {}}}", item.size, offsets)
    };
    let kinds = |item: &Struct| object(item.fields.iter().map(|f| (f.name, quoted(f.kind))));
    let values = |init: &Init| object(init.fields.iter().map(|(name, hex)| (*name, quoted(hex))));

    object([
        ("functions", object(functions.iter().map(|f| (f.name, f.arguments.len())))),
        ("signatures", object(functions.iter().map(|f| (f.name, signature(f))))),
        ("constants", object(constants)),
        ("structs", object(structs.iter().map(|item| (item.name, layout(item))))),
        ("kinds", object(structs.iter().map(|item| (item.name, kinds(item))))),
        ("defaults", object(inits.iter().map(|init| (init.name, values(init))))),
    ])
}
