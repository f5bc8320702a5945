//! The points of cost and error that no other point beats (the Pareto front).

/// The points for which no other point is at least as good in both values and better in one, the
/// cheapest first. Equal points all stay.
pub fn front(points: &[(f64, f64)]) -> Vec<usize> {
    let beats = |a: (f64, f64), b: (f64, f64)| a.0 <= b.0 && a.1 <= b.1 && a != b;
    let mut front: Vec<usize> = (0..points.len())
        .filter(|at| !points.iter().any(|other| beats(*other, points[*at])))
        .collect();
    front.sort_by(|a, b| points[*a].0.total_cmp(&points[*b].0));
    front
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn front_has_all_points_not_beaten() {
        let points = [(3.0, 1.0), (1.0, 5.0), (2.0, 5.0), (2.0, 2.0), (4.0, 1.0)];
        assert_eq!(front(&points), [1, 3, 0]);
    }

    #[test]
    fn equal_points_stay_together() {
        assert_eq!(front(&[(1.0, 1.0), (1.0, 1.0)]), [0, 1]);
        assert!(front(&[]).is_empty());
    }
}
