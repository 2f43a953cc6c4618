"""Run the benchmarks and write docs/benchmarks.md.

``python benchmarks/run.py`` measures everything and writes the page whole at the end.
``--only quality,growth`` and ``--quick`` measure a part, which is printed and not written.
"""

import argparse
import os
import time

# one core for every method, before NumPy is loaded; and start-up as it is where bytecode is kept
os.environ.update(dict.fromkeys(("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS"), "1"))
os.environ.pop("PYTHONDONTWRITEBYTECODE", None)

import families
import force_sets
import growth
import motion
import page
import push
import runs
import startup

import placement
import quality

SECTIONS = {
    "quality": quality,
    "placement": placement,
    "families": families,
    "growth": growth,
    "force-sets": force_sets,
    "push": push,
    "motion": motion,
    "runs": runs,
    "startup": startup,
}


def read_arguments():
    """Read the command line."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--only", default=",".join(SECTIONS), help=f"of {','.join(SECTIONS)}")
    parser.add_argument("--quick", action="store_true", help="few inputs and small sizes")
    parser.add_argument("--largest", type=int, default=1_000_000, help="robots, at most")
    parser.add_argument("--patience", type=float, default=60.0, help="seconds per size of growth")
    args = parser.parse_args()
    args.only = args.only.split(",")
    if strangers := set(args.only) - set(SECTIONS):
        parser.error(f"no such section: {', '.join(sorted(strangers))}")
    return args


def main():
    """Measure, and write the page or print the parts."""
    args = read_arguments()
    parts = []
    for name in args.only:
        start = time.perf_counter()
        print(name, flush=True)
        parts.append(SECTIONS[name].measure(args))
        print(f"    {name} took {time.perf_counter() - start:.0f} s", flush=True)
    if args.quick or set(args.only) != set(SECTIONS):
        print("\n" + "\n".join((*(part.text for part in parts), page.machine())))
    else:
        page.write(parts)


if __name__ == "__main__":
    main()
