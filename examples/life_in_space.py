#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Makes the data files of 19_life_in_space.scn: generations of a three-dimensional cellular automaton on a torus.

A cell has 26 neighbours. Rule 4555 (C. Bays, "Candidates for the Game of Life in Three Dimensions", 1987): a living
cell lives on with 4 or 5 living neighbours, a dead one comes to life with 5. A file holds a number for each living
cell: x + SIZE * (y + SIZE * (z + SIZE * age)). Usage: life_in_space.py [FOLDER]
"""
import itertools
import pathlib
import random
import sys

SIZE = 16
OLDEST = 9  # ages are not counted further
SEED = 9
GENERATIONS = 60
LIVES_ON = {4, 5}
IS_BORN = {5}
AROUND = [step for step in itertools.product((-1, 0, 1), repeat=3) if step != (0, 0, 0)]


def first_generation():
    """Every fifth cell, at random."""
    chance = random.Random(SEED)
    return {cell: 0 for cell in itertools.product(range(SIZE), repeat=3) if chance.random() < 0.2}


def next_generation(ages):
    neighbours = {}
    for x, y, z in ages:
        for dx, dy, dz in AROUND:
            cell = ((x + dx) % SIZE, (y + dy) % SIZE, (z + dz) % SIZE)
            neighbours[cell] = neighbours.get(cell, 0) + 1
    return {
        cell: min(ages[cell] + 1, OLDEST) if cell in ages else 0
        for cell, count in neighbours.items()
        if count in (LIVES_ON if cell in ages else IS_BORN)
    }


def main():
    folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).with_suffix(""))
    folder.mkdir(exist_ok=True)
    ages = first_generation()
    for generation in range(GENERATIONS):
        cells = sorted(x + SIZE * (y + SIZE * (z + SIZE * age)) for (x, y, z), age in ages.items())
        text = "".join(f"{cell},\n" for cell in cells)
        (folder / f"{generation:03}.txt").write_text(text)
        ages = next_generation(ages)


if __name__ == "__main__":
    main()
