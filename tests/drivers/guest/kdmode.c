/* Prints the mode of a virtual terminal: 0 while the kernel draws its text, 1 while a program draws. */
#include <fcntl.h>
#include <linux/kd.h>
#include <stdio.h>
#include <sys/ioctl.h>

int main(int count, char **arguments)
{
    int mode, terminal = count == 2 ? open(arguments[1], O_RDWR | O_NOCTTY) : -1;

    if (terminal < 0 || ioctl(terminal, KDGETMODE, &mode) < 0) {
        perror(count == 2 ? arguments[1] : "usage: kdmode TERMINAL");
        return 1;
    }
    printf("%d\n", mode);
    return 0;
}
