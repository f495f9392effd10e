# What the checks of stubs have in common.

# hole_code FILE: what stands between the markers, without comments and blank lines.
hole_code() {
  awk '{ sub(/\r$/, "") }
       /--- your code ends here ---/ { inside = 0 }
       inside && !/^ *\/\// && NF
       /--- your code starts here ---/ { inside = 1 }' "$1"
}

# without_holes FILE: everything else, markers included.
without_holes() {
  awk '{ sub(/\r$/, "") }
       /--- your code ends here ---/ { inside = 0 }
       !inside
       /--- your code starts here ---/ { inside = 1 }' "$1"
}

# untouched FILE: the stub is as it was shipped: every hole holds nothing but `unwritten`.
untouched() { ! hole_code "$1" | grep -qv '^ *return .*unwritten(".*").*;$'; }
