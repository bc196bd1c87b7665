# shellcheck shell=bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The beginning of every script in packaging/: strict mode, the top folder, messages. It is sourced, never run.

set -euo pipefail

BORESIGHT_TOP=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
BORESIGHT_COMMAND=packaging/$(basename "$0")
# shellcheck disable=SC2034  # used by the scripts that source this file
readonly BORESIGHT_TOP BORESIGHT_COMMAND

say() {
    printf '%s: %s\n' "$BORESIGHT_COMMAND" "$*" >&2
}

# Ends the script with one line: the reason.
fail() {
    say "$*"
    exit 1
}

# Runs a command with its output kept in FILE, and shows the end of that file only if the command fails.
quietly() {  # FILE COMMAND ARG…
    local log=$1
    shift
    if ! "$@" >"$log" 2>&1; then
        tail -n 40 "$log" >&2
        return 1
    fi
}

# Prints the step, its number, the number of steps and the time so far. A script that does not call begin_steps prints
# its steps without numbers.
steps_done=0 steps_in_all=0

begin_steps() {  # NUMBER
    steps_in_all=$1
}

step() {  # TEXT
    steps_done=$((steps_done + 1))
    say "$(step_number)$(printf '%d:%02d min' $((SECONDS / 60)) $((SECONDS % 60))): $*"
}

step_number() {
    [[ $steps_in_all -eq 0 ]] || printf 'step %d of %d, ' "$steps_done" "$steps_in_all"
}

# The text that ninja writes at the beginning of each line.
ninja_status() {
    printf '%s: %spart %%f of %%t: ' "$BORESIGHT_COMMAND" "$(step_number)"
}
