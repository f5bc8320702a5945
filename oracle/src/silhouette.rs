//! Which pixels lie where a picture jumps.
//!
//! Invariant: as many answers as pixels, in their order.

/// Whether what a pixel shows is not what all of its eight neighbours show. `sights` is what each
/// shows, row after row of `width`.
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
