#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Runs a program that must succeed and say nothing: neither it nor the library may print.
output=$("$@" 2>&1) || { echo "exit code $?: $output"; exit 1; }
[[ -z $output ]] || { echo "it is not silent: $output"; exit 1; }
