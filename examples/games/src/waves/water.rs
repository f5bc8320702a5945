//! A square of water: heights on a grid, which obey the wave equation.
//!
//! Invariant: heights and their speeds are finite. Each step damps them, and pushes are limited.

/// Metres of a side.
pub const SIDE: f64 = 8.0;
/// Seconds of a step.
pub const STEP: f64 = 1.0 / 60.0;
/// Metres a second that waves move: on the finest grid 0.6 squares a step. From 0.7 on, heights
/// would grow without limit.
const SPEED: f64 = 1.15;
/// The share of its speed that water keeps in a step.
const KEPT: f32 = 0.997;
/// The highest water, and the deepest.
const HIGHEST: f32 = 0.6;

/// The water.
pub struct Water {
    /// Squares along a side.
    count: usize,
    /// Heights of the grid's points, row by row, and their changes a step.
    heights: Vec<f32>,
    speeds: Vec<f32>,
}

impl Water {
    /// Water at rest, of this number of squares along a side.
    pub fn new(count: usize) -> Self {
        let points = (count + 1) * (count + 1);
        Self { count, heights: vec![0.0; points], speeds: vec![0.0; points] }
    }

    /// The number of squares along a side.
    pub fn count(&self) -> usize {
        self.count
    }

    /// Metres of a square's side.
    fn square(&self) -> f64 {
        SIDE / self.count as f64
    }

    /// A step of the wave equation. The walls reflect waves.
    pub fn step(&mut self) {
        let side = self.count + 1;
        let part = SPEED * STEP / self.square();
        let pull = (part * part) as f32;
        for row in 0..side {
            let at = |row: usize| &self.heights[row * side..][..side];
            let (own, above) = (at(row), at(row.saturating_sub(1)));
            let below = at((row + 1).min(side - 1));
            for (column, speed) in self.speeds[row * side..][..side].iter_mut().enumerate() {
                let left = own[column.saturating_sub(1)];
                let right = own[(column + 1).min(side - 1)];
                let around = (left + right) + (above[column] + below[column]);
                *speed = (*speed + pull * (around - 4.0 * own[column])) * KEPT;
            }
        }
        for (height, speed) in self.heights.iter_mut().zip(&self.speeds) {
            *height = (*height + speed).clamp(-HIGHEST, HIGHEST);
        }
    }

    /// Raises the water around a point, most in the middle, and not at all from `radius` on.
    pub fn raise(&mut self, x: f64, z: f64, radius: f64, by: f64) {
        let square = self.square();
        let range = |middle: f64| {
            let grid = |place: f64| ((place + 0.5 * SIDE) / square).clamp(0.0, self.count as f64);
            grid(middle - radius).ceil() as usize..=grid(middle + radius) as usize
        };
        for row in range(z) {
            for column in range(x) {
                let [dx, dz] = [(column, x), (row, z)]
                    .map(|(point, middle)| point as f64 * square - 0.5 * SIDE - middle);
                let share = 1.0 - (dx * dx + dz * dz) / (radius * radius);
                if share > 0.0 {
                    let height = &mut self.heights[row * (self.count + 1) + column];
                    *height = (*height + (by * share) as f32).clamp(-HIGHEST, HIGHEST);
                }
            }
        }
    }

    /// The height at a point of the square.
    pub fn height(&self, x: f64, z: f64) -> f64 {
        let grid = |place: f64| {
            let place = (place + 0.5 * SIDE) / self.square();
            let point = place.clamp(0.0, self.count as f64 - 0.001);
            (point as usize, point.fract())
        };
        let ((column, right), (row, down)) = (grid(x), grid(z));
        let at =
            |row: usize, column: usize| f64::from(self.heights[row * (self.count + 1) + column]);
        let across = |row: usize| at(row, column) * (1.0 - right) + at(row, column + 1) * right;
        across(row) * (1.0 - down) + across(row + 1) * down
    }

    /// Writes the positions of the grid's points and the surface's normals there.
    pub fn shape(&self, positions: &mut [[f32; 3]], normals: &mut [[f32; 3]]) {
        let side = self.count + 1;
        let square = self.square() as f32;
        let half = 0.5 * SIDE as f32;
        let vertices = positions.chunks_exact_mut(side).zip(normals.chunks_exact_mut(side));
        for (row, (positions, normals)) in vertices.enumerate() {
            let at = |row: usize| &self.heights[row * side..][..side];
            let (own, above) = (at(row), at(row.saturating_sub(1)));
            let below = at((row + 1).min(side - 1));
            for (column, (position, normal)) in positions.iter_mut().zip(normals).enumerate() {
                let left = own[column.saturating_sub(1)];
                let right = own[(column + 1).min(side - 1)];
                let (x, z) = (column as f32 * square - half, row as f32 * square - half);
                *position = [x, own[column], z];
                *normal = [left - right, 2.0 * square, above[column] - below[column]];
            }
        }
    }
}
