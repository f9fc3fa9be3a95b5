# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The command pellucid-render of a wheel."""

import os
import pathlib
import subprocess
import sys


def main():
    """Run the program of the wheel with the arguments of this one, and end as it does."""
    program = pathlib.Path(__file__).parent / "bin" / "pellucid-render"
    command = [str(program), *sys.argv[1:]]
    if os.name == "posix":
        os.execv(program, command)  # so that signals are the program's own
    sys.exit(subprocess.call(command))
