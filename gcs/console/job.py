"""Whether this process belongs to a shell's job, so that it can be continued once it is suspended."""

from __future__ import annotations

import os
from pathlib import Path


def can_suspend() -> bool:
    """Whether an ancestor in this session is outside the process group: such a shell gets the terminal back.

    POSIX calls a group without one orphaned (XBD 3.262): the kernel does not stop it by SIGTSTP.
    """
    group, session = os.getpgrp(), os.getsid(0)
    pid = os.getppid()
    while pid > 1:
        try:
            if os.getsid(pid) != session:
                return False
            if os.getpgid(pid) != group:
                return True
            # The name, in parentheses, may hold anything; state and parent follow the last one.
            pid = int(Path(f"/proc/{pid}/stat").read_text(encoding="utf-8").rpartition(")")[2].split()[1])
        except (OSError, ValueError, IndexError):
            return False
    return False
