/* Runs an SPU program that prints by printf: hello_spu.s, or hello_spu.c for an SPU compiler. The
 * library serves its calls on the thread that runs it. embedspu gives the program its name here. */
#include <libspe2.h>
#include <stdio.h>

extern spe_program_handle_t hello_spu;

int main(void)
{
    spe_context_ptr_t spe = spe_context_create(0, NULL);
    unsigned int entry = SPE_DEFAULT_ENTRY;
    spe_stop_info_t stop;

    if (spe == NULL || spe_program_load(spe, &hello_spu) != 0) {
        perror("hello: the SPU program can't be loaded");
        return 1;
    }
    printf("PPE: starting the SPU program\n");
    if (spe_context_run(spe, &entry, 0, NULL, NULL, &stop) < 0) {
        perror("hello: spe_context_run");
        return 1;
    }
    printf("PPE: it printed %d characters\n", stop.result.spe_exit_code);
    return spe_context_destroy(spe) == 0 ? 0 : 1;
}
