#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# requirements_mistakes.sh TOP
#
# Runs packaging/requirements --check on a small tree, first without an error, then with one error of each kind.

# shellcheck disable=SC2016  # the backticks are those of the pages
set -euo pipefail

top=$1
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT
failed=0

new_tree() {
    rm -rf "${tree:?}"/*
    mkdir -p "$tree"/{app,core/room,ui,tests,packaging/lib}
    cp "$top/packaging/requirements" "$tree/packaging"
    cp "$top/packaging/lib/common.sh" "$top/packaging/lib/requirements.awk" "$tree/packaging/lib"
    : >"$tree/core/room/room.cpp"
    printf '# top\n' >"$tree/README.md"
    printf '# room\n\nREQ-ROOM-01, `Door.Opens`, `Door.*`, `Door.Clo…`, `….Opens`\n' >"$tree/core/room/README.md"
    cat >"$tree/tests/door_test.cpp" <<'END'
// REQ-ROOM-01: The door opens.
// It also closes.
TEST(Door, Opens)
{
}

// REQ-ROOM-01
// REQ-ROOM-02 (Door.*): The door has a lock.
TEST_F(Door, Closes)
{
}
END
    "$tree/packaging/requirements"
}

# Adds a line to the end of FILE. The check must report it with these words.
expect() {  # WORDS FILE LINE…
    local words=$1 file=$2
    shift 2
    new_tree
    printf '%s\n' "$@" >>"$tree/$file"
    if "$tree/packaging/requirements" --check >"$tree/said" 2>&1; then
        echo "not found: $words"
        failed=1
    elif ! grep -qF -- "$words" "$tree/said"; then
        echo "instead of: $words"
        cat "$tree/said"
        failed=1
    fi
}

new_tree
"$tree/packaging/requirements" --check
grep -qF "| REQ-ROOM-01 | The door opens. It also closes. | \`Door.Opens\`, \`Door.Closes\` |" "$tree/tests/REQUIREMENTS.md"

code=tests/door_test.cpp page=core/room/README.md
expect "REQUIREMENTS.md is not current" tests/REQUIREMENTS.md 'by hand'
expect "REQ-ROOM-01 has a text already" $code '// REQ-ROOM-01: Twice.' 'TEST(Door, Falls)'
expect "REQ-ROOM-03 has no text" $code '// REQ-ROOM-03' 'TEST(Door, Falls)'
expect "REQ-ROOM-03 stands above no test" $code '// REQ-ROOM-03: It squeaks.' 'int main();'
expect "REQ-ROOM-03 has no test" $code '// REQ-ROOM-03: It squeaks.' 'int main();'
expect "REQ-ROOM-03 names Gate.Opens, which is no test" $code '// REQ-ROOM-03 (Gate.Opens): It squeaks.'
expect "REQ-ROOM-03 names tests/bench/none.cpp, which is no test" $code '// REQ-ROOM-03 (tests/bench/none.cpp): It squeaks.'
expect "there is no test Door.Sings" $page '`Door.Sings`'
expect "there is no test Gate.Opens" $page '`Gate.Opens`'
expect "there is no test Gate.*" $page '`Gate.*`'
expect "there is no test Door.Si*" $page '`Door.Opens`, `….Si…`'
expect "no test is called Sing*" $page '`Sing…`'
expect "there is no requirement REQ-ROOM-09" $page 'REQ-ROOM-09'
new_tree
rm "$tree/$page"
"$tree/packaging/requirements" --check >"$tree/said" 2>&1 || true
grep -qF 'core/room has no README.md' "$tree/said" || {
    echo "not found: a room without a page"
    failed=1
}
mapfile -t lines < <(seq 130)
expect "core/room/README.md has more than 120 lines" $page "${lines[@]}"
exit "$failed"
