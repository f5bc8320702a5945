//! Makes pixels of what rays see, as `docs/shading.md#pixels` defines it: how many samples a pixel
//! has, and what it shows of their light.
//!
//! Does not depend on the model. Invariant: the same model and settings give the same picture and
//! the same counts, with any number of threads.

use glam::DVec3;
use scenes::depth;

use crate::whitted::Counts;
use crate::{Colour, Error, Picture, Reference, rows, silhouette};

/// Columns and rows of a tile. Pixels are only compared within one.
const TILE: (usize, usize) = (64, 16);

/// How many samples, evenly spread, a pixel that differs from a neighbour is the mean of.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum Samples {
    /// Its centre alone.
    #[default]
    One,
    /// Four.
    Four,
    /// Sixteen.
    Sixteen,
}

impl Samples {
    /// The samples' places, from the pixel's centre: a regular grid that is turned so far that no
    /// two have the same column or row.
    fn places(self) -> impl Iterator<Item = (f64, f64)> {
        let side = match self {
            Self::One => 1,
            Self::Four => 2,
            Self::Sixteen => 4,
        };
        let cell = 1.0 / f64::from(side);
        let middle = move |index: i32| (f64::from(index) + 0.5) * cell - 0.5;
        let cells = (0..side).flat_map(move |row| (0..side).map(move |column| (column, row)));
        cells.map(move |(column, row)| {
            let (x, y) = (middle(column), middle(row));
            (x + cell * y, y - cell * x)
        })
    }
}

/// How pixels are made of the light that rays see.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Pixels {
    /// The samples of a pixel that differs from a neighbour in its tile.
    pub samples: Samples,
    /// By how much a channel of such a pixel's byte differs at least; with 0, every pixel has all
    /// samples.
    pub contrast: u8,
    /// The colour space of the scene's colours and of pixels.
    pub colour: Colour,
    /// Whether light above 3/4 is limited without a step.
    pub roll_off: bool,
    /// Whether there is a pixel at each corner instead of each centre, and the picture has the
    /// means of four corners, as the Standard Procedural Databases require.
    pub corners: bool,
}

impl Pixels {
    /// One sample a pixel, in linear light.
    pub const PLAIN: Self = Self {
        samples: Samples::One,
        contrast: 0,
        colour: Colour::Linear,
        roll_off: false,
        corners: false,
    };

    /// What a pixel shows of light: its channels from 0 to 1.
    pub(crate) fn shown(&self, light: DVec3) -> DVec3 {
        let limited = |light: f64| {
            if self.roll_off && light > 0.75 { 1.0 - 0.0625 / (light - 0.5) } else { light }
        };
        let light = light.to_array().map(limited);
        let shown = self.colour.shown(light.into());
        shown.clamp(DVec3::ZERO, DVec3::ONE)
    }

    /// The bytes of a pixel that sees this light.
    pub(crate) fn bytes(&self, light: DVec3) -> [u8; 3] {
        depth::bytes(self.shown(light))
    }

    /// The point of the picture that is the mean of these samples.
    fn point(&self, samples: &[Seen]) -> Point {
        let light = samples.iter().map(|seen| seen.light).sum::<DVec3>();
        let first = samples.first().map_or(0, |seen| seen.way);
        let is_one = samples.iter().all(|seen| seen.way == first);
        // The golden ratio's bits, which spread what they multiply.
        let mixed = |hash: u64, seen: &Seen| {
            hash.rotate_left(5).wrapping_add(seen.way).wrapping_mul(0x9e37_79b9_7f4a_7c15)
        };
        Point {
            shown: self.shown(light / samples.len() as f64),
            way: if is_one { first } else { samples.iter().fold(0, mixed) },
            on_edge: !is_one || samples.iter().any(|seen| seen.on_edge),
        }
    }
}

/// What a ray sees.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Seen {
    /// The light, which is not limited.
    pub light: DVec3,
    /// A number for the way that the ray took: rays with equal ones hit the same objects, and the
    /// same lights reach them.
    pub way: u64,
    /// Whether it passes an edge so near that a kernel may decide otherwise.
    pub on_edge: bool,
}

/// A pixel, or a corner of pixels.
#[derive(Debug, Clone, Copy, Default)]
struct Point {
    shown: DVec3,
    /// The way of its rays, or a number for all of their ways.
    way: u64,
    /// Whether its rays took several ways, or one of them passes an edge.
    on_edge: bool,
}

/// A model that computes the colours of a scene's rays.
pub(crate) trait Model: Sync {
    /// Returns the function that traces the ray through a position in a row of the picture, and
    /// counts its rays. The centre of the top left pixel is (0, 0).
    fn row(&self, y: f64) -> impl Fn(f64, &mut Counts) -> Seen;
}

/// Renders a picture with its silhouettes, and counts the rays.
pub(crate) fn paint(
    (width, height): (u32, u32),
    pixels: &Pixels,
    model: &impl Model,
) -> Result<(Reference, Counts), Error> {
    let mut picture = Picture::black(width, height)?;
    let (more, start) = if pixels.corners { (1, -0.5) } else { (0, 0.0) };
    let (columns, lines) = (width as usize + more, height as usize + more);
    let at = |index: usize| index as f64 + start;
    let mut points = vec![Point::default(); columns * lines];
    let mut counts = vec![Counts::default(); lines];

    let all_samples = pixels.samples != Samples::One && pixels.contrast == 0;
    if !all_samples {
        let items = points.chunks_mut(columns).zip(&mut counts).enumerate();
        rows::each(items, |(y, (points, counts))| {
            let look = model.row(at(y));
            for (x, point) in points.iter_mut().enumerate() {
                *point = pixels.point(&[look(at(x), counts)]);
            }
        });
    }
    let refined = match pixels.samples {
        Samples::One => vec![false; points.len()],
        _ if all_samples => vec![true; points.len()],
        _ => differing(&points, columns, pixels.contrast),
    };
    if pixels.samples != Samples::One {
        // Where a first ray decides otherwise than the reference's, other neighbours are chosen. So
        // it is also known of those whether their samples are on a silhouette.
        let beside = silhouette::mask(&refined, columns);
        let chosen = refined.chunks(columns).zip(beside.chunks(columns));
        let items = points.chunks_mut(columns).zip(&mut counts).zip(chosen);
        rows::each(items.enumerate(), |(y, ((points, counts), (chosen, beside)))| {
            if !chosen.contains(&true) && !beside.contains(&true) {
                return;
            }
            let samples = pixels.samples.places();
            let looks: Vec<_> = samples.map(|(dx, dy)| (dx, model.row(at(y) + dy))).collect();
            let mut not_counted = Counts::default();
            for (x, point) in points.iter_mut().enumerate() {
                let sampled = |counts: &mut Counts| {
                    let seen = looks.iter().map(|(dx, look)| look(at(x) + dx, counts));
                    pixels.point(&seen.collect::<Vec<_>>())
                };
                if chosen[x] {
                    *point = sampled(counts);
                } else if beside[x] {
                    let sampled = sampled(&mut not_counted);
                    point.on_edge |= sampled.on_edge || sampled.way != point.way;
                }
            }
        });
    }
    let counts = counts.into_iter().fold(Counts::default(), |mut sum, row| {
        sum += row;
        sum
    });

    let of_pixel = |(x, y): (usize, usize)| {
        let first = y * columns + x;
        if pixels.corners {
            [first, first + 1, first + columns, first + columns + 1].map(|at| points[at])
        } else {
            [points[first]; 4]
        }
    };
    let places = (0..height as usize).flat_map(|y| (0..width as usize).map(move |x| (x, y)));
    let mut ways = Vec::with_capacity(picture.pixels().len());
    let mut on_edge = Vec::with_capacity(ways.capacity());
    for (bytes, points) in picture.pixels_mut().iter_mut().zip(places.map(of_pixel)) {
        let [a, b, c, d] = points.map(|point| point.shown);
        *bytes = depth::bytes(((a + b) + (c + d)) / 4.0);
        ways.push(points.map(|point| point.way));
        on_edge.push(points.iter().any(|point| point.on_edge));
    }
    let mut silhouette = silhouette::mask(&ways, width as usize);
    for (is_silhouette, on_edge) in silhouette.iter_mut().zip(on_edge) {
        *is_silhouette |= on_edge;
    }
    let reference = Reference {
        picture,
        silhouette,
        covered: counts.eye_hit as f64 / counts.eye as f64,
        refined: refined.iter().filter(|&&refined| refined).count() as u64,
    };
    Ok((reference, counts))
}

/// For each point of a picture, whether a channel of its bytes differs by at least `contrast` from
/// the point to the left, to the right, above or below, if that is in the same tile.
fn differing(points: &[Point], columns: usize, contrast: u8) -> Vec<bool> {
    let bytes: Vec<_> = points.iter().map(|point| depth::bytes(point.shown)).collect();
    let differ = |a: [u8; 3], b: [u8; 3]| {
        let mut channels = a.into_iter().zip(b);
        channels.any(|(a, b)| a.abs_diff(b) >= contrast)
    };
    let mut chosen = vec![false; points.len()];
    for (index, &here) in bytes.iter().enumerate() {
        let (x, y) = (index % columns, index / columns);
        let right = ((x + 1) % TILE.0 != 0 && x + 1 < columns).then_some(index + 1);
        let below = ((y + 1) % TILE.1 != 0).then_some(index + columns);
        for other in [right, below].into_iter().flatten() {
            if bytes.get(other).is_some_and(|&there| differ(here, there)) {
                chosen[index] = true;
                chosen[other] = true;
            }
        }
    }
    chosen
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Everything left of a line is black, everything right of it is grey.
    struct Line {
        at: f64,
        grey: f64,
    }

    impl Model for Line {
        fn row(&self, _: f64) -> impl Fn(f64, &mut Counts) -> Seen {
            |x, counts| {
                counts.eye += 1;
                let is_right = x > self.at;
                Seen {
                    light: DVec3::splat(f64::from(is_right) * self.grey),
                    way: u64::from(is_right),
                    on_edge: false,
                }
            }
        }
    }

    fn row(line: &Line, pixels: &Pixels) -> (Vec<u8>, Reference, Counts) {
        let (reference, counts) = paint((80, 1), pixels, line).expect("a picture");
        let bytes = reference.picture.pixels().iter().map(|pixel| pixel[0]);
        (bytes.collect(), reference, counts)
    }

    #[test]
    fn no_two_samples_share_a_column_or_a_row() {
        for (samples, count) in [(Samples::One, 1), (Samples::Four, 4), (Samples::Sixteen, 16)] {
            let places: Vec<_> = samples.places().collect();
            for side in [|(x, _): (f64, f64)| x, |(_, y)| y] {
                let mut lines: Vec<_> = places.iter().map(|&place| side(place)).collect();
                lines.sort_by(f64::total_cmp);
                let even = (0..count).map(|line| (f64::from(line) + 0.5) / f64::from(count) - 0.5);
                assert!(lines.iter().zip(even).all(|(a, b)| (a - b).abs() < 1e-12), "{lines:?}");
            }
        }
    }

    #[test]
    fn both_sides_of_an_edge_get_samples() {
        let line = Line { at: 10.2, grey: 1.0 };
        let four = Pixels { samples: Samples::Four, contrast: 32, ..Pixels::PLAIN };
        let (plain, one, _) = row(&line, &Pixels::PLAIN);
        assert_eq!((plain[10], plain[11], one.refined), (0, 255, 0));
        let (smooth, reference, counts) = row(&line, &four);
        // One of the samples at -3/8, -1/8, 1/8 and 3/8 of pixel 10 is right of the edge.
        assert_eq!((smooth[9], smooth[10], smooth[11]), (0, 64, 255));
        assert_eq!((reference.refined, counts.eye), (2, 80 + 2 * 4));
        let silhouette = |x: usize| reference.silhouette[x];
        assert_eq!([8, 9, 10, 11, 12].map(silhouette), [false, true, true, true, false]);
        // Where the edge is between tiles, or has too little contrast, it keeps its step.
        let between = Line { at: 63.2, ..line };
        assert_eq!(row(&between, &four).1.refined, 0);
        assert_eq!(row(&Line { grey: 31.0 / 255.0, ..line }, &four).1.refined, 0);
        assert_eq!(row(&Line { grey: 32.0 / 255.0, ..line }, &four).1.refined, 2);
        // With a contrast of 0, every pixel has samples and no other ray.
        let (everywhere, reference, counts) = row(&line, &Pixels { contrast: 0, ..four });
        assert_eq!((everywhere, reference.refined, counts.eye), (smooth, 80, 80 * 4));
    }

    /// An edge at 10.45, and a thing that only the last sample of pixel 9 sees.
    struct Thin;

    impl Model for Thin {
        fn row(&self, _: f64) -> impl Fn(f64, &mut Counts) -> Seen {
            |x, counts| {
                counts.eye += 1;
                let way = match x {
                    9.3..9.4 => 2,
                    10.45.. => 1,
                    _ => 0,
                };
                Seen { light: DVec3::splat(f64::from(u8::from(way > 0))), way, on_edge: false }
            }
        }
    }

    #[test]
    fn pixel_beside_refined_ones_is_on_silhouette() {
        let four = Pixels { samples: Samples::Four, contrast: 32, ..Pixels::PLAIN };
        let (reference, counts) = paint((80, 1), &four, &Thin).expect("a picture");
        assert_eq!((reference.refined, counts.eye), (2, 80 + 2 * 4));
        assert_eq!(reference.picture.pixels()[9], [0; 3]);
        let silhouette = |x: usize| reference.silhouette[x];
        assert_eq!([8, 9, 10, 11, 12].map(silhouette), [false, true, true, true, false]);
    }

    #[test]
    fn mean_is_taken_before_display_encoding() {
        let line = Line { at: 10.2, grey: 2.0 };
        let four = Pixels { samples: Samples::Four, contrast: 32, ..Pixels::PLAIN };
        let shown = |pixels: Pixels| row(&line, &pixels).0;
        // A quarter of twice white is half of white, whose value in sRGB is 188.
        assert_eq!(shown(four)[10..12], [128, 255]);
        let srgb = Pixels { colour: Colour::Srgb, ..four };
        assert_eq!(shown(srgb)[10..12], [188, 255]);
        // 1 - 1/16 / 1.5
        let rolled = Pixels { roll_off: true, ..four };
        assert_eq!(shown(rolled)[10..12], [128, 244]);
        // The mean of corners is one of what they show.
        let line = Line { at: 10.2, grey: 0.5 };
        let corners = Pixels { corners: true, colour: Colour::Srgb, ..Pixels::PLAIN };
        assert_eq!(row(&line, &corners).0[9..12], [0, 94, 188]);
    }
}
