//! Arrays of two dimensions as numpy stores them.

use super::{Map, allowed};
use crate::Fault;

/// Reads an array: a mark, a version, the header's length, the header, and the numbers.
pub(super) fn read(bytes: &[u8]) -> Result<Map, Fault> {
    let wrong = |what: &str| Fault::HeightMap(what.to_owned());
    let ends = || wrong("the file ends inside its header");
    let rest = bytes.strip_prefix(crate::NPY_MARK);
    let rest = rest.ok_or_else(|| wrong("it doesn't begin as an array of numpy"))?;
    let (length, rest) = match *rest {
        [1, _, a, b, ref rest @ ..] => (u32::from(u16::from_le_bytes([a, b])), rest),
        [2 | 3, _, a, b, c, d, ref rest @ ..] => (u32::from_le_bytes([a, b, c, d]), rest),
        [version, ..] if version > 3 || version == 0 => {
            return Err(wrong(&format!(
                "its version is {version}; those that are read are 1 to 3"
            )));
        }
        _ => return Err(ends()),
    };
    let (header, numbers) = rest.split_at_checked(length as usize).ok_or_else(ends)?;
    let header = String::from_utf8_lossy(header);
    let field = |name: &str| {
        let (_, value) = header.split_once(&format!("'{name}':"))?;
        Some(value.trim_start())
    };
    let missing = |name: &str| wrong(&format!("its header has no {name}"));
    let kind = field("descr").ok_or_else(|| missing("descr"))?;
    let kind = kind.split('\'').nth(1).unwrap_or_default();
    let by_columns = field("fortran_order").ok_or_else(|| missing("fortran_order"))?;
    let by_columns = by_columns.starts_with("True");
    let shape = field("shape").and_then(|value| value.strip_prefix('(')?.split_once(')'));
    let (shape, _) = shape.ok_or_else(|| missing("shape"))?;
    let sides: Result<Vec<u64>, _> =
        shape.split(',').map(str::trim).filter(|side| !side.is_empty()).map(str::parse).collect();
    let Ok(&[rows, columns]) = sides.as_deref() else {
        return Err(wrong(&format!("its shape is ({shape}); a height map has two dimensions")));
    };
    let size = [columns, rows].map(|side| u32::try_from(side).unwrap_or(u32::MAX));
    let [columns, rows] = allowed(size)?.map(|side| side as usize);
    let decoded: Option<Vec<f64>> = match kind {
        "|u1" => values(numbers, columns * rows, |[byte]: [u8; 1]| byte.into()),
        "<i2" => values(numbers, columns * rows, |bytes| i16::from_le_bytes(bytes).into()),
        ">i2" => values(numbers, columns * rows, |bytes| i16::from_be_bytes(bytes).into()),
        "<u2" => values(numbers, columns * rows, |bytes| u16::from_le_bytes(bytes).into()),
        ">u2" => values(numbers, columns * rows, |bytes| u16::from_be_bytes(bytes).into()),
        "<f4" => values(numbers, columns * rows, |bytes| f32::from_le_bytes(bytes).into()),
        ">f4" => values(numbers, columns * rows, |bytes| f32::from_be_bytes(bytes).into()),
        "<f8" => values(numbers, columns * rows, f64::from_le_bytes),
        ">f8" => values(numbers, columns * rows, f64::from_be_bytes),
        _ => {
            return Err(wrong(&format!(
                "its numbers are of the type {kind:?}; those that are read are u1, i2, u2, f4 and \
                 f8"
            )));
        }
    };
    let Some(mut heights) = decoded else {
        return Err(wrong(&format!(
            "its header states {rows} x {columns} numbers of type {kind}, and {} bytes follow",
            numbers.len()
        )));
    };
    if by_columns {
        let places = (0..rows).flat_map(|row| (0..columns).map(move |column| column * rows + row));
        heights = places.map(|at| heights[at]).collect();
    }
    Ok(Map { size, heights, scale: None, notes: Vec::new() })
}

/// All numbers of an array, if there are as many bytes.
fn values<const N: usize>(bytes: &[u8], count: usize, of: fn([u8; N]) -> f64) -> Option<Vec<f64>> {
    let (chunks, rest) = bytes.as_chunks::<N>();
    (chunks.len() == count && rest.is_empty()).then(|| chunks.iter().map(|it| of(*it)).collect())
}
