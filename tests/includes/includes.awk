# includes.awk: reads `FILE:LINE:#include ...` lines, as grep prints them, and the list of all files before them
# (-v files=LIST), and compares each include with the order of the rooms. It prints a line for each fault; with -v draw=1 it
# prints the picture of the rooms instead. The exit code is 1 if there is a fault.
#
# A room may include itself and the rooms before it. This table has the exceptions.
BEGIN {
  # The generator, in its order. `oracle` is a judge that is independent of the others.
  split("support lang algebra poly ir search bound lower passes target", order_gen, " ")
  for (i = 1; i in order_gen; ++i) {
    rooms["gen/" order_gen[i]] = 1
    for (j = 1; j <= i; ++j)
      may["gen/" order_gen[i], "gen/" order_gen[j]] = 1
  }
  delete may["gen/target", "gen/algebra"] # targets read the results of lowering
  rooms["gen/oracle"] = rooms["gen/verify"] = rooms["gen"] = 1
  may["gen/oracle", "gen/oracle"] = 1
  for (room in rooms) {
    if (room != "gen" && room != "gen/target")
      may["gen/verify", room] = 1
    may["gen", room] = 1 # the driver and main
  }
  # The runtime, in its order; each may include the kernel headers.
  split("kernel core core/device io picture bodies app bench/peers bench/baselines bench/truth bench/harness bench/scenes" \
        " bench/tables main", order_runtime, " ")
  for (i = 1; i in order_runtime; ++i) {
    rooms["runtime/" order_runtime[i]] = 1
    for (j = 1; j <= i; ++j)
      may["runtime/" order_runtime[i], "runtime/" order_runtime[j]] = 1
  }
  # Tests, which have no program, also use the truth of a pair.
  for (j = 2; order_runtime[j] != "bench/baselines"; ++j)
    delete may["runtime/bench/truth", "runtime/" order_runtime[j]]
  # Only the program and its benchmarks know shapes and predicates. Generated code includes the kernel headers and its own.
  rooms["generated"] = 1
  may["generated", "generated"] = may["generated", "runtime/kernel"] = 1
  may["runtime/app", "generated"] = may["runtime/bench/tables", "generated"] = may["runtime/main", "generated"] = 1
  may["runtime/bench/truth", "generated"] = 1

  while ((getline file < files) > 0) {
    exists[file] = 1
    lives[room_of(file)] = 1
    if (file ~ /^runtime\/bench\// && ++held[folder(file)] > 25)
      crowded[folder(file)] = 1
  }
  close(files)
}

function folder(path) {
  sub(/\/?[^\/]*$/, "", path)
  return path
}

# The room of a file, or "".
function room_of(path,    room) {
  if (path == "runtime/main.cpp")
    return "runtime/main"
  if (path ~ /^generated\//)
    return "generated"
  for (room = folder(path); room != ""; room = folder(room))
    if (room in rooms && (room != "gen" || folder(path) == "gen"))
      return room
  return ""
}

# The folder of a generated file's namespace: generated/default/cga.
function namespace_of(path,    part) {
  split(path, part, "/")
  return part[1] "/" part[2] "/" part[3]
}

# The file that an include in `from` names: in the same folder, the tree, runtime/, runtime/kernel/ or a folder of generated/.
function resolve(from, name,    file) {
  if ((folder(from) "/" name) in exists)
    return folder(from) "/" name
  if (name in exists)
    return name
  if (("runtime/" name) in exists)
    return "runtime/" name
  if (("runtime/kernel/" name) in exists)
    return "runtime/kernel/" name
  for (file in exists)
    if (file ~ /^generated\// && substr(file, length(file) - length(name)) == "/" name)
      if (from !~ /^generated\// || namespace_of(from) == namespace_of(file))
        return file
  return ""
}

function fault(text) {
  if (!draw)
    print text
  ++faults
}

{
  match($0, /:[0-9]+:/)
  file = substr($0, 1, RSTART - 1)
  place = substr($0, 1, RSTART + RLENGTH - 2)
  text = substr($0, RSTART + RLENGTH)
  if (!match(text, /["<][^">]+[">]/))
    next
  quoted = substr(text, RSTART, 1) == "\""
  name = substr(text, RSTART + 1, RLENGTH - 2)
  here = room_of(file)
  if (here == "") {
    fault(place ": this file lies in no room of the order")
    next
  }
  target = resolve(file, name)
  if (target == "") {
    # The header of another library. Generated code includes only standard headers, which have no folder.
    if (quoted)
      fault(place ": \"" name "\" is no file of this tree")
    else if (here == "generated" && name ~ /\//)
      fault(place ": generated code includes <meetc/...> and its own files, not <" name ">")
    next
  }
  there = room_of(target)
  ++edges
  if (!((here, there) in may))
    fault(place ": " here " may not include " (there == "" ? "what lies in no room" : there) " (" target ")")
  # The engine of every pair stands apart: sets, queries and their launchers know nothing of it.
  if (target ~ /\/every_pair\// && file !~ /every_pair/ && (here == "runtime/core/device" || here == "runtime/core" || \
      here == "runtime/app" || file ~ /^runtime\/kernel\/meetc\/cuda_/ || file ~ /_cuda[.](hpp|cu)$/))
    fault(place ": only benchmarks and tests include the engine of every pair (" target ")")
  if (here != there)
    arrow[here, there] = 1
  follows[file] = follows[file] " " target
}

# A depth-first search; `path` is the current path.
function visit(file, path,    next_files, count, i) {
  state[file] = 1
  count = split(follows[file], next_files, " ")
  for (i = 1; i <= count; ++i) {
    if (state[next_files[i]] == 1) {
      path = path " -> " file " -> " next_files[i]
      sub(".* -> " next_files[i] " -> ", next_files[i] " -> ", path)
      sub(/^ -> /, "", path)
      fault("a cycle of includes: " path)
    } else if (!state[next_files[i]])
      visit(next_files[i], path " -> " file)
  }
  state[file] = 2
}

# The picture omits an arrow if a longer path implies it.
function reaches(from, to, long,    room) {
  if (!long && ((from, to) in arrow))
    return 1
  for (room in rooms)
    if (((from, room) in arrow) && room != to && room != from && !((room, from) in arrow) && reaches(room, to, 0))
      return 1
  return 0
}

function draw_rooms(part,    room, key) {
  for (room in rooms)
    if ((room in lives) && (room == part || index(room, part "/") == 1))
      print "    \"" room "\"" (room == "gen" ? " [label=\"gen/driver, main\"]" : "") ";" | "LC_ALL=C sort"
  close("LC_ALL=C sort")
}

END {
  for (file in follows)
    if (!state[file])
      visit(file, "")
  for (room in crowded)
    fault(room ": holds " held[room] " files, and a folder of benchmarks holds at most 25")
  if (!edges)
    fault("no include was read")
  if (draw) {
    print "// The rooms and their includes, drawn by tests/includes/includes.sh. An arrow is left out where a longer way says as much."
    print "digraph includes {"
    print "  rankdir=LR; node [shape=box, fontname=\"sans-serif\", fontsize=11]; edge [color=gray40];"
    print "  subgraph cluster_gen {\n    label=\"the compiler\"; fontname=\"sans-serif\";"
    draw_rooms("gen")
    print "  }\n  subgraph cluster_runtime {\n    label=\"the runtime\"; fontname=\"sans-serif\";"
    draw_rooms("runtime")
    print "  }\n  \"generated\";"
    for (key in arrow) {
      split(key, ends, SUBSEP)
      if (!reaches(ends[1], ends[2], 1))
        print "  \"" ends[1] "\" -> \"" ends[2] "\";" | "LC_ALL=C sort"
    }
    close("LC_ALL=C sort")
    print "}"
    exit
  }
  exit faults > 0
}
