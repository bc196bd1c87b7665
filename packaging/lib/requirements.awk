# SPDX-License-Identifier: GPL-3.0-or-later
# Reads the sources below tests, then the pages (*.md). A requirement stands above the test that shows it:
#
#   // REQ-CAN-05: Both axes' frames leave in one write.     above the test, once for each id; it may go on in more lines
#   // REQ-CAN-05                                            above each further test that shows it
#   // REQ-CAN-05 (FdcanusbProbeTest.*): …                   anywhere: a whole suite, a test of ctest, a file below tests
#
# Prints one line for each requirement, "ROOM NUMBER LETTER ID TEXT TESTS" with tabs between, and one for each mistake,
# which begins with "!".
# -v top=FOLDER is where the files of a benchmark are looked for.

function mistake(what) { print "!" FILENAME ":" FNR ": " what }

# Whether a test has this name, in which * stands for anything.
function is_shown(name,    pattern, test) {
    if (name in tests) return 1
    pattern = name
    gsub(/\./, "\\.", pattern)
    gsub(/\*/, ".*", pattern)
    for (test in tests) if (test ~ ("^" pattern "$")) return 1
    for (test in families) if (index(name, test) == 1) return 1
    return 0
}

function is_file(name,    path, line, status) {
    path = top "/" name
    status = (getline line < path)
    close(path)
    return status > 0
}

# A test, or a file below tests with arguments behind its name.
function exists(name,    words) {
    if (name ~ /^tests\//) {
        split(name, words, " ")
        return is_file(words[1])
    }
    return is_shown(name)
}

function show(id, name) {
    shown[id] = shown[id] (shown[id] == "" ? "" : ", ") "`" name "`"
}

# "REQ-CAN-05 (Suite.*): text", its three parts in id, named and text.
function read_requirement(line) {
    match(line, /^REQ-[A-Z][A-Z0-9]*-[0-9]+[a-z]?/)
    id = substr(line, 1, RLENGTH)
    line = substr(line, RLENGTH + 1)
    named = ""
    if (match(line, /^ \([^)]*\)/)) {
        named = substr(line, 3, RLENGTH - 3)
        line = substr(line, RLENGTH + 1)
    }
    text = line
    sub(/^: */, "", text)
    if (line != "" && (line !~ /^: / || text == "")) mistake("after " id " comes \": \" and its text, or nothing")
}

function add_requirement(line,    i, names, count) {
    read_requirement(line)
    if (!(id in where)) where[id] = FILENAME ":" FNR
    if (text != "") {
        if (id in texts) mistake(id " has a text already, at " where[id])
        texts[id] = text
        where[id] = FILENAME ":" FNR
    }
    growing = text != "" ? id : ""
    count = split(named, names, /, */)
    for (i = 1; i <= count; ++i) {
        show(id, names[i])
        to_check[++checks] = names[i] "\t" FILENAME ":" FNR ": " id
    }
    if (count == 0) waiting[++waits] = id
}

# What looks like the name of a test in a page: Suite.Test, Suite.*, and with "…" for what is left out. A name that
# begins with it is of the suite named last.
function check_name(name,    parts, suite, rest) {
    gsub(/…/, "*", name)
    if (name !~ /^[A-Za-z0-9_.*]+$/ || name ~ /^\*+$/) return
    if (name ~ /^\*\.?[A-Z]/) {
        sub(/^\*\.?/, "", name)
        name = last_suite "." name
    }
    split(name, parts, ".")
    suite = parts[1]
    rest = substr(name, length(suite) + 2)
    if (rest == "") {
        if (name ~ /^[A-Z].*\*$/ && !is_shown("*." name)) mistake("no test is called " name)
        return
    }
    if (suite in suites) last_suite = suite
    else if (suite !~ /^[A-Z]/ || (rest != "*" && rest !~ /^[A-Z].*[a-z]/)) return
    if (!is_shown(name)) mistake("there is no test " name)
}

FNR == 1 {
    is_page = FILENAME ~ /\.md$/
    is_fenced = 0
    last_suite = ""
    waits = 0
    growing = ""
}

is_page && /^ *```/ { is_fenced = !is_fenced }

is_page {
    rest_of_line = $0
    while (match(rest_of_line, /REQ-[A-Z][A-Z0-9]*-[0-9]+[a-z]?/)) {
        id = substr(rest_of_line, RSTART, RLENGTH)
        if (!(id in texts)) mistake("there is no requirement " id)
        rest_of_line = substr(rest_of_line, RSTART + RLENGTH)
    }
    count = is_fenced ? 0 : split($0, spans, "`")
    for (i = 2; i <= count; i += 2) check_name(spans[i])
    next
}

/^(\/\/|#) REQ-[A-Z][A-Z0-9]*-[0-9]/ {
    line = $0
    sub(/^(\/\/|#) /, "", line)
    add_requirement(line)
    next
}

/^(\/\/|#) / && growing != "" {
    line = $0
    sub(/^(\/\/|#) +/, "", line)
    texts[growing] = texts[growing] " " line
    next
}

/^(TEST|TEST_F|TEST_P|TYPED_TEST|TYPED_TEST_P)\(/ {
    split($0, parts, /[(,) ]+/)
    name = parts[2] "." parts[3]
    tests[name] = 1
    suites[parts[2]] = 1
    for (i = 1; i <= waits; ++i) show(waiting[i], name)
    waits = 0
}

match($0, /add_test\(NAME [^ )]+/) {
    name = substr($0, RSTART + 14, RLENGTH - 14)
    tests[name] = 1
    if (match(name, /\$/) && RSTART > 1) families[substr(name, 1, RSTART - 1)] = 1
    split(name, parts, ".")
    suites[parts[1]] = 1
}

{
    for (i = 1; i <= waits; ++i) mistake(waiting[i] " stands above no test")
    waits = 0
    growing = ""
}

END {
    for (i = 1; i <= checks; ++i) {
        split(to_check[i], parts, "\t")
        if (!exists(parts[1])) print "!" parts[2] " names " parts[1] ", which is no test"
    }
    for (id in where) {
        if (!(id in texts)) print "!" where[id] ": " id " has no text"
        if (!(id in shown)) print "!" where[id] ": " id " has no test"
        split(id, parts, "-")
        number = parts[3]
        letter = number
        sub(/[a-z]$/, "", number)
        sub(/^[0-9]+/, "", letter)
        printf "%s\t%05d\t%s.\t%s\t%s\t%s\n", parts[2], number, letter, id, texts[id], shown[id]
    }
}
