/*
 * Runs a program as a login on a virtual terminal would: at the head of a session of its own, with the
 * terminal's keys as its signals. A shell's background jobs have SIGINT and SIGQUIT ignored.
 */
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <sys/ioctl.h>
#include <unistd.h>

int main(int count, char **arguments)
{
    int terminal;

    if (count < 3) {
        fprintf(stderr, "usage: on-terminal TERMINAL PROGRAM [ARGUMENT...]\n");
        return 2;
    }
    signal(SIGINT, SIG_DFL);
    signal(SIGQUIT, SIG_DFL);
    if (setsid() < 0 || (terminal = open(arguments[1], O_RDWR)) < 0 ||
        ioctl(terminal, TIOCSCTTY, 1) < 0 || dup2(terminal, 0) < 0 || dup2(terminal, 1) < 0) {
        perror(arguments[1]);
        return 1;
    }
    execvp(arguments[2], arguments + 2);
    perror(arguments[2]);
    return 1;
}
