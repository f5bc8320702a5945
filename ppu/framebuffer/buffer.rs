//! Private memory for one frame, zeroed and aligned for the fastest DMA.
//!
//! Invariant: base and stride are multiples of 128 bytes, the MFC's line, so every row starts a
//! line.

use super::{FramebufferError, Geometry, PIXEL_BYTES, PixelFormat, Target};
use std::alloc::{self, Layout};
use std::ptr::NonNull;

/// The bytes of a line: the MFC is fastest with transfers of whole lines.
const LINE: usize = 128;

/// One frame, which is written through [`FrameBuffer::target`] in the pixel format that the caller
/// passes there.
pub(super) struct FrameBuffer {
    base: NonNull<u8>,
    layout: Layout,
    stride: u32,
    geometry: Geometry,
}

// SAFETY: the allocation belongs only to this value, and isn't tied to a thread.
unsafe impl Send for FrameBuffer {}

impl FrameBuffer {
    pub(super) fn new(geometry: Geometry) -> Result<FrameBuffer, FramebufferError> {
        geometry.check()?;
        let stride = (geometry.width * PIXEL_BYTES).next_multiple_of(LINE as u32);
        let bytes = stride as usize * geometry.height as usize;
        let out_of_memory = || FramebufferError::OutOfMemory { bytes };
        let layout = Layout::from_size_align(bytes, LINE).map_err(|_| out_of_memory())?;
        // SAFETY: both sides are at least 1, so the layout's size is not zero.
        let base =
            NonNull::new(unsafe { alloc::alloc_zeroed(layout) }).ok_or_else(out_of_memory)?;
        Ok(FrameBuffer { base, layout, stride, geometry })
    }

    pub(super) fn geometry(&self) -> Geometry {
        self.geometry
    }

    pub(super) fn stride(&self) -> u32 {
        self.stride
    }

    pub(super) fn target(&mut self, format: PixelFormat) -> Target {
        Target {
            base: self.base,
            bytes: self.layout.size(),
            stride: self.stride,
            geometry: self.geometry,
            format,
        }
    }

    /// The rows from top to bottom, without padding.
    pub(super) fn rows(&self) -> impl Iterator<Item = &[u8]> {
        let shown = self.geometry.shown_row_bytes();
        self.bytes().chunks_exact(self.stride as usize).map(move |row| &row[..shown])
    }

    /// The same rows, to draw in.
    pub(super) fn rows_mut(&mut self) -> impl Iterator<Item = &mut [u8]> {
        let (shown, stride) = (self.geometry.shown_row_bytes(), self.stride as usize);
        // SAFETY: the allocation has this length and is initialised. By Target's rule nobody
        // writes through an older target while a method of the framebuffer runs, and the borrow of
        // `self` excludes all other access.
        let bytes =
            unsafe { std::slice::from_raw_parts_mut(self.base.as_ptr(), self.layout.size()) };
        bytes.chunks_exact_mut(stride).map(move |row| &mut row[..shown])
    }

    fn bytes(&self) -> &[u8] {
        // SAFETY: the allocation has this length and is initialised. By Target's rule nobody
        // writes through an older target while a method of the framebuffer runs.
        unsafe { std::slice::from_raw_parts(self.base.as_ptr(), self.layout.size()) }
    }
}

impl Drop for FrameBuffer {
    fn drop(&mut self) {
        // SAFETY: `new` allocated it with this layout.
        unsafe { alloc::dealloc(self.base.as_ptr(), self.layout) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn frames_are_line_aligned_and_black() {
        for (width, height, stride) in
            [(1, 1, 128), (32, 2, 128), (33, 2, 256), (101, 57, 512), (1280, 720, 5120)]
        {
            let mut frame = FrameBuffer::new(Geometry { width, height }).unwrap();
            let target = frame.target(PixelFormat::ARGB);
            assert_eq!(target.base.as_ptr() as usize % LINE, 0);
            assert_eq!((target.stride, target.bytes), (stride, (stride * height) as usize));
            assert!(target.stride >= target.geometry.written_row_bytes());
            assert_eq!(frame.rows().count(), height as usize);
            assert!(frame.rows().all(|row| row.len() == width as usize * 4 && row.iter().all(|&byte| byte == 0)));
        }
    }
}
