# SPDX-License-Identifier: Apache-2.0
"""Where what a binding declares differs from what the C headers do."""

# A binding in which functions are called by hand may leave out what a compiler would see.
NEEDED = ("functions", "constants", "structs")
OPTIONAL = ("signatures", "kinds", "defaults")


def differences(truth: dict, declared: dict) -> list[str]:
    """One line for each; none if the binding is complete and right."""
    found = [f"{name}: not told at all" for name in NEEDED if name not in declared]
    found += [f"{name}: not known" for name in declared if name not in NEEDED + OPTIONAL]
    for name in NEEDED + OPTIONAL:
        if name in declared:
            found += walk(name, truth[name], declared[name])
    return found


def walk(place: str, wanted, got) -> list[str]:
    if not isinstance(wanted, dict) or not isinstance(got, dict):
        same = wanted == got and type(wanted) is type(got)
        return [] if same else [f"{place}: {got!r}, but {wanted!r} in C"]
    found = [f"{place}: {name} is missing" for name in wanted if name not in got]
    found += [f"{place}: {name} is not in the headers" for name in got if name not in wanted]
    for name in wanted:
        if name in got:
            found += walk(f"{place}: {name}", wanted[name], got[name])
    return found
