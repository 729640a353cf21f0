#!/usr/bin/env python3
"""check_types.py SOURCE: mypy accepts the package and its examples, and refuses what is wrong. The module is not needed."""

import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

WRONG = 'import meetc\nmeetc.pairs(1, 2, precision="fp16")\nx: str = meetc.count(3, 4)\n'


def main(source: Path) -> int:
    with tempfile.TemporaryDirectory() as folder:
        environment = dict(os.environ, MYPYPATH=str(source / "runtime/python"))
        wrong = Path(folder, "wrong.py")
        wrong.write_text(WRONG, encoding="ascii")

        def errors(*words: object) -> tuple[int, str]:
            command = ["mypy", "--strict", f"--cache-dir={folder}/cache", *map(str, words)]
            found = subprocess.run(command, capture_output=True, text=True, env=environment, check=False)
            text = found.stdout + found.stderr
            return found.returncode and max(1, len(re.findall(": error: ", text))), text

        right = [("-p", "meetc"), *((file,) for file in sorted(Path(source, "docs/examples/python").glob("*.py")))]
        for words in right:
            count, text = errors(*words)
            if count:
                print(text)
                return 1
        count, text = errors(wrong)
        if count != 6:
            print(f"{count} errors are found where 6 are:\n{text}")
            return 1
    print(f"mypy accepts the package and {len(right) - 1} examples")
    return 0


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1])))
