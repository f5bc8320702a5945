//! What a user may have meant by the name of a scene that does not exist.

use std::path::Path;

use scenes::Generated;

use crate::{mountains, terrain};

/// The endings of files with scenes.
const ENDINGS: [&str; 9] = ["nff", "obj", "ply", "stl", "gltf", "glb", "vrm", "hgt", "npy"];

const MISSING: &str = "there is no such file";

/// A hint about a name that is no file; `None` for names of generated scenes.
pub(crate) fn hint(name: &Path) -> Option<String> {
    let text = name.to_str().unwrap_or_default();
    let (kind, level) = match text.split_once(':') {
        Some((kind, level)) => (kind, Some(level)),
        None => (text, None),
    };
    let mut all: Vec<_> = scenes::generated().collect();
    all.push(Generated { name: terrain::PREFIX.trim_end_matches(':'), level: Some(5) });
    all.push(Generated { name: mountains::PREFIX.trim_end_matches(':'), level: Some(10) });
    let example = |of: &Generated| match of.level {
        Some(level) => format!("{}:{level}", of.name),
        None => of.name.to_owned(),
    };
    if let Some(of) = all.iter().find(|of| of.name == kind) {
        let needs_level = of.level.is_some() && level.is_none();
        return needs_level.then(|| format!("this scene needs a level, as in {}", example(of)));
    }
    let file = nearest_file(name);
    let likely = || {
        let near = all.iter().map(|of| (distance(kind, of.name), of));
        let near = near.filter(|(distance, _)| is_near(*distance, kind));
        let (_, of) = near.min_by_key(|near| near.0)?;
        Some(match level {
            Some(level) => format!("{}:{level}", of.name),
            None => example(of),
        })
    };
    if let Some(meant) = file.or_else(likely) {
        return Some(format!("{MISSING}; did you mean {meant}?"));
    }
    // Where a folder or an ending is named, a file is meant.
    let is_file = name.extension().is_some() || text.contains('/');
    let names = all.iter().map(example).collect::<Vec<_>>().join(", ");
    Some(match is_file {
        true => MISSING.to_owned(),
        false => format!("{MISSING}; scenes without a file are {names}"),
    })
}

/// The file with a scene whose name is nearest, in the same folder.
fn nearest_file(name: &Path) -> Option<String> {
    let meant = name.file_name()?.to_str()?;
    let folder = name.parent()?;
    let here = match folder.as_os_str().is_empty() {
        true => Path::new("."),
        false => folder,
    };
    // Without an ending, or with another one, the name is that of any scene.
    let stem_meant = stem(meant)?;
    let files = here.read_dir().ok()?.filter_map(Result::ok);
    let near = files.filter_map(|file| {
        let file = file.file_name().into_string().ok()?;
        let ending = Path::new(&file).extension()?.to_str()?;
        let distance = distance(meant, &file).min(distance(stem_meant, stem(&file)?));
        let is_likely = ENDINGS.contains(&ending) && is_near(distance, stem_meant);
        is_likely.then_some((distance, file))
    });
    let (_, file) = near.min()?;
    Some(folder.join(file).display().to_string())
}

fn stem(file: &str) -> Option<&str> {
    Path::new(file).file_stem()?.to_str()
}

/// How many letters are missing, too many, other ones or swapped with their neighbours. Upper and
/// lower case are the same.
fn distance(a: &str, b: &str) -> usize {
    strsim::osa_distance(&a.to_lowercase(), &b.to_lowercase())
}

/// Whether a name may be a slip of the hand for another at this distance.
fn is_near(distance: usize, name: &str) -> bool {
    distance <= (name.chars().count() / 3).min(3)
}
