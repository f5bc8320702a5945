/* Words by mailbox: the SPU program doubles each and replies by its interrupt mailbox. */
#include <libspe2.h>
#include <pthread.h>
#include <stdio.h>

extern spe_program_handle_t mailboxes_spu;

/* The thread that calls spe_context_run is the SPU's for as long as the program runs. */
static void *run(void *context)
{
    unsigned int entry = SPE_DEFAULT_ENTRY;

    if (spe_context_run(context, &entry, 0, NULL, NULL, NULL) < 0)
        perror("mailboxes: spe_context_run");
    return NULL;
}

int main(void)
{
    unsigned int words[] = {1, 2, 3, 40, 500, 6000, 0x7fffffff, 0};
    int count = sizeof words / sizeof words[0];
    spe_context_ptr_t spe = spe_context_create(0, NULL);
    unsigned int total;
    pthread_t thread;

    if (spe == NULL || spe_program_load(spe, &mailboxes_spu) != 0) {
        perror("mailboxes: the SPU program can't be loaded");
        return 1;
    }
    if (pthread_create(&thread, NULL, run, spe) != 0) {
        fprintf(stderr, "mailboxes: no thread for the SPU\n");
        return 1;
    }
    for (int n = 0; n < count; n++) {
        unsigned int reply;

        if (spe_in_mbox_write(spe, &words[n], 1, SPE_MBOX_ALL_BLOCKING) != 1 ||
            spe_out_intr_mbox_read(spe, &reply, 1, SPE_MBOX_ALL_BLOCKING) != 1) {
            perror("mailboxes: a mailbox");
            return 1;
        }
        printf("%u doubled is %u\n", words[n], reply);
    }
    pthread_join(thread, NULL);
    if (spe_out_mbox_read(spe, &total, 1) != 1) {
        fprintf(stderr, "mailboxes: no word in the outbound mailbox\n");
        return 1;
    }
    printf("%u words\n", total);
    return spe_context_destroy(spe) == 0 ? 0 : 1;
}
