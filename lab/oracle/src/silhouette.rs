//! Finds the pixels on silhouettes.
//!
//! Invariant: the result has one entry for each pixel, in their order.

/// For each pixel, whether one of its eight neighbours shows something else. `sights` has what
/// each pixel shows, in rows of `width`.
pub(crate) fn mask<T: PartialEq>(sights: &[T], width: usize) -> Vec<bool> {
    let height = sights.len() / width;
    let around = |at: usize, end: usize| at.saturating_sub(1)..(at + 2).min(end);
    let differs = |(index, sight): (usize, &T)| {
        let (x, y) = (index % width, index / width);
        around(y, height).any(|y| {
            let row = &sights[y * width..][around(x, width)];
            row.iter().any(|neighbour| neighbour != sight)
        })
    };
    sights.iter().enumerate().map(differs).collect()
}
