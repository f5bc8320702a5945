//! Wide characters: 32 bits in the guest, UTF-8 in files.

use super::Errno;

/// Size in bytes of the guest's `wchar_t`.
pub(super) const CHARACTER: u32 = 4;
/// The largest number of bytes of a character.
pub(super) const LONGEST: usize = 4;
/// Why a conversion fails.
pub(super) const INVALID: Errno = Errno(libc::EILSEQ);

/// The character of these bytes, or `None` if more bytes belong to it.
pub(super) fn decode(bytes: &[u8]) -> Result<Option<char>, Errno> {
    match std::str::from_utf8(bytes) {
        Ok(text) => Ok(text.chars().next()),
        Err(error) if error.error_len().is_none() => Ok(None),
        Err(_) => Err(INVALID),
    }
}

/// The bytes of a character.
pub(super) fn encode(character: u32) -> Result<Vec<u8>, Errno> {
    let character = char::from_u32(character).ok_or(INVALID)?;
    Ok(character.to_string().into_bytes())
}
