use std::fs;
use std::os::unix::ffi::OsStrExt as _;

use spu_emulator::ppe_call::{CallError, Class};

use super::support::{GuestProgram, Reply};

const STDIN: u32 = 1;
const STDOUT: u32 = 2;
const BUFFER: u32 = 0x8000;
const SEEK_SET: u32 = 0;
const SEEK_END: u32 = 2;

struct Files {
    guest: GuestProgram,
    folder: tempfile::TempDir,
}

impl Files {
    fn new(input: &str) -> Self {
        Self { guest: GuestProgram::new(input), folder: tempfile::tempdir().unwrap() }
    }

    fn path(&mut self, name: &str) -> u32 {
        let path = self.folder.path().join(name);
        self.guest.text(path.as_os_str().as_bytes())
    }

    fn call(&mut self, name: &str, arguments: &[u32]) -> Reply {
        self.guest.call(name, arguments)
    }

    fn open(&mut self, name: &str, mode: &str) -> Reply {
        let (path, mode) = (self.path(name), self.guest.text(mode));
        self.call("fopen", &[path, mode])
    }

    fn put(&mut self, name: &str, text: &str) {
        fs::write(self.folder.path().join(name), text).unwrap();
    }

    fn contents(&self, name: &str) -> String {
        fs::read_to_string(self.folder.path().join(name)).unwrap()
    }
}

/// Provenance: C, 7.21.5.4.
#[test]
fn a_stream_reopens_its_own_file_in_another_mode() {
    let mut files = Files::new("");
    let (path, write, read, append) =
        (files.path("again"), files.guest.text("w"), files.guest.text("r"), files.guest.text("a"));
    let handle = files.call("fopen", &[path, write]).value as u32;
    let number = files.call("fileno", &[handle]).value;
    let text = files.guest.text("kept");
    files.call("fputs", &[text, handle]);
    let again = files.call("freopen", &[0, read, handle]);
    assert_eq!(again, Reply::ok(handle as i32));
    assert_eq!(files.call("fileno", &[handle]), Reply::ok(number));
    assert_eq!(files.call("fgets", &[BUFFER, 100, handle]), Reply::ok(BUFFER as i32));
    assert_eq!(files.guest.read_text(BUFFER), "kept");
    assert_eq!(files.call("freopen", &[0, append, handle]).value, handle as i32);
    assert_eq!(files.call("fgetc", &[handle]).errno, libc::EBADF);
    assert_eq!(files.call("fclose", &[handle]), Reply::ok(0));
    assert_eq!(files.call("freopen", &[0, read, handle]), Reply::failed(0, libc::EBADF));
}

#[test]
fn a_file_is_written_and_read_back() {
    let mut files = Files::new("");
    assert_eq!(files.open("f", "w"), Reply::ok(4));
    let text = files.guest.text("line one\nline two\n");
    assert_eq!(files.call("fputs", &[text, 4]), Reply::ok(1));
    assert_eq!(files.call("fwrite", &[text, 4, 2, 4]), Reply::ok(2));
    assert_eq!(files.call("fputc", &[0x121, 4]), Reply::ok(0x21));
    assert_eq!(files.call("ftell", &[4]), Reply::ok(27));
    assert_eq!(files.contents("f"), "", "it is buffered");
    assert_eq!(files.call("fflush", &[4]), Reply::ok(0));
    assert_eq!(files.contents("f"), "line one\nline two\nline one!");
    assert_eq!(files.call("fclose", &[4]), Reply::ok(0));
    assert_eq!(files.call("fclose", &[4]), Reply::failed(-1, libc::EBADF));

    assert_eq!(files.open("f", "r"), Reply::ok(4));
    assert_eq!(files.call("fgets", &[BUFFER, 6, 4]), Reply::ok(BUFFER as i32));
    assert_eq!(files.guest.read_text(BUFFER), "line ");
    assert_eq!(files.call("fgets", &[BUFFER, 100, 4]), Reply::ok(BUFFER as i32));
    assert_eq!(files.guest.read_text(BUFFER), "one\n");
    assert_eq!(files.call("fread", &[BUFFER, 4, 100, 4]), Reply::ok(4), "whole items");
    assert_eq!(files.guest.read_text(BUFFER), "line two\nline one!");
    assert_eq!(files.call("feof", &[4]), Reply::ok(1));
    assert_eq!(files.call("fgetc", &[4]), Reply::ok(-1));
    assert_eq!(files.call("fgets", &[BUFFER, 100, 4]), Reply::ok(0));
    files.call("rewind", &[4]);
    assert_eq!(files.call("feof", &[4]), Reply::ok(0));
    assert_eq!(files.call("fgetc", &[4]), Reply::ok(i32::from(b'l')));
}

#[test]
fn positions_count_what_is_buffered() {
    let mut files = Files::new("");
    files.put("f", "0123456789");
    files.open("f", "r+");
    files.call("fgetc", &[4]);
    files.call("fgetc", &[4]);
    assert_eq!(files.call("ungetc", &[u32::from(b'x'), 4]), Reply::ok(0x78));
    assert_eq!(files.call("ftell", &[4]), Reply::ok(1));
    assert_eq!(files.call("fgetc", &[4]), Reply::ok(0x78));
    assert_eq!(files.call("fgetpos", &[4, BUFFER]), Reply::ok(0));
    assert_eq!(files.guest.words(BUFFER), [2]);
    // Reading went ahead of this position, but the written bytes must follow where reading
    // stopped.
    files.call("fputc", &[u32::from(b'A'), 4]);
    assert_eq!(files.call("fseek", &[4, -1_i32 as u32, SEEK_END]), Reply::ok(0));
    assert_eq!(files.call("fgetc", &[4]), Reply::ok(i32::from(b'9')));
    assert_eq!(files.call("fsetpos", &[4, BUFFER]), Reply::ok(0));
    assert_eq!(files.call("fgetc", &[4]), Reply::ok(i32::from(b'A')));
    let bad = files.call("fseek", &[4, -5_i32 as u32, SEEK_SET]);
    assert_eq!(bad, Reply::failed(-1, libc::EINVAL));
    files.call("fclose", &[4]);
    assert_eq!(files.contents("f"), "01A3456789");
}

#[test]
fn thirteen_files_can_be_open() {
    let mut files = Files::new("");
    for handle in 4..=16 {
        assert_eq!(files.open("f", "w"), Reply::ok(handle));
    }
    assert_eq!(files.open("f", "w"), Reply::failed(0, libc::EMFILE));
    assert_eq!(files.call("tmpfile", &[]), Reply::failed(0, libc::EMFILE));
    files.call("fclose", &[7]);
    assert_eq!(files.call("tmpfile", &[]), Reply::ok(7));
    let text = files.guest.text("kept");
    files.call("fputs", &[text, 7]);
    files.call("rewind", &[7]);
    assert_eq!(files.call("fgetc", &[7]), Reply::ok(i32::from(b'k')));
}

#[test]
fn modes_and_errors_of_opening() {
    let mut files = Files::new("");
    assert_eq!(files.open("none", "r"), Reply::failed(0, libc::ENOENT));
    assert_eq!(files.open("f", "q"), Reply::failed(0, libc::EINVAL));
    assert_eq!(files.call("fopen", &[0, 0]), Reply::failed(0, libc::EFAULT));
    files.put("f", "old");
    assert_eq!(files.open("f", "wx"), Reply::failed(0, libc::EEXIST));
    files.open("f", "a");
    files.call("fputc", &[u32::from(b'!'), 4]);
    assert_eq!(files.call("fgetc", &[4]), Reply::failed(-1, libc::EBADF));
    assert_eq!(files.call("ferror", &[4]), Reply::ok(1));
    files.call("clearerr", &[4]);
    assert_eq!(files.call("ferror", &[4]), Reply::ok(0));
    let (path, mode) = (files.path("f"), files.guest.text("r"));
    assert_eq!(files.call("freopen", &[path, mode, 4]), Reply::ok(4));
    assert_eq!(files.contents("f"), "old!");
    assert_eq!(files.call("fputc", &[0, 4]), Reply::failed(-1, libc::EBADF));
    let (from, to) = (files.path("f"), files.path("g"));
    assert_eq!(files.call("rename", &[from, to]), Reply::ok(0));
    assert_eq!(files.contents("g"), "old!");
    assert_eq!(files.call("remove", &[to]), Reply::ok(0));
    assert_eq!(files.call("remove", &[to]), Reply::failed(-1, libc::ENOENT));
}

#[test]
fn standard_streams() {
    let mut files = Files::new("first line\nlast");
    let text = files.guest.text("text");
    assert_eq!(files.call("puts", &[text]), Reply::ok(5));
    assert_eq!(files.call("putchar", &[0x2a]), Reply::ok(0x2a));
    assert_eq!(files.guest.output(), "text\n*");
    assert_eq!(files.call("gets", &[BUFFER]), Reply::ok(BUFFER as i32));
    assert_eq!(files.guest.read_text(BUFFER), "first line");
    assert_eq!(files.call("getchar", &[]), Reply::ok(i32::from(b'l')));
    assert_eq!(files.call("gets", &[BUFFER]), Reply::ok(BUFFER as i32));
    assert_eq!(files.guest.read_text(BUFFER), "ast", "a line without an end");
    assert_eq!(files.call("gets", &[BUFFER]), Reply::ok(0));
    files.call("perror", &[text, libc::ENOENT as u32]);
    files.call("perror", &[0, libc::EACCES as u32]);
    let error = files.guest.console(|console| console.error.clone());
    assert_eq!(error, b"text: No such file or directory\nPermission denied\n");
    assert_eq!(files.call("fileno", &[STDOUT]), Reply::ok(1));
    assert_eq!(files.call("ungetc", &[u32::MAX, STDIN]), Reply::ok(-1));
}

/// Calls without a result leave the cell unchanged.
#[test]
fn buffering_is_the_programs_choice() {
    let mut files = Files::new("");
    let text = files.guest.text("a\nb");
    let written = |files: &Files| files.guest.console(|console| console.output.clone());
    files.call("fputs", &[text, STDOUT]);
    assert_eq!(written(&files), b"");
    assert_eq!(files.call("setvbuf", &[STDOUT, 0, 1, 0]), Reply::ok(0));
    files.call("fputs", &[text, STDOUT]);
    assert_eq!(written(&files), b"a\nba\nb");
    let untouched = files.call("setbuf", &[STDOUT, 0]);
    assert_eq!(untouched.value, STDOUT as i32);
    files.call("putchar", &[0x2e]);
    assert_eq!(written(&files), b"a\nba\nb.");
    let bad = files.call("setvbuf", &[STDOUT, 0, 3, 0]);
    assert_eq!(bad, Reply::failed(-1, libc::EINVAL));
}

#[test]
fn a_command_gives_its_status() {
    let mut files = Files::new("");
    let command = files.guest.text("exit 3");
    assert_eq!(files.call("system", &[command]), Reply::ok(3 << 8));
    assert_eq!(files.call("system", &[0]), Reply::ok(1), "there is a shell");
    assert_eq!(files.call("tmpnam", &[0]), Reply::ok(0));
}

#[test]
fn closed_handles_fail() {
    let mut files = Files::new("");
    for handle in [0, 5, 17, u32::MAX] {
        assert_eq!(files.call("feof", &[handle]), Reply::failed(-1, libc::EBADF));
        let put = files.call("fputc", &[0, handle]);
        assert_eq!(put, Reply::failed(-1, libc::EBADF));
        let read = files.call("fread", &[BUFFER, 1, 1, handle]);
        assert_eq!(read, Reply::failed(0, libc::EBADF));
    }
}

#[test]
fn sizes_beyond_local_store() {
    let mut files = Files::new("");
    files.open("f", "w");
    let written = files.call("fwrite", &[0, 0x1_0000, 0x1_0000, 4]);
    assert_eq!(written, Reply::ok(4), "local store once");
    assert_eq!(files.call("fwrite", &[0, 0, 5, 4]), Reply::ok(0));
    assert_eq!(files.call("fread", &[0, 0, 5, STDIN]), Reply::ok(0));
}

#[test]
fn unsupported_calls_are_named() {
    let mut guest = GuestProgram::new("");
    let error = guest.serve_opcode(7, 1, &[]).unwrap_err();
    assert_eq!(error, CallError::UnknownClass(7));
    assert!(error.to_string().contains("0x2107"), "{error}");
    for (class, number, last) in [(Class::C99, 0, 41), (Class::Posix, 1, 68), (Class::Libea, 5, 5)]
    {
        for opcode in [0, last as u8 + 1, 255] {
            let expected = CallError::UnknownOpcode { class, opcode, last };
            assert_eq!(guest.serve_opcode(number, opcode, &[]), Err(expected));
        }
    }
    // The first and last functions of the lists, and some between.
    let name = |class: Class, opcode| class.function(opcode).unwrap();
    assert_eq!(
        [1, 10, 21, 41].map(|n| name(Class::C99, n)),
        ["clearerr", "fopen", "gets", "vsscanf"]
    );
    let posix = [1, 16, 23, 27, 31, 43, 57, 68].map(|n| name(Class::Posix, n));
    let expected = ["adjtimex", "read", "stat", "write", "time", "getcwd", "readdir", "writev"];
    assert_eq!(posix, expected);
}
