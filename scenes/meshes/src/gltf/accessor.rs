//! Reads the numbers of accessors, with a check of every bound.

use std::borrow::Cow;

use super::json::{Accessor, Root};
use super::wrong;
use crate::Fault;
use crate::builder::MAX_TRIANGLES;

/// The most items of an accessor: three corners of each triangle.
const MAX_ITEMS: usize = 3 * MAX_TRIANGLES;

/// A file's JSON and its buffers.
pub(super) struct Data<'a> {
    pub root: &'a Root,
    /// The bytes of each buffer, or why there are none.
    pub buffers: Vec<Result<Cow<'a, [u8]>, String>>,
    /// Whether whole numbers that are not said to be normalised are to be taken as they are.
    pub is_quantised: bool,
}

/// What an accessor is for.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Use {
    /// Whole numbers are taken as they are.
    Positions,
    /// Whole numbers are parts of the largest one, unless the file is quantised.
    Shares,
    Indices,
}

/// A type of components.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Component {
    I8,
    U8,
    I16,
    U16,
    U32,
    F32,
}

impl Component {
    fn of(number: u32) -> Option<Self> {
        Some(match number {
            5120 => Self::I8,
            5121 => Self::U8,
            5122 => Self::I16,
            5123 => Self::U16,
            5125 => Self::U32,
            5126 => Self::F32,
            _ => return None,
        })
    }

    fn size(self) -> usize {
        match self {
            Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 => 2,
            Self::U32 | Self::F32 => 4,
        }
    }

    /// The number that is 1 if numbers are normalised.
    fn most(self) -> f64 {
        match self {
            Self::I8 => f64::from(i8::MAX),
            Self::U8 => f64::from(u8::MAX),
            Self::I16 => f64::from(i16::MAX),
            Self::U16 => f64::from(u16::MAX),
            Self::U32 => f64::from(u32::MAX),
            Self::F32 => 1.0,
        }
    }

    /// The number whose bytes these are.
    fn number(self, bytes: &[u8]) -> f64 {
        match (self, bytes) {
            (Self::I8, &[a, ..]) => f64::from(a as i8),
            (Self::U8, &[a, ..]) => f64::from(a),
            (Self::I16, &[a, b, ..]) => f64::from(i16::from_le_bytes([a, b])),
            (Self::U16, &[a, b, ..]) => f64::from(u16::from_le_bytes([a, b])),
            (Self::U32, &[a, b, c, d, ..]) => f64::from(u32::from_le_bytes([a, b, c, d])),
            (Self::F32, &[a, b, c, d, ..]) => f64::from(f32::from_le_bytes([a, b, c, d])),
            _ => 0.0,
        }
    }
}

/// The components of an item of this type. Other matrices than these are not read.
fn components(kind: &str) -> Option<usize> {
    Some(match kind {
        "SCALAR" => 1,
        "VEC2" => 2,
        "VEC3" => 3,
        "VEC4" => 4,
        "MAT4" => 16,
        _ => return None,
    })
}

impl Data<'_> {
    /// The number of an accessor's items; 0 if there is no such accessor.
    pub fn count(&self, index: usize) -> usize {
        self.root.accessors.get(index).map_or(0, |accessor| accessor.count)
    }

    /// The items of an accessor. Of longer ones the first `N` components are taken, of shorter ones
    /// the others are 1.
    pub fn read<const N: usize>(
        &self,
        index: usize,
        purpose: Use,
        allowed: &[&str],
    ) -> Result<Vec<[f64; N]>, Fault> {
        let wrong = |what: String| wrong(format!("accessor {index} {what}"));
        let accessor = self.root.accessors.get(index);
        let accessor = accessor.ok_or_else(|| wrong("doesn't exist".into()))?;
        let Accessor { kind, count, .. } = accessor;
        let width = components(kind).filter(|_| allowed.contains(&kind.as_str()));
        let width = width.ok_or_else(|| {
            wrong(format!("has items of the type \"{kind}\", not of {}", allowed.join(" or ")))
        })?;
        let component = Component::of(accessor.component_type).filter(|it| {
            let is_whole = matches!(it, Component::U8 | Component::U16 | Component::U32);
            purpose != Use::Indices || is_whole
        });
        let component = component.ok_or_else(|| {
            let number = accessor.component_type;
            wrong(format!("has components of the type {number}, which is not one for this use"))
        })?;
        if *count > MAX_ITEMS {
            return Err(wrong(format!("has {count} items; the most is {MAX_ITEMS}")));
        }
        let normalises = component != Component::F32
            && match purpose {
                Use::Indices => false,
                Use::Positions => accessor.normalized,
                Use::Shares => accessor.normalized || !self.is_quantised,
            };
        let scale = if normalises { component.most() } else { 1.0 };
        let item = |bytes: &[u8]| -> [f64; N] {
            std::array::from_fn(|place| {
                if place >= width {
                    return 1.0;
                }
                let number = component.number(&bytes[place * component.size()..]) / scale;
                if normalises { number.max(-1.0) } else { number }
            })
        };
        let size = width * component.size();
        // An accessor without a view is zeros, which a sparse part may replace.
        let mut items: Vec<[f64; N]> = match accessor.buffer_view {
            Some(view) => self
                .items(view, accessor.byte_offset, *count, size)
                .map_err(&wrong)?
                .map(item)
                .collect(),
            None => vec![item(&[0; 64]); *count],
        };
        let Some(sparse) = &accessor.sparse else {
            return Ok(items);
        };
        let kind = Component::of(sparse.indices.component_type)
            .filter(|it| matches!(it, Component::U8 | Component::U16 | Component::U32))
            .ok_or_else(|| wrong("has sparse indices of an unknown type".into()))?;
        let part = &sparse.indices;
        let indices = self
            .items(part.buffer_view, part.byte_offset, sparse.count, kind.size())
            .map_err(&wrong)?;
        let part = &sparse.values;
        let values =
            self.items(part.buffer_view, part.byte_offset, sparse.count, size).map_err(&wrong)?;
        for (at, value) in indices.zip(values) {
            let at = kind.number(at) as usize;
            let count = items.len();
            *items
                .get_mut(at)
                .ok_or_else(|| wrong(format!("has a sparse item {at} of {count}")))? = item(value);
        }
        Ok(items)
    }

    pub fn view(&self, index: usize) -> Result<&[u8], String> {
        let view = self.root.buffer_views.get(index);
        let view = view.ok_or_else(|| format!("has buffer view {index}, which doesn't exist"))?;
        let buffer = self.buffers.get(view.buffer);
        let buffer =
            buffer.ok_or_else(|| format!("has buffer {}, which doesn't exist", view.buffer))?;
        let bytes =
            buffer.as_ref().map_err(|what| format!("has buffer {}, but {what}", view.buffer))?;
        let end = view.byte_offset.checked_add(view.byte_length);
        let part = end.and_then(|end| bytes.get(view.byte_offset..end));
        part.ok_or_else(|| {
            format!(
                "has buffer view {index} of {} bytes from {} on, which are not all in the {} bytes of buffer {}",
                view.byte_length,
                view.byte_offset,
                bytes.len(),
                view.buffer
            )
        })
    }

    /// Items of `size` bytes each in a view, from an offset on.
    fn items(
        &self,
        view: usize,
        offset: usize,
        count: usize,
        size: usize,
    ) -> Result<impl Iterator<Item = &[u8]>, String> {
        let whole = self.view(view)?;
        let stride = self.root.buffer_views[view].byte_stride;
        let stride = stride.unwrap_or(size).max(size);
        let needed = match count.checked_sub(1) {
            None => Some(0),
            Some(gaps) => gaps.checked_mul(stride).and_then(|it| it.checked_add(size)),
        };
        let part = whole.get(offset..);
        let part = part.zip(needed).and_then(|(part, needed)| part.get(..needed));
        let part = part.ok_or_else(|| {
            format!(
                "has {count} items, which are not all in the {} bytes of buffer view {view}",
                whole.len()
            )
        })?;
        Ok(part.chunks(stride).map(move |item| &item[..size]))
    }
}
