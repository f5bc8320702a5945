//! Reads the numbers of an accessor, with a check of every bound.

use gltf::Accessor;
use gltf::accessor::{DataType, Dimensions};

use crate::Fault;

/// Vectors of three numbers.
pub(super) fn vectors(accessor: &Accessor<'_>, blob: &[u8]) -> Result<Vec<[f32; 3]>, Fault> {
    let kind = (accessor.data_type(), accessor.dimensions());
    if kind != (DataType::F32, Dimensions::Vec3) {
        return Err(wrong(accessor, "is not of three floats"));
    }
    let number = |bytes: &[u8]| f32::from_le_bytes([bytes[0], bytes[1], bytes[2], bytes[3]]);
    let vector = |bytes: &[u8]| [number(bytes), number(&bytes[4..]), number(&bytes[8..])];
    Ok(items(accessor, blob, 12)?.map(vector).collect())
}

/// Texture coordinates: floats, or parts of the greatest number.
pub(super) fn coordinates(accessor: &Accessor<'_>, blob: &[u8]) -> Result<Vec<[f32; 2]>, Fault> {
    let size = match (accessor.data_type(), accessor.dimensions()) {
        (DataType::F32, Dimensions::Vec2) => 4,
        (DataType::U16, Dimensions::Vec2) => 2,
        (DataType::U8, Dimensions::Vec2) => 1,
        _ => return Err(wrong(accessor, "is not of two texture coordinates")),
    };
    let number = |bytes: &[u8]| match *bytes {
        [a, b, c, d] => f32::from_le_bytes([a, b, c, d]),
        [a, b] => f32::from(u16::from_le_bytes([a, b])) / 65535.0,
        [a, ..] => f32::from(a) / 255.0,
        [] => 0.0,
    };
    let pair = |item: &[u8]| [number(&item[..size]), number(&item[size..])];
    Ok(items(accessor, blob, 2 * size)?.map(pair).collect())
}

/// Indices of vertices.
pub(super) fn indices(accessor: &Accessor<'_>, blob: &[u8]) -> Result<Vec<i64>, Fault> {
    let size = match (accessor.data_type(), accessor.dimensions()) {
        (DataType::U8, Dimensions::Scalar) => 1,
        (DataType::U16, Dimensions::Scalar) => 2,
        (DataType::U32, Dimensions::Scalar) => 4,
        _ => return Err(wrong(accessor, "is not of unsigned numbers")),
    };
    let index = |bytes: &[u8]| {
        let bytes = bytes.iter().rev();
        bytes.fold(0, |sum, &byte| sum << 8 | i64::from(byte))
    };
    Ok(items(accessor, blob, size)?.map(index).collect())
}

/// The items of an accessor, `size` bytes each.
fn items<'a>(
    accessor: &Accessor<'_>,
    blob: &'a [u8],
    size: usize,
) -> Result<impl Iterator<Item = &'a [u8]>, Fault> {
    let view = accessor.view().filter(|_| accessor.sparse().is_none());
    let Some(view) = view else {
        return Err(wrong(accessor, "is sparse, which is not supported"));
    };
    if !matches!(view.buffer().source(), gltf::buffer::Source::Bin) {
        return Err(wrong(
            accessor,
            "is in another file, which is not supported",
        ));
    }
    let stride = view.stride().unwrap_or(size).max(size);
    let outside = || {
        let (count, there) = (accessor.count(), blob.len());
        wrong(
            accessor,
            &format!(
                "has {count} items, which are not all in the {there} bytes of the binary chunk"
            ),
        )
    };
    let part = view.offset().checked_add(view.length());
    let part = part.and_then(|end| blob.get(view.offset()..end));
    let part = part
        .and_then(|part| part.get(accessor.offset()..))
        .ok_or_else(outside)?;
    let count = accessor.count();
    let bytes = match count.checked_sub(1) {
        None => Some(0),
        Some(gaps) => gaps
            .checked_mul(stride)
            .and_then(|start| start.checked_add(size)),
    };
    let part = bytes
        .and_then(|bytes| part.get(..bytes))
        .ok_or_else(outside)?;
    Ok(part.chunks(stride).map(move |item| &item[..size]))
}

fn wrong(accessor: &Accessor<'_>, what: &str) -> Fault {
    Fault::Glb(format!("accessor {} {what}", accessor.index()))
}
