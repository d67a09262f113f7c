#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# check_scripts.sh SCRIPT…: whether bash can read them, and shellcheck has nothing to say.
set -euo pipefail
for script in "$@"; do bash -n "$script"; done
command -v shellcheck >/dev/null || { echo "skipped: there is no shellcheck"; exit 77; }
shellcheck "$@"
