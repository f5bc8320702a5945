//! Buffers and images: in the binary chunk, in data URIs, or in files beside the glTF file.

use std::borrow::Cow;
use std::path::{Path, PathBuf};

use base64::Engine as _;
use base64::alphabet::STANDARD;
use base64::engine::{DecodePaddingMode, GeneralPurpose, GeneralPurposeConfig};
use percent_encoding::percent_decode_str;

/// Base64, with or without the signs that fill its last group.
const BASE64: GeneralPurpose = GeneralPurpose::new(
    &STANDARD,
    GeneralPurposeConfig::new()
        .with_decode_padding_mode(DecodePaddingMode::Indifferent)
        .with_decode_allow_trailing_bits(true),
);
/// The most characters of a URI that a message repeats.
const SHOWN: usize = 60;

/// The bytes that a URI of a file in `folder` means, or why there are none.
pub(super) fn bytes(uri: &str, folder: &Path) -> Result<Cow<'static, [u8]>, String> {
    if let Some(data) = uri.strip_prefix("data:") {
        let (kind, data) = data.split_once(',').ok_or("its data URI has no comma")?;
        let decoded: Vec<u8> = percent_decode_str(data).collect();
        if !kind.ends_with(";base64") {
            return Ok(decoded.into());
        }
        let text: Vec<u8> =
            decoded.into_iter().filter(|byte| !byte.is_ascii_whitespace()).collect();
        let found = BASE64.decode(text);
        return found
            .map(Cow::Owned)
            .map_err(|error| format!("its data URI is not valid base64: {error}"));
    }
    let scheme = uri.split_once("://").map(|(scheme, _)| scheme);
    let is_elsewhere = scheme.is_some_and(|it| it.chars().all(|sign| sign.is_ascii_alphanumeric()));
    if is_elsewhere {
        let start: String = uri.chars().take(SHOWN).collect();
        return Err(format!("it is at {start}; only files beside this one are read"));
    }
    let path = path(uri, folder);
    crate::bytes(&path).map(Cow::Owned).map_err(|fault| format!("{}: {fault}", path.display()))
}

/// The file of a relative URI. Some programs don't encode the names of files, so a name that exists
/// as it stands is taken so.
fn path(uri: &str, folder: &Path) -> PathBuf {
    let plain = folder.join(uri);
    if plain.is_file() {
        return plain;
    }
    let decoded = percent_decode_str(uri).decode_utf8_lossy();
    folder.join(decoded.replace('\\', "/"))
}
