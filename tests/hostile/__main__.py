"""Attack the public interface with random bad inputs and list what is found.

python -m tests.hostile [--seed 1] [--count 5000] [scenes files states ...]

Every case is made from seed, attack and number alone, so a finding can be repeated:
``--show NUMBER`` runs one case of one attack in this process.
"""

from __future__ import annotations

import argparse
import sys
import tempfile
from pathlib import Path

from tests.hostile.attack import attacks, lacking, module_of, run


def main(arguments: list[str] | None = None) -> int:
    """Run the attacks; 1 where one found something."""
    parser = argparse.ArgumentParser(prog="python -m tests.hostile", description=__doc__)
    parser.add_argument("attack", nargs="*", help=f"of {', '.join(attacks())}; all by default")
    parser.add_argument("--seed", default="1")
    parser.add_argument("--count", type=int, default=5000, help="cases of each attack")
    parser.add_argument("--show", type=int, metavar="NUMBER", help="one case, in this process")
    given = parser.parse_args(arguments)
    unknown = sorted(set(given.attack) - set(attacks()))
    if unknown:
        parser.error(f"unknown: {', '.join(unknown)}; there are {', '.join(attacks())}")
    names = given.attack or attacks()
    found = 0
    for name in names:
        if missing := lacking(name):
            print(f"{name}: left out, since this machine lacks {missing}")
            continue
        with tempfile.TemporaryDirectory(prefix="hostile-") as folder:
            if given.show is not None:
                module = module_of(name)
                module.prepare(Path(folder))
                print(module.case(given.seed, given.show, Path(folder)) or "nothing")
                continue
            findings = run(name, given.seed, given.count, Path(folder))
        print(f"{name}: {given.count} cases of seed {given.seed}, {len(findings)} findings")
        for finding in findings:
            print(f"  case {finding.number}: {finding.text}")
        found += len(findings)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
