/*
 * DMA with double buffering: the SPU program fetches an array in pieces, adds a number to each
 * word, and stores the piece in another array, while the next piece is on its way.
 */
#include <endian.h>
#include <libspe2.h>
#include <stdint.h>
#include <stdio.h>

#define WORDS (64 * 1024)

/*
 * What the SPU program fetches first. The SPU is big-endian, and so is the PPE. On another machine,
 * whatever both use must be converted.
 */
struct job {
    uint64_t from, to;
    uint32_t bytes, add;
    uint64_t padding;
} __attribute__((aligned(16)));

extern spe_program_handle_t dma_spu;

static uint32_t from[WORDS] __attribute__((aligned(128)));
static uint32_t to[WORDS] __attribute__((aligned(128)));

int main(void)
{
    struct job job = {htobe64((uintptr_t)from), htobe64((uintptr_t)to), htobe32(sizeof from),
                      htobe32(1000), 0};
    spe_context_ptr_t spe = spe_context_create(0, NULL);
    unsigned int entry = SPE_DEFAULT_ENTRY, wrong = 0;

    if (spe == NULL || spe_program_load(spe, &dma_spu) != 0) {
        perror("dma: the SPU program can't be loaded");
        return 1;
    }
    for (uint32_t n = 0; n < WORDS; n++)
        from[n] = htobe32(n * n);
    if (spe_context_run(spe, &entry, 0, &job, NULL, NULL) < 0) {
        perror("dma: spe_context_run");
        return 1;
    }
    for (uint32_t n = 0; n < WORDS; n++)
        wrong += be32toh(to[n]) != n * n + 1000;
    printf("%d words, %u wrong; the last is %u\n", WORDS, wrong, be32toh(to[WORDS - 1]));
    return spe_context_destroy(spe) == 0 && wrong == 0 ? 0 : 1;
}
