# includes.awk: reads `FILE:LINE:#include ...` lines, as grep prints them, and the list of all files before them
# (-v files=LIST), and compares each include with the order of the rooms. It prints a line for each fault; with -v draw=1 it
# prints the picture of the rooms instead. The exit code is 1 if there is a fault.
#
# A room is a folder. It may include itself and the rooms before it. This table has the exceptions.
BEGIN {
  most = 25 # files in a folder
  # The generator, in its order. `oracle` is a judge that is independent of the others.
  split("support lang algebra poly ir search bound lower/expand lower/programs lower/kernel lower/analytic lower/predicate lower passes" \
        " target target/cpp target/gappa target/c target/cuda target/every_pair target/json target/latex target/python" \
        " target/shader target/text" \
        " target/registry", order_gen, " ")
  for (i = 1; i in order_gen; ++i) {
    rooms["gen/" order_gen[i]] = 1
    for (j = 1; j <= i; ++j)
      may["gen/" order_gen[i], "gen/" order_gen[j]] = 1
    if (order_gen[i] ~ /^target/)
      delete may["gen/" order_gen[i], "gen/algebra"] # targets read the results of lowering
  }
  rooms["gen/oracle"] = rooms["gen/verify"] = rooms["gen"] = 1
  may["gen/oracle", "gen/oracle"] = 1
  for (room in rooms) {
    if (room != "gen" && room !~ /^gen\/target/)
      may["gen/verify", room] = 1
    may["gen", room] = 1 # the driver and main
  }
  # The runtime, in its order; each may include the kernel headers.
  split("kernel/meetc/environment kernel/meetc/number kernel/meetc/table kernel/meetc/decide" \
        " kernel/meetc/contact kernel/meetc kernel/meetc/simd kernel/meetc/volume kernel/meetc/cuda kernel/meetc/every_pair" \
        " core/threads core/views core/hierarchy core/sets core/answers core/traversal core/cascade core/query core/world" \
        " core/contacts" \
        " core/device/memory core/device/set core/device/walk core/device/answers core/device/query core/device" \
        " core/device/every_pair io/files io/text io/elements io/polygon io/mesh io front picture report python" \
        " python/device bodies app/input app/text app/query app/output app/inspect app/world app/commands bench/peers" \
        " bench/baselines bench/truth" \
        " bench/harness bench/scenes bench/tables bench/tables/cpu bench/tables/gpu bench/tables/paper bench/tables/trade" \
        " bench/tables/command main", order_runtime, " ")
  for (i = 1; i in order_runtime; ++i) {
    rooms["runtime/" order_runtime[i]] = 1
    for (j = 1; j <= i; ++j)
      may["runtime/" order_runtime[i], "runtime/" order_runtime[j]] = 1
  }
  # Tests, which have no program, also use the truth of a pair.
  for (j = 1; order_runtime[j] != "bench/baselines"; ++j)
    if (order_runtime[j] !~ /^kernel/)
      delete may["runtime/bench/truth", "runtime/" order_runtime[j]]
  # Only the program, the module for Python and the benchmarks know shapes and predicates. Generated code includes the kernel
  # headers and its own.
  rooms["generated"] = 1
  may["generated", "generated"] = 1
  for (room in rooms) {
    if (room ~ /^runtime\/kernel/)
      may["generated", room] = 1
    if (room ~ /^runtime\/(front|app|python|bench\/tables|bench\/truth|main)/)
      may[room, "generated"] = 1
  }

  while ((getline file < files) > 0) {
    exists[file] = 1
    lives[room_of(file)] = 1
    if (file !~ /^generated\//)
      ++held[folder(file)]
  }
  close(files)
}

function folder(path) {
  sub(/\/?[^\/]*$/, "", path)
  return path
}

# The room of a file, or "". Folders of tests are rooms without an order.
function room_of(path,    room) {
  if (path == "runtime/main.cpp")
    return "runtime/main"
  if (path == "runtime/meet.hpp")
    return "runtime/front"
  if (path ~ /^generated\//)
    return "generated"
  room = folder(path)
  return room in rooms || room ~ /^tests(\/|$)/ ? room : ""
}

# The folder of a generated file's namespace: generated/default/cga.
function namespace_of(path,    part) {
  split(path, part, "/")
  return part[1] "/" part[2] "/" part[3]
}

# The file that an include in `from` names: in the same folder, the tree, runtime/ as meet/, runtime/kernel/ or a folder of
# generated/.
function resolve(from, name,    file) {
  if ((folder(from) "/" name) in exists)
    return folder(from) "/" name
  if (name in exists)
    return name
  if (name ~ /^meet\// && ("runtime/" substr(name, 6)) in exists)
    return "runtime/" substr(name, 6)
  if (("runtime/kernel/" name) in exists)
    return "runtime/kernel/" name
  if (name !~ /\//)
    return ""
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
  if (file !~ /[.](cpp|hpp|c|h|cu|cuh)$/)
    next
  if (here == "") {
    fault(place ": this file lies in no room of the order")
    next
  }
  target = resolve(file, name)
  if (target == "") {
    # The header of another library. Generated code includes only standard headers, which have no folder.
    if (quoted && here !~ /^tests/)
      fault(place ": \"" name "\" is no file of this tree")
    else if (here == "generated" && name ~ /\//)
      fault(place ": generated code includes <meetc/...> and its own files, not <" name ">")
    next
  }
  there = room_of(target)
  ++edges
  if (name ~ /^meet\/kernel\//)
    fault(place ": the kernel headers are <meetc/...>, not <" name ">")
  if (here !~ /^tests/ && !((here, there) in may))
    fault(place ": " here " may not include " (there == "" ? "what lies in no room" : there) " (" target ")")
  # The engine of every pair stands apart: sets, queries and their launchers know nothing of it.
  if (target ~ /^runtime\/.*\/every_pair\// && file !~ /every_pair/ && here !~ /^(tests|runtime\/(bench|main))/)
    fault(place ": only benchmarks and tests include the engine of every pair (" target ")")
  follows[file] = follows[file] " " target
  if (here != there && !((here, there) in joins)) {
    joins[here, there] = place
    leads[here] = leads[here] " " there
    if (here !~ /^tests/)
      arrow[here, there] = 1
  }
}

# A depth-first search along `follow`, by files or by folders; `path` is the current path.
function visit(from, follow, what, path,    nexts, count, i) {
  state[from] = 1
  count = split(follow[from], nexts, " ")
  for (i = 1; i <= count; ++i) {
    if (state[nexts[i]] == 1) {
      path = path " -> " from " -> " nexts[i]
      sub(".* -> " nexts[i] " -> ", nexts[i] " -> ", path)
      sub(/^ -> /, "", path)
      fault("a cycle of " what ": " path)
    } else if (!state[nexts[i]])
      visit(nexts[i], follow, what, path " -> " from)
  }
  state[from] = 2
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

function draw_rooms(part,    room, key, label) {
  for (room in rooms)
    if ((room in lives) && (room == part || index(room, part "/") == 1)) {
      label = room == "gen" ? "driver, main" : substr(room, length(part) + 2)
      sub(/kernel\/meetc/, "kernel", label)
      print "    \"" room "\" [label=\"" label "\"];" | "LC_ALL=C sort"
    }
  close("LC_ALL=C sort")
}

END {
  for (file in follows)
    if (!state[file])
      visit(file, follows, "includes", "")
  for (room in leads)
    if (!state[room])
      visit(room, leads, "folders", "")
  for (place in held)
    if (held[place] > most)
      fault(place ": holds " held[place] " files, and a folder holds at most " most)
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
