"""What both scripts share: the program under test as a child process, ports, and the report."""

import json
import socket
import subprocess
import sys
import threading
import time

LOOPBACK = "127.0.0.1"
# Nothing that the scripts wait for takes longer.
PATIENCE_S = 20.0


def free_udp_port():
    """A UDP port that nobody uses at the moment."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
        probe.bind((LOOPBACK, 0))
        return probe.getsockname()[1]


class Program:
    """`team` with some arguments, from its ready line to the end of the block."""

    def __init__(self, program, arguments, ready):
        self.command = [program, *arguments]
        self.ready = ready
        self.lines = []
        self.is_ready = threading.Event()

    def __enter__(self):
        self.process = subprocess.Popen(
            self.command,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
        )
        threading.Thread(target=self._read, daemon=True).start()
        if not self.is_ready.wait(PATIENCE_S) or self.process.poll() is not None:
            self.__exit__()
            raise RuntimeError("not ready: " + " ".join(self.command) + "\n" + self.output())
        return self

    def __exit__(self, *_):
        self.process.terminate()
        try:
            self.process.wait(PATIENCE_S)
        except subprocess.TimeoutExpired:
            self.process.kill()
            self.process.wait()

    def _read(self):
        for line in self.process.stdout:
            self.lines.append(line)
            if self.ready in line:
                self.is_ready.set()
        # A program that has ended will not become ready any more.
        self.is_ready.set()

    def output(self):
        return "".join(self.lines)


class Report:
    """What was checked, as lines for people and as an exit code for programs."""

    def __init__(self):
        self.failed = 0
        self.began = time.monotonic()

    def check(self, what, holds, value=""):
        self.failed += not holds
        print(f"{'ok  ' if holds else 'FAIL'}  {what}{': ' if value != '' else ''}{value}", flush=True)

    def end(self, figures):
        figures["seconds"] = round(time.monotonic() - self.began, 1)
        print(json.dumps(figures))
        sys.exit(1 if self.failed else 0)
