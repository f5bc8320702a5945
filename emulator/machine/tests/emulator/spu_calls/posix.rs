use std::fs;
use std::os::unix::ffi::OsStrExt as _;
use std::os::unix::fs::MetadataExt as _;
use std::path::PathBuf;

use super::support::{GuestProgram, HEAP_EA, Reply, Value};

const O_RDWR: u32 = 2;
const O_CREAT: u32 = 64;
const O_EXCL: u32 = 128;
const O_TRUNC: u32 = 512;
const BUFFER: u32 = 0x8000;
const ENOENT: Reply = Reply { value: -1, low: 0, errno: libc::ENOENT };

struct Files {
    guest: GuestProgram,
    folder: tempfile::TempDir,
}

impl Files {
    fn new() -> Self {
        Self { guest: GuestProgram::new("typed"), folder: tempfile::tempdir().unwrap() }
    }

    fn file(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    fn path(&mut self, name: &str) -> u32 {
        let path = self.file(name);
        self.guest.text(path.as_os_str().as_bytes())
    }

    fn call(&mut self, name: &str, arguments: &[u32]) -> Reply {
        self.guest.call(name, arguments)
    }

    fn open(&mut self, name: &str, flags: u32) -> Reply {
        let path = self.path(name);
        self.call("open", &[path, flags, 0o640])
    }
}

#[test]
fn descriptors() {
    let mut files = Files::new();
    assert_eq!(files.open("f", O_RDWR), ENOENT);
    let opened = files.open("f", O_RDWR | O_CREAT | O_EXCL);
    assert_eq!(opened.errno, 0);
    let fd = opened.value as u32;
    assert_eq!(files.open("f", O_CREAT | O_EXCL).errno, libc::EEXIST);
    assert_eq!(files.open("f", 1 << 20).errno, libc::EINVAL);
    let text = files.guest.text("0123456789");
    assert_eq!(files.call("write", &[fd, text, 10]), Reply::ok(10));
    assert_eq!(files.call("lseek", &[fd, -4_i32 as u32, 2]), Reply::ok(6));
    assert_eq!(files.call("read", &[fd, BUFFER, 100]), Reply::ok(4));
    assert_eq!(files.guest.read_text(BUFFER), "6789");
    assert_eq!(files.call("pread", &[fd, BUFFER, 3, 1]), Reply::ok(3));
    assert_eq!(files.guest.read_text(BUFFER), "1239");
    assert_eq!(files.call("pwrite", &[fd, text, 2, 8]), Reply::ok(2));
    assert_eq!(files.call("ftruncate", &[fd, 9]), Reply::ok(0));
    assert_eq!(fs::read(files.file("f")).unwrap(), b"012345670");
    let copy = files.call("dup", &[fd]).value as u32;
    assert_ne!(copy, fd);
    assert_eq!(files.call("close", &[fd]), Reply::ok(0));
    assert_eq!(files.call("fsync", &[copy]), Reply::ok(0));
    assert_eq!(files.call("fdatasync", &[copy]), Reply::ok(0));
    assert_eq!(files.call("fchmod", &[copy, 0o600]), Reply::ok(0));
    assert_eq!(files.call("lockf", &[copy, 2, 0]), Reply::ok(0));
    assert_eq!(files.call("dup2", &[copy, copy]), Reply::ok(copy as i32));
    assert_eq!(files.call("close", &[copy]), Reply::ok(0));
    for name in ["read", "write", "pread", "pwrite", "lseek", "dup", "fsync", "fstat", "fchdir"] {
        let reply = files.call(name, &[u32::MAX, BUFFER, 1, 0]);
        assert_eq!(reply, Reply::failed(-1, libc::EBADF), "{name}");
    }
}

#[test]
fn standard_streams_go_through_the_outside() {
    let mut files = Files::new();
    assert_eq!(files.call("read", &[0, BUFFER, 3]), Reply::ok(3));
    assert_eq!(files.guest.read_text(BUFFER), "typ");
    let text = files.guest.text("out");
    assert_eq!(files.call("write", &[1, text, 3]), Reply::ok(3));
    assert_eq!(files.guest.output(), "out");
}

#[test]
fn vectors() {
    let mut files = Files::new();
    let fd = files.open("f", O_RDWR | O_CREAT | O_TRUNC).value as u32;
    let (one, two) = (files.guest.text("moon"), files.guest.text("light"));
    let vector = |files: &Files, words: &[u32]| {
        for (n, word) in (0..).zip(words) {
            files.guest.store.write(0x9000 + 4 * n, &word.to_be_bytes());
        }
    };
    vector(&files, &[one, 4, two, 5]);
    assert_eq!(files.call("writev", &[fd, 0x9000, 2]), Reply::ok(9));
    files.call("lseek", &[fd, 0, 0]);
    vector(&files, &[BUFFER, 6, BUFFER + 16, 6]);
    assert_eq!(files.call("readv", &[fd, 0x9000, 2]), Reply::ok(9));
    assert_eq!(files.guest.read_text(BUFFER), "moonli");
    assert_eq!(files.guest.read_text(BUFFER + 16), "ght");
    let many = files.call("readv", &[fd, 0x9000, 1025]);
    assert_eq!(many, Reply::failed(-1, libc::EINVAL));
    vector(&files, &[BUFFER, 0x7fff_ffff, BUFFER, 1]);
    let long = files.call("writev", &[fd, 0x9000, 2]);
    assert_eq!(long, Reply::failed(-1, libc::EINVAL));
}

#[test]
fn the_status_has_thirteen_words() {
    let mut files = Files::new();
    fs::write(files.file("f"), [0; 5000]).unwrap();
    std::os::unix::fs::symlink("f", files.file("l")).unwrap();
    let known = fs::metadata(files.file("f")).unwrap();
    let (path, link) = (files.path("f"), files.path("l"));
    assert_eq!(files.call("stat", &[path, BUFFER]), Reply::ok(0));
    let words: [u32; 14] = files.guest.words(BUFFER);
    let expected = [
        known.dev(),
        known.ino(),
        known.mode().into(),
        known.nlink(),
        known.uid().into(),
        known.gid().into(),
        known.rdev(),
        known.size(),
        known.blksize(),
        known.blocks(),
        known.atime() as u64,
        known.mtime() as u64,
        known.ctime() as u64,
        0,
    ];
    assert_eq!(words, expected.map(|value| value as u32));
    files.call("stat", &[link, BUFFER]);
    assert_eq!(files.guest.words::<2>(BUFFER)[1], known.ino() as u32);
    files.call("lstat", &[link, BUFFER]);
    assert_ne!(files.guest.words::<2>(BUFFER)[1], known.ino() as u32);
    let none = files.path("none");
    assert_eq!(files.call("stat", &[none, BUFFER]), ENOENT);
}

#[test]
fn names() {
    let mut files = Files::new();
    let (f, g, d) = (files.path("f"), files.path("g"), files.path("d"));
    let fd = files.call("creat", &[f, 0o600]).value as u32;
    files.call("close", &[fd]);
    assert_eq!(files.call("access", &[f, 6]), Reply::ok(0));
    assert_eq!(files.call("access", &[g, 0]), ENOENT);
    assert_eq!(files.call("chmod", &[f, 0o644]), Reply::ok(0));
    assert_eq!(files.call("truncate", &[f, 100]), Reply::ok(0));
    assert_eq!(fs::metadata(files.file("f")).unwrap().len(), 100);
    assert_eq!(files.call("link", &[f, g]), Reply::ok(0));
    assert_eq!(files.call("unlink", &[g]), Reply::ok(0));
    assert_eq!(files.call("symlink", &[f, g]), Reply::ok(0));
    let length = files.file("f").as_os_str().len();
    assert_eq!(files.call("readlink", &[g, BUFFER, 4096]), Reply::ok(length as i32));
    assert_eq!(files.guest.read_text(BUFFER), files.file("f").to_str().unwrap());
    assert_eq!(files.call("mkdir", &[d, 0o700]), Reply::ok(0));
    assert_eq!(files.call("rmdir", &[d]), Reply::ok(0));
    assert_eq!(files.call("rmdir", &[d]), ENOENT);
    files.guest.store.write(BUFFER, &[0, 0, 0, 77, 0, 0, 0, 88]);
    assert_eq!(files.call("utime", &[f, BUFFER]), Reply::ok(0));
    assert_eq!(fs::metadata(files.file("f")).unwrap().mtime(), 88);
    files.guest.store.write(BUFFER, &[0, 0, 0, 7, 0, 0, 0, 1, 0, 0, 0, 9, 0, 0, 0, 2]);
    assert_eq!(files.call("utimes", &[f, BUFFER]), Reply::ok(0));
    let known = fs::metadata(files.file("f")).unwrap();
    assert_eq!((known.atime(), known.mtime(), known.mtime_nsec()), (7, 9, 2000));
    assert_ne!(files.call("ftok", &[f, 65]).value, -1);
}

#[test]
fn temporary_names() {
    let mut files = Files::new();
    let template = files.path("fXXXXXX");
    let fd = files.call("mkstemp", &[template]);
    assert!(fd.value > 2 && fd.errno == 0);
    assert!(PathBuf::from(files.guest.read_text(template)).is_file());
    files.call("close", &[fd.value as u32]);
    let template = files.path("gXXXXXX");
    assert_eq!(files.call("mktemp", &[template]), Reply::ok(template as i32));
    let name = files.guest.read_text(template);
    assert!(!name.ends_with("XXXXXX") && !PathBuf::from(name).exists());
    let bad = files.path("h");
    assert_eq!(files.call("mkstemp", &[bad]).errno, libc::EINVAL);
}

#[test]
fn the_working_directory() {
    let mut files = Files::new();
    assert_eq!(files.call("getcwd", &[BUFFER, 4096]), Reply::ok(BUFFER as i32));
    let here = std::env::current_dir().unwrap();
    assert_eq!(files.guest.read_text(BUFFER), here.to_str().unwrap());
    assert_eq!(files.call("getcwd", &[BUFFER, 0]), Reply::failed(0, libc::EINVAL));
    assert_eq!(files.call("getcwd", &[BUFFER, 3]), Reply::failed(0, libc::ERANGE));
    let here = files.guest.text(here.as_os_str().as_bytes());
    assert_eq!(files.call("chdir", &[here]), Reply::ok(0));
    let none = files.path("none");
    assert_eq!(files.call("chdir", &[none]), ENOENT);
}

#[test]
fn directories() {
    let mut files = Files::new();
    for name in ["a", "b"] {
        fs::write(files.file(name), "").unwrap();
    }
    let folder = files.path("");
    let directory = files.call("opendir", &[folder]);
    assert_eq!(directory.errno, 0);
    let directory = Value::Long(directory.doubleword());
    let call = |files: &mut Files, name: &str, argument: u32| {
        let cells = [directory.clone(), Value::Word(argument)];
        files.guest.serve(name, &cells)
    };
    let mut found = Vec::new();
    while call(&mut files, "readdir", BUFFER).value != 0 {
        let name = files.guest.read_text(BUFFER + 4);
        let known = fs::metadata(files.file(&name)).unwrap();
        assert_eq!(files.guest.words(BUFFER), [known.ino() as u32]);
        found.push(name);
    }
    assert_eq!(call(&mut files, "telldir", 0), Reply::ok(4));
    call(&mut files, "seekdir", 3);
    call(&mut files, "readdir", BUFFER);
    assert_eq!(files.guest.read_text(BUFFER + 4), found[3]);
    found.sort();
    assert_eq!(found, [".", "..", "a", "b"]);
    fs::write(files.file("c"), "").unwrap();
    assert_eq!(call(&mut files, "rewinddir", 0), Reply::ok(0));
    let entries = std::iter::repeat_with(|| call(&mut files, "readdir", BUFFER).value);
    assert_eq!(entries.take_while(|&value| value != 0).count(), 5);
    assert_eq!(call(&mut files, "closedir", 0), Reply::ok(0));
    for name in ["closedir", "telldir", "seekdir", "rewinddir"] {
        assert_eq!(call(&mut files, name, 0).errno, libc::EBADF, "{name}");
    }
    let none = files.path("none");
    let reply = files.call("opendir", &[none]);
    assert_eq!((reply.doubleword(), reply.errno), (0, libc::ENOENT));
}

#[test]
fn files_in_effective_address_space() {
    let mut files = Files::new();
    fs::write(files.file("f"), "in memory").unwrap();
    let fd = files.open("f", O_RDWR).value as u32;
    let map = |files: &mut Files, words: [u32; 5]| {
        let mut cells = vec![Value::Long(0)];
        cells.extend(words.map(Value::Word));
        files.guest.serve("mmap", &cells)
    };
    let private = map(&mut files, [100, 3, 2, fd, 0]);
    assert_eq!(private.errno, 0);
    assert!(private.doubleword() >= HEAP_EA && private.doubleword() % 4096 == 0);
    let anonymous = map(&mut files, [100, 3, 0x22, u32::MAX, 0]);
    assert_eq!(anonymous.errno, 0);
    assert_eq!(map(&mut files, [100, 3, 1, fd, 0]).errno, libc::ENOTSUP, "writes through");
    assert_eq!(map(&mut files, [0, 3, 2, fd, 0]).errno, libc::EINVAL);
    assert_eq!(map(&mut files, [100, 1, 2, u32::MAX, 0]).errno, libc::EBADF);
    assert_eq!(map(&mut files, [1 << 30, 1, 0x22, 0, 0]).errno, libc::ENOMEM);
    let at = |files: &mut Files, name: &str, words: [u32; 3]| {
        let mut cells = vec![Value::Long(private.doubleword())];
        cells.extend(words.map(Value::Word));
        files.guest.serve(name, &cells)
    };
    assert_eq!(at(&mut files, "msync", [100, 0, 0]), Reply::ok(0));
    assert_eq!(at(&mut files, "mremap", [100, 8192, 0]).errno, libc::ENOMEM);
    assert_eq!(at(&mut files, "mremap", [100, 8192, 1]).errno, 0);
    assert_eq!(at(&mut files, "munmap", [100, 0, 0]).errno, libc::EINVAL, "it has moved");
}

#[test]
fn time_and_process() {
    let mut files = Files::new();
    let now = std::time::SystemTime::now().duration_since(std::time::UNIX_EPOCH).unwrap();
    let now = now.as_secs() as u32;
    let returned = files.call("time", &[BUFFER]).value as u32;
    assert!(returned.wrapping_sub(now) < 60);
    assert_eq!(files.guest.words(BUFFER), [returned]);
    assert_eq!(files.call("gettimeofday", &[BUFFER, BUFFER + 16]), Reply::ok(0));
    let [seconds, microseconds] = files.guest.words(BUFFER);
    assert!(seconds.wrapping_sub(now) < 60 && microseconds < 1_000_000);
    files.guest.store.write(BUFFER, &[0, 0, 0, 0, 0, 0, 0, 9]);
    assert_eq!(files.call("nanosleep", &[BUFFER, BUFFER]), Reply::ok(0));
    assert_eq!(files.guest.words(BUFFER), [0, 0]);
    assert!(files.call("getpagesize", &[]).value >= 4096);
    let own = std::process::id();
    assert_eq!(files.call("kill", &[own, 0]), Reply::ok(0));
    assert_eq!(files.call("kill", &[u32::MAX, 9]), Reply::failed(-1, libc::EPERM));
    assert_eq!(files.call("waitpid", &[own, 0, 0]).errno, libc::ECHILD);
    assert_eq!(files.call("sched_yield", &[]), Reply::ok(0));
    let before = files.call("umask", &[0o22]).value;
    assert_eq!(files.call("umask", &[before as u32]), Reply::ok(0o22));
}

#[test]
fn unsupported_calls_report_an_error() {
    let mut files = Files::new();
    for name in ["adjtimex", "shmat", "shmctl", "shmdt", "shmget", "shm_open", "shm_unlink"] {
        assert_eq!(files.call(name, &[]), Reply::failed(-1, libc::ENOSYS), "{name}");
    }
}
