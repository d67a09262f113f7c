# SPDX-License-Identifier: BSD-3-Clause
import os
import pathlib
import re
import tempfile
import unittest

from site_cases import SOURCE


class DocsTest(unittest.TestCase):
    def run_blocks(self, document):
        """Runs the document's blocks of Python, one after the other, where maps/ is."""
        blocks = re.findall(r"^```python\n(.*?)^```$", document.read_text(), re.MULTILINE | re.DOTALL)
        self.assertTrue(blocks)
        before = os.getcwd()
        self.addCleanup(os.chdir, before)
        with tempfile.TemporaryDirectory() as folder:
            (pathlib.Path(folder) / "maps").symlink_to(SOURCE / "maps")
            os.chdir(folder)
            names = {"__name__": "__main__"}
            for block in blocks:
                exec(compile(block, document.name, "exec"), names)
            os.chdir(before)

    def test_every_block_of_the_page_runs(self):
        self.run_blocks(SOURCE / "docs/python.md")

    def test_every_block_of_the_readme_runs(self):
        self.run_blocks(SOURCE / "README.md")
