/* Checks a function for rot, rotate words left, with the vectors of rot.bin:
 *
 *     cc -o rot rot.c && ./rot rot.bin
 */
#include <stdint.h>
#include <stdio.h>
#include <string.h>

static uint32_t rot(uint32_t a, uint32_t b)
{
    return a << (b & 31) | a >> (-b & 31);
}

static uint32_t word(const unsigned char *bytes)
{
    return (uint32_t)bytes[0] << 24 | (uint32_t)bytes[1] << 16 | (uint32_t)bytes[2] << 8 | bytes[3];
}

int main(int argc, char **argv)
{
    static uint32_t before[128][4], after[128][4];
    unsigned char head[28], record[36];
    FILE *file = argc == 2 ? fopen(argv[1], "rb") : NULL;
    uint32_t count, vector, differ = 0;

    if (file == NULL || fread(head, 12, 1, file) != 1 || memcmp(head, "SPUVECT1", 8) != 0) {
        fprintf(stderr, "usage: rot rot.bin, a file that spu vectors has written\n");
        return 2;
    }
    count = word(head + 8);
    for (vector = 0; vector < count; vector++) {
        uint32_t pc, place, lane, code = 0, wrong = 0, read = fread(head, 28, 1, file);
        int records = read == 1 ? head[27] : 0;

        for (pc = word(head); records > 0 && read == 1; records--) {
            read = fread(record, 36, 1, file);
            place = word(record);
            for (lane = 0; place < 128 && lane < 4; lane++) {
                before[place][lane] = word(record + 4 + 4 * lane);
                after[place][lane] = word(record + 20 + 4 * lane);
            }
            if (place == (0x80000000 | (pc & ~15u)))
                code = word(record + 4 + pc % 16);
        }
        if (read != 1) {
            fprintf(stderr, "%s: vector %u is not complete\n", argv[1], (unsigned)vector);
            return 2;
        }
        for (lane = 0; lane < 4; lane++) {
            uint32_t a = before[code >> 7 & 127][lane], b = before[code >> 14 & 127][lane];
            wrong |= rot(a, b) != after[code & 127][lane];
        }
        differ += wrong;
    }
    printf("%u vectors, %u differ\n", (unsigned)count, (unsigned)differ);
    return differ != 0;
}
