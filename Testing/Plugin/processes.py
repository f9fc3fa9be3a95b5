# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""ParaView's programs, each in a process of its own."""

import contextlib
import os
import pathlib
import re
import signal
import subprocess
import tempfile
import time

HERE = pathlib.Path(__file__).parent
PLUGIN = pathlib.Path(os.environ["PELLUCID_PLUGIN"])

# What VTK's logger, Mesa and Python begin a complaint with.
COMPLAINT = re.compile(r"ERR\||WARN\||FATL\||ERROR|Mesa: |Warning:|Traceback")


def program(name):
    """The path of a program of ParaView."""
    return pathlib.Path(os.environ["PELLUCID_PARAVIEW_BIN"]) / name


@contextlib.contextmanager
def started(*command, environment=None, folder=None):
    """Start a program; yields the process and the file that it prints to.

    Neither the process nor one of its children survives.
    """
    with tempfile.TemporaryFile("w+") as output:
        process = subprocess.Popen(
            [str(part) for part in command],
            stdin=subprocess.DEVNULL,
            stdout=output,
            stderr=subprocess.STDOUT,
            env={**os.environ, **(environment or {})},
            cwd=folder,
            start_new_session=True,
        )
        try:
            yield process, output
        finally:
            with contextlib.suppress(ProcessLookupError):
                os.killpg(process.pid, signal.SIGKILL)
            process.wait()


def printed(output):
    output.seek(0)
    return output.read()


def run(*command, environment=None, folder=None, timeout=120):
    """What a program prints; it has to succeed without a complaint."""
    with started(*command, environment=environment, folder=folder) as (process, output):
        try:
            process.wait(timeout)
        except subprocess.TimeoutExpired:
            raise AssertionError(f"{command[0]} does not end:\n{printed(output)}") from None
        text = printed(output)
    assert process.returncode == 0 and not COMPLAINT.search(text), f"{process.returncode}\n{text}"
    return text


@contextlib.contextmanager
def server(timeout=60):
    """Start a pvserver; yields the port that it listens at, one that was free."""
    with started(program("pvserver"), "--server-port=0") as (process, output):
        deadline = time.monotonic() + timeout
        # Not found out by connecting to it: a server takes only one client.
        while not (listens := re.search(r"^Accepting connection.*:(\d+)$", printed(output), re.M)):
            if process.poll() is not None or time.monotonic() > deadline:
                raise AssertionError(f"pvserver does not listen:\n{printed(output)}")
            time.sleep(0.1)
        yield int(listens[1])
        process.wait(timeout)  # it ends with its client
        text = printed(output)
    assert process.returncode == 0 and not COMPLAINT.search(text), f"{process.returncode}\n{text}"
