/* The SPU's part of hello.c, for spu-gcc (ci/spu-gcc builds one): it prints by printf. hello_spu.s
 * is the same in assembly. */
#include <stdio.h>

int main(unsigned long long spe, unsigned long long argp, unsigned long long envp)
{
    (void)spe, (void)argp, (void)envp;
    return printf("hello, %s: %d, %.3f, %lld%c\n", "moon", -42, 3.14159265358979,
                  123456789012345LL, '!');
}
