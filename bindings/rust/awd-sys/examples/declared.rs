// SPDX-License-Identifier: Apache-2.0
//! Prints what awd-sys declares.

fn main() {
    println!("{}", awd_sys::declared::json());
}
