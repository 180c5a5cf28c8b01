# SPDX-License-Identifier: MIT
# The deepest chain of calls from each public function.
# Calls are those of the compiler's graphs (.ci) and those in the linked code, together: a compiler's graph lacks what it calls late
# (helpers of libgcc); code alone may hide a call through a pointer. Frames are the larger of what the compiler states (.ci or .su;
# it forgets arguments that arrive half in registers) and the sum of all that a function's code pushes, whichever path it takes,
# which is all there is to know about helpers of libgcc.
# usage: awk -v title=TEXT [-v entry=NAME] [-v return_bytes=N] [-v pointer=REGISTER] -f stack.awk HEADER... symbols code GRAPH...
#   HEADER.h       its functions are the entry points; entry: this one alone, and nothing but its figure is printed
#   symbols, code  what objdump -t and objdump -d --no-show-raw-insn print of the image
#   GRAPH          .ci files, or .su files from compilers that draw no graphs
#   return_bytes   what a call itself pushes, for functions of which the compiler states no frame
#   pointer        the stack pointer's name in the code, sp where nothing is said
# Prints a line for each entry point, its chain with bytes per frame (*: not stated by a compiler; gone: released before the last call,
# and not in the sum), and a verdict. Recursion is
# infinite; a call through a pointer and a frame of variable size are unknown; both fail, and so does an image without entry points.

function base(path) { sub(/^.*\//, "", path); return path }

# key NAME FILE: the address of a function, a static one of that file if there is one; "" if it is not in the image.
function key(name, file) {
    if ((file, name) in local_at) return local_at[file, name]
    return name in global_at ? global_at[name] : ""
}

function add_call(from, to) {
    if (from == "" || to == "" || (from, to) in called) return
    called[from, to] = 1
    callee[from, ++callees[from]] = to
}

# add_frame ADDRESS BYTES QUALIFIER: clones of a function may share a name, so the largest counts.
function add_frame(at, bytes, qualifier) {
    if (at == "") return
    if (!(at in frame) || bytes > frame[at]) frame[at] = bytes
    if (qualifier !~ /static|bounded/) unknown[at] = "a frame of variable size"
}

# address_of TITLE: of a function in a graph, "path/file.c:name" or "name".
function address_of(title,  n) {
    n = index(title, ".c:")
    return n ? key(substr(title, n + 3), base(substr(title, 1, n + 1))) : key(title, "")
}

# quoted LINE WORD: what follows WORD: in quotes.
function quoted(line, word) {
    if (!sub(".*" word ": \"", "", line)) return ""
    sub(/".*/, "", line)
    return line
}

BEGIN { if (pointer == "") pointer = "sp" }

FILENAME ~ /\.h$/ {
    line = $0
    while (match(line, /lmb_[a-z0-9_]+\(/)) {
        public[substr(line, RSTART, RLENGTH - 1)] = 1
        line = substr(line, RSTART + RLENGTH)
    }
    next
}

FILENAME ~ /symbols$/ {
    if ($3 == "df") file = base($NF)
    else if ($2 == "l") local_at[file, $NF] = $1
    else if ($2 == "g" || $2 == "w") {
        global_at[$NF] = $1
        if ($NF in public) entry_name[++entries] = $NF
    }
    next
}

# The head of a function in the code, "0000012c <name>:". Assembly may run on from one into the next.
FILENAME ~ /code$/ && /^[0-9a-f]+ <[^>]*>:$/ {
    if (at != "" && mnemonic !~ /^(ret|reti|ret\.n|jr|j|b|b\.n|b\.w|bx|jmp|rjmp|ijmp|pop|pop\.w|ldmia\.w)$/) falls_to[at] = $1
    at = $1
    name_of[at] = substr($2, 2, length($2) - 3)
    at_name[name_of[at], ++of_name[name_of[at]]] = at
    mnemonic = ""
    next
}

FILENAME ~ /code$/ && /^ *[0-9a-f]+:\t/ {
    count = split($0, field, "\t")
    if (field[2] ~ /^(\.|nop|\.\.\.)/) next # literals and padding
    mnemonic = field[2]
    sub(/ +$/, "", mnemonic)
    operands = field[3]
    for (i = 4; i <= count; i++) operands = operands " " field[i]
    pushes()
    calls()
    next
}

# What an instruction of function at takes from the stack.
function pushes(  n, list) {
    if (operands ~ /\{/) {
        list = operands
        gsub(/.*\{|\}.*| /, "", list)
        n = split(list, field, ",")
        if (mnemonic ~ /^push|^stmdb|^stmfd/) pushed[at] += 4 * n
        if (mnemonic == "pop") for (; n > 0; n--) popped[at, field[n]] = 1
    } else if (mnemonic == "push") pushed[at] += 1 # AVR
    else if (mnemonic ~ /^str/ && operands ~ /\[sp, #-[48]\]!/) pushed[at] += 8
    else if (mnemonic == "rcall" && operands ~ /^\.\+0/) pushed[at] += return_bytes # AVR: room, not a call
    else if (mnemonic == "out" && operands ~ /^0x3[de]/) variable[at] = 1 # AVR: another stack pointer
    else if (index(operands, pointer ",") == 1 && mnemonic ~ /^(c\.)?(add|sub)/) {
        n = operands
        sub(/ *[@;].*/, "", n)
        sub(/.*[, #]/, "", n)
        if (n !~ /^-?[0-9]+$/) variable[at] = 1
        else if (mnemonic ~ /sub/) pushed[at] += n
        else if (n + 0 < 0) pushed[at] -= n
    }
}

# Whether an instruction calls through a pointer. One that jumps through a register may be a switch, or a return; where the compiler
# draws a graph that tells them apart. The others (AVR) jump to their switches by a helper.
function through_pointer() {
    if (mnemonic ~ /^e?icall$/ || mnemonic ~ /^e?ijmp$/ && name_of[at] !~ /^__tablejump/) return 1
    if (mnemonic == "bx") return operands !~ /^lr/ && !((at, operands) in popped)
    return mnemonic ~ /^(blx|jalr|c\.jalr|callx0)$/ && operands !~ /</
}

# What an instruction of function at calls: by call or by jump.
function calls(  target, name, call) {
    if (through_pointer()) unknown[at] = "a call through a pointer"
    if (operands !~ /</ || mnemonic !~ /^(b|c|j|r|tail)/) return
    target = operands
    sub(/.*</, "", target)
    sub(/>.*/, "", target)
    name = target
    sub(/[+-]0x[0-9a-f]+$/, "", name)
    if (name != target) { # into the middle: a jump of its own, or of assembly into another
        if (name != name_of[at]) into[at, ++intos[at]] = name
        return
    }
    call = mnemonic ~ /^(bl|jal|jalr|call|rcall|call0)$/
    if (name == name_of[at] && !call) return # a loop
    target = operands
    sub(/ *<.*/, "", target)
    sub(/.*[, ]/, "", target)
    sub(/^0x/, "", target)
    while (length(target) < length(at)) target = "0" target
    add_call(at, target)
    if (call) by_call[at, target] = 1
    else by_jump[at, target] = 1
}

FILENAME ~ /\.su$/ {
    count = split($0, part, "\t")
    line = part[1]
    sub(/.*:/, "", line)
    name = base(FILENAME)
    sub(/su$/, "c", name)
    add_frame(key(line, name), part[2] + 0, part[3])
    next
}

FILENAME ~ /\.ci$/ && /^node:/ {
    line = quoted($0, "label")
    if (match(line, /[0-9]+ bytes \([a-z,]*\)/)) {
        line = substr(line, RSTART, RLENGTH)
        add_frame(address_of(quoted($0, "title")), line + 0, line)
    }
    next
}

FILENAME ~ /\.ci$/ && /^edge:/ {
    line = address_of(quoted($0, "sourcename"))
    name = quoted($0, "targetname")
    if (name != "__indirect_call") add_call(line, address_of(name))
    else if (line != "") unknown[line] = "a call through a pointer"
    next
}

# leaves FROM TO: whether a call is a last one, a jump after which the frame of the caller is gone. Assembly may jump with its frame.
function leaves(from, to) { return (from, to) in by_jump && !((from, to) in by_call) && from in stated }

# depth ADDRESS: bytes of the deepest chain from a function on, or infinite or unknown; next_of[] leads along that chain.
function depth(at,  i, below, best, word, sum) {
    if (at in done) return done[at]
    if (at in active) return "infinite"
    active[at] = 1
    best = frame[at]
    word = at in unknown ? "unknown" : ""
    for (i = 1; i <= callees[at]; i++) {
        below = depth(callee[at, i])
        if (below == "infinite" && word != "infinite" || below == "unknown" && word == "") {
            next_of[at] = callee[at, i]
            word = below
        } else if (word == "") {
            sum = leaves(at, callee[at, i]) ? below : below + frame[at]
            if (sum <= best) continue
            best = sum
            next_of[at] = callee[at, i]
        }
    }
    delete active[at]
    done[at] = word != "" ? word : best
    return done[at]
}

function chain(at,  text, seen) {
    while (1) {
        text = text (text == "" ? "" : " > ") name_of[at] " " frame[at] (at in stated ? "" : "*")
        if (done[at] == "unknown" && at in unknown) return text " (" unknown[at] ")"
        if (at in seen) return text " (again)"
        if (!(at in next_of)) return text
        if (leaves(at, next_of[at])) text = text " (gone)"
        seen[at] = 1
        at = next_of[at]
    }
}

END {
    for (at in name_of) {
        for (i = 1; i <= intos[at]; i++) {
            name = into[at, i]
            for (n = 1; n <= of_name[name]; n++) add_call(at, at_name[name, n])
        }
        if (at in frame) {
            stated[at] = 1
            if (pushed[at] > frame[at]) frame[at] = pushed[at]
            continue
        }
        if (at in falls_to) add_call(at, falls_to[at])
        frame[at] = pushed[at] + return_bytes
        if (at in variable) unknown[at] = "a frame of variable size"
    }
    for (i = 1; i <= entries; i++) {
        name = entry_name[i]
        if (!(global_at[name] in name_of) || entry != "" && name != entry) continue
        figure = depth(global_at[name])
        listed++
        if (figure !~ /^[0-9]+$/) why = why (why == "" ? " " : ", ") name " " figure
        else if (figure > deepest) deepest = figure
        if (entry == "") printf "%8s  %s\n", figure, chain(global_at[name]) | "sort -k1,1rn -k2"
    }
    close("sort -k1,1rn -k2")
    if (entry != "") print listed ? figure : "missing"
    else if (!listed) print "FAIL stack " title ": no entry point in the image: nothing was followed"
    else if (why != "") print "FAIL stack " title ":" why
    else print "pass stack " title ": " deepest " bytes at most from " listed " entry points; no recursion, no call through a pointer"
    exit !listed || why != ""
}
