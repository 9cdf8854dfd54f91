"""The nearest name to a misspelt one, by the rules of the program (src/parameters/nearest.cpp)."""
from __future__ import annotations

from collections.abc import Iterable

_longest = 80
_matrix = ("", "ecm", "matrix", "gel")
_run = ("", "run", "simulation")
_aliases: dict[str, tuple[tuple[str, ...], str]] = {  # words that people try: in which sections, and what they mean
    **dict.fromkeys(("stiffness", "elasticity", "elastic_modulus", "modulus", "rigidity"), (_matrix, "ecm.youngs_modulus")),
    "domain_radius": (_matrix, "ecm.radius"),
    "poisson_ratio": (_matrix, "ecm.poissons_ratio"),
    "resolution": (_matrix, "ecm.particle_spacing"),
    "time": (_run, "run.duration"),
    **dict.fromkeys(("hours", "end_time"), ((*_run, "time"), "run.duration")),
    **dict.fromkeys(("dt", "step"), ((*_run, "time"), "run.time_step")),
    **dict.fromkeys(("contraction", "contractility"), (("", "cell", "actomyosin"), "actomyosin.force")),
    "diameter": (("", "cell"), "cell.radius"),
    "orientation": (("", "fibres", "fibers"), "fibres.direction_deg"),
}


def edit_distance(a: str, b: str) -> int:
    """Letters to insert, remove, replace or swap; upper and lower case are the same.

    >>> edit_distance("raduis", "radius")
    1
    """
    a, b = a.lower(), b.lower()
    before, above = [0] * (len(b) + 1), list(range(len(b) + 1))
    for i in range(1, len(a) + 1):
        row = [i]
        for j in range(1, len(b) + 1):
            best = min(above[j] + 1, row[j - 1] + 1, above[j - 1] + (a[i - 1] != b[j - 1]))
            if i > 1 and j > 1 and a[i - 1] == b[j - 2] and a[i - 2] == b[j - 1]:
                best = min(best, before[j - 2] + 1)
            row.append(best)
        before, above = above, row
    return above[-1]


def _allowance(name: str) -> int:
    return max(1, len(name) // 3)


def nearest(typed: str, names: Iterable[str]) -> str | None:
    """The first of the nearest names, if it is near enough."""
    if not typed or len(typed) > _longest:
        return None
    found = min(((edit_distance(typed, name), k, name) for k, name in enumerate(names)), default=None)
    return found[2] if found and found[0] <= _allowance(typed) else None


def nearest_parameter(path: str, parameters: dict[str, str], sections: Iterable[str]) -> str | None:
    """Of paths with their symbols, and of sections: a key counts in a wrong section, too, and a symbol as its key."""
    if not path or len(path) > _longest:
        return None
    key, best, least = path.rsplit(".", 1)[-1], None, _allowance(path) + 1
    alias_sections, alias = _aliases.get(key, ((), ""))
    if path.removesuffix(key).removesuffix(".") in alias_sections:
        return alias
    for name, symbol in parameters.items():
        if symbol and key == symbol:
            return name
        elsewhere = edit_distance(key, name.rsplit(".", 1)[-1])
        distances = [edit_distance(path, name)] + ([elsewhere + 1] if elsewhere <= _allowance(key) else [])
        if min(distances) < least:
            best, least = name, min(distances)
    for name in sections:
        if edit_distance(path, name) < least:
            best, least = name, edit_distance(path, name)
    return best


def did_you_mean(name: str | None) -> str:
    return f"; did you mean {name}?" if name else ""
