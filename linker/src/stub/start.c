/* Since glibc 2.34 the library calls a program's constructors before main. Earlier, a function in the program
   called them, and the program passed this function to the library. The library still calls it if it gets one. */
typedef void (*function)(int, char **, char **);
extern function __init_array_start[], __init_array_end[];
void _init(void);

static int call_all(int count, char **words, char **variables)
{
    _init();
    for (function *next = __init_array_start; next < __init_array_end; next++)
        (*next)(count, words, variables);
    return 0;
}

/* As in the start-up code of 64-bit PowerPC. */
struct program {
    void *unused;
    int (*main)(int, char **, char **);
    int (*before)(int, char **, char **);
    void (*after)(void);
};

int start(int, char **, char **, void *, void (*)(void), struct program *, char **);
__asm__(".symver start, " START);

int __libc_start_main(int count, char **words, char **variables, void *auxiliary, void (*end)(void),
                      struct program *program, char **stack)
{
    struct program with = *program;
    with.before = call_all;
    return start(count, words, variables, auxiliary, end, &with, stack);
}
