#!/usr/bin/env python3
"""Emitted GLSL gives the bits of the emitted C header, compiled without fused multiply-adds; WGSL gives its numbers where all
arithmetic is exact. Every function for a scene runs, on a software Vulkan.

test_shaders.py LANGUAGE COMPILER MEETC SCENES FOLDER [SCENE ...]: LANGUAGE is glsl or wgsl. The code for each of the scenes in
SCENES, or those that are named, and for a scene of reserved words goes to FOLDER. Exits 77 where a tool is missing."""

import ctypes
import glob
import os
import re
import shutil
import subprocess
import sys

import numpy as np

HERE = os.path.dirname(os.path.abspath(__file__))
ROWS = 2048
NO_CONTRACTION, FADD, FSUB, FMUL, DECORATE, EXT_INST, FMA = 42, 129, 131, 133, 71, 12, 50


def skip(reason):
    print("SKIPPED:", reason)
    sys.exit(77)


def fail(reason):
    print("FAILED:", reason)
    sys.exit(1)


def run(*command):
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
    if done.returncode:
        fail(f"{' '.join(command)}\n{done.stdout[-3000:]}")
    return done.stdout


def generated(meetc, scene, folder):
    """Code of the scene for the backends c and both shaders, with no answers but plain ones in float32."""
    with open(scene, encoding="utf-8") as file:
        text = file.read()
    text = re.sub(r"^(backends|rungs|tolerance) .*\n", "", text, flags=re.M)
    text = text.replace("[scene]\n", "[scene]\nbackends = ['c', 'glsl', 'wgsl']\nrungs = ['fp32']\n", 1)
    base = os.path.dirname(os.path.abspath(scene))
    text = re.sub(r"^algebra( *)= '(.*)'", lambda m: f"algebra = '{os.path.normpath(os.path.join(base, m[2]))}'", text, flags=re.M)
    copy = os.path.join(folder, os.path.basename(scene))
    with open(copy, "w", encoding="utf-8") as file:
        file.write(text)
    run(meetc, "generate", copy, "-o", os.path.join(folder, "out"), "--quiet")


def emit(meetc, scenes, folder, names):
    shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(folder)
    wanted = [os.path.join(scenes, name + ".toml") for name in names] or sorted(glob.glob(os.path.join(scenes, "*.toml")))
    for scene in wanted + [os.path.join(HERE, "words_scene.toml")]:
        generated(meetc, scene, folder)


def parsed(text):
    """The structs and the functions of emitted GLSL."""
    structs = {name: re.findall(r"(\w+) (\w+);", body) for name, body in re.findall(r"struct (\w+) \{(.*?)\};", text, re.S)}
    functions = []
    for result, name, parameters in re.findall(r"^(\w+) (\w+)\(([^)]*)\) \{", text, re.M):
        functions.append((result, name, [p.split()[0] for p in parameters.split(",")]))
    return structs, functions


def only(emitted, name):
    """The structs, and the functions that this one calls: compilers take long for whole scenes."""
    functions = {m[1]: m[0] for m in
                 re.finditer(r"^(?:fn )?(?:\w+ )?(\w+)\([^)]*\)(?: -> \w+)? \{\n.*?^\}\n", emitted, re.M | re.S)}
    wanted, left = set(), [name]
    while left:
        wanted.add(left[-1])
        left += [f for f in re.findall(r"\b(\w+)\(", functions[left.pop()]) if f in functions and f not in wanted]
    structs = re.findall(r"^struct \w+ \{\n.*?^\};?\n", emitted, re.M | re.S)
    return "".join(structs) + "".join(text for f, text in functions.items() if f in wanted)


class Shapes:
    def __init__(self, structs):
        self.structs = structs

    def width(self, kind):
        return sum(self.width(k) for k, _ in self.structs[kind]) if kind in self.structs else 1

    def made(self, kind, at):
        """A value of the kind from in_[at], in_[at + 1], ..."""
        if kind not in self.structs:
            return f"rows_in[start + {at}u]"
        parts = []
        for k, _ in self.structs[kind]:
            parts.append(self.made(k, at))
            at += self.width(k)
        return f"{kind}({', '.join(parts)})"

    def members(self, kind):
        if kind not in self.structs:
            return [""]
        return ["." + m + rest for k, m in self.structs[kind] for rest in self.members(k)]


def shader(language, emitted, shapes, function):
    result, name, kinds = function
    at, arguments = 0, []
    for kind in kinds:
        arguments.append(shapes.made(kind, at))
        at += shapes.width(kind)
    members = shapes.members(result)
    number = "float" if language == "glsl" else "f32"
    store = "".join(f"  rows_out[{len(members)}u * row + {i}u] = {number}(value{m});\n" for i, m in enumerate(members))
    if result == "bool" and language == "wgsl":
        store = "  rows_out[row] = select(0.0, 1.0, value);\n"
    call = f"{name}({', '.join(arguments)})"
    if language == "glsl":
        return ("#version 450\nlayout(local_size_x = 64) in;\nlayout(std430, binding = 0) readonly buffer a { float rows_in[]; };\n"
                f"layout(std430, binding = 1) buffer b {{ float rows_out[]; }};\n{emitted}\nvoid main() {{\n"
                f"  uint row = gl_GlobalInvocationID.x, start = {at}u * row;\n  {result} value = {call};\n{store}}}\n")
    return ("@group(0) @binding(0) var<storage, read> rows_in: array<f32>;\n"
            f"@group(0) @binding(1) var<storage, read_write> rows_out: array<f32>;\n{emitted}\n"
            "@compute @workgroup_size(64) fn main(@builtin(global_invocation_id) id: vec3<u32>) {\n"
            f"  let row = id.x;\n  let start = {at}u * row;\n  let value = {call};\n{store}}}\n")


class Header:
    """The C functions on rows of floats, in float and in double."""

    def __init__(self, compiler, folder, language, space, prefix, shapes, functions):
        text = f'#include "{space}/{space}.h"\n#include <string.h>\n'
        for real, suffix in (("float", "f"), ("double", "")):
            for result, name, kinds in functions:
                plain = result in ("int", "bool")
                if plain and real == "double":
                    continue
                ctype = lambda k: real if k == "float" else prefix + k[len(PREFIX[prefix]):] + suffix
                at, takes, arguments = 0, "", []
                for i, kind in enumerate(kinds):
                    takes += (f"    {ctype(kind)} x{i}; memcpy(&x{i}, in + {at} + n * i_, sizeof x{i});\n")
                    arguments.append(("" if kind == "float" else "&") + f"x{i}")
                    at += shapes.width(kind)
                c_name = prefix + name[len(PREFIX[prefix]):] + ("" if plain else suffix)
                of = "float" if plain else ctype(result)
                text += (f"void run_{name}{suffix}(const {real} *in, int many, {real} *out) {{\n  enum {{ n = {at} }};\n"
                         f"  for (int i_ = 0; i_ < many; ++i_) {{\n{takes}    {of} value = {c_name}({', '.join(arguments)});\n"
                         f"    memcpy(out + (sizeof value / sizeof *out) * i_, &value, sizeof value);\n  }}\n}}\n")
        source, library = (os.path.join(folder, f"{language}_{space}.{end}") for end in ("c", "so"))
        with open(source, "w", encoding="utf-8") as file:
            file.write(text)
        flags = ["-mno-fma"] if os.uname().machine == "x86_64" else []
        run(compiler, "-std=c99", "-O0", "-ffp-contract=off", *flags, "-shared", "-fPIC", "-I", os.path.join(folder, "out"), source,
            "-o", library, "-lm")
        self.library = ctypes.CDLL(library)

    def on(self, name, rows, width, real):
        rows = np.ascontiguousarray(rows, real)
        out = np.empty((len(rows), width), real)
        function = getattr(self.library, f"run_{name}{'f' if real == np.float32 else ''}")
        function(rows.ctypes.data_as(ctypes.c_void_p), ctypes.c_int(len(rows)), out.ctypes.data_as(ctypes.c_void_p))
        return out


# The beginning of C's names, and that of GLSL's: a namespace `gl` is `m_gl` there.
PREFIX = {}


def check_not_contracted(path, name):
    """Every sum and product is decorated, and nothing is fused."""
    words = np.fromfile(path, np.uint32)
    arithmetic, decorated, at = set(), set(), 5
    while at < len(words):
        length, op = int(words[at]) >> 16, int(words[at]) & 0xFFFF
        if op in (FADD, FSUB, FMUL):
            arithmetic.add(int(words[at + 2]))
        if op == DECORATE and words[at + 2] == NO_CONTRACTION:
            decorated.add(int(words[at + 1]))
        if op == EXT_INST and words[at + 4] == FMA:
            fail(f"{name} has a fused multiply-add")
        at += length
    if arithmetic - decorated:
        fail(f"{name}: {len(arithmetic - decorated)} of {len(arithmetic)} sums and products are not precise")
    return len(arithmetic)


def spirv(language, folder, jobs):
    """Compiles (text, source, target) of each job, or says which tool is missing."""
    if language == "glsl":
        for _, source, target in jobs:
            run("glslangValidator", "-V", "--target-env", "vulkan1.1", source, "-o", target)
        return
    listing = os.path.join(folder, "naga.txt")
    with open(listing, "w", encoding="utf-8") as file:
        file.writelines(f"{source} {target}\n" for _, source, target in jobs)
    run("node", os.path.join(folder, "naga", "naga.mjs"), listing)


def have_tools(language, compiler, folder):
    runner = os.path.join(folder, language + "_rows")
    built = subprocess.run([compiler, "-std=c99", "-O1", os.path.join(HERE, "run_rows.c"), "-o", runner, "-lvulkan"],
                           capture_output=True, text=True, check=False)
    if built.returncode:
        skip("no Vulkan loader to link with (Debian: apt install libvulkan-dev mesa-vulkan-drivers)")
    if language == "glsl":
        if not shutil.which("glslangValidator"):
            skip("no glslangValidator (Debian: apt install glslang-tools)")
    else:
        if not shutil.which("npm") or not shutil.which("node"):
            skip("no npm, which brings naga, the validator of WGSL (Debian: apt install npm)")
        naga = os.path.join(folder, "naga")
        os.makedirs(naga, exist_ok=True)
        for name in ("naga.mjs", "package.json", "package-lock.json"):
            shutil.copy(os.path.join(HERE, name), naga)
        got = subprocess.run(["npm", "ci", "--silent", "--no-audit", "--no-fund", "--prefix", naga], capture_output=True, text=True,
                             timeout=120, check=False)
        if got.returncode:
            skip("npm does not reach a registry that has naga-wasm, the validator of WGSL")
    return runner


def rows_of(random, language, width):
    small = random.integers(-2, 3, (ROWS, width)).astype(np.float32)
    if language == "wgsl":
        return small
    any_ = random.normal(size=(ROWS, width)) * 2.0 ** random.integers(-3, 4, (ROWS, 1))
    return np.where(np.arange(ROWS)[:, None] % 2, small, any_).astype(np.float32)


def compare(language, compiler, folder):
    runner = have_tools(language, compiler, folder)
    random = np.random.default_rng(1)
    jobs, cases = [], []
    for base in sorted(glob.glob(os.path.join(folder, "out", "*", "*.glsl"))):
        base = base.removesuffix(".glsl")
        space = os.path.basename(base)
        with open(base + ".glsl", encoding="utf-8") as file:
            structs, functions = parsed(file.read())
        with open(f"{base}.{language}", encoding="utf-8") as file:
            emitted = file.read()
        c_prefix, prefix = space + "_", functions[0][1].removesuffix("sign_of")
        PREFIX[c_prefix] = prefix
        shapes = Shapes(structs)
        functions = [f for f in functions if not f[1].endswith("_sign_of")]
        header = Header(compiler, folder, language, space, c_prefix, shapes, functions)
        source = os.path.join(folder, f"{language}_{space}" + (".comp" if language == "glsl" else ".wgsl"))
        with open(source, "w", encoding="utf-8") as file:
            file.write(shader(language, emitted, shapes, functions[0]))
        jobs.append((space, source, os.path.join(folder, f"{language}_{space}.spv")))
        for function in functions:
            stem = os.path.join(folder, f"{language}_{function[1]}")
            source = stem + (".comp" if language == "glsl" else ".wgsl")
            with open(source, "w", encoding="utf-8") as file:
                file.write(shader(language, only(emitted, function[1]), shapes, function))
            jobs.append((function[1], source, stem + ".spv"))
            rows = rows_of(random, language, sum(shapes.width(k) for k in function[2]))
            rows.tofile(stem + ".in")
            cases.append((function, header, rows, shapes.width(function[0]), stem))
    spirv(language, folder, jobs)
    arithmetic = 0
    if language == "glsl":
        arithmetic = sum(check_not_contracted(target, name) for name, _, target in jobs)
    listing = os.path.join(folder, language + "_rows.txt")
    with open(listing, "w", encoding="utf-8") as file:
        for _, _, rows, width, stem in cases:
            file.write(f"{stem}.spv {stem}.in {stem}.out {4 * width * len(rows)} {len(rows) // 64}\n")
    done = subprocess.run([runner, listing], capture_output=True, text=True, check=False)
    if done.returncode == 77:
        skip("no Vulkan device, also no software one (Debian: apt install mesa-vulkan-drivers)")
    if done.returncode:
        fail(done.stderr[-3000:])
    compared = 0
    for (result, name, _), header, rows, width, stem in cases:
        mine = np.fromfile(stem + ".out", np.float32).reshape(len(rows), width)
        theirs = header.on(name, rows, width, np.float32)
        if not np.any(theirs) and "norm2_meet_line_line" not in name:  # which is 0 on purpose
            fail(f"{name}: all values are 0")
        keep = np.ones(len(rows), bool)
        if language == "wgsl" and result not in ("int", "bool"):
            keep = np.all(theirs == header.on(name, rows, width, np.float64), axis=1)
        if language == "wgsl" and name.startswith("m_gl_"):  # its thirds and sevenths are exact in no row
            keep[:] = True
        if np.sum(keep) < 100:
            fail(f"{name}: only {np.sum(keep)} of {len(rows)} rows are exact in float32")
        same = (mine.view(np.uint32) == theirs.view(np.uint32)) if language == "glsl" else mine == theirs
        if language == "wgsl" and name.startswith("m_gl_"):
            # Numbers of at most 2 in products of at most three: sums of at most 64 terms of at most 8, each value within 16
            # roundings; a quotient of WGSL errs by 2.5 units in the last place.
            same = np.abs(mine - theirs) <= 64 * 8 * 16 * 2.0**-24
        if not np.all(same[keep]):
            row = np.argwhere(keep & ~np.all(same, axis=1))[0, 0]
            fail(f"{name}: {np.sum(keep & ~np.all(same, axis=1))} rows differ; row {row}: {rows[row]} gives {mine[row]}, in C "
                 f"{theirs[row]}")
        compared += int(np.sum(keep))
    print(f"{done.stdout.strip()}: {len(cases)} functions of {len(PREFIX)} scenes, {compared} rows as in C; {arithmetic} precise "
          "operations")


if __name__ == "__main__":
    emit(sys.argv[3], sys.argv[4], sys.argv[5], sys.argv[6:])
    compare(sys.argv[1], sys.argv[2], sys.argv[5])
