//! Binary glTF files, as examples and tests make them.

/// A file of its two chunks.
pub fn container(json: &[u8], blob: &[u8]) -> Vec<u8> {
    let padded = |bytes: &[u8], fill: u8| {
        let mut bytes = bytes.to_vec();
        bytes.resize(bytes.len().next_multiple_of(4), fill);
        bytes
    };
    let (json, blob) = (padded(json, b' '), padded(blob, 0));
    let word = |number: usize| (number as u32).to_le_bytes();
    let length = word(12 + 8 + json.len() + 8 + blob.len());
    let head = |bytes: &[u8], kind: &[u8]| [&word(bytes.len())[..], kind].concat();
    let (first, second) = (head(&json, b"JSON"), head(&blob, b"BIN\0"));
    [b"glTF", &word(2)[..], &length, &first, &json, &second, &blob].concat()
}
