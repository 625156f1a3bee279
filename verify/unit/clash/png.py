"""A reader of the PNG files that the tests meet: RGB or RGBA, eight bits, not interlaced."""

import struct
import zlib


def unfilter(kind, line, above, step):
    for i in range(len(line)):
        left = line[i - step] if i >= step else 0
        up = above[i]
        corner = above[i - step] if i >= step else 0
        if kind == 1:
            line[i] = (line[i] + left) & 255
        elif kind == 2:
            line[i] = (line[i] + up) & 255
        elif kind == 3:
            line[i] = (line[i] + (left + up) // 2) & 255
        elif kind == 4:
            distances = [abs(up - corner), abs(left - corner), abs(left + up - 2 * corner)]
            line[i] = (line[i] + (left, up, corner)[distances.index(min(distances))]) & 255
    return line


def read_png(data):
    """Width, height and the rows, each a list of (red, green, blue). Checks every chunk's sum."""
    assert data[:8] == b"\x89PNG\r\n\x1a\n"
    at, body, header = 8, b"", None
    while at < len(data):
        size, kind = struct.unpack(">I4s", data[at:at + 8])
        content = data[at + 8:at + 8 + size]
        assert zlib.crc32(kind + content) == struct.unpack(">I", data[at + 8 + size:at + 12 + size])[0]
        at += 12 + size
        if kind == b"IHDR":
            header = struct.unpack(">IIBBBBB", content)
        if kind == b"IDAT":
            body += content
    width, height, depth, color = header[:4]
    assert depth == 8 and color in (2, 6) and header[6] == 0, header
    step = 3 if color == 2 else 4
    raw, above, rows = zlib.decompress(body), bytearray(width * step), []
    assert len(raw) == height * (width * step + 1)
    for y in range(height):
        begin = y * (width * step + 1)
        above = unfilter(raw[begin], bytearray(raw[begin + 1:begin + 1 + width * step]), above, step)
        rows.append([tuple(above[i:i + 3]) for i in range(0, len(above), step)])
    return width, height, rows


def share(rows, is_wanted):
    """The share of the pixels for which is_wanted(red, green, blue)."""
    return sum(is_wanted(*pixel) for row in rows for pixel in row) / (len(rows) * len(rows[0]))
