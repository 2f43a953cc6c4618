"""The compiled modules: each copy has types of its own."""

import gc
import importlib.util
import weakref

import numpy as np
import pytest

from swarmgrasp.kernels import core

ARGUMENTS = np.eye(3), (1.0,) * 3, np.zeros((0, 12)), 0, (0.0,) * 3, np.zeros((0, 3)), False
PIECE = np.array([[0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 1.0, 0.0]])


def copy_of_core():
    """Return the module once more, from the same file."""
    spec = importlib.util.spec_from_file_location(core.__name__, core.__file__)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_copies_share_no_type():
    """A criterion of one copy is none of the other's, and the first works on beside the second."""
    other = copy_of_core()
    criterion, foreign = core.Criterion(*ARGUMENTS), other.Criterion(*ARGUMENTS)
    search = core.Search(np.eye(3), (1.0,) * 3, PIECE, (0.0,) * 3, criterion)
    assert search.quality == other.weakest(np.eye(3))[0]
    with pytest.raises(TypeError, match="Criterion or None"):
        core.Search(np.eye(3), (1.0,) * 3, PIECE, (0.0,) * 3, foreign)


def test_a_copy_goes_with_its_last_object():
    """An object keeps its copy of the module; both are gone after it."""
    other = copy_of_core()
    gone = weakref.ref(other.Criterion)
    criterion = other.Criterion(*ARGUMENTS)
    del other
    gc.collect()
    assert gone() is type(criterion)
    del criterion
    gc.collect()
    assert gone() is None
