#  SPDX-License-Identifier: GPL-3.0-or-later
"""The program: options, guard, gateway."""

import functools
import sys

from . import guard, options, version


def main() -> int:
    try:
        chosen = options.read(sys.argv[1:])
    except options.Usage as mistake:
        print(f"destijl_web: {mistake}", file=sys.stderr)
        return 2
    if chosen is options.Wish.HELP:
        print(options.HELP, end="")
        return 0
    if isinstance(chosen, options.Wish):
        print(f"destijl_web {version.number()}")
        return 0
    return guard.run(functools.partial(_serve, chosen))


def _serve(chosen: options.Options, heart: int) -> int:
    #  Imported here: the guard does not need it
    from . import server

    return server.run(chosen, heart)


if __name__ == "__main__":
    sys.exit(main())
