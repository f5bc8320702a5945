/* Tests the functions of which programs linked against glibc 2.17 contain copies, with the installed C library.
   ci/ppc64 links this program to the stubs. Its exit status is the line of the check that failed. */
#define _GNU_SOURCE
#include <fcntl.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

#define CHECK(condition) do { if (!(condition)) return __LINE__; } while (0)

static int called;

__attribute__((constructor)) static void before_main(int count, char **words)
{
    called = count == 2 && words[1][0] == 'x';
}

int main(int count, char **words)
{
    struct stat found;
    char path[] = "/tmp/copies-XXXXXX";
    int file = mkstemp(path);
    CHECK(count == 2 && words[1][0] == 'x' && called);
    CHECK(file >= 0 && write(file, "seven b", 7) == 7);
    CHECK(fstat(file, &found) == 0 && found.st_size == 7);
    CHECK(stat(path, &found) == 0 && found.st_size == 7);
    CHECK(lstat(path, &found) == 0 && S_ISREG(found.st_mode));
    CHECK(fstatat(AT_FDCWD, path, &found, 0) == 0 && found.st_size == 7);
    CHECK(unlink(path) == 0 && stat(path, &found) == -1);
    CHECK(mknod(path, S_IFIFO | 0600, 0) == 0);
    CHECK(lstat(path, &found) == 0 && S_ISFIFO(found.st_mode) && unlink(path) == 0);
    CHECK(mknodat(AT_FDCWD, path, S_IFIFO | 0600, 0) == 0);
    CHECK(lstat(path, &found) == 0 && S_ISFIFO(found.st_mode) && unlink(path) == 0);
    return 0;
}
