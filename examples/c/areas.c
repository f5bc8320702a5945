/* Problem-state areas: a mailbox, a signal and a proxy DMA by plain loads and stores. */
#include <libspe2.h>
#include <stdint.h>
#include <stdio.h>

#define TEXT_IN_LOCAL_STORE 0x4000
#define GET 0x40
#define TAG 3

extern spe_program_handle_t areas_spu;

static char text[16] __attribute__((aligned(16))) = "text of 16 bytes";

int main(void)
{
    spe_context_ptr_t spe = spe_context_create(SPE_MAP_PS, NULL);
    unsigned int entry = SPE_DEFAULT_ENTRY;
    volatile spe_spu_control_area_t *control;
    volatile spe_mfc_command_area_t *command;
    volatile spe_sig_notify_1_area_t *signal;

    if (spe == NULL || spe_program_load(spe, &areas_spu) != 0) {
        perror("areas: the SPU program can't be loaded");
        return 1;
    }
    control = spe_ps_area_get(spe, SPE_CONTROL_AREA);
    command = spe_ps_area_get(spe, SPE_MFC_COMMAND_AREA);
    signal = spe_ps_area_get(spe, SPE_SIG_NOTIFY_1_AREA);
    if (control == NULL || command == NULL || signal == NULL) {
        perror("areas: spe_ps_area_get");
        return 1;
    }
    printf("%u words free\n", control->SPU_Mbox_Stat >> 8 & 0xff);
    control->SPU_In_Mbox = 1000;
    signal->SPU_Sig_Notify_1 = 234;

    command->MFC_LSA = TEXT_IN_LOCAL_STORE;
    command->MFC_EAH = (uint64_t)(uintptr_t)text >> 32;
    command->MFC_EAL = (uintptr_t)text;
    command->MFC_Size_Tag = sizeof text << 16 | TAG;
    command->MFC_ClassID_CMD = GET;
    if ((command->MFC_CMDStatus & 3) != 0) {
        fprintf(stderr, "areas: the command is refused\n");
        return 1;
    }
    command->Prxy_QueryMask = 1 << TAG;
    while (command->Prxy_TagStatus != 1 << TAG)
        ;
    printf("%.16s\n", (char *)spe_ls_area_get(spe) + TEXT_IN_LOCAL_STORE);

    if (spe_context_run(spe, &entry, 0, NULL, NULL, NULL) < 0) {
        perror("areas: spe_context_run");
        return 1;
    }
    printf("status %#x, next instruction at %#x\n", control->SPU_Status, control->SPU_NPC);
    printf("words waiting: %u\n", control->SPU_Mbox_Stat & 0xff);
    printf("sum %u\n", control->SPU_Out_Mbox);
    printf("words waiting: %u\n", control->SPU_Mbox_Stat & 0xff);
    return spe_context_destroy(spe) == 0 ? 0 : 1;
}
