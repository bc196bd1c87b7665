# SPDX-License-Identifier: GPL-3.0-or-later
# What packaging/test says about one run of ctest. Reads ctest's JUnit file, and for each of its tests that is a
# GoogleTest program the file FOLDER/<test>.xml the program wrote. The first line is "PASSED FAILED SKIPPED", counted by
# case; then each failed case by name, with the end of what it said. A program that died has no file, and one that
# ended badly for all its cases are well (a leak) counts one failure more: of those the end of the output is shown. So
# does a program that could test nothing at all (status 77): packaging/test has installed every tool that it needs.
# Variables: `folder`, `prefix` of each name, `most` failures are told. ctest indents by tabs and escapes every < of a
# test's output, so a line that looks like a tag is one.

function plain(text) {
    gsub(/&lt;/, "<", text)
    gsub(/&gt;/, ">", text)
    gsub(/&quot;/, "\"", text)
    gsub(/&apos;/, "'", text)
    gsub(/&#x0A;|&#xA;/, " ", text)
    gsub(/&amp;/, "\\&", text)
    return text
}

function attribute(line, name) {
    if (!sub(".* " name "=\"", "", line)) {
        return ""
    }
    sub(/".*/, "", line)
    return plain(line)
}

function tell(line) {
    if (told <= most) {
        report = report "    " line "\n"
    }
}

function fail(name) {
    failed++
    if (++told <= most) {
        report = report prefix name "\n"
    }
}

# Returns how many cases of it failed; -1 if there is no whole file.
function count_cases(file,    line, bad, whole, said) {
    cases = left = bad = whole = 0
    while ((getline line < file) > 0) {
        if (line ~ /^ *<testcase /) {
            cases++
            name = attribute(line, "classname") "." attribute(line, "name")
            is_bad = 0
            left += line ~ / result="(skipped|suppressed)"/
        } else if (line ~ /^ *<failure /) {
            if (!is_bad) {
                is_bad = 1
                bad++
                fail(name)
            }
            said = longest
            sub(/.*<!\[CDATA\[/, "", line)
        }
        if (said > 0 && is_bad) {
            said = line ~ /\]\]><\/failure>/ ? 0 : said - 1
            sub(/\]\]><\/failure>/, "", line)
            tell(line)
        }
        whole = whole || line ~ /^<\/testsuites>/
    }
    close(file)
    return whole ? bad : -1
}

function end_of_test(    bad, i) {
    bad = folder == "" ? -1 : count_cases(folder "/" test ".xml")
    if (bad >= 0) {
        passed += cases - left - bad
        skipped += left
    } else if (status == "run") {
        passed++
    } else if (status == "disabled") {
        skipped++
    }
    if (status != "run" && status != "disabled" && bad <= 0) {
        fail(test)
        for (i = (lines > longest ? lines - longest : 0); i < lines; i++) {
            tell(plain(output[i % longest]))
        }
        if (lines == 0) {
            tell("no output in " seconds " s")
        }
    }
}

BEGIN { longest = 25 }

/^\t<testcase / {
    test = attribute($0, "name")
    seconds = attribute($0, "time")
    status = attribute($0, "status")
    lines = 0
}

/^\t\t<system-out>/ {
    writes = 1
    sub(/^\t\t<system-out>/, "")
}

writes {
    if (sub(/<\/system-out>$/, "")) {
        writes = 0
    }
    if (writes || $0 != "") {
        output[lines++ % longest] = $0
    }
}

/^\t<\/testcase>/ { end_of_test() }

END {
    printf "%d %d %d\n%s", passed, failed, skipped, report
}
