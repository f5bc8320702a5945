//! A framebuffer with text over its frames.
//!
//! The SPUs write to the visible memory, and keep what is already there. So before they write to a
//! page again, the pixels under the text are put back.

use std::cell::Cell;
use std::slice;
use std::sync::{Arc, Mutex, PoisonError};

use cellray::framebuffer::{Framebuffer, FramebufferError, Geometry, Target};

use super::layout::Rectangle;
use super::paint::{Canvas, Painter};
use crate::overlay::Overlay;

/// A framebuffer with text over its frames.
pub struct Printed {
    inner: Box<dyn Framebuffer>,
    geometry: Geometry,
    overlay: Arc<Mutex<Overlay>>,
    painter: Painter,
    /// The buffer of the coming frame, as long as it may be written to.
    target: Cell<Option<Open>>,
    pages: Vec<Page>,
}

/// A target that may still be written to.
struct Open(Target);

// SAFETY: The address is only used through a `Printed` that is borrowed exclusively, and the memory
// belongs to its inner framebuffer, which may be sent to another thread together with it.
unsafe impl Send for Open {}

struct Page {
    address: usize,
    /// Rows of pixels under the text: the index of the first word, and the words.
    under: Vec<(usize, Vec<u32>)>,
}

impl Printed {
    /// Shows `overlay` over the frames of a framebuffer.
    pub fn new(inner: Box<dyn Framebuffer>, overlay: Arc<Mutex<Overlay>>) -> Self {
        Self {
            geometry: inner.geometry(),
            inner,
            overlay,
            painter: Painter::default(),
            target: Cell::new(None),
            pages: Vec::new(),
        }
    }

    /// The words of a target.
    ///
    /// # Safety
    /// No method of the inner framebuffer was called since it has returned the target, and nothing
    /// else uses its memory while the slice exists.
    unsafe fn words<'a>(target: Target) -> &'a mut [u32] {
        // SAFETY: A target is aligned to more than a word, and its bytes may be written to until
        // the next call, as the caller promises.
        unsafe { slice::from_raw_parts_mut(target.base.as_ptr().cast(), target.bytes / 4) }
    }

    fn print(&mut self, target: Target) {
        let overlay = self.overlay.lock().unwrap_or_else(PoisonError::into_inner);
        let area = (self.geometry.width as usize, self.geometry.height as usize);
        let picture = ((0, 0), area);
        let layout = self.painter.place(&overlay, area, picture);
        if layout.rectangles().next().is_none() {
            return;
        }
        // SAFETY: The target is the one that was returned last; the SPUs have ended their transfers
        // before `present` is called.
        let words = unsafe { Self::words(target) };
        let stride = target.stride as usize / 4;
        self.pages.push(Page {
            address: target.base.as_ptr().addr(),
            under: saved(layout.rectangles(), area, words, stride),
        });
        let mut canvas = Canvas { words, stride, area, format: target.format };
        self.painter.paint(&overlay, picture, &mut canvas);
    }
}

/// The pixels in rectangles, as far as they are in the area, row by row.
fn saved(
    rectangles: impl Iterator<Item = Rectangle>,
    area: (usize, usize),
    words: &[u32],
    stride: usize,
) -> Vec<(usize, Vec<u32>)> {
    let rows = rectangles.flat_map(|((left, top), (width, height))| {
        let (right, bottom) = ((left + width).min(area.0), (top + height).min(area.1));
        (top..bottom).map(move |y| y * stride + left..y * stride + right.max(left))
    });
    rows.filter_map(|row| Some((row.start, words.get(row)?.to_vec()))).collect()
}

impl Framebuffer for Printed {
    fn geometry(&self) -> Geometry {
        self.geometry
    }

    fn target(&mut self) -> Target {
        let target = self.inner.target();
        let address = target.base.as_ptr().addr();
        let page = self.pages.iter().position(|page| page.address == address);
        if let Some(number) = page {
            // SAFETY: The target was returned just now, and nobody else has it yet.
            let words = unsafe { Self::words(target) };
            for (first, under) in self.pages.swap_remove(number).under {
                if let Some(row) = words.get_mut(first..first + under.len()) {
                    row.copy_from_slice(&under);
                }
            }
        }
        self.target.set(Some(Open(target)));
        target
    }

    fn present(&mut self) -> Result<(), FramebufferError> {
        if let Some(Open(target)) = self.target.take() {
            self.print(target);
        }
        self.inner.present()
    }

    fn keeps_contents(&self) -> bool {
        // Any call ends the time in which the target may be written to.
        self.target.take();
        self.inner.keeps_contents()
    }

    fn describe(&self) -> String {
        self.target.take();
        self.inner.describe()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use cellray::framebuffer::{File, PixelFormat};
    use cellray::game::{PlacedLabel, Side};

    /// Fills the pixels that `changes` selects with a colour, as the SPUs would, and presents.
    fn frame(framebuffer: &mut Printed, colour: [u8; 3], changes: impl Fn(usize) -> bool) {
        assert!(framebuffer.keeps_contents());
        let target = framebuffer.target();
        // SAFETY: The target was returned just now.
        let words = unsafe { Printed::words(target) };
        for (number, word) in words.iter_mut().enumerate() {
            if changes(number) {
                *word = PixelFormat::ARGB.word(colour).to_be();
            }
        }
        framebuffer.present().expect("a frame");
    }

    #[test]
    fn removed_text_restores_picture() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("fb");
        let size = Geometry::new(200, 100).expect("a size");
        let inner = File::open(&path, Some(size)).expect("a file");
        let overlay = Arc::new(Mutex::new(Overlay::default()));
        let mut printed = Printed::new(Box::new(inner), Arc::clone(&overlay));
        let shown = || std::fs::read(&path).expect("the frame");
        let grey = [90; 3];
        frame(&mut printed, grey, |_| true);
        let plain = shown();
        // Panels that cover one another, because the area is small, and a label at the corner.
        *overlay.lock().expect("the text") = Overlay {
            labels: vec![PlacedLabel {
                text: "a label".into(),
                place: [1.0, 1.0],
                side: Side::Over,
                colour: [255; 3],
            }],
            help: vec!["the keys are listed here".into(); 12],
            notice: Some("Paused".into()),
            ..Overlay::default()
        };
        // Nothing is traced, as if the world stood still.
        for _ in 0..3 {
            frame(&mut printed, grey, |_| false);
            assert_ne!(shown(), plain);
        }
        *overlay.lock().expect("the text") = Overlay::default();
        frame(&mut printed, grey, |_| false);
        assert!(shown() == plain);
    }

    #[test]
    fn pixels_traced_under_text_appear_after_it() {
        let folder = tempfile::tempdir().expect("a folder");
        let size = Geometry::new(200, 100).expect("a size");
        let [path, other] = ["fb", "plain"].map(|name| folder.path().join(name));
        let overlay =
            Arc::new(Mutex::new(Overlay { notice: Some("Paused".into()), ..Overlay::default() }));
        let file = |path| Box::new(File::open(path, Some(size)).expect("a file"));
        let mut printed = Printed::new(file(&path), Arc::clone(&overlay));
        let mut plain = Printed::new(file(&other), Arc::default());
        let half = |number: usize| number % 200 < 100;
        for framebuffer in [&mut printed, &mut plain] {
            frame(framebuffer, [90; 3], |_| true);
            frame(framebuffer, [200, 10, 10], half);
        }
        *overlay.lock().expect("the text") = Overlay::default();
        for framebuffer in [&mut printed, &mut plain] {
            frame(framebuffer, [0; 3], |_| false);
        }
        let [with, without] = [&path, &other].map(|path| std::fs::read(path).expect("a frame"));
        assert!(with == without);
    }
}
