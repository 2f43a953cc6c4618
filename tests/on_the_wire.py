"""Sending in tests of the network: after somebody is known to listen, and never dropped."""

import os

import zenoh

BLOCK = zenoh.CongestionControl.BLOCK


def await_listener(session, key):
    """Wait until this session knows of a subscriber to a key: a put before that is lost."""
    with session.declare_publisher(key) as publisher:
        while not publisher.matching_status.matching:
            os.sched_yield()


def send(session, key, data):
    """Send bytes to whoever listens, however many and large those before them were."""
    await_listener(session, key)
    session.put(key, data, congestion_control=BLOCK)
