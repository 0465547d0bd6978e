// SPDX-License-Identifier: Apache-2.0
//! Tells the linker where libawd is: in AWD_LIB_DIR, or where pkg-config says.

use std::env;
use std::path::Path;
use std::process::{exit, Command};

fn main() {
    for name in ["AWD_LIB_DIR", "PKG_CONFIG", "PKG_CONFIG_PATH", "PKG_CONFIG_LIBDIR"] {
        println!("cargo:rerun-if-env-changed={}", name);
    }
    println!("cargo:rerun-if-changed=build.rs");
    let folders = match env::var("AWD_LIB_DIR") {
        Ok(folder) if !folder.is_empty() => given(folder),
        _ => asked(),
    };
    match folders {
        Ok(folders) => {
            for folder in folders {
                println!("cargo:rustc-link-search=native={}", folder);
            }
            println!("cargo:rustc-link-lib=dylib=awd");
        }
        Err(reason) => {
            eprintln!("awd-sys: {}", reason);
            exit(1);
        }
    }
}

fn given(folder: String) -> Result<Vec<String>, String> {
    let names = ["libawd.so", "libawd.dylib", "awd.lib"];
    if names.iter().any(|name| Path::new(&folder).join(name).exists()) {
        return Ok(vec![folder]);
    }
    Err(format!(
        "AWD_LIB_DIR is \"{}\", where there is no libawd.so: set it to the folder that has it",
        folder
    ))
}

/// Folders that the linker does not know by itself.
fn asked() -> Result<Vec<String>, String> {
    const REMEDY: &str = "set AWD_LIB_DIR to the folder of libawd.so, or PKG_CONFIG_PATH to that \
                          of awd.pc";
    let program = env::var("PKG_CONFIG").unwrap_or_else(|_| "pkg-config".to_string());
    let answer = Command::new(&program)
        .args(["--libs-only-L", "awd"])
        .output()
        .map_err(|error| format!("libawd was not found: {}. ({}: {})", REMEDY, program, error))?;
    if !answer.status.success() {
        let said = String::from_utf8_lossy(&answer.stderr);
        return Err(format!("libawd was not found: {}. ({}: {})", REMEDY, program, said.trim()));
    }
    let flags = String::from_utf8_lossy(&answer.stdout).into_owned();
    Ok(flags
        .split_whitespace()
        .filter_map(|flag| flag.strip_prefix("-L"))
        .map(String::from)
        .collect())
}
