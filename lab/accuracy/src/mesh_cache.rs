//! How many blocks of a mesh an SPU caches, against speed and bytes: rows of the table that
//! `ci/measure cache` prints.

use thiserror::Error;

/// A row of the table.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// The scene, and the size of its picture.
    pub scene: String,
    /// The most blocks that are cached.
    pub blocks: f64,
    /// Frames a second in simulated time.
    pub frames_per_second: f64,
    /// Bytes of blocks that are fetched for a ray.
    pub bytes_a_ray: f64,
}

/// There is no row in the text.
#[derive(Debug, Error)]
#[error("no row of a scene, blocks, frames/s, blocks cached, bytes a ray and waiting for DMA")]
pub struct NoRows;

/// The rows in a document or a table by itself.
///
/// # Errors
///
/// Fails if there are none.
pub fn rows(text: &str) -> Result<Vec<Row>, NoRows> {
    let rows: Vec<Row> = text.lines().filter_map(row).collect();
    if rows.is_empty() {
        return Err(NoRows);
    }
    Ok(rows)
}

fn row(line: &str) -> Option<Row> {
    let cells = line.trim().strip_prefix('|')?.strip_suffix('|')?;
    let cells: Vec<&str> = cells.split('|').map(str::trim).collect();
    let [scene, blocks, rate, _, bytes, _] = cells[..] else {
        return None;
    };
    Some(Row {
        scene: scene.to_owned(),
        blocks: blocks.parse().ok()?,
        frames_per_second: rate.parse().ok()?,
        bytes_a_ray: bytes.parse().ok()?,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_are_found_among_other_lines() {
        let text = "# Meshes\n\n| scene | blocks, at most | frames/s | blocks cached | bytes a ray | waiting |\n\
                    |---|---|---|---|---|---|\n| bunny, 512x512 | 4 | 97.0 | 38.6 % | 74.8 | 1.5 % |\n";
        let expected = Row {
            scene: "bunny, 512x512".to_owned(),
            blocks: 4.0,
            frames_per_second: 97.0,
            bytes_a_ray: 74.8,
        };
        assert_eq!(rows(text).expect("a row"), [expected]);
        assert!(rows("| a | b |\n").is_err());
    }
}
