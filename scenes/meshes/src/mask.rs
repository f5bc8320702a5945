//! Holes in surfaces: cuts triangles along the line at which a texture's alpha passes a limit.
//!
//! Between the middles of four texels alpha is bilinear, as the texture's colours are. The line is
//! drawn straight within such a cell (marching squares). So the mesh has the holes, and rays need
//! no texture to find them.

use glam::{DVec2, DVec3};
use scenes::Wrap;

/// Beyond this many texels from the texture a triangle is not cut: floats have no texels there.
const FARTHEST: f64 = (1 << 30) as f64;

/// The alpha of a texture, and the limit from which on the surface is there.
#[derive(Debug)]
pub(crate) struct Mask {
    width: i64,
    height: i64,
    /// Alpha of each texel minus the limit.
    values: Vec<f32>,
    /// For each texel, the number of those with surface to the left of it and above it, in rows
    /// that are one longer than those of the texels.
    sums: Vec<u32>,
    wrap: [Wrap; 2],
}

/// A corner of a part of a triangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Corner {
    /// One of the triangle's own corners.
    Own(usize),
    /// A point of the triangle, as shares of its corners.
    Within(DVec3),
}

/// A convex part of a triangle, each corner as shares of the triangle's corners.
type Part = Vec<DVec3>;

/// Cells of four texels' middles: the texels of the first column and row, and the ends.
#[derive(Clone, Copy)]
struct Cells {
    low: [i64; 2],
    high: [i64; 2],
}

/// Which part of a set of texels has surface.
enum Cover {
    Nothing,
    Some,
    All,
}

impl Mask {
    /// A mask of a texture's alpha, in rows of `width`. The surface is where alpha times `factor`
    /// is at least `limit`.
    pub fn new(width: u32, alpha: &[u8], factor: f64, limit: f64, wrap: [Wrap; 2]) -> Self {
        let value = |&alpha: &u8| (f64::from(alpha) / 255.0 * factor - limit) as f32;
        let values: Vec<f32> = alpha.iter().map(value).collect();
        let columns = width as usize;
        let height = values.len() / columns.max(1);
        let mut sums = vec![0; (columns + 1) * (height + 1)];
        for row in 0..height {
            let mut sum = 0;
            for column in 0..columns {
                sum += u32::from(values[row * columns + column] >= 0.0);
                let above = sums[row * (columns + 1) + column + 1];
                sums[(row + 1) * (columns + 1) + column + 1] = above + sum;
            }
        }
        Self { width: i64::from(width), height: height as i64, values, sums, wrap }
    }

    /// Whether no texel has a hole.
    pub fn is_whole(&self) -> bool {
        self.sums.last().copied() == Some(self.values.len() as u32)
    }

    /// The parts of a triangle with surface, given the texture coordinates of its corners.
    pub fn parts(&self, places: [DVec2; 3]) -> Vec<Vec<Corner>> {
        let size = DVec2::new(self.width as f64, self.height as f64);
        let ends = places.map(|place| place * size - 0.5);
        let whole = vec![DVec3::X, DVec3::Y, DVec3::Z];
        let low = ends[0].min(ends[1]).min(ends[2]).floor();
        let high = ends[0].max(ends[1]).max(ends[2]).ceil();
        let mut found = Vec::new();
        if low.min_element() < -FARTHEST || high.max_element() > FARTHEST {
            found.push(whole);
        } else {
            let cells = Cells {
                low: [low.x as i64, low.y as i64],
                high: [
                    (high.x as i64).max(low.x as i64 + 1),
                    (high.y as i64).max(low.y as i64 + 1),
                ],
            };
            self.divide(&ends, cells, whole, &mut found);
        }
        let corner = |shares: DVec3| match [DVec3::X, DVec3::Y, DVec3::Z]
            .iter()
            .position(|own| *own == shares)
        {
            Some(own) => Corner::Own(own),
            None => Corner::Within(shares),
        };
        found.into_iter().map(|part| part.into_iter().map(corner).collect()).collect()
    }

    /// Halves cells until all of their texels have surface, or none has, or one cell is left.
    fn divide(&self, ends: &[DVec2; 3], cells: Cells, part: Part, found: &mut Vec<Part>) {
        if part.len() < 3 {
            return;
        }
        match self.cover(cells) {
            Cover::Nothing => return,
            Cover::All => {
                found.push(part);
                return;
            }
            Cover::Some => {}
        }
        let Cells { low, high } = cells;
        let size = [high[0] - low[0], high[1] - low[1]];
        if size == [1, 1] {
            self.march(ends, low, &part, found);
            return;
        }
        let axis = usize::from(size[1] > size[0]);
        let middle = low[axis] + size[axis] / 2;
        let side = |shares: DVec3| at(ends, shares)[axis] - middle as f64;
        let (mut first, mut second) = (cells, cells);
        first.high[axis] = middle;
        second.low[axis] = middle;
        self.divide(ends, first, clipped(&part, |shares| -side(shares)), found);
        self.divide(ends, second, clipped(&part, side), found);
    }

    /// Cuts a part that lies in one cell.
    fn march(&self, ends: &[DVec2; 3], low: [i64; 2], part: &Part, found: &mut Vec<Part>) {
        // The cell's corners, counter-clockwise.
        let corners = [[0, 0], [1, 0], [1, 1], [0, 1]].map(|[right, down]: [i64; 2]| {
            let value = self.value(low[0] + right, low[1] + down);
            let place = DVec2::new((low[0] + right) as f64, (low[1] + down) as f64);
            (place, f64::from(value))
        });
        let there = corners.map(|(_, value)| value >= 0.0);
        // Where the line crosses the edge from a corner to the next one.
        let crossing = |corner: usize| {
            let ((from, a), (to, b)) = (corners[corner % 4], corners[(corner + 1) % 4]);
            from.lerp(to, a / (a - b))
        };
        // The side of the line that cuts off a corner on which the corner is not.
        let beyond = |corner: usize| {
            let (before, after) = (crossing(corner + 3), crossing(corner));
            move |shares: DVec3| (after - before).perp_dot(at(ends, shares) - before)
        };
        let mut keep = |part: Part| {
            if part.len() >= 3 {
                found.push(part);
            }
        };
        match there.iter().filter(|there| **there).count() {
            1 => {
                let corner = there.iter().position(|there| *there).unwrap_or(0);
                let side = beyond(corner);
                keep(clipped(part, |shares| -side(shares)));
            }
            3 => {
                let corner = there.iter().position(|there| !*there).unwrap_or(0);
                keep(clipped(part, beyond(corner)));
            }
            2 if there[0] == there[2] => {
                // Two opposite corners: they are joined if the middle is surface.
                let joined = corners.iter().map(|(_, value)| value).sum::<f64>() >= 0.0;
                let first = usize::from(there[0] == joined);
                let sides = [beyond(first), beyond(first + 2)];
                if joined {
                    let [first, second] = sides;
                    keep(clipped(&clipped(part, first), second));
                } else {
                    for side in sides {
                        keep(clipped(part, |shares| -side(shares)));
                    }
                }
            }
            _ => {
                // Two neighbours: the second of them is the one after which the surface ends.
                let last = (0..4).find(|&it| there[it] && !there[(it + 1) % 4]).unwrap_or(0);
                let (from, to) = (crossing(last), crossing(last + 2));
                keep(clipped(part, |shares| (to - from).perp_dot(at(ends, shares) - from)));
            }
        }
    }

    fn value(&self, column: i64, row: i64) -> f32 {
        let column = wrapped(column, self.width, self.wrap[0]);
        let row = wrapped(row, self.height, self.wrap[1]);
        self.values[(row * self.width + column) as usize]
    }

    fn cover(&self, cells: Cells) -> Cover {
        let columns = ranges(cells.low[0], cells.high[0], self.width, self.wrap[0]);
        let rows = ranges(cells.low[1], cells.high[1], self.height, self.wrap[1]);
        let (mut there, mut all) = (0, 0);
        for &[left, right] in &columns {
            for &[top, bottom] in &rows {
                let sum = |column: i64, row: i64| {
                    i64::from(self.sums[(row * (self.width + 1) + column) as usize])
                };
                there += sum(right, bottom) - sum(left, bottom) - sum(right, top) + sum(left, top);
                all += (right - left) * (bottom - top);
            }
        }
        match there {
            0 => Cover::Nothing,
            _ if there == all => Cover::All,
            _ => Cover::Some,
        }
    }
}

/// The place in texels of a point of a triangle.
fn at(ends: &[DVec2; 3], shares: DVec3) -> DVec2 {
    shares.x * ends[0] + shares.y * ends[1] + shares.z * ends[2]
}

/// The part of a convex part at which `side` is not below 0.
fn clipped(part: &Part, side: impl Fn(DVec3) -> f64) -> Part {
    let mut found = Part::with_capacity(part.len() + 1);
    for (index, &to) in part.iter().enumerate() {
        let from = part[(index + part.len() - 1) % part.len()];
        let (a, b) = (side(from), side(to));
        if (a < 0.0 && b > 0.0) || (a > 0.0 && b < 0.0) {
            found.push(from.lerp(to, a / (a - b)));
        }
        if b >= 0.0 {
            found.push(to);
        }
    }
    found
}

/// The texel that is shown at an index, which may be beyond the edges.
fn wrapped(index: i64, count: i64, wrap: Wrap) -> i64 {
    match wrap {
        Wrap::Repeat => index.rem_euclid(count),
        Wrap::Clamp => index.clamp(0, count - 1),
        Wrap::Mirror => {
            let index = index.rem_euclid(2 * count);
            index.min(2 * count - 1 - index)
        }
    }
}

/// The texels that are shown from one index to another one, as ranges: starts and ends.
fn ranges(low: i64, high: i64, count: i64, wrap: Wrap) -> Vec<[i64; 2]> {
    let period = match wrap {
        Wrap::Clamp => {
            let [first, last] = [low, high].map(|index| wrapped(index, count, wrap));
            return vec![[first, last + 1]];
        }
        Wrap::Repeat => count,
        Wrap::Mirror => 2 * count,
    };
    if high - low + 1 >= period {
        return vec![[0, count]];
    }
    // Within one period, after the edge at its end and, if it is mirrored, in its second half.
    let first = low.rem_euclid(period);
    let last = first + high - low;
    let pieces = [[first, last.min(period - 1)], [0, last - period]];
    let mut found = Vec::new();
    for [first, last] in pieces.into_iter().filter(|[first, last]| first <= last) {
        if first < count {
            found.push([first, last.min(count - 1) + 1]);
        }
        if last >= count {
            found.push([2 * count - 1 - last, 2 * count - first.max(count)]);
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    const SQUARE: [[DVec2; 3]; 2] =
        [[DVec2::ZERO, DVec2::X, DVec2::ONE], [DVec2::ZERO, DVec2::ONE, DVec2::Y]];

    /// The area of the parts that a mask leaves of some triangles, in their texture coordinates.
    fn area(mask: &Mask, triangles: &[[DVec2; 3]]) -> f64 {
        let mut sum = 0.0;
        for triangle in triangles {
            for part in mask.parts(*triangle) {
                let places: Vec<DVec2> = part
                    .iter()
                    .map(|corner| match *corner {
                        Corner::Own(own) => triangle[own],
                        Corner::Within(shares) => at(triangle, shares),
                    })
                    .collect();
                for pair in places[1..].windows(2) {
                    let turn = (pair[0] - places[0]).perp_dot(pair[1] - places[0]) / 2.0;
                    assert!(turn > -1e-12, "{part:?}");
                    sum += turn;
                }
            }
        }
        sum
    }

    /// The share of a square at which the bilinear alpha of a mask is not below the limit.
    fn sampled(mask: &Mask, scale: f64, steps: u32) -> f64 {
        let mut there = 0;
        for index in 0..steps * steps {
            let place = DVec2::new((index % steps).into(), (index / steps).into()) + 0.5;
            let size = DVec2::new(mask.width as f64, mask.height as f64);
            let texel = scale * place / f64::from(steps) * size - 0.5;
            let (low, part) = (texel.floor(), texel - texel.floor());
            let value = |right: i64, down: i64| {
                f64::from(mask.value(low.x as i64 + right, low.y as i64 + down))
            };
            let above = value(0, 0) + part.x * (value(1, 0) - value(0, 0));
            let below = value(0, 1) + part.x * (value(1, 1) - value(0, 1));
            there += u32::from(above + part.y * (below - above) >= 0.0);
        }
        f64::from(there) / f64::from(steps * steps)
    }

    #[test]
    fn half_opaque_texture_keeps_half_of_square() {
        let mask = Mask::new(2, &[255, 0, 255, 0], 1.0, 0.5, [Wrap::Clamp; 2]);
        let found = area(&mask, &SQUARE);
        assert!((found - 0.5).abs() < 1e-3, "{found}");
    }

    #[test]
    fn full_and_empty_masks_cut_no_edges() {
        let whole = Mask::new(2, &[255, 200, 128, 255], 1.0, 0.5, [Wrap::Repeat; 2]);
        assert!(whole.is_whole());
        assert_eq!(whole.parts(SQUARE[0]), [[0, 1, 2].map(Corner::Own)]);
        let empty = Mask::new(2, &[255, 200, 128, 255], 0.4, 0.5, [Wrap::Repeat; 2]);
        assert!(empty.parts(SQUARE[0]).is_empty());
    }

    #[test]
    fn areas_agree_with_samples_for_all_wraps() {
        let mut state = 7_u32;
        let mut random = || {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (state >> 24) as u8
        };
        for wrap in [Wrap::Repeat, Wrap::Clamp, Wrap::Mirror] {
            for scale in [1.0, 2.75] {
                let alpha: Vec<u8> = (0..5 * 3).map(|_| random()).collect();
                let mask = Mask::new(5, &alpha, 1.0, 0.5, [wrap; 2]);
                let scaled = SQUARE.map(|triangle| triangle.map(|place| scale * place));
                let found = area(&mask, &scaled) / (scale * scale);
                let expected = sampled(&mask, scale, 400);
                // Lines of a cell are straight here, and hyperbolas there.
                assert!((found - expected).abs() < 0.04, "{wrap:?}: {found}, {expected}");
            }
        }
    }
}
