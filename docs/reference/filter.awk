# A header as doxygen reads it: lines `/// Example: EXPRESSION`, which the tests compile and run, become blocks of
# code, remarks behind members, `double x;  // in radians`, become their documentation, and all belongs to its room.

function end_example() {
    if (inside) print indent "/// @endcode"
    inside = 0
}

/^namespace algae {$/ {
    room = FILENAME
    sub(/^.*src\//, "", room)
    sub(/\/.*/, "", room)
    print "namespace algae { /** @addtogroup " room " */ /** @{ */"
    next
}
/^}  \/\/ namespace algae$/ { print "/** @} */ }"; next }

match($0, /^ *\/\/\/ Example: /) {
    if (!inside) {
        indent = $0
        sub(/\/.*/, "", indent)
        print indent "///\n" indent "/// @par Example\n" indent "/// @code{.cpp}"
        inside = 1
    }
    print indent "/// " substr($0, RLENGTH + 1)
    next
}
inside && match($0, /^ *\/\/\/     /) {
    print indent "/// " substr($0, RLENGTH - 3)
    next
}
{ end_example() }
# A remark: its sign, if it begins with one, as code; # is no link.
function remark(text) {
    if (match(text, /^[]!#$%&'*+,.\/:;<>?@\\^|{}~[-]+( |$)/)) {
        sign = substr(text, 1, RLENGTH)
        sub(/ $/, "", sign)
        text = "`" sign "`" substr(text, length(sign) + 1)
    }
    gsub(/#[a-z]/, "\\\\&", text)
    return "///< " text
}
match($0, /[;,{}] +\/\/ /) && !/^ *\/\// && !/"[^"]*\/\/ / {
    column = RSTART + RLENGTH - 3
    print substr($0, 1, column - 1) remark(substr($0, column + 3))
    next
}
column && match($0, /^ +\/\/ /) && RLENGTH - 2 == column {  # it goes on
    print substr($0, 1, column - 1) remark(substr($0, column + 3))
    next
}
{ column = 0; print }
