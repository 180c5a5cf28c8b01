#!/bin/sh
# SPDX-License-Identifier: MIT
# Draws a diagram of functions from its description, as SVG. usage: flow.sh NAME.flow OUT.svg
#
# Lines of a description, fields parted by bars:
#   title|TEXT
#   band|ROW|ROWS|TEXT              a stage: rows that belong together, counted from 0
#   box|ROW|COLUMN|FUNCTION|TEXT    a function of the sources; columns 0 to 2; a semicolon in the text begins a new line
#   data|ROW|COLUMN|TEXT            what goes in or comes out; no function
#   calls|FUNCTION|FUNCTION         the body of the first names the second: hosttest/test_flow.sh looks
#   feeds|NAME|NAME                 what the first leaves is what the second takes; data are named row.column
set -eu
awk -F'|' '
function escape(s) { gsub(/&/, "\\&amp;", s); gsub(/</, "\\&lt;", s); gsub(/>/, "\\&gt;", s); return s }
function x_of(column) { return 96 + column * 236 }
function y_of(row) { return 52 + row * 104 }
function text(x, y, style, s) { printf "<text x=\"%g\" y=\"%g\" %s>%s</text>\n", x, y, style, escape(s) }
function box(id, row, column, head, body, is_function,   n, part, i, y) {
    at_row[id] = row; at_column[id] = column
    y = y_of(row)
    boxes = boxes sprintf("<rect x=\"%g\" y=\"%g\" width=\"216\" height=\"72\" rx=\"%d\" fill=\"%s\" stroke=\"#444\"/>\n", x_of(column), y, \
        is_function ? 4 : 20, is_function ? "#FFF" : "#EEE")
    n = split(body, part, ";")
    y += is_function ? 20 : 42 - 9 * n
    if (is_function) words[++w] = x_of(column) + 108 SUBSEP y SUBSEP "class=\"name\"" SUBSEP head
    for (i = 1; i <= n; i++) words[++w] = x_of(column) + 108 SUBSEP y + (is_function ? 18 * i : 18 * i - 9) SUBSEP "class=\"note\"" SUBSEP part[i]
}
# From the side of one box to that of another: down, up, or along a row.
function arrow(a, b, kind,   x1, y1, x2, y2) {
    if (!(a in at_row) || !(b in at_row)) { print "flow: no box for " a " or " b | "cat >&2"; bad = 1; return }
    x1 = x_of(at_column[a]) + 108; y1 = y_of(at_row[a]) + 36
    x2 = x_of(at_column[b]) + 108; y2 = y_of(at_row[b]) + 36
    if (at_row[a] == at_row[b]) { x1 += x2 > x1 ? 108 : -108; x2 += x2 > x1 ? -108 : 108 }
    else { y1 += y2 > y1 ? 36 : -36; y2 += y2 > y1 ? -36 : 36; x1 += (x2 - x1) / 8; x2 -= (x2 - x1) / 8 }
    lines = lines sprintf("<line x1=\"%g\" y1=\"%g\" x2=\"%g\" y2=\"%g\" stroke=\"#0072B2\" stroke-width=\"1.6\"%s marker-end=\"url(#tip)\"/>\n", \
        x1, y1, x2, y2, kind == "feeds" ? " stroke-dasharray=\"6,4\"" : "")
}
/^#/ || NF == 0 { next }
{ if (($1 == "box" || $1 == "data" || $1 == "band") && $2 + ($1 == "band" ? $3 : 1) > rows) rows = $2 + ($1 == "band" ? $3 : 1) }
$1 == "title" { title = $2 }
$1 == "band" { band[++bands] = $0 }
$1 == "box" { box($4, $2, $3, $4, $5, 1) }
$1 == "data" { box($2 "." $3, $2, $3, "", $4, 0) }
$1 == "calls" || $1 == "feeds" { from[++arrows] = $2; to[arrows] = $3; kind[arrows] = $1 }
END {
    height = y_of(rows) + 18
    printf "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"816\" height=\"%d\" viewBox=\"0 0 816 %d\">\n", height, height
    print "<style>text{font-family:\"DejaVu Sans\",sans-serif;font-size:12px;text-anchor:middle;fill:#222}.name{font-family:\"DejaVu Sans Mono\",monospace;font-weight:bold}.title{font-size:15px}.band{fill:#555}</style>"
    print "<defs><marker id=\"tip\" viewBox=\"0 0 8 8\" refX=\"7\" refY=\"4\" markerWidth=\"8\" markerHeight=\"8\" orient=\"auto\"><path d=\"M0,0L8,4L0,8z\" fill=\"#0072B2\"/></marker></defs>"
    printf "<rect width=\"816\" height=\"%d\" fill=\"#FFF\"/>\n", height
    text(408, 24, "class=\"title\"", title)
    for (i = 1; i <= bands; i++) {
        split(band[i], b, "|")
        y = y_of(b[2]) - 10; tall = 104 * b[3] - 12
        printf "<rect x=\"8\" y=\"%g\" width=\"800\" height=\"%g\" rx=\"6\" fill=\"%s\"/>\n", y, tall, i % 2 ? "#E8F0F6" : "#F6EFE4"
        n = split(b[4], part, ";")
        for (k = 1; k <= n; k++) text(50, y + tall / 2 + 16 * (k - (n + 1) / 2) + 4, "class=\"band\"", part[k])
    }
    for (i = 1; i <= arrows; i++) arrow(from[i], to[i], kind[i])
    printf "%s%s", boxes, lines
    for (i = 1; i <= w; i++) { split(words[i], p, SUBSEP); text(p[1], p[2], p[3], p[4]) }
    print "</svg>"
    exit bad
}' "$1" >"$2.tmp" && mv "$2.tmp" "$2" && echo "$2"
