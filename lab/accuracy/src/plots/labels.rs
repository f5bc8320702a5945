//! Positions for names that overlap neither each other nor points.

/// A rectangle in pixels: left, top, right, bottom.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Area {
    pub left: f64,
    pub top: f64,
    pub right: f64,
    pub bottom: f64,
}

impl Area {
    /// The area of this size centred on a point.
    pub fn around((x, y): (f64, f64), width: f64, height: f64) -> Self {
        Self {
            left: x - width / 2.0,
            top: y - height / 2.0,
            right: x + width / 2.0,
            bottom: y + height / 2.0,
        }
    }

    /// The point in the area that is nearest to another point.
    pub fn nearest(&self, (x, y): (f64, f64)) -> (f64, f64) {
        (x.clamp(self.left, self.right), y.clamp(self.top, self.bottom))
    }

    fn meets(&self, other: &Self) -> bool {
        self.left < other.right
            && other.left < self.right
            && self.top < other.bottom
            && other.top < self.bottom
    }

    fn within(&self, other: &Self) -> bool {
        self.left >= other.left
            && self.right <= other.right
            && self.top >= other.top
            && self.bottom <= other.bottom
    }
}

/// The size of a point including its margin.
const POINT: f64 = 14.0;

/// The directions in which a name may be placed, the best first.
const WAYS: [(f64, f64); 8] = [
    (1.0, 0.0),
    (-1.0, 0.0),
    (0.0, -1.0),
    (0.0, 1.0),
    (1.0, -1.0),
    (1.0, 1.0),
    (-1.0, -1.0),
    (-1.0, 1.0),
];

/// The length of the pieces into which a line is cut to keep names off it.
const STEP: f64 = 5.0;

/// Small areas that cover a line.
fn along(line: &[(f64, f64)]) -> impl Iterator<Item = Area> {
    line.windows(2).flat_map(|ends| {
        let ((x, y), (to_x, to_y)) = (ends[0], ends[1]);
        let (across, down) = (to_x - x, to_y - y);
        let steps = (across.abs().max(down.abs()) / STEP).ceil().max(1.0);
        (0..=steps as u32).map(move |step| {
            let part = f64::from(step) / steps;
            Area::around((x + part * across, y + part * down), STEP, STEP)
        })
    })
}

/// Places names of these sizes next to their points, as near as they fit, within a frame and off
/// these lines.
pub(super) fn beside(
    points: &[(f64, f64)],
    sizes: &[(f64, f64)],
    lines: &[Vec<(f64, f64)>],
    frame: &Area,
) -> Vec<Area> {
    let points_taken = points.iter().map(|point| Area::around(*point, POINT, POINT));
    let lines_taken = lines.iter().flat_map(|line| along(line));
    let mut taken: Vec<Area> = points_taken.chain(lines_taken).collect();
    let mut areas: Vec<Area> = Vec::new();
    for (&(x, y), &(width, height)) in points.iter().zip(sizes) {
        let away = |(across, down): (f64, f64), far: f64| {
            let middle = (x + across * (width / 2.0 + far), y + down * (height / 2.0 + far));
            Area::around(middle, width, height)
        };
        let all = (0..40).flat_map(|step| {
            let far = POINT / 2.0 + 1.0 + 7.0 * f64::from(step);
            WAYS.map(|way| away(way, far))
        });
        let free = |area: &Area| area.within(frame) && !taken.iter().any(|other| other.meets(area));
        let area = all.clone().find(free).unwrap_or_else(|| away(WAYS[0], POINT));
        taken.push(area);
        taken.extend(along(&[(x, y), area.nearest((x, y))]));
        areas.push(area);
    }
    areas
}

/// Moves heights apart, so that they are at least `gap` apart and between `top` and `bottom`.
/// Their order stays.
pub(super) fn apart(heights: &[f64], gap: f64, top: f64, bottom: f64) -> Vec<f64> {
    let mut order: Vec<usize> = (0..heights.len()).collect();
    order.sort_by(|a, b| heights[*a].total_cmp(&heights[*b]));
    let mut moved = heights.to_vec();
    let mut lowest = top;
    for &at in &order {
        moved[at] = moved[at].max(lowest);
        lowest = moved[at] + gap;
    }
    let mut highest = bottom;
    for &at in order.iter().rev() {
        moved[at] = moved[at].min(highest);
        highest = moved[at] - gap;
    }
    moved
}

#[cfg(test)]
mod tests {
    use super::*;

    const FRAME: Area = Area { left: 0.0, top: 0.0, right: 400.0, bottom: 300.0 };

    #[test]
    fn labels_of_close_points_do_not_overlap() {
        let points: Vec<(f64, f64)> = (0..12)
            .map(|number| (200.0 + f64::from(number % 3), 150.0 + f64::from(number)))
            .collect();
        let lines = [vec![(0.0, 140.0), (400.0, 160.0)]];
        let areas = beside(&points, &[(60.0, 14.0); 12], &lines, &FRAME);
        for (at, area) in areas.iter().enumerate() {
            assert!(area.within(&FRAME));
            assert!(areas[..at].iter().all(|other| !other.meets(area)));
            let point = |point: &(f64, f64)| Area::around(*point, POINT, POINT);
            assert!(points.iter().all(|other| !point(other).meets(area)));
            assert!(along(&lines[0]).all(|line| !line.meets(area)));
        }
    }

    #[test]
    fn heights_keep_their_order_and_their_gap() {
        let moved = apart(&[50.0, 49.0, 51.0, 290.0], 10.0, 0.0, 295.0);
        assert_eq!(moved, [59.0, 49.0, 69.0, 290.0]);
        let moved = apart(&[299.0, 298.0], 10.0, 0.0, 295.0);
        assert_eq!(moved, [295.0, 285.0]);
    }
}
