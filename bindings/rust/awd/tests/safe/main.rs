// SPDX-License-Identifier: Apache-2.0
//! The safe interface, from outside.

mod bases;
mod callbacks;
mod common;
mod continuation;
mod density;
mod field;
mod render;
mod scene;
