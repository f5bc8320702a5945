"""Checks a function for shufb, shuffle bytes, with the vectors of shufb.jsonl:

    python3 shufb.py shufb.jsonl
"""

import json
import sys


def shufb(a, b, selectors):
    both = a + b

    def byte(selector):
        if selector >= 0xE0:
            return 0x80
        if selector >= 0xC0:
            return 0xFF
        return 0 if selector >= 0x80 else both[selector & 31]

    return bytes(byte(selector) for selector in selectors)


def differs(vector):
    before, after = ({n: bytes.fromhex(value) for n, value in vector[state]["regs"]}
                     for state in ("initial", "final"))
    pc = vector["initial"]["pc"]
    code = bytes.fromhex(dict(vector["initial"]["ram"])[pc & ~15])
    word = int.from_bytes(code[pc % 16:pc % 16 + 4], "big")
    rt, rb, ra, rc = (word >> shift & 127 for shift in (21, 14, 7, 0))
    return shufb(before[ra], before[rb], before[rc]) != after[rt]


with open(sys.argv[1], encoding="ascii") as lines:
    results = [differs(json.loads(line)) for line in lines]
print(f"{len(results)} vectors, {sum(results)} differ")
sys.exit(any(results))
