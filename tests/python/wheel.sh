#!/usr/bin/env bash
# wheel.sh PYTHON SOURCE BUILD: makes a wheel of the package that was compiled in BUILD, installs it in a fresh environment,
# and uses it there. It leaves nothing in the source tree.
set -euo pipefail
python=$1 source=$2 build=$3
room=$(mktemp -d)
trap 'rm -rf "$room"' EXIT
before=$(git -C "$source" status --porcelain --ignored 2>/dev/null || true)
"$python" -m build --wheel --no-isolation -C "build-dir=$build" -o "$room" "$source" >"$room/log" 2>&1 || {
  cat "$room/log"
  exit 1
}
after=$(git -C "$source" status --porcelain --ignored 2>/dev/null || true)
[ "$before" = "$after" ] || {
  echo "building the wheel has changed the source tree: $after"
  exit 1
}
"$python" -m venv --system-site-packages "$room/venv"
"$room/venv/bin/pip" install --quiet --no-index --no-deps "$room"/meetc-*.whl
cd "$room"
unset PYTHONPATH
"$room/venv/bin/python" "$source/docs/examples/python/touching.py" >"$room/found"
"$room/venv/bin/python" -c "
import importlib.metadata, meetc, os
assert meetc.__file__.startswith('$room/venv'), meetc.__file__
assert importlib.metadata.version('meetc') == meetc.__version__
names = set(os.listdir(os.path.dirname(meetc.__file__)))
assert {'py.typed', '_native.pyi', '__init__.py', 'trimesh.py'} <= names, names
print(open('$room/found').readline().strip())
" | grep -Fx '[[0, 0], [1, 0]]'
