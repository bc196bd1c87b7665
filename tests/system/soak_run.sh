#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# tests/system/soak_run.sh [HOURS]
#
# Runs the soak for HOURS of mount time (24) with the release build. SOAK.md explains the counts and has the results. The
# log of the station is build/release/soak.log.

set -eu
top=$(cd "$(dirname "$0")/../.." && pwd)
cmake --build "$top/build/release" --target soak_test
log=$top/build/release/soak.log
echo "the log of the station: $log"
BORESIGHT_SOAK_HOURS=${1:-24} "$top/build/release/bin/soak_test" 2>"$log"
