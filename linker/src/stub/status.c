/* Since glibc 2.33 the library has functions of these names. Earlier, programs contained these copies. On 64-bit
   PowerPC, the structures that they read and write have the first layout in every version. */
enum { LAYOUT = 1 };

int __xstat(int layout, const char *path, void *status);
int __lxstat(int layout, const char *path, void *status);
int __fxstat(int layout, int file, void *status);
int __fxstatat(int layout, int folder, const char *path, void *status, int flags);
int __xmknod(int layout, const char *path, unsigned mode, unsigned long *device);
int __xmknodat(int layout, int folder, const char *path, unsigned mode, unsigned long *device);

int stat(const char *path, void *status) { return __xstat(LAYOUT, path, status); }
int lstat(const char *path, void *status) { return __lxstat(LAYOUT, path, status); }
int fstat(int file, void *status) { return __fxstat(LAYOUT, file, status); }
int fstatat(int folder, const char *path, void *status, int flags)
{
    return __fxstatat(LAYOUT, folder, path, status, flags);
}

int stat64(const char *path, void *status) { return __xstat(LAYOUT, path, status); }
int lstat64(const char *path, void *status) { return __lxstat(LAYOUT, path, status); }
int fstat64(int file, void *status) { return __fxstat(LAYOUT, file, status); }
int fstatat64(int folder, const char *path, void *status, int flags)
{
    return __fxstatat(LAYOUT, folder, path, status, flags);
}

int mknod(const char *path, unsigned mode, unsigned long device)
{
    return __xmknod(LAYOUT, path, mode, &device);
}
int mknodat(int folder, const char *path, unsigned mode, unsigned long device)
{
    return __xmknodat(LAYOUT, folder, path, mode, &device);
}
