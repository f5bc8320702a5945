//! Height fields: ground as a grid of heights, with a colour each.
//!
//! Invariant: there are at least two samples in a row and two rows, at most [`MAX_SAMPLES`] of
//! each, and a height and a colour for each of them.

use std::ops::Range;

use glam::DVec3;

use crate::Mesh;

/// The most samples of a row, and the most rows.
pub const MAX_SAMPLES: u32 = 4097;

/// Why there is no such height field.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum HeightError {
    /// There are too few or too many samples.
    #[error(
        "a height field of {columns} x {rows} samples: there must be 2 to {MAX_SAMPLES} in a row, \
         and as many rows"
    )]
    Size {
        /// Samples of a row.
        columns: u32,
        /// Rows.
        rows: u32,
    },
    /// The numbers of samples and of heights or colours differ.
    #[error("{found} {what} for {columns} x {rows} samples of a height field")]
    Count {
        /// The part with another number.
        what: &'static str,
        /// How many there are.
        found: usize,
        /// Samples of a row.
        columns: u32,
        /// Rows.
        rows: u32,
    },
    /// A length is no number, or can't be that of anything.
    #[error("{what} of a height field is {value}: it must be a number above 0")]
    Length {
        /// Which length.
        what: &'static str,
        /// Its value.
        value: f64,
    },
}

/// A file of heights (`#cellray heights`).
#[derive(Debug, Clone)]
pub struct HeightMap {
    /// Line of the scene's file, from 1.
    pub line: u32,
    /// The file, as the scene's file names it.
    pub file: String,
    /// The distance between samples, and the length of a height of 1 in the file.
    pub scale: (f64, f64),
    /// The file with a colour for each sample, if there is one.
    pub colours: Option<String>,
    /// Its material, as [`HeightField::material`].
    pub material: u32,
}

impl PartialEq for HeightMap {
    fn eq(&self, other: &Self) -> bool {
        let Self { line: _, file, scale, colours, material } = self;
        (file, scale, colours, material)
            == (&other.file, &other.scale, &other.colours, &other.material)
    }
}

/// A rectangle of samples: what a brush changes.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct HeightRegion {
    /// Its samples of each row.
    pub columns: Range<u32>,
    /// Its rows.
    pub rows: Range<u32>,
}

impl HeightRegion {
    /// Whether it has no sample.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.columns.is_empty() || self.rows.is_empty()
    }

    /// The smallest one that has both.
    #[must_use]
    pub fn with(&self, other: &Self) -> Self {
        let both = |own: &Range<u32>, other: &Range<u32>| {
            own.start.min(other.start)..own.end.max(other.end)
        };
        match (self.is_empty(), other.is_empty()) {
            (true, _) => other.clone(),
            (false, true) => self.clone(),
            (false, false) => Self {
                columns: both(&self.columns, &other.columns),
                rows: both(&self.rows, &other.rows),
            },
        }
    }

    /// The part of it that is in a field of this size.
    #[must_use]
    pub fn within(&self, [columns, rows]: [u32; 2]) -> Self {
        let part = |range: &Range<u32>, count: u32| range.start.min(count)..range.end.min(count);
        Self { columns: part(&self.columns, columns), rows: part(&self.rows, rows) }
    }
}

/// A sample of a height field.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct HeightSample {
    /// Its height, in units.
    pub height: u16,
    /// Its colour, encoded as those of materials are, with 255 for 1.
    pub colour: [u8; 3],
}

/// A height field. Its rows go along x, one row follows another along z, and y is up.
#[derive(Debug, Clone, PartialEq)]
pub struct HeightField {
    columns: u32,
    rows: u32,
    heights: Vec<u16>,
    /// No sample is lower than the first or higher than the second.
    range: [u16; 2],
    colours: Vec<[u8; 3]>,
    /// The place of the first sample, if its height is 0.
    pub corner: DVec3,
    step: f64,
    unit: f64,
    /// Its material, as an index in [`Scene::materials`](crate::Scene::materials), whose colour
    /// is multiplied by those of the samples.
    pub material: u32,
}

impl HeightField {
    /// A height field in the middle of the plane y = 0. `step` is the distance between samples,
    /// and `unit` the length of a height of 1. Colours are encoded as those of materials are, with
    /// 255 for 1; no colours at all are white.
    ///
    /// # Errors
    /// There is not a height and a colour for each sample, there are too few or too many samples,
    /// or a length is not above 0.
    pub fn new(
        [columns, rows]: [u32; 2],
        heights: Vec<u16>,
        mut colours: Vec<[u8; 3]>,
        step: f64,
        unit: f64,
    ) -> Result<Self, HeightError> {
        let allowed = 2..=MAX_SAMPLES;
        if !allowed.contains(&columns) || !allowed.contains(&rows) {
            return Err(HeightError::Size { columns, rows });
        }
        let count = columns as usize * rows as usize;
        if colours.is_empty() {
            colours = vec![[255; 3]; count];
        }
        for (what, found) in [("heights", heights.len()), ("colours", colours.len())] {
            if found != count {
                return Err(HeightError::Count { what, found, columns, rows });
            }
        }
        for (what, value) in [("the step", step), ("the unit of heights", unit)] {
            if !(value > 0.0 && value.is_finite()) {
                return Err(HeightError::Length { what, value });
            }
        }
        let half = |samples: u32| -step * f64::from(samples - 1) / 2.0;
        let corner = DVec3::new(half(columns), 0.0, half(rows));
        let range = [heights.iter().copied().min(), heights.iter().copied().max()];
        let range = range.map(Option::unwrap_or_default);
        Ok(Self { columns, rows, heights, range, colours, corner, step, unit, material: 0 })
    }

    /// Samples of a row, and rows.
    #[must_use]
    pub fn size(&self) -> [u32; 2] {
        [self.columns, self.rows]
    }

    /// The distance between neighbouring samples of a row or column.
    #[must_use]
    pub fn step(&self) -> f64 {
        self.step
    }

    /// The length of a height of 1.
    #[must_use]
    pub fn unit(&self) -> f64 {
        self.unit
    }

    /// The height of a sample, in units; of the next one at the edge if it is beyond that.
    #[must_use]
    #[inline]
    pub fn sample(&self, column: i64, row: i64) -> u16 {
        self.heights[self.index(column, row)]
    }

    /// The colour of a sample, in the same way.
    #[must_use]
    #[inline]
    pub fn colour(&self, column: i64, row: i64) -> [u8; 3] {
        self.colours[self.index(column, row)]
    }

    /// A sample, in the same way.
    #[must_use]
    pub fn at(&self, column: u32, row: u32) -> HeightSample {
        let (column, row) = (column.into(), row.into());
        HeightSample { height: self.sample(column, row), colour: self.colour(column, row) }
    }

    #[inline]
    fn index(&self, column: i64, row: i64) -> usize {
        let within = |at: i64, count: u32| at.clamp(0, i64::from(count) - 1) as usize;
        within(row, self.rows) * self.columns as usize + within(column, self.columns)
    }

    /// The ground's y above or below a point: in its square, or at the edge that is nearest.
    #[must_use]
    pub fn ground(&self, point: DVec3) -> f64 {
        let at = (point - self.corner) / self.step;
        let x = at.x.clamp(0.0, f64::from(self.columns - 1));
        let z = at.z.clamp(0.0, f64::from(self.rows - 1));
        let (column, row) = (x.floor() as i64, z.floor() as i64);
        let height = |column: i64, row: i64| f64::from(self.sample(column, row));
        let (x, z) = (x - x.floor(), z - z.floor());
        let along = |row: i64| height(column, row) * (1.0 - x) + height(column + 1, row) * x;
        self.corner.y + self.unit * (along(row) * (1.0 - z) + along(row + 1) * z)
    }

    /// Changes the samples of a region, of which a part beyond the field counts for nothing. Each
    /// becomes what `change` returns for its column, its row and what it was. The box around the
    /// field becomes larger if it must, by a quarter of its height at least, so that it does so
    /// rarely while a brush is at work.
    pub fn shape(
        &mut self,
        region: &HeightRegion,
        mut change: impl FnMut([u32; 2], HeightSample) -> HeightSample,
    ) {
        let HeightRegion { columns, rows } = region.within(self.size());
        let [mut low, mut high] = self.range;
        for row in rows {
            for column in columns.clone() {
                let at = self.index(column.into(), row.into());
                let HeightSample { height, colour } = change([column, row], self.at(column, row));
                self.heights[at] = height;
                self.colours[at] = colour;
                low = low.min(height);
                high = high.max(height);
            }
        }
        let quarter = (high - low) / 4;
        if low < self.range[0] {
            self.range[0] = low.saturating_sub(quarter);
        }
        if high > self.range[1] {
            self.range[1] = high.saturating_add(quarter);
        }
    }

    /// The samples that are no farther from a place than `radius`, along x and along z.
    #[must_use]
    pub fn around(&self, place: DVec3, radius: f64) -> HeightRegion {
        let [low, high] = [-radius, radius].map(|away| (place - self.corner + away) / self.step);
        // Numbers below 0 become 0, and too large ones the largest.
        let range = |low: f64, high: f64| low.ceil() as u32..(high.floor() + 1.0) as u32;
        HeightRegion { columns: range(low.x, high.x), rows: range(low.z, high.z) }
            .within(self.size())
    }

    /// The lower and the upper corner of a box around it. The box is as small as it can be until
    /// [`HeightField::shape`] changes it.
    #[must_use]
    pub fn bounds(&self) -> (DVec3, DVec3) {
        let [low, high] = self.range;
        let place = |column: u32, height: u16, row: u32| {
            let along = DVec3::new(f64::from(column), 0.0, f64::from(row)) * self.step;
            self.corner + along + DVec3::Y * (self.unit * f64::from(height))
        };
        (place(0, low, 0), place(self.columns - 1, high, self.rows - 1))
    }

    /// Its surface in full detail: two triangles for each square of four samples, which the
    /// diagonal from low to high x and z divides, with normals of the slopes between the samples
    /// beside each.
    #[must_use]
    pub fn mesh(&self) -> Mesh {
        let mut mesh = Mesh { origin: self.corner, ..Mesh::default() };
        for row in 0..i64::from(self.rows) {
            for column in 0..i64::from(self.columns) {
                let height = |column: i64, row: i64| f64::from(self.sample(column, row));
                let position = DVec3::new(
                    self.step * column as f64,
                    self.unit * height(column, row),
                    self.step * row as f64,
                );
                let slopes = [
                    height(column + 1, row) - height(column - 1, row),
                    height(column, row + 1) - height(column, row - 1),
                ];
                let [along, across] = slopes.map(|slope| -self.unit * slope);
                let normal = DVec3::new(along, 2.0 * self.step, across).normalize();
                mesh.positions.push(position.as_vec3().to_array());
                mesh.normals.push(normal.as_vec3().to_array());
                mesh.colours.push(self.colour(column, row).map(|part| f32::from(part) / 255.0));
            }
        }
        for row in 0..self.rows - 1 {
            for column in 0..self.columns - 1 {
                let first = row * self.columns + column;
                let [b, c, d] = [1, self.columns, self.columns + 1].map(|step| first + step);
                mesh.triangles.extend([[first, c, d], [first, d, b]]);
                mesh.materials.extend([self.material; 2]);
            }
        }
        mesh
    }
}
