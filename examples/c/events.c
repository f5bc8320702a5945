/* One thread waits for the events of two SPEs: their messages, and their ends. */
#include <libspe2.h>
#include <pthread.h>
#include <stdio.h>

#define SPES 2

extern spe_program_handle_t events_spu;

static void *run(void *context)
{
    unsigned int entry = SPE_DEFAULT_ENTRY;

    if (spe_context_run(context, &entry, 0, NULL, NULL, NULL) < 0)
        perror("events: spe_context_run");
    return NULL;
}

int main(void)
{
    spe_event_handler_ptr_t handler = spe_event_handler_create();
    spe_context_ptr_t spes[SPES];
    pthread_t threads[SPES];
    unsigned int messages[SPES] = {0}, sums[SPES] = {0};
    int running = SPES, codes[SPES];

    for (unsigned int n = 0; n < SPES; n++) {
        spe_event_unit_t unit = {.events = SPE_EVENT_OUT_INTR_MBOX | SPE_EVENT_SPE_STOPPED};
        unsigned int first = 100 * n;

        spes[n] = spe_context_create(SPE_EVENTS_ENABLE, NULL);
        if (spes[n] == NULL || spe_program_load(spes[n], &events_spu) != 0) {
            perror("events: the SPU program can't be loaded");
            return 1;
        }
        unit.spe = spes[n];
        unit.data.u32 = n;
        if (spe_event_handler_register(handler, &unit) != 0 ||
            spe_in_mbox_write(spes[n], &first, 1, SPE_MBOX_ALL_BLOCKING) != 1) {
            perror("events: the start");
            return 1;
        }
        if (pthread_create(&threads[n], NULL, run, spes[n]) != 0) {
            fprintf(stderr, "events: no thread for an SPU\n");
            return 1;
        }
    }
    while (running > 0) {
        spe_event_unit_t units[4];
        int count = spe_event_wait(handler, units, 4, 60 * 1000);

        if (count <= 0) {
            fprintf(stderr, "events: none within a minute\n");
            return 1;
        }
        for (int k = 0; k < count; k++) {
            unsigned int n = units[k].data.u32, word;
            spe_stop_info_t stop;

            /* A message may still be there when the end is reported. */
            while (spe_out_intr_mbox_read(units[k].spe, &word, 1, SPE_MBOX_ANY_NONBLOCKING) == 1) {
                messages[n]++;
                sums[n] += word;
            }
            if (units[k].events == SPE_EVENT_SPE_STOPPED &&
                spe_stop_info_read(units[k].spe, &stop) == 0) {
                codes[n] = stop.result.spe_exit_code;
                running--;
            }
        }
    }
    for (int n = 0; n < SPES; n++) {
        pthread_join(threads[n], NULL);
        printf("SPE %d: %u messages, sum %u, exit code %d\n", n, messages[n], sums[n], codes[n]);
        spe_context_destroy(spes[n]);
    }
    return spe_event_handler_destroy(handler) == 0 ? 0 : 1;
}
