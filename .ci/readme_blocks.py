# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Print the code of README.md in one language: readme_blocks.py README.md LANGUAGE.

Blocks of one language are joined, in their order. A language that the text does not have is an
error: then a check that relies on it would check nothing.
"""

import pathlib
import re
import sys

path, language = sys.argv[1:]
text = pathlib.Path(path).read_text(encoding="utf-8")
blocks = re.findall(rf"^```{re.escape(language)}\n(.*?)^```$", text, re.MULTILINE | re.DOTALL)
if not blocks:
    sys.exit(f"readme_blocks: {path} has no block of {language}")
print("".join(blocks), end="")
