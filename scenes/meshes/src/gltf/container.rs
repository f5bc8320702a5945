//! The binary container of glTF: a header, then chunks of JSON and of binary data.

use super::wrong;
use crate::Fault;

/// Bytes of the container's header, and of each chunk's.
const HEADER: usize = 12;
const CHUNK_HEADER: usize = 8;

pub(super) struct Chunks<'a> {
    pub json: &'a [u8],
    pub binary: Option<&'a [u8]>,
}

/// Takes a binary file apart.
pub(super) fn chunks(bytes: &[u8]) -> Result<Chunks<'_>, Fault> {
    let there = bytes.len();
    if !bytes.starts_with(b"glTF") {
        return Err(wrong("it doesn't begin with \"glTF\"".into()));
    }
    if there < HEADER {
        return Err(wrong(format!("it has {there} bytes, less than a header")));
    }
    let version = word(bytes, 4);
    if version != 2 {
        return Err(wrong(format!("its container has version {version}; only glTF 2.0 is read")));
    }
    let length = word(bytes, 8);
    if !(HEADER..=there).contains(&length) {
        return Err(wrong(format!("its header states {length} bytes, but it has {there}")));
    }
    let (mut json, mut binary) = (None, None);
    let mut rest = &bytes[HEADER..length];
    while rest.len() >= CHUNK_HEADER {
        let size = word(rest, 0);
        let kind = &rest[4..CHUNK_HEADER];
        let Some(chunk) = rest.get(CHUNK_HEADER..CHUNK_HEADER + size) else {
            let left = rest.len() - CHUNK_HEADER;
            return Err(wrong(format!("a chunk of {size} bytes is in the last {left} bytes")));
        };
        match kind {
            b"JSON" => json = json.or(Some(chunk)),
            b"BIN\0" => binary = binary.or(Some(chunk)),
            _ => {}
        }
        rest = &rest[CHUNK_HEADER + size..];
    }
    let json: &[u8] = json.ok_or_else(|| wrong("it has no JSON chunk".into()))?;
    // Some programs fill the chunk with zeros instead of blanks.
    let end = json.iter().rposition(|&byte| byte != 0).map_or(0, |last| last + 1);
    let json = &json[..end];
    Ok(Chunks { json, binary })
}

fn word(bytes: &[u8], at: usize) -> usize {
    u32::from_le_bytes([bytes[at], bytes[at + 1], bytes[at + 2], bytes[at + 3]]) as usize
}
