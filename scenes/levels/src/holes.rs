//! Walls with holes: rectangles of a picture's texels, so that rays need no texture to find a hole.

use glam::DVec2;

use crate::Picture;
use crate::walls::Wall;

/// The most rectangles of a picture. Leaves and foam would take thousands of triangles for a wall.
const MOST: usize = 400;

/// A rectangle of texels: the first column and row, and those after its last ones.
pub(crate) type Rectangle = [usize; 4];

/// Divides the texels of a picture into rectangles, each from left to right as far as there is no
/// hole, and then down; `None` if there would be too many.
pub(crate) fn rectangles(picture: &Picture) -> Option<Vec<Rectangle>> {
    let (width, height) = (picture.width, picture.height());
    let mut left: Vec<bool> = picture.texels.iter().map(Option::is_some).collect();
    let mut found = Vec::new();
    for top in 0..height {
        let mut first = 0;
        while first < width {
            let row = &left[top * width..][..width];
            let Some(begin) = row[first..].iter().position(|it| *it) else { break };
            let begin = first + begin;
            let end = row[begin..].iter().position(|it| !it).map_or(width, |count| begin + count);
            let is_full = |row: &usize| left[row * width..][begin..end].iter().all(|it| *it);
            let bottom = (top..height).find(|row| !is_full(row)).unwrap_or(height);
            (top..bottom).for_each(|row| left[row * width..][begin..end].fill(false));
            if found.len() == MOST {
                return None;
            }
            found.push([begin, top, end, bottom]);
            first = end;
        }
    }
    Some(found)
}

/// Texels across and down of a square that is kept or left out as a whole.
const SQUARE: usize = 4;

/// The rectangles of the squares of a picture of which texels cover at least a quarter: the outline
/// of a thing needs no more.
pub(crate) fn squares(picture: &Picture) -> Vec<Rectangle> {
    let (width, height) = (picture.width, picture.height());
    let squares = |side: usize| (0..side.div_ceil(SQUARE)).map(|at| at * SQUARE);
    let is_kept = |top: usize, left: usize| {
        let rows = top..(top + SQUARE).min(height);
        let columns = left..(left + SQUARE).min(width);
        let area = rows.len() * columns.len();
        let texels = rows.flat_map(|row| &picture.texels[row * width..][columns.clone()]);
        4 * texels.flatten().count() >= area
    };
    let kept = squares(height).flat_map(|top| squares(width).map(move |left| (top, left)));
    let kept = kept.map(|(top, left)| is_kept(top, left).then_some([0; 3]));
    let coarse = Picture { width: width.div_ceil(SQUARE), texels: kept.collect() };
    let mut found = rectangles(&coarse).unwrap_or_default();
    for rectangle in &mut found {
        let sides = [width, height, width, height];
        *rectangle = std::array::from_fn(|at| (rectangle[at] * SQUARE).min(sides[at]));
    }
    found
}

impl Wall {
    /// The parts of a wall that these rectangles of its picture leave. The picture is repeated
    /// along the wall, but not upwards.
    pub fn parts<'a>(
        &'a self,
        rectangles: &'a [Rectangle],
        width: f64,
    ) -> impl Iterator<Item = Self> + 'a {
        let [from, to] = self.ends;
        let length = from.distance(to);
        let DVec2 { x: column, y: row } = self.texel;
        let pictures = (column / width).floor() as i64..((column + length) / width).ceil() as i64;
        let repeated = pictures.flat_map(move |picture| {
            rectangles.iter().map(move |rectangle| (picture as f64 * width, rectangle))
        });
        repeated.filter_map(move |(start, rectangle)| {
            let [left, top, right, bottom] = rectangle.map(|texel| texel as f64);
            let [left, right] =
                [left, right].map(|texel| (start + texel - column).clamp(0.0, length));
            let [top, bottom] =
                [top, bottom].map(|texel| (texel - row).clamp(0.0, self.top - self.bottom));
            (left < right && top < bottom).then(|| Self {
                ends: [left, right].map(|along| from.lerp(to, along / length)),
                top: self.top - top,
                bottom: self.top - bottom,
                texel: DVec2::new(column + left, row + top),
                ..*self
            })
        })
    }
}
