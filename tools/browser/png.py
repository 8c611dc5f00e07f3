"""Pixels of a PNG of 8 bits a channel, with the standard library."""

import struct
import zlib


def pixels(data):
    """Width, height, and a list of rows of (red, green, blue)."""
    assert data[:8] == b"\x89PNG\r\n\x1a\n", "no PNG"
    place, packed = 8, b""
    while place < len(data):
        length, kind = struct.unpack(">I4s", data[place:place + 8])
        body = data[place + 8:place + 8 + length]
        if kind == b"IHDR":
            width, height, depth, colour = struct.unpack(">IIBB", body[:10])
        if kind == b"IDAT":
            packed += body
        place += 12 + length
    channels = {2: 3, 6: 4}[colour]
    assert depth == 8
    raw = zlib.decompress(packed)
    rows, before = [], bytearray(width * channels)
    for y in range(height):
        start = y * (width * channels + 1)
        row = unfiltered(raw[start], bytearray(raw[start + 1:start + 1 + width * channels]), before, channels)
        rows.append([tuple(row[k:k + 3]) for k in range(0, len(row), channels)])
        before = row
    return width, height, rows


def unfiltered(kind, row, above, step):
    for k in range(len(row)):
        left = row[k - step] if k >= step else 0
        corner = above[k - step] if k >= step else 0
        if kind == 1:
            add = left
        elif kind == 2:
            add = above[k]
        elif kind == 3:
            add = (left + above[k]) // 2
        elif kind == 4:
            guess = left + above[k] - corner
            add = min((left, above[k], corner), key=lambda near: abs(guess - near))
        else:
            break
        row[k] = (row[k] + add) & 255
    return row
