//! Files that are watched, so that what was made of them is made again when one changes.

use std::fs;
use std::path::PathBuf;
use std::thread;
use std::time::{Duration, SystemTime};

/// How often the files are looked at.
const INTERVAL: Duration = Duration::from_millis(100);

/// Files and when each was last written, as far as that is known.
#[derive(Clone, Debug)]
pub struct Watch(Vec<(PathBuf, Option<SystemTime>)>);

impl Watch {
    /// Watches these files from now on. A file that doesn't exist counts as changed when it
    /// appears.
    #[must_use]
    pub fn new(files: impl IntoIterator<Item = PathBuf>) -> Self {
        let written = |file: PathBuf| {
            let time = written(&file);
            (file, time)
        };
        Self(files.into_iter().map(written).collect())
    }

    /// Whether a file was written since the last call, or since the start.
    pub fn has_changed(&mut self) -> bool {
        let mut has_changed = false;
        for (file, before) in &mut self.0 {
            let now = written(file);
            // An editor that replaces a file takes it away first: that is no new text yet.
            if now.is_some() && now != *before {
                *before = now;
                has_changed = true;
            }
        }
        has_changed
    }

    /// Waits until a file is written.
    pub fn wait(&mut self) {
        while !self.has_changed() {
            thread::sleep(INTERVAL);
        }
    }
}

fn written(file: &PathBuf) -> Option<SystemTime> {
    fs::metadata(file).and_then(|data| data.modified()).ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn change_is_reported_once() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("scene.nff");
        fs::write(&file, "1").unwrap();
        let mut watch = Watch::new([file.clone(), folder.path().join("missing")]);
        assert!(!watch.has_changed());
        let later = SystemTime::now() + Duration::from_secs(5);
        fs::File::open(&file).unwrap().set_modified(later).unwrap();
        assert!(watch.has_changed());
        assert!(!watch.has_changed());
        fs::remove_file(&file).unwrap();
        assert!(!watch.has_changed());
        fs::write(&file, "2").unwrap();
        assert!(watch.has_changed());
        fs::write(folder.path().join("missing"), "").unwrap();
        assert!(watch.has_changed());
    }
}
