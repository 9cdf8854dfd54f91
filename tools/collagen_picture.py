#!/usr/bin/env python3
"""Draws scenarios/collagen.png: a network of fibres as bright lines on black, 280 by 280 pixels of 1 um.

Drawn, not a micrograph: bent fibres of 40 to 120 um in all directions, smeared as by a microscope, from one fixed seed.
    tools/collagen_picture.py FILE.png
"""

import struct
import sys
import zlib

import numpy as np

SIDE, FIBRES = 280, 420


def network() -> np.ndarray:
    """Brightness from 0 to 1; shape (SIDE, SIDE)."""
    random = np.random.default_rng(2020)
    picture = np.zeros((SIDE, SIDE))
    for _ in range(FIBRES):
        length = random.uniform(40.0, 120.0)
        steps = int(2 * length)
        angle = random.uniform(0.0, np.pi) + np.cumsum(random.normal(0.0, 0.02, steps))
        x, y = random.uniform(-40.0, SIDE + 40.0, (2, 1)) + 0.5 * np.cumsum([np.cos(angle), np.sin(angle)], axis=1)
        inside = (x >= 0) & (x < SIDE) & (y >= 0) & (y < SIDE)
        np.add.at(picture, (y[inside].astype(int), x[inside].astype(int)), 0.5)
    reach = np.arange(-4, 5)
    kernel = np.exp(-0.5 * (reach / 1.2) ** 2)
    kernel /= kernel.sum()
    for axis in (0, 1):
        picture = np.apply_along_axis(np.convolve, axis, picture, kernel, mode="same")
    return np.clip(picture / np.quantile(picture, 0.98), 0.0, 1.0)


def write_png(file: str, brightness: np.ndarray) -> None:
    """Grey, 8 bits a pixel."""
    def chunk(kind: bytes, data: bytes) -> bytes:
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    height, width = brightness.shape
    rows = np.insert(np.rint(255 * brightness).astype(np.uint8), 0, 0, axis=1).tobytes()  # each row begins with its filter
    with open(file, "wb") as out:
        out.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 0, 0, 0, 0))
                  + chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b""))


if __name__ == "__main__":
    write_png(sys.argv[1], network())
