"""Something done while a kernel computes, at no particular time."""

import sys
import threading
from contextlib import contextmanager


@contextmanager
def while_it_computes(do):
    """Do something in another thread as soon as this one lets others run.

    Python itself does not let it run inside the block: only a kernel that leaves the
    interpreter to others does.
    """
    gate = threading.Lock()

    def wait():
        with gate:
            do()

    interval = sys.getswitchinterval()
    gate.acquire()
    other = threading.Thread(target=wait)
    other.start()
    sys.setswitchinterval(1000.0)
    try:
        gate.release()
        yield
    finally:
        sys.setswitchinterval(interval)
        other.join()
