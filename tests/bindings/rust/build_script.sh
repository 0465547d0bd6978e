#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# How awd-sys finds libawd, and what it says when it doesn't.
#   build_script.sh <rustc> <build.rs> <folder of libawd.so> <work folder>
set -euo pipefail
rustc=$1 source=$2 library=$3 work=$4
rm -rf "$work"
mkdir -p "$work"
"$rustc" --edition 2021 -o "$work/script" "$source"
unset AWD_LIB_DIR PKG_CONFIG PKG_CONFIG_PATH

# expect STATUS TEXT COMMAND...: how it ends, and part of what it prints.
expect() {
  local wanted=$1 text=$2 got=0 output
  shift 2
  output=$("$@" 2>&1) || got=$?
  [[ $got == "$wanted" && $output == *"$text"* ]] ||
    { echo "$* gave $got, not $wanted with \"$text\": $output"; exit 1; }
}

pkg_config() { printf '#!/bin/sh\n%s\n' "$1" >"$work/pkg-config"; chmod +x "$work/pkg-config"; }

expect 0 "rustc-link-search=native=$library" env AWD_LIB_DIR="$library" "$work/script"
expect 1 "there is no libawd.so: set it to" env AWD_LIB_DIR="$work" "$work/script"

pkg_config 'echo -L/some/where -L/else'
expect 0 "rustc-link-search=native=/else" env PKG_CONFIG="$work/pkg-config" "$work/script"
pkg_config 'echo "no awd.pc" >&2; exit 1'
expect 1 "set AWD_LIB_DIR to the folder of libawd.so" \
  env PKG_CONFIG="$work/pkg-config" "$work/script"
expect 1 "no awd.pc" env PKG_CONFIG="$work/pkg-config" "$work/script"
expect 1 "set AWD_LIB_DIR" env PKG_CONFIG="$work/missing" "$work/script"
