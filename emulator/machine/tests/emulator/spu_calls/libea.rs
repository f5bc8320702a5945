use super::support::{GuestProgram, HEAP, HEAP_EA, Reply, Value};

fn call(guest: &mut GuestProgram, name: &str, arguments: &[u64]) -> Reply {
    let cells: Vec<Value> = arguments.iter().map(|&value| Value::Long(value)).collect();
    guest.serve(name, &cells)
}

#[test]
fn memory_comes_and_goes() {
    let mut guest = GuestProgram::new("");
    let all = call(&mut guest, "malloc", &[HEAP as u64]);
    assert_eq!((all.doubleword(), all.errno), (HEAP_EA, 0));
    let none = call(&mut guest, "malloc", &[1]);
    assert_eq!((none.doubleword(), none.errno), (0, libc::ENOMEM));
    call(&mut guest, "free", &[HEAP_EA]);
    call(&mut guest, "free", &[0]);
    call(&mut guest, "free", &[0xdead]);
    let half = call(&mut guest, "calloc", &[HEAP as u64 / 8, 4]).doubleword();
    assert_eq!(half, HEAP_EA);
    let wraps = call(&mut guest, "calloc", &[1 << 40, 1 << 40]);
    assert_eq!((wraps.doubleword(), wraps.errno), (0, libc::ENOMEM));
    let grown = call(&mut guest, "realloc", &[half, HEAP as u64]);
    assert_eq!(grown.doubleword(), 0, "there is no space beside the old one");
    let shrunk = call(&mut guest, "realloc", &[half, 16]).doubleword();
    assert_ne!(shrunk, 0);
    assert_eq!(call(&mut guest, "realloc", &[shrunk, 0]).doubleword(), 0);
    assert_eq!(call(&mut guest, "realloc", &[0, HEAP as u64]).doubleword(), HEAP_EA);
}

#[test]
fn aligned_memory_answers_by_error_number() {
    let mut guest = GuestProgram::new("");
    let mut memalign = |alignment, size| {
        let cells = [Value::Word(0x8000), Value::Long(alignment), Value::Long(size)];
        let reply = guest.serve("posix_memalign", &cells);
        let [high, low] = guest.words(0x8000);
        (reply.value, u64::from(high) << 32 | u64::from(low))
    };
    assert_eq!(memalign(16, 1), (0, HEAP_EA));
    let (result, ea) = memalign(4096, 100);
    assert_eq!((result, ea % 4096), (0, 0));
    for alignment in [0, 4, 24] {
        assert_eq!(memalign(alignment, 1).0, libc::EINVAL);
    }
    assert_eq!(memalign(16, 1 << 40).0, libc::ENOMEM);
}
