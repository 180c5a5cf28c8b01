# SPDX-License-Identifier: MIT
# A page with what stands between the marks of a name, marks included, replaced by a file.
# usage: awk -v name=NAME -v block=FILE -f hosttest/block.awk PAGE
index($0, "<!-- " name ": begin") { while ((getline line <block) > 0) print line; skip = 1; next }
!skip
index($0, "<!-- " name ": end") { skip = 0 }
