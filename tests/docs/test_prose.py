#!/usr/bin/env python3
"""prose.py reports each fault that it is there for, and no other line."""

import unittest

from prose import faults


def found(path, text):
    return [fault for _, fault in faults(path, text)]


class Prose(unittest.TestCase):
    def test_of(self):
        for path, line in [("a.hpp", "// Of one warp.\n"), ("a.cpp", '  say("Of them all");\n'), ("a.md", "It is. Of two sets one\n"),
                           ("a.md", "- Of these\n"), ("a.sh", "# Of a file\n"), ("a.v", "(* Of a sum *)\n"), ("a.py", '"""Of it."""\n')]:
            self.assertEqual(found(path, line), ['a sentence begins with "Of"'], line)
        self.assertEqual(found("a.hpp", "// The sum of a row, and one of two. Ofen.\n"), [])
        self.assertEqual(found("a.md", "```\n// Of code\n```\n"), [])

    def test_what(self):
        self.assertEqual(len(found("a.hpp", "// What a query counts.\n")), 1)
        self.assertEqual(len(found("a.md", "It is so. What is left is not.\n")), 1)
        self.assertEqual(found("a.hpp", "// What is the least K?\n"), [])
        self.assertEqual(found("a.md", "## What a scene saves\n"), [])

    def test_lines(self):
        self.assertEqual(found("a.hpp", "// " + "x" * 126 + "\n"), ["a line of 129 characters"])
        self.assertEqual(found("a.md", "é" * 129 + "\n"), ["a line of 129 characters"])
        self.assertEqual(found("a.md", "é" * 128 + "\n| " + "x" * 200 + "\nhttps://" + "x" * 200 + "\n"), [])
        self.assertEqual(found("a.hpp", "int " + "x" * 200 + ";\n"), [])

    def test_files(self):
        self.assertEqual(found("a.cpp", "\n" * 401), ["a file of 401 lines"])
        self.assertEqual(found("a.cpp", "\n" * 400), [])
        self.assertEqual(found("a.md", "\n" * 500), [])


if __name__ == "__main__":
    unittest.main()
