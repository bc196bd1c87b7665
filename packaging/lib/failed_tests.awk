# SPDX-License-Identifier: GPL-3.0-or-later
# What packaging/test says at its end about the tests that failed: reads the JUnit file of one ctest run and prints
# each by name, with the end of what it wrote. Variables: `prefix` of each name, `most` tests. ctest indents by tabs and
# escapes every < of a test's output, so a line that looks like a tag is one.

function plain(text) {
    gsub(/&lt;/, "<", text)
    gsub(/&gt;/, ">", text)
    gsub(/&quot;/, "\"", text)
    gsub(/&apos;/, "'", text)
    gsub(/&amp;/, "\\&", text)
    return text
}

function attribute(name,    text) {
    text = $0
    sub(".* " name "=\"", "", text)
    sub(/".*/, "", text)
    return plain(text)
}

function report(    i) {
    print prefix name
    for (i = (lines > longest ? lines - longest : 0); i < lines; i++) {
        print "    " plain(output[i % longest])
    }
    if (lines == 0) {
        print "    no output in " seconds " s"
    }
}

BEGIN { longest = 25 }

/^\t<testcase / {
    name = attribute("name")
    seconds = attribute("time")
    status = attribute("status")
    bad = status != "run" && status != "disabled"
    lines = 0
}

/^\t\t<skipped message="SKIP_/ { bad = 0 }

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

/^\t<\/testcase>/ && bad && shown < most {
    shown++
    report()
}
