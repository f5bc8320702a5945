//! The functions that the stand-in calls: the C library's. A static program has one function of a
//! name, so there it makes the kernel's calls itself.

use std::ffi::c_void;

use libc::{c_char, c_int, c_long, mode_t, nfds_t, off_t, off64_t, pollfd, size_t, ssize_t};

/// Defines a function: the call's number, the type of the C library's function, and its head.
macro_rules! next {
    ($(= $number:expr;)? $pointer:ty, $name:ident($($argument:ident: $type:ty),*) -> $result:ty) => {
        /// # Safety
        /// As the function of this name in the C library.
        pub(crate) unsafe fn $name($($argument: $type),*) -> $result {
            #[cfg(not(all(target_feature = "crt-static", target_arch = "powerpc64")))]
            {
                static ADDRESS: library::Address = library::Address::new(0);
                let name = concat!(stringify!($name), "\0");
                // SAFETY: the type is the function's, and the rest is the caller's promise.
                unsafe { library::find::<$pointer>(name, &ADDRESS)($($argument),*) }
            }
            #[cfg(all(target_feature = "crt-static", target_arch = "powerpc64"))]
            {
                // SAFETY: the caller's promise.
                unsafe { kernel::call([$($number,)? $($argument as c_long),*]) as $result }
            }
        }
    };
}

next!(= libc::SYS_openat; unsafe extern "C" fn(c_int, *const c_char, c_int, ...) -> c_int,
    openat(directory: c_int, path: *const c_char, flags: c_int, mode: mode_t) -> c_int);
next!(= libc::SYS_close; unsafe extern "C" fn(c_int) -> c_int, close(descriptor: c_int) -> c_int);
next!(= libc::SYS_read; unsafe extern "C" fn(c_int, *mut c_void, size_t) -> ssize_t,
    read(descriptor: c_int, into: *mut c_void, size: size_t) -> ssize_t);
next!(= libc::SYS_write; unsafe extern "C" fn(c_int, *const c_void, size_t) -> ssize_t,
    write(descriptor: c_int, from: *const c_void, size: size_t) -> ssize_t);
next!(= libc::SYS_pwrite64; unsafe extern "C" fn(c_int, *const c_void, size_t, off64_t) -> ssize_t,
    pwrite64(descriptor: c_int, from: *const c_void, size: size_t, offset: off64_t) -> ssize_t);
next!(= libc::SYS_mmap;
    unsafe extern "C" fn(*mut c_void, size_t, c_int, c_int, c_int, off_t) -> *mut c_void,
    mmap(address: *mut c_void, size: size_t, protection: c_int, flags: c_int, descriptor: c_int,
        offset: off_t) -> *mut c_void);
next!(= libc::SYS_munmap; unsafe extern "C" fn(*mut c_void, size_t) -> c_int,
    munmap(address: *mut c_void, size: size_t) -> c_int);
next!(= libc::SYS_poll; unsafe extern "C" fn(*mut pollfd, nfds_t, c_int) -> c_int,
    poll(files: *mut pollfd, count: nfds_t, milliseconds: c_int) -> c_int);
next!(unsafe extern "C" fn(c_long, ...) -> c_long,
    syscall(number: c_long, a: c_long, b: c_long, c: c_long, d: c_long, e: c_long, f: c_long)
        -> c_long);

#[cfg(not(all(target_feature = "crt-static", target_arch = "powerpc64")))]
mod library {
    use std::mem;
    use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};

    pub(super) type Address = AtomicUsize;

    /// The function of this name, which is looked up when it is first called.
    ///
    /// # Safety
    /// `F` must be the type of a function pointer that fits the function.
    pub(super) unsafe fn find<F: Copy>(name: &'static str, known: &Address) -> F {
        let mut address = known.load(Relaxed);
        if address == 0 {
            // SAFETY: the macro ends each name with a zero.
            let found = unsafe { libc::dlsym(libc::RTLD_NEXT, name.as_ptr().cast()) };
            assert!(!found.is_null(), "no {name:?} behind this object");
            address = found.expose_provenance();
            known.store(address, Relaxed);
        }
        // SAFETY: the caller's promise; function pointers have the size of an address.
        unsafe { mem::transmute_copy(&address) }
    }
}

#[cfg(all(target_feature = "crt-static", target_arch = "powerpc64"))]
mod kernel {
    use std::arch::asm;

    use libc::c_long;

    /// # Safety
    /// The words must be the number of a call and its arguments.
    pub(super) unsafe fn call<const N: usize>(words: [c_long; N]) -> c_long {
        let word = |at| words.get(at).copied().unwrap_or(0);
        let result: c_long;
        // SAFETY: the caller's promise. The call changes no register but those that functions may
        // change, and sets the summary overflow bit where it fails.
        unsafe {
            asm!(
                "sc",
                "bns+ 2f",
                "neg 3, 3",
                "2:",
                inout("r0") word(0) => _, inout("r3") word(1) => result,
                inout("r4") word(2) => _, inout("r5") word(3) => _,
                inout("r6") word(4) => _, inout("r7") word(5) => _,
                inout("r8") word(6) => _, out("r9") _, out("r10") _, out("r11") _,
                out("r12") _, out("cr0") _, out("ctr") _, out("xer") _,
            );
        }
        if (-4095..0).contains(&result) {
            // SAFETY: the address is this thread's errno.
            unsafe { *libc::__errno_location() = -result as i32 };
            return -1;
        }
        result
    }
}
