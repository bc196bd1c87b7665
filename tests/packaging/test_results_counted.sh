#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_results_counted.sh TEST_RESULTS_AWK
#
# Runs packaging/lib/test_results.awk on the files that ctest and GoogleTest write, for each kind of result.
#
# REQ-PACKAGING-500 (Packaging.resultsAreCounted): packaging/test counts each case once. A program that died, and a
# program that could test nothing at all, are failures.

set -euo pipefail

awk_file=$1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
failed=0

begin() {
    rm -f "$folder"/*
    printf '%s\n' '<?xml version="1.0" encoding="UTF-8"?>' '<testsuite name="(empty)">' >"$folder/ctest.junit"
}

# As ctest indents it.
test_of_ctest() {  # NAME STATUS INNER OUTPUT
    printf '\t<testcase name="%s" classname="%s" time="0.5" status="%s">\n' "$1" "$1" "$2" >>"$folder/ctest.junit"
    [[ -z $3 ]] || printf '\t\t%s\n' "$3" >>"$folder/ctest.junit"
    printf '\t\t<properties/>\n\t\t<system-out>%s</system-out>\n\t</testcase>\n' "$4" >>"$folder/ctest.junit"
}

cases_of() {  # PROGRAM CASE…
    printf '%s\n' '<?xml version="1.0" encoding="UTF-8"?>' '<testsuites name="AllTests">' '  <testsuite name="Door">' \
        "${@:2}" '  </testsuite>' '</testsuites>' >"$folder/$1.xml"
}

expect() {  # WHAT COUNTS REPORT_LINE…
    local result
    printf '</testsuite>\n' >>"$folder/ctest.junit"
    result=$(awk -v folder="$folder" -v prefix='failed: ' -v most=10 -f "$awk_file" "$folder/ctest.junit")
    if [[ $result != "$(printf '%s\n' "${@:2}")" ]]; then
        printf '%s:\n%s\ninstead of:\n%s\n' "$1" "$result" "$(printf '%s\n' "${@:2}")"
        failed=1
    fi
}

good='    <testcase name="Opens" file="d.cpp" line="1" status="run" result="completed" time="0." classname="Door" />'
left='    <testcase name="Sings" status="run" result="skipped" time="0." classname="Door">'
off='    <testcase name="DISABLED_Falls" status="notrun" result="suppressed" time="0." classname="Door" />'

begin
test_of_ctest door_test run '' 'fine'
cases_of door_test "$good" "$left" '      <skipped message="no song"/>' '    </testcase>' "$off"
expect "passed, skipped and disabled cases" '1 0 2'

begin
test_of_ctest door_test fail '<failure message=""/>' 'said much'
cases_of door_test "$good" '    <testcase name="Closes" status="run" result="completed" time="0." classname="Door">' \
    '      <failure message="x" type=""><![CDATA[d.cpp:7' 'it stays open]]></failure>' '    </testcase>'
expect "a case that failed" '1 1 0' 'failed: Door.Closes' '    d.cpp:7' '    it stays open'

begin
test_of_ctest door_test fail '<failure message="SEGFAULT"/>' 'the &lt;last&gt; word'
expect "a program that died" '0 1 0' 'failed: door_test' '    the <last> word'

begin
test_of_ctest door_test fail '<failure message=""/>' 'leaked'
cases_of door_test "$good"
expect "a program that ended badly after its cases" '1 1 0' 'failed: door_test' '    leaked'

begin
test_of_ctest door_test disabled '<skipped message="Disabled"/>' ''
test_of_ctest script run '' 'fine'
expect "a disabled test, and one that is a script" '1 0 1'

begin
test_of_ctest door_test notrun '<skipped message="SKIP_RETURN_CODE=77"/>' 'no key here'
expect "a program that could test nothing" '0 1 0' 'failed: door_test' '    no key here'

exit "$failed"
